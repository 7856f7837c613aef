// Variables that setup and operator give a value before the program runs.
#pragma once
#include <string_view>

namespace polyturn::channels::fagor {

struct Execution;

bool preset_variable(Execution& x, std::string_view name, double value);

}  // namespace polyturn::channels::fagor
