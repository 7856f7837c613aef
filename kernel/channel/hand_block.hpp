// A block that runs in place of the program: the next MDI line, or the block of a key whose label
// says that it starts something (tool, part transfer). The two are never mixed.
#pragma once
#include <array>
#include <cstdint>

#include "ipc/capacities.hpp"

namespace polyturn::kernel {

struct HandBlock {
    enum class Of : std::uint8_t { Nobody, List, Key };
    Of runs = Of::Nobody;  // it runs, or is held
    // a start in a hold has asked the channel whether the program can be left for it
    Of wanted = Of::Nobody;
    std::array<char, kCommandText> of_key{};  // its text
};

}  // namespace polyturn::kernel
