// Programs that a signal at an input calls (SETINT), by the number of the input.
#pragma once
#include <map>
#include <string>

namespace polyturn::channels::sinumerik {

struct Routine {
    std::string program;
    bool enabled = true, at_block_end = false;
    bool lifts = false;  // LIFTFAST
};

struct InterruptState {
    std::map<int, Routine> routines;
};

}  // namespace polyturn::channels::sinumerik
