// FXS, FXST, FXSW: travel to a fixed stop.
#pragma once
namespace polyturn::channels::sinumerik {

struct Execution;
struct Word;

bool a_fixed_stop(Execution& x, const Word& word);
bool a_stop_torque(Execution& x, const Word& word);
bool a_stop_window(Execution& x, const Word& word);
bool begin_stops(Execution& x);

}  // namespace polyturn::channels::sinumerik
