// A block that runs in place of the program: the next MDI line, or the block of a key whose label
// says that it starts something (tool, part transfer). The two are never mixed.
#pragma once
#include <array>
#include <cstdint>

#include "ipc/capacities.hpp"
#include "kernel/channel/mdi_lines.hpp"

namespace polyturn::kernel {

struct HandBlock {
    enum class Of : std::uint8_t { Nobody, List, Key };
    Of runs = Of::Nobody;  // it runs, or is held
    // a start in a hold has asked the channel whether the program can be left for it
    Of wanted = Of::Nobody;
    std::array<char, kCommandText> of_key{};  // its text
};

struct HandBlocks {
    MdiLines lines;  // entered by hand
    HandBlock block;

    // What runs, or is held, is no program.
    bool run() const noexcept { return block.runs != HandBlock::Of::Nobody; }
    void block_is_over() noexcept {
        lines.ended();
        block.runs = HandBlock::Of::Nobody;
    }
};

}  // namespace polyturn::kernel
