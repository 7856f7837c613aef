// Programs of the B axis.
#pragma once

namespace polyturn::channels::fanuc {

struct Execution;
struct GCode;

bool g_b_register(Execution& x, const GCode& row);
bool b_record(Execution& x);
bool g_b_single(Execution& x, const GCode&);
bool b_start(Execution& x, double code);

}  // namespace polyturn::channels::fanuc
