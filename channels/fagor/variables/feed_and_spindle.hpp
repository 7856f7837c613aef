// Variables of feed and spindle, and their overrides.
#pragma once
#include "channels/fagor/grammar/expression.hpp"

namespace polyturn::channels::fagor {

struct Execution;

Access read_feed_or_spindle(Execution& x, const Target& target, double& value);

}  // namespace polyturn::channels::fagor
