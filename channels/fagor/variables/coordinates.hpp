// Variables of positions: programmed, commanded, measured, and those of another block.
#pragma once
#include "channels/fagor/grammar/expression.hpp"

namespace polyturn::channels::fagor {

struct Execution;

Access read_coordinate(Execution& x, const Target& target, double& value);

}  // namespace polyturn::channels::fagor
