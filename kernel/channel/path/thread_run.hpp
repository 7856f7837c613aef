// Threads: the records from the first kThread to kThreadEnd are one motion that follows a spindle.
// It begins only when all of them are there and the spindle turns at its speed; feed hold, reset
// and the channel's death act behind it, because leaving a thread halfway breaks the tool.
#pragma once
#include "kernel/channel/channel.hpp"

namespace polyturn::kernel {

// True when the thread is done and the path is stopped behind it.
bool drive_thread(Channel& c, double& left) noexcept;

}  // namespace polyturn::kernel
