// How far a way may be travelled: working areas, software limits, CALCPOSI.
#pragma once
#include "channels/state/core.hpp"

namespace polyturn::channels::sinumerik {

struct Call;
struct Execution;

bool f_calcposi(Execution& x, Call& c);
bool within_areas(Execution& x, const AxisValues& target);
bool arc_within_areas(Execution& x, const AxisValues& target, const ArcCall& call);

}  // namespace polyturn::channels::sinumerik
