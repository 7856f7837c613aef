// INIT, START: programs of other channels.
#pragma once
namespace polyturn::channels::sinumerik {

struct Call;
struct Execution;

bool p_init(Execution& x, Call& c);
bool p_start(Execution& x, Call& c);

}  // namespace polyturn::channels::sinumerik
