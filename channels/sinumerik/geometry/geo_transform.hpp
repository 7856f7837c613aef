// TRANSMIT, TRACYL, TRAANG, TRAFOOF.
#pragma once
namespace polyturn::channels::sinumerik {

struct Call;
struct Execution;

bool p_transmit(Execution& x, Call& c);
bool p_tracyl(Execution& x, Call& c);
bool p_traang(Execution& x, Call& c);
bool p_trafoof(Execution& x, Call& c);

}  // namespace polyturn::channels::sinumerik
