// G66, G68, G69: a profile is cut in passes (fagor_8037t part 2, 9.1 to 9.3).
#pragma once

namespace polyturn::channels::fagor {

struct Execution;
struct GCode;

bool g_profile(Execution& x, const GCode& row);

}  // namespace polyturn::channels::fagor
