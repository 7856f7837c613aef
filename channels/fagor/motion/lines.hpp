// G00 G01 and G53.
#pragma once
#include "channels/sink.hpp"

namespace polyturn::channels::fagor {

struct Execution;
struct GCode;

bool g_linear(Execution& x, const GCode& row);
// The move of a block, with its plan (loop_scan.hpp) and the element at its end.
bool drive_line(Execution& x, const AxisValues& programmed, bool rapid);
// Only the move.
bool drive_straight(Execution& x, const AxisValues& target, bool rapid);
// G53: the coordinates of the block are the machine's, or alone: no zero holds.
bool begin_machine_block(Execution& x);

}  // namespace polyturn::channels::fagor
