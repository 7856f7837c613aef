// F, and the feed of the next move.
#pragma once
#include "channels/sink.hpp"

namespace polyturn::channels::fagor {

struct Execution;
struct GCode;

bool g_feed_mode(Execution& x, const GCode& row);
bool feed_word(Execution& x);
// The modal feed becomes that of the next move, which goes to `target`.
bool set_feed(Execution& x, const AxisValues& target);
// No axis faster than it can, on a circle from the angle `from` by `sweep` (radians, signed).
double largest_feed_on_arc(const Execution& x, double from, double sweep, unsigned p, unsigned q);
// All that moves are axes that are positioned only: "always G00" (3.7).
bool only_positions(const Execution& x, const AxisValues& target);
// FG.AXISTYPE.
int get_axis_type(const Execution& x, unsigned place);

}  // namespace polyturn::channels::fagor
