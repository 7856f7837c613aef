// Synchronous spindles.
#pragma once
namespace polyturn::channels::sinumerik {

struct Call;
struct Execution;

bool p_coupling(Execution& x, Call& c);
bool f_posrange(Execution& x, Call& c);

}  // namespace polyturn::channels::sinumerik
