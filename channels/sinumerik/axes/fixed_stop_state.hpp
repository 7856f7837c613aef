// Travel to a fixed stop: the axes whose drives hold at the stop or shall on the way there (FXS=1).
#pragma once
#include "channels/sink.hpp"

namespace polyturn::channels::sinumerik {

struct FixedStopState {
    AxisSet on = 0;
    AxisSet wanted = 0;  // by this block
};

}  // namespace polyturn::channels::sinumerik
