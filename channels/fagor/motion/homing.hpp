// G74: axes look for their reference points.
#pragma once

namespace polyturn::channels::fagor {

struct Execution;
struct GCode;

bool g_home(Execution& x, const GCode&);

}  // namespace polyturn::channels::fagor
