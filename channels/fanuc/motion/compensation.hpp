// G40 to G42: where nose compensation begins and ends.
#pragma once

namespace polyturn::channels::fanuc {

struct Execution;
struct GCode;

bool g_comp_on(Execution& x, const GCode& row);
bool g_comp_off(Execution& x, const GCode&);

}  // namespace polyturn::channels::fanuc
