// SETINT and its kin: programs that a signal at an input calls.
#pragma once
namespace polyturn::channels::sinumerik {

struct Call;
struct Execution;

void arm_interrupts(Execution& x);
bool st_setint(Execution& x);
bool p_interrupts(Execution& x, Call& c);

}  // namespace polyturn::channels::sinumerik
