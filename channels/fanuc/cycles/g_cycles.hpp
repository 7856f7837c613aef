// G90, G92, G94: the simple cycles.
#pragma once

namespace polyturn::channels::fanuc {

struct Execution;
struct GCode;

bool g_cycle_turning(Execution& x, const GCode& row);
bool g_cycle_facing(Execution& x, const GCode& row);
bool g_cycle_thread(Execution& x, const GCode& row);

}  // namespace polyturn::channels::fanuc
