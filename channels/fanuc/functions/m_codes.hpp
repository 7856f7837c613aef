// M codes: when they act, stops, ends, calls.
#pragma once

namespace polyturn::channels::fanuc {

struct Execution;

bool functions_before_motion(Execution& x);
bool functions_behind_motion(Execution& x);

}  // namespace polyturn::channels::fanuc
