// Reasons for which a path is stopped or must not begin: spindles and drives that are not ready
// yet, axes that are not in position, feeds that are zero; and what a channel reports about it to
// the operator.
#pragma once
#include "kernel/channel/channel.hpp"

namespace polyturn::kernel {

// A cut that begins from standstill waits for the spindle's speed (PT_FEED_WAITS); the M3 before it
// did not, whichever channel it was in: a feed per revolution waits for the spindle that it
// follows. A floating tap waits in any case: at the bottom the spindle turns on inward until its
// ramp has reversed it, and Z that left before would pull the tap out of its holder. One whose
// speed changes all the time (constant surface speed of another channel) is only followed. 0:
// nothing is waited for.
std::uint32_t awaited_spindle(const Channel& c) noexcept;
// The PLC has detached a spindle that a program waits for, or cuts with: it will never turn. Not
// while the PLC may still be at the code that attaches it again.
bool refuses_detached(Channel& c, std::uint32_t spindle) noexcept;
// A C axis whose drive is a spindle now: the path waits while that stops, and is refused when it
// turns, or when the spindle has turned the axis since the program last looked where it is.
bool waits_for_drive(Channel& c) noexcept;
// A spindle is still coming to rest before it gives its drive to a C axis of this channel: what is
// read at the barrier must be where that axis stays.
bool drive_is_coming(const Core& core, std::uint32_t number) noexcept;
// At a barrier the channel reads where its axes are.
void know_positions(Core& core, std::uint32_t number) noexcept;
// The path is at standstill though a program runs: must the reason be reported to the operator?
void watch_standstill(Channel& c, const PathRecord* running) noexcept;
bool axes_in_position(const Channel& c) noexcept;

}  // namespace polyturn::kernel
