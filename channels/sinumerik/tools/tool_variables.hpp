// $TC_...: tool data as system variables.
#pragma once
#include <cstddef>
#include <string>
#include <vector>

#include "channels/sinumerik/grammar/tables.hpp"
#include "channels/sinumerik/grammar/value.hpp"

namespace polyturn::channels::sinumerik {

struct Execution;

bool tool_value(Execution& x, const std::string& name, const std::vector<Value>& indices, const char* from, std::size_t length, Value& value);
bool edge_cell(Execution& x, const std::string& name, const std::vector<Value>& indices, const char* from, std::size_t length, bool make, double*& cell);

}  // namespace polyturn::channels::sinumerik
