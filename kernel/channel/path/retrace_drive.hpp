// The path driven back and forth: retrace in a hold, and a handwheel that is the time base of the
// programs of a machine group (prove-out). Both drive the retrace memory (trail.hpp); the channel's
// own planner keeps its position and continues from there.
#pragma once
#include "kernel/channel/channel.hpp"
#include "kernel/gate/motion_gate.hpp"

namespace polyturn::kernel {

// No function, thread or rendezvous is in progress: the path may be left here and resumed.
bool may_leave_path(const Channel& c) noexcept;
// Cycle start while a way back is chosen. True: the trail is driven.
bool start_retrace(Channel& c, StartPermit) noexcept;
// The handwheel turns backwards, or the retraced path has been left already.
bool handwheel_drives_trail(Channel& c) noexcept;
// A program runs; or it has ended, and the handwheel takes it back.
bool drives_by_handwheel(const Channel& c) noexcept;
void drive_trail(Channel& c) noexcept;
// Why it cannot go further back.
void tell_obstacle(Channel& c) noexcept;

}  // namespace polyturn::kernel
