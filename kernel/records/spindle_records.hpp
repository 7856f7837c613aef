// Spindle speeds, modes, positions and couplings; who owns a spindle (architecture 5.9).
#pragma once
#include "kernel/channel/channel.hpp"

namespace polyturn::kernel {

// An angle for a spindle whose loop is closed is driven at once and waited for; for the others it
// is where the PLC's M19 will take it, and the M code that follows waits.
bool position_spindle(Channel& c, const PathRecord& r) noexcept;
// A program couples something to a spindle, and goes on when it runs synchronously; uncoupled, when
// it is free.
bool couple_spindle(Channel& c, const PathRecord& r) noexcept;
void spindle_mode(Channel& c, const PathRecord& r) noexcept;
// A spindle is positioned beside the path, or given a speed: nothing waits.
void spindle_record(Channel& c, const PathRecord& r) noexcept;
// True: the spindle is where it is to be, or runs synchronously, or is free.
bool standing_spindle_record(Channel& c, const PathRecord& r) noexcept;

}  // namespace polyturn::kernel
