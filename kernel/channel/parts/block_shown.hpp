// The block that a channel is at, for screens and messages, and the one that ended last.
#pragma once
#include <cstdint>

#include "polyturn/image_structs.hpp"

namespace polyturn::kernel {

struct BlockShown {
    std::uint32_t line = 0, file = 0;
    std::int64_t block = -1;
    std::uint64_t serial = 0;        // of the record that began last
    std::uint64_t ended_serial = 0;  // of the record that ended last
    std::uint32_t ended_part = 0;
    // line at which the program was broken off; 0: it has ended, or has not begun
    std::uint32_t broken_off = 0;

    void show(const PathRecord& r) noexcept {
        line = r.line;
        block = r.block;
        file = r.file;
    }
    void ended(std::uint64_t of_serial, std::uint32_t of_part) noexcept {
        ended_serial = of_serial;
        ended_part = of_part;
    }
};

}  // namespace polyturn::kernel
