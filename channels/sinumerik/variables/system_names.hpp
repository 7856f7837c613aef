// The names of the system variables.
#pragma once
#include <string>
#include <string_view>
#include <vector>

#include "channels/sinumerik/grammar/tables.hpp"
#include "channels/sinumerik/grammar/value.hpp"

namespace polyturn::channels::sinumerik {

struct Execution;

bool system_name(Execution& x, std::string& name, std::vector<Value>& indices);
bool is_system_variable(std::string_view name);

}  // namespace polyturn::channels::sinumerik
