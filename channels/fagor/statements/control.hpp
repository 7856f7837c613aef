// What the program takes out of the operator's hands: single block, stop, feed hold, spindle
// override.
#pragma once

namespace polyturn::channels::fagor {

struct Execution;

// In path order (12.3). `group_ends`: what ESBLK has begun is over.
void tell_control(Execution& x, bool group_ends);

}  // namespace polyturn::channels::fagor
