// System variables: read in expressions, written by assignments.
#pragma once
#include <cstddef>
#include <string>
#include <vector>

#include "channels/sinumerik/grammar/tables.hpp"
#include "channels/sinumerik/grammar/value.hpp"

namespace polyturn::channels::sinumerik {

struct Execution;

// at '$'
bool system_value(Execution& x, Value& value);
bool parse_system_assignment(Execution& x);
bool write_system(Execution& x, const std::string& name, const std::vector<Value>& indices,
                  Value value, const char* from, std::size_t length, const char* at);

}  // namespace polyturn::channels::sinumerik
