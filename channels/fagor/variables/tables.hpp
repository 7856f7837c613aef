// The tables of offsets and tools behind their variables, by number from 0 to 255.
#pragma once
#include "channels/fagor/grammar/expression.hpp"

namespace polyturn::channels::fagor {

struct Execution;

Access table_value(Execution& x, const Target& target, double& value);
Access write_table(Execution& x, const Target& target, double value);

}  // namespace polyturn::channels::fagor
