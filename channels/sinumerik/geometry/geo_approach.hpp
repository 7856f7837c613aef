// G147 to G348: soft approach and retract.
#pragma once
#include "channels/state/core.hpp"

namespace polyturn::channels::sinumerik {

struct Execution;
struct GCode;

bool geo_approach(Execution& x, const GCode& code);
bool finish_approach(Execution& x, const AxisValues& target, const ArcCall* arc, bool& taken);
bool geo_retract(Execution& x, const GCode& code);

}  // namespace polyturn::channels::sinumerik
