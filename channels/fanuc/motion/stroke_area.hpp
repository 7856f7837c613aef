// G22, G23: stroke range 2.
#pragma once

namespace polyturn::channels::fanuc {

struct Execution;
struct GCode;

bool g_stroke_area(Execution& x, const GCode& row);

}  // namespace polyturn::channels::fanuc
