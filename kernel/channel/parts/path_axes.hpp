// What a channel's path has done with its axes.
#pragma once
#include <array>
#include <cstdint>

#include "ipc/capacities.hpp"
#include "kernel/records/moved_axes.hpp"

namespace polyturn::kernel {

struct PathAxes {
    MovedAxes placed, placed_before;  // by the path in this tick, and in the one before
    // brake by themselves: a record led one of them beyond its limits
    MovedAxes off_path;
    // of the last move: who must be in position
    std::array<std::uint8_t, kMaxPathAxes> last{};
    std::uint32_t last_count = 0;
    // the PLC has ended its program, and the channel does not know the axis' position yet; kMaxAxes
    // none
    std::uint32_t limited = kMaxAxes;
    // record that is placed; and the last tapping one of them
    std::uint64_t record = 0, tapped = ~0ull;
    double tap_from = 0;  // revolutions at which that began
    // The path has been at standstill since this tick; the tick in which that was looked at last.
    std::int64_t stands_since = 0, watched = 0;
};

}  // namespace polyturn::kernel
