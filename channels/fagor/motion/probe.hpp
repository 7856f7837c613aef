// G75, G76: moves that the probe ends; G52 likewise with a hard stop.
#pragma once
#include "channels/language.hpp"

namespace polyturn::channels::fagor {

struct Execution;
struct GCode;

bool g_probe(Execution& x, const GCode& row);
bool g_hard_stop(Execution& x, const GCode&);
// Behind the barrier: the axes stand where the signal stopped them, and are programmed to be there.
Step finish_probe(Execution& x);

}  // namespace polyturn::channels::fagor
