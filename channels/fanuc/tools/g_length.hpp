// G43 to G49: lengths of tools, the tip of the tool; D.
#pragma once

namespace polyturn::channels::fanuc {

struct Execution;
struct GCode;

bool g_length(Execution& x, const GCode& row);
bool radius_offset(Execution& x);

}  // namespace polyturn::channels::fanuc
