// Codes that set how the words and moves behind them count.
#pragma once
#include <cstdint>

namespace polyturn::channels::fanuc {

struct Execution;
struct GCode;

// In tenths: G20 or G21, in system C G70 or G71.
std::uint16_t units_code(const Execution& x, bool inch);

bool g_nothing(Execution& x, const GCode& row);
bool g_units(Execution& x, const GCode& row);
bool g_plane(Execution& x, const GCode& row);
bool g_distance(Execution& x, const GCode& row);
bool g_exact_stop(Execution& x, const GCode& row);
bool g_exact_once(Execution& x, const GCode&);
bool g_diameter(Execution& x, const GCode&);
bool g_smoothing(Execution& x, const GCode&);

}  // namespace polyturn::channels::fanuc
