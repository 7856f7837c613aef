// G40 G41 G42.
#pragma once
#include "channels/compensation/options.hpp"

namespace polyturn::channels::fagor {

struct Execution;
struct GCode;

bool g_comp(Execution& x, const GCode& row);
// The block names axes, but no way.
bool at_standstill(Execution& x);
compensation::Corner outer_corner(const Execution& x);

}  // namespace polyturn::channels::fagor
