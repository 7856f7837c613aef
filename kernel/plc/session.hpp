// The PLC process' side of the cycle: each set of inputs that the kernel publishes is answered by
// one set of outputs.
//
//   kernel   | inputs n |  .  .  . PT_PLC_CYCLE .  .  . | outputs n act, inputs n+1 |
//   here                | cycle(n) | outputs n published, then cycle = n, then the bell
//
// Only PlcSegment is mapped writable: whatever a builder's code overwrites here, it reaches no
// axis.
#pragma once
#include <atomic>
#include <string>

#include "ipc/diagnosis/diagnosis.hpp"
#include "kernel/plc/builder_plc.hpp"

namespace polyturn::plc {

enum class SessionEnd { Asked, NewKernel };

// Runs until `stop`, or until another kernel has taken the instance over (then a new session begins
// with fresh state). retained: file of what the PLC keeps over power-off (N1274 #1); empty:
// nowhere.
Result<SessionEnd> run_session(const std::string& instance, BuilderPlc& plc,
                               const std::atomic<bool>& stop, const std::string& retained = {});

}  // namespace polyturn::plc
