// Threading in several passes: fanuc G76. Once for every language.
//
//          A <- - - - - - - - - - - - - - .
//          |  start of pass k moves by     :      depth of pass k: first * sqrt(k), each step at
//          |  depth * tan(angle / 2)       :      least `least`; until height - allowance, then
//          v                               :      `finishing` passes at the full height
//      ----*------- k = 1 ------------.    : back
//     ------*------ k = 2 -------------'.  :
//     -------*----- k = 3 ---------------'.:  run-out: leaves the thread at an angle over `chamfer`
//     mm
//
// The number of passes is bounded before the first move (kMostThreadPasses).
#pragma once
#include "channels/cycles/contour.hpp"
#include "channels/state/core.hpp"

namespace polyturn::channels::cycles {

inline constexpr int kMostThreadPasses = 5'000;

struct ThreadPasses {
    Point end;                        // bottom of the thread at its end
    double taper = 0.0;               // start less end, mm on the radius
    double height = 0.0;              // of the thread, mm
    double first = 0.0, least = 0.0;  // infeed of the first pass, least infeed, mm
    double allowance = 0.0;           // left for the finishing passes, mm
    int finishing = 1;
    double tool_angle_deg = 60.0;
    double chamfer = 0.0;  // length of the run-out along the thread, mm
    double chamfer_angle_deg = 45.0;
    ThreadCall thread;
    char height_letter = 'P', first_letter = 'Q';  // to point at
};

// A pass of a cycle that is held leaves the thread as far as the cycle's own start point stands
// clear of it, and repeats.
void withdraw_to(ThreadCall& call, unsigned x_place, double clear, double from, double to);
// Depths of all passes; empty: a value makes them endless.
std::vector<double> thread_depths(const ThreadPasses& cycle);
bool cut_thread(Core& core, const ThreadPasses& cycle);

}  // namespace polyturn::channels::cycles
