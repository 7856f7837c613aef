// What a hold is good for: offsets that change in it act when the program goes on, because the
// channel takes back what it has pushed (architecture 5.6); a block can be entered and executed by
// hand. The channel is asked before anything is discarded: not every block can be read again.
#pragma once
#include "kernel/channel/channel.hpp"
#include "kernel/gate/motion_gate.hpp"

namespace polyturn::kernel {

// The first block of which nothing has begun: it and what follows was only read ahead. 0: nothing
// was.
std::uint64_t first_not_begun(const Channel& c) noexcept;
// The path rests where pushed records may be taken back, and the axes are on it.
bool stands_in_hold(const Channel& c) noexcept;
// Axes were moved in the hold, and the language knows how to go on without going back first (N1337
// #5 REL).
bool resumes_elsewhere(const Channel& c) noexcept;
// Once a tick, at rest: the answer of the channel, a change that is due, a start that waits.
void settle_hold(Channel& c) noexcept;
// Asks the channel whether the program can be read again from where it is held.
void ask_to_go_back(Channel& c, Resume::BackFor why) noexcept;
// What was pushed and is not executed is void.
void discard_ahead(Channel& c) noexcept;
// The block that a start has asked for; the program is still held behind it.
void enter_by_hand(Channel& c, StartPermit) noexcept;
// Cycle start in a hold. False: an answer must come first, or the program is being taken back.
bool ready_to_continue(Channel& c) noexcept;

}  // namespace polyturn::kernel
