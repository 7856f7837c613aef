// G4.
#pragma once

namespace polyturn::channels::fanuc {

struct Execution;
struct GCode;

bool g_dwell(Execution& x, const GCode&);

}  // namespace polyturn::channels::fanuc
