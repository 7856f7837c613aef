// Mirror and scale, G10 to G14 and G72.
#pragma once

namespace polyturn::channels::fagor {

struct Execution;
struct GCode;

bool g_mirror(Execution& x, const GCode& row);
bool g_mirror_axes(Execution& x, const GCode&);
bool g_scale(Execution& x, const GCode&);

}  // namespace polyturn::channels::fagor
