// S, G96, G97, G25, G26: speeds of spindles.
#pragma once

namespace polyturn::channels::fanuc {

struct Execution;
struct GCode;

bool spindle_word(Execution& x);
bool named_spindles(Execution& x);
bool g_surface(Execution& x, const GCode& row);
bool g_spindle_watch(Execution& x, const GCode& code);

}  // namespace polyturn::channels::fanuc
