// The program of a positioning axis, step by step beside the path (positioning_program.hpp).
#pragma once
#include "kernel/channel/channel.hpp"

namespace polyturn::kernel {

// A step of the program that the axis runs by itself; it waits behind those before it
// (positioning_program.hpp).
void take_step(Channel& c, const PathRecord& r) noexcept;
// Moves of another channel's program in between are none of ours.
bool runs_positioning(const Channel& c, std::uint32_t axis) noexcept;
// For its axis, where its program is about to begin.
void queue_up(Channel& c) noexcept;
// One step at a time; several that take no time in one tick.
void run_steps(Channel& c) noexcept;
bool holds_positioning(const Channel& c) noexcept;
// It gives up what its axes do beside the path.
bool breaks_off_positioning(const Channel& c) noexcept;

}  // namespace polyturn::kernel
