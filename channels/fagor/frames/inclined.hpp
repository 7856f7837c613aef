// G46: the inclined axis.
#pragma once
#include "channels/sink.hpp"

namespace polyturn::channels::fagor {

struct Execution;
struct GCode;

bool g_inclined(Execution& x, const GCode&);
// S of G46: 0 off, 1 on, 2 frozen.
void set_inclined(Execution& x, int state);
// While frozen only the inclined axis moves: the point slides along it (13.2).
void slide_along_inclined(const Execution& x, AxisValues& target, AxisSet named);

}  // namespace polyturn::channels::fagor
