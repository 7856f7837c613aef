// Macro calls: G65, G66, G67, and codes and letters that call programs.
#pragma once
#include "channels/text/word_scanner.hpp"

namespace polyturn::channels::fanuc {

struct Execution;
struct GCode;

bool g_macro_call(Execution& x, const GCode&);
bool g_macro_modal(Execution& x, const GCode& row);
bool g_macro_modal_off(Execution& x, const GCode&);
bool gives_arguments(const Execution& x);
const Word* stops_or_waits(const Execution& x);
bool stands_alone(Execution& x, const Word& stop);
bool per_block_call(Execution& x);
bool code_calls(Execution& x, bool& called);

}  // namespace polyturn::channels::fanuc
