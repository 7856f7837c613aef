// G10: offsets and work zeros.
#pragma once

namespace polyturn::channels::fanuc {

struct Execution;
struct GCode;

bool g_data(Execution& x, const GCode&);

}  // namespace polyturn::channels::fanuc
