// Work zones, G20 to G22: limits are radii from machine zero (fagor_8037t part 1, 3.8).
#pragma once

namespace polyturn::channels::fagor {

struct Execution;
struct GCode;

bool g_zone_limit(Execution& x, const GCode& row);
bool g_zone(Execution& x, const GCode&);

}  // namespace polyturn::channels::fagor
