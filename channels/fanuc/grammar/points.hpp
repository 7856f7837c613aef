// A program that writes no decimal point at all means millimetres more often than not.
#pragma once

namespace polyturn::channels::fanuc {

struct Execution;

void judge_points(Execution& x);

}  // namespace polyturn::channels::fanuc
