// TANG: a rotary axis that points along the path.
#pragma once
#include "channels/state/core.hpp"

namespace polyturn::channels::sinumerik {

struct Call;
struct Execution;

bool p_tangential(Execution& x, Call& c);
bool tangential_line(Execution& x, AxisValues& target);
bool tangential_arc(Execution& x, AxisValues& target, const ArcCall& call);

}  // namespace polyturn::channels::sinumerik
