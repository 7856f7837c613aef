// G70 to G73: finishing, stock removal, pattern repeating.
#pragma once

namespace polyturn::channels::fanuc {

struct Execution;
struct GCode;

bool g_stock_removal(Execution& x, const GCode& row);
bool g_pattern(Execution& x, const GCode& row);
bool g_finishing(Execution& x, const GCode& row);
bool end_finishing(Execution& x);

}  // namespace polyturn::channels::fanuc
