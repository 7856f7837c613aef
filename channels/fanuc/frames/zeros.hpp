// Work zeros, fixture offsets and coordinate settings.
#pragma once

namespace polyturn::channels::fanuc {

struct Execution;
struct GCode;

bool g_zero(Execution& x, const GCode& row);
bool g_zero_extended(Execution& x, const GCode&);
bool g_fixture(Execution& x, const GCode&);
bool g_preset(Execution& x, const GCode&);
bool g_preset_off(Execution& x, const GCode& row);
bool g_local_zero(Execution& x, const GCode&);

}  // namespace polyturn::channels::fanuc
