// Variables by name: reading and writing them (fagor_8037t part 2, 11.2). Groups of them have files
// of their own beside this one.
#pragma once
#include <string>

#include "channels/fagor/grammar/expression.hpp"

namespace polyturn::channels::fagor {

struct Execution;

// Notes a fault; gives Access::Fault.
Access variable_fault(Execution& x, Alarm alarm, std::string detail, double v0 = 0.0,
                      double v1 = 0.0);
// A parameter or a variable by its name.
Access write_value(Execution& x, const Target& target, double value);
Access read_named(Execution& x, const Target& target, double& value);
Access write_named(Execution& x, const Target& target, double value);

}  // namespace polyturn::channels::fagor
