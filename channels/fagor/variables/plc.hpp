// PLC resources as variables: inputs, outputs, marks, registers, timers, counters.
#pragma once
#include "channels/fagor/grammar/expression.hpp"

namespace polyturn::channels::fagor {

struct Execution;

Access plc_value(Execution& x, const Target& target, bool write, double& value);

}  // namespace polyturn::channels::fagor
