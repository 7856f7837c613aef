// What a program becomes when its path has come to rest: the reasons to brake are taken in their
// order (program_state.hpp).
#pragma once
#include "kernel/channel/channel.hpp"

namespace polyturn::kernel {

// States that begin with the path at rest.
void settle_program(Channel& c) noexcept;
// The path rests: what was pushed and not executed is void, the channel begins again behind it.
void finish_reset(Channel& c) noexcept;

}  // namespace polyturn::kernel
