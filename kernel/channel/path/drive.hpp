// One tick of the path: what holds and slows it, how far it goes, which records begin and end with
// it.
#pragma once
#include "kernel/channel/channel.hpp"

namespace polyturn::kernel {

void drive_path(Channel& c) noexcept;
// What holds and slows every path of this channel.
PathInput path_input(Channel& c) noexcept;
// Along the path no axis may brake harder than its own emergency deceleration.
double emergency_deceleration(const Core& core, std::uint32_t number) noexcept;
// N0302 of the axes that it moves and that have no reference (nct_parameters_part1 5: in any mode).
// Along a line each has its share of the speed, elsewhere none is faster than the path.
double ceiling_before_reference(const Core& core, const PathRecord& r) noexcept;

}  // namespace polyturn::kernel
