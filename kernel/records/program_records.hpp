// Records that steer the program itself: dwells, waits and markers, stops and ends, interrupts,
// messages, and statements outside the path.
#pragma once
#include "kernel/channel/channel.hpp"

namespace polyturn::kernel {

// Statements of the program outside the path.
void set_flag(Channel& c, const PathRecord& r) noexcept;
bool dwell(Channel& c, const PathRecord& r, double& left) noexcept;
bool arrive_at_wait(Channel& c, const PathRecord& r) noexcept;
// M0, M1, dialogues, and the end of the program.
bool stop_program(Channel& c, const PathRecord& r) noexcept;
// M96, M97: an edge counts from here on; a level that is there already counts at once.
void interrupts_record(Channel& c, const PathRecord& r) noexcept;
// The program's own words, for the operator.
void message_record(Channel& c, const PathRecord& r, double offset_s) noexcept;
void marker_record(Channel& c, const PathRecord& r) noexcept;
// A flying wait that was let pass: it is an arrival like any other.
void flying_wait(Channel& c, const PathRecord& r) noexcept;

}  // namespace polyturn::kernel
