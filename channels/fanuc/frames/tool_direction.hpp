// G53.1: head and table go where the tool points along Z of the rotated system.
#pragma once

namespace polyturn::channels::fanuc {

struct Execution;
struct GCode;

bool g_tool_direction(Execution& x, const GCode&);

}  // namespace polyturn::channels::fanuc
