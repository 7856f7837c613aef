// Motion that a program starts beside its path and later waits for: positioning axes, positioned
// spindles; torque limits for fixed stops; reference points that a program finds (G28).
#pragma once
#include "kernel/channel/channel.hpp"

namespace polyturn::kernel {

// False: the program of the axis is so long that it must get on first.
bool begin_positioning(Channel& c, const PathRecord& r) noexcept;
// Axes rest at their targets; spindles are in position, or have the speed or the standstill that
// they were commanded.
bool await_axes(Channel& c, const PathRecord& r) noexcept;
// A limit acts at once. When it is removed, the command returns to the slide's actual position, and
// the program waits for that.
bool limit_torque(Channel& c, const PathRecord& r) noexcept;
// A reset: the torque limits of programs are gone.
void release_stops(Core& core, std::uint32_t number) noexcept;
// Axes that have no reference point yet find it as reference mode would do it; the others stay
// where they are.
bool find_reference(Channel& c, const PathRecord& r) noexcept;

}  // namespace polyturn::kernel
