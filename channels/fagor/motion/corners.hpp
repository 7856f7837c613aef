// G05 G07 G50 G51: how blocks meet; G36 to G39: what happens at the end of a block.
#pragma once

namespace polyturn::channels::fagor {

struct Execution;
struct GCode;

bool g_corner(Execution& x, const GCode& row);
bool g_look_ahead(Execution& x, const GCode& row);
// G36 to G39 of this block, told before its move.
bool element_at_end(Execution& x, bool straight_block);

}  // namespace polyturn::channels::fagor
