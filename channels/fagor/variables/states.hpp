// Variables that say what holds: program, modal codes, plane, mirror, times, machine parameters.
#pragma once
#include "channels/fagor/grammar/expression.hpp"

namespace polyturn::channels::fagor {

struct Execution;

Access read_state(Execution& x, const Target& target, double& value);
double machine_parameter(const Execution& x, const Target& target);

}  // namespace polyturn::channels::fagor
