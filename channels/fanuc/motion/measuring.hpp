// G31, G36, G37: moves that a signal ends.
#pragma once
#include <string_view>

#include "channels/language.hpp"

namespace polyturn::channels::fanuc {

struct Execution;
struct GCode;

bool g_skip(Execution& x, const GCode&);
std::string_view dwell_signal(Execution& x);
bool g_measure(Execution& x, const GCode& row);
Step finish_skip(Execution& x);

}  // namespace polyturn::channels::fanuc
