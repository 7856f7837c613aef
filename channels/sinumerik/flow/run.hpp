// How the run goes on behind this block: barriers, another place of the text, the end.
#pragma once
#include "channels/sinumerik/execution.hpp"

namespace polyturn::channels::sinumerik {

void keep_resume_states(Execution& x, bool on);
void finish(Execution& x, StopReason reason);
bool need_fresh(Execution& x);
void seek(Execution& x, TextPosition to);

// AtBarrier behind this block
inline void stop_reading(Execution& x) { x.run.wants_barrier = true; }

}  // namespace polyturn::channels::sinumerik
