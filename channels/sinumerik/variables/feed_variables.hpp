// System variables of feeds, speeds and tool offsets.
#pragma once
#include <cstddef>
#include <string>
#include <vector>

#include "channels/sinumerik/grammar/tables.hpp"
#include "channels/sinumerik/grammar/value.hpp"

namespace polyturn::channels::sinumerik {

struct Execution;

bool feed_value(Execution& x, const std::string& name, const std::vector<Value>& indices,
                const char* from, std::size_t length, Value& value, bool& known);

}  // namespace polyturn::channels::sinumerik
