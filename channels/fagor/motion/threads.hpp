// G33 G34, and G233: how the axes leave a thread that is stopped.
#pragma once

namespace polyturn::channels::fagor {

struct Execution;
struct GCode;

bool g_thread(Execution& x, const GCode& row);
bool g_withdrawal(Execution& x, const GCode&);

}  // namespace polyturn::channels::fagor
