// The position at which the tool stops before a block with an error.
#pragma once
#include "ipc/diagnosis/diagnosis.hpp"

namespace polyturn::channels::compensation {

// These concern the block behind the held one, whose own end is known: the tool comes to rest
// there. Behind any other error nothing is known, and a block that ends at its normal could cut
// into an inner corner: it is not begun.
inline bool leaves_held_block(Alarm alarm) {
    return alarm == Alarm::CompArcStartEnd || alarm == Alarm::CompPlaneChanged ||
           alarm == Alarm::CompArcCentre;
}

}  // namespace polyturn::channels::compensation
