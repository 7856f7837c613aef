// Zero offsets and presets, G54 to G59, G92, G159.
#pragma once

namespace polyturn::channels::fagor {

struct Execution;
struct GCode;

bool g_zero(Execution& x, const GCode& row);
bool g_zero_table(Execution& x, const GCode&);
bool g_preset(Execution& x, const GCode&);
// Zeros of the tables have changed.
void refresh_zero(Execution& x);

}  // namespace polyturn::channels::fagor
