// Barriers before a block: a value that only the machine knows, and what is looked at behind one.
#pragma once

namespace polyturn::channels::fanuc {

struct Execution;

void check_synchronous_axes(Execution& x);
void barrier_passed(Execution& x);
void read_value_barrier(Execution& x);
void live_value_barrier(Execution& x);

}  // namespace polyturn::channels::fanuc
