// Tools of tool management (fagor_8037t_part2 11.2.2): the tool's number is its data number, its
// family the type number. An expended tool gives way to another of its family; the store says
// which, so T (with TOFFM06: M06) is executed before the rest of its block is read.
#pragma once
#include <cstddef>

#include "channels/fagor/variables/values.hpp"
#include "channels/state/core.hpp"

namespace polyturn::channels::fagor {

struct Execution;

// Tool management answers T.
bool managed(Execution& x);
// The tools of the store that this channel sees.
void preset_tools(Execution& x, const ToolTable& tools, int unit);
// T or M06 of this block is output before the rest of it; true: just now, a barrier follows.
bool asks_for_tool(Execution& x);
// What M06 has changed to.
bool take_over_change(Execution& x);
// TLFN and the like: what the program writes is the store's too.
void tell_tool(Execution& x, ToolField field, std::size_t n, double value);

}  // namespace polyturn::channels::fagor
