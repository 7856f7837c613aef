// CYCLE81, CYCLE82, CYCLE85, HOLES1, HOLES2.
#pragma once
namespace polyturn::channels::sinumerik {

struct Call;
struct Execution;

bool p_cycle81(Execution& x, Call& c);
bool p_cycle82(Execution& x, Call& c);
bool p_cycle85(Execution& x, Call& c);
bool modal_cycle(Execution& x);
bool p_holes(Execution& x, Call& c);

}  // namespace polyturn::channels::sinumerik
