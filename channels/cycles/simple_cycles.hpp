// The cycles of four moves: turning, facing and threading pass, each from the start point and back
// to it.
//
//   turning (fanuc G90, nct G77)       facing (G94, G79)          thread (G92, G78)
//      4 <- - - - - - start             1 <- - - start            as turning; move 2 follows the
//      ^            1 :                 |2        : 4 rapid       spindle and may end with a
//     3|______________v                 v_________:               chamfer at an angle
//            2 feed                        3 feed
#pragma once
#include "channels/state/core.hpp"

namespace polyturn::channels::cycles {

struct SimpleCycle {
    AxisValues end{};  // corner opposite the start point, workpiece system
    // start less end of the cut, mm on the radius (turning, thread: X; facing: Z)
    double taper = 0.0;
    ThreadCall thread;            // thread: its lead
    double chamfer = 0.0;         // thread: length of the run-out along the thread, mm; 0 none
    double chamfer_angle = 45.0;  // deg
};

bool turning(Core& core, const SimpleCycle& cycle);
bool facing(Core& core, const SimpleCycle& cycle);
bool thread(Core& core, const SimpleCycle& cycle);

}  // namespace polyturn::channels::cycles
