// What becomes of a controller's processes when its supervisor dies, by whatever: the kernel brings
// the machine to rest along its paths and ends; until then PLC, channels, store and drives go on,
// and none of them outlives it.
//
//   supervisor  X
//   kernel      ......stops.....X
//   the others  ................X       and all at once when supervisor and kernel have died
//
// The supervisor says in the environment of whom it starts that it does so (kSupervisorWord). A
// process that somebody else has started, a test or a person at a shell, is not concerned.
#pragma once
#include <functional>
#include <string>

namespace polyturn {

inline constexpr const char* kSupervisorWord = "POLYTURN_SUPERVISOR";  // its process number

// Calls `died` from a thread of its own when the supervisor of this process has died.
void when_supervisor_dies(std::function<void()> died);
// For everybody but the kernel: this process ends (SIGTERM to itself, then without asking) when
// supervisor and kernel of `instance` have died.
void end_with_kernel(const std::string& instance);

}  // namespace polyturn
