// The words of a cycle: which it needs, its points and times (fagor_8037t part 2, 9.0).
#pragma once
#include <string_view>

#include "channels/cycles/contour.hpp"

namespace polyturn::channels::fagor {

struct Execution;

// Each of the three refuses the block when one of these letters is missing, 0, or negative.
bool cycle_needs(Execution& x, std::string_view letters);
bool cycle_not_zero(Execution& x, std::string_view letters);
bool cycle_not_negative(Execution& x, std::string_view letters);
// K in hundredths of a second.
bool cycle_dwell(Execution& x, double& seconds);
// A point of the plane by these two words: absolute, whatever G90 and G91 say.
cycles::Point cycle_point(Execution& x, char abscissa, char ordinate);
// The tool's position in the plane.
cycles::Point cycle_call_point(Execution& x);
std::string_view cycle_name(unsigned number);
// Feed and spindle as for a move of the block.
bool begin_cycle_block(Execution& x);
void drop_compensation(Execution& x);

}  // namespace polyturn::channels::fagor
