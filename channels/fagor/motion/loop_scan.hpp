// G41 N, G42 N: the blocks behind the one that switches compensation on are interpreted in advance
// by a second execution that only records their contour; what contour_loops finds there changes
// the blocks when they really come (fagor_8037t part 1, 8.3).
//
// A block that is left out moves nothing in the plane; its functions and its other axes act.
// Positions within the program (increments, arc centres) count as if it had moved: path.programmed
// takes its end, path.machine does not.
#pragma once
#include "channels/sink.hpp"

namespace polyturn::channels::fagor {

struct Execution;

// Looks at the blocks ahead; behind the block that asks for it, and where the last scan ended.
bool scan_loops(Execution& x);
// The plan of this block, applied to its target. True: its way in the plane is left out.
bool leave_out(Execution& x, AxisValues& target);
// The chamfer or rounding at the end of this block is left out.
bool ends_sharp(const Execution& x);
// Only what lies outside of the plane is driven; the program is where the block would have led.
bool drive_left_out(Execution& x, const AxisValues& target, bool rapid);

}  // namespace polyturn::channels::fagor
