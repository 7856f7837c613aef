// Mirror, scale, rotation and polar points.
#pragma once
#include "channels/state/core.hpp"

namespace polyturn::channels::fanuc {

struct Execution;
struct GCode;

void apply_frames(Execution& x);
bool g_scale(Execution& x, const GCode& row);
bool g_mirror(Execution& x, const GCode& row);
bool g_turret_mirror(Execution& x, const GCode&);
bool g_rotation(Execution& x, const GCode& row);
bool g_polar(Execution& x, const GCode& row);
bool polar_target(Execution& x, AxisValues& target, AxisSet named);

}  // namespace polyturn::channels::fanuc
