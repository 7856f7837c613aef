// Where the axes of a record, and the spindle of a rigid tap, are to be. What cannot be driven is
// refused; a path that would lead an axis beyond its limits is given up, and its axes brake by
// themselves.
#pragma once
#include "kernel/channel/channel.hpp"

namespace polyturn::kernel {

// To where the record is `s` along its length.
void place_axes(Channel& c, const PathRecord& r, double s) noexcept;
// Axes that obey a master, are not there, or have lost their reference while the program ran, move
// for no program.
void refuse_bound(Channel& c, const PathRecord& r) noexcept;
// Rigid tapping: the spindle is one of those whose limits the path keeps (N1508, N1516, N1524,
// N0320).
void limit_tapping(const Core& core, const PathRecord& r, PlannedRecord& planned) noexcept;
// Whatever speed the records ask for, no axis is commanded beyond its limits. An axis that would be
// brakes, with all that the path moves. An open loop has no command; a withdrawal from a thread
// adds its own travel, within limits of its own.
void watch_commands(Channel& c) noexcept;
// The path is given up: the axes' position on it is unknown.
void brake_off_path(Channel& c) noexcept;

}  // namespace polyturn::kernel
