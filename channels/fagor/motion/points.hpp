// From the words of a block to the point it means: cartesian, polar, angle and one coordinate
// (fagor_8037t part 1, 3.6).
#pragma once
#include "channels/sink.hpp"

namespace polyturn::channels::fagor {

struct Execution;

// The target of the block; `named`, unless nullptr: the axes that it names.
bool read_point(Execution& x, AxisValues& target, AxisSet* named);
// R and Q about the polar origin; what is not programmed keeps its value.
bool polar_point(Execution& x, AxisValues& target);
// The direction in which the path left the last block, before mirror and scale; false: none yet.
bool end_direction(const Execution& x, double& p, double& q);
void note_direction(Execution& x, double p, double q);

}  // namespace polyturn::channels::fagor
