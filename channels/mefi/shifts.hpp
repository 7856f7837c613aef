// Group 5 of mefi: zero shifts G53 to G59, and G92, G93 that fill their table.
#pragma once

namespace polyturn::channels::fanuc {

struct Execution;
struct GCode;

bool g_shift(Execution& x, const GCode& row);
bool says_it_once(Execution& x);
void end_one_block_shift(Execution& x);
bool g_shift_table(Execution& x, const GCode& row);

}  // namespace polyturn::channels::fanuc
