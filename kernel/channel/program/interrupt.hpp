// The interrupt macro's signal: it is watched between M96 and M97, in path order, and stops the
// path at once or at the end of the running block. What was pushed beyond is void; the channel goes
// on from there with the interrupt program.
#pragma once
#include "kernel/channel/channel.hpp"

namespace polyturn::kernel {

// Once a tick, before the path.
void watch_interrupt(Channel& c) noexcept;
// What the channel has done ahead acts now. True: nothing of it is left, and nothing more comes.
bool obey_ahead(Channel& c) noexcept;
// The path rests: is this a place where the program may break off?
bool is_stopped_for_interrupt(Channel& c) noexcept;
// The rest of the path is void; the channel pushes the interrupt program.
void break_off(Channel& c) noexcept;

}  // namespace polyturn::kernel
