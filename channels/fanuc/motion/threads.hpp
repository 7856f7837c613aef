// Threads: G32 to G35.
#pragma once

namespace polyturn::channels::fanuc {

struct Execution;
struct GCode;

bool g_thread(Execution& x, const GCode&);
bool g_thread_arc(Execution& x, const GCode&);
bool g_thread_variable(Execution& x, const GCode&);

}  // namespace polyturn::channels::fanuc
