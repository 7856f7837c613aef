// Tools of tool management: T is answered by the store.
#pragma once
#include <cstddef>
#include <string>
#include <vector>

#include "channels/sinumerik/grammar/tables.hpp"
#include "channels/sinumerik/grammar/value.hpp"
#include "polyturn/image_structs.hpp"

namespace polyturn::channels::sinumerik {

struct Execution;

// tool management answers T
bool managed(Execution& x);
void preset_stored(Execution& x, const polyturn::ToolTable& tools,
                   const polyturn::ToolEdgeTable& edges, int unit);
// the T or tool change of this block has been executed; false: it is read again behind it
bool managed_tool(Execution& x);
bool monitoring(Execution& x, const std::string& name, const std::vector<Value>& indices,
                const char* from, std::size_t length, std::string& field, double& value);
bool write_monitoring(Execution& x, const std::string& name, const std::vector<Value>& indices,
                      const char* from, std::size_t length, const Value& value);
void tell_tool(Execution& x, const std::string& name, const Value& value);
bool p_reset_monitoring(Execution& x, Call& c);

}  // namespace polyturn::channels::sinumerik
