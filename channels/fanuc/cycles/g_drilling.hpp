// G80 to G89.
#pragma once

namespace polyturn::channels::fanuc {

struct Execution;
struct GCode;

bool g_drilling_off(Execution& x, const GCode&);
bool g_drilling(Execution& x, const GCode& row);
bool run_drilling(Execution& x);

}  // namespace polyturn::channels::fanuc
