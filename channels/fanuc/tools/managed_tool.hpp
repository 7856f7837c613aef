// T of tool management.
#pragma once
#include <cstdint>

namespace polyturn::channels::fanuc {

struct Execution;

// What the T of the block asks of tool management.
enum class ToolRequest : std::uint8_t { Plain, OwnOffset, Group, Place };

ToolRequest tool_request(const Execution& x);
bool waits_for_tool(const Execution& x);
bool call_managed_tool(Execution& x);
bool names_managed_offset(const Execution& x);
bool managed_offset(Execution& x, bool radius, std::int64_t& offset);

}  // namespace polyturn::channels::fanuc
