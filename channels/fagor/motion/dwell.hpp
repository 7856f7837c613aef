// G04: a dwell, or the stop of block preparation.
#pragma once

namespace polyturn::channels::fagor {

struct Execution;
struct GCode;

bool g_dwell(Execution& x, const GCode&);
// G04 without K, or with K0, interrupts the preparation of blocks; with K it is a dwell (7.1).
bool ends_reading(const Execution& x);

}  // namespace polyturn::channels::fagor
