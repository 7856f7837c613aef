// Variables: found by name, assigned, reported; outputs.
#pragma once
#include <cstddef>
#include <string>
#include <string_view>
#include <vector>

#include "channels/sinumerik/execution.hpp"

namespace polyturn::channels::sinumerik {

Reference find_variable(const Execution& x, std::string_view name);
bool reference_ahead(Execution& x, Reference& reference);
bool index_list(Execution& x, std::vector<Value>& indices);
bool element_of(Execution& x, const Variable& variable, const std::vector<Value>& indices,
                const char* at, std::size_t& element);
bool character_of(Execution& x, const Reference& reference, const char* at, std::size_t& i);
void store(Execution& x, const Reference& reference, Value value);
bool assign(Execution& x, const Reference& reference, Value value, const char* at);
bool assignment(Execution& x, const Reference& reference);
void report_variable(Execution& x, const std::string& name, const Value& value);
void look_at_outputs(Execution& x);

// the names of the running program
inline std::shared_ptr<Scope> scope(const Execution& x) { return x.calls.levels.back().scope; }

}  // namespace polyturn::channels::sinumerik
