// G74, G75, G76.
#pragma once

namespace polyturn::channels::fanuc {

struct Execution;
struct GCode;

bool g_grooving(Execution& x, const GCode& row);
bool g_thread_passes(Execution& x, const GCode& row);

}  // namespace polyturn::channels::fanuc
