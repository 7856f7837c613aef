// M, S and T: given to the PLC, which finishes them. A new number in the strobe register is a new
// code, the same number in the answer finishes it.
#pragma once
#include "kernel/channel/channel.hpp"

namespace polyturn::kernel {

// Gives it to the PLC; its end is waited for by give_function().
void strobe_function(Channel& c, const PathRecord& r) noexcept;
// The PLC is notified of the program's end too, and stops what belongs to it; the end itself does
// not wait.
void strobe_program_end(Channel& c, StopReason reason) noexcept;
// True: the PLC has finished it, and what it changed is known.
bool give_function(Channel& c, const PathRecord& r) noexcept;

}  // namespace polyturn::kernel
