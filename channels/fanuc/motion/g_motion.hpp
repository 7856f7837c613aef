// G0 to G3, G53, and the ways to reference positions.
#pragma once
#include "channels/state/core.hpp"

namespace polyturn::channels::fanuc {

struct Execution;
struct GCode;

bool g_rapid(Execution& x, const GCode&);
bool g_linear(Execution& x, const GCode&);
bool g_arc(Execution& x, const GCode& row);
bool arc_words(Execution& x, ArcCall& call, bool& goes);
bool g_machine(Execution& x, const GCode&);
bool g_reference(Execution& x, const GCode& row);
bool g_reference_check(Execution& x, const GCode& row);

}  // namespace polyturn::channels::fanuc
