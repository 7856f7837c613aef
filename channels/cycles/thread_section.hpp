// Threading of one section in passes: fagor G86 (along Z) and G87 (along X). Once for every
// language.
//
//      approach . - - - - - - - - - - - .  safety above the section
//      start ---+-----------------------+--- end     h  depth, away from the part (G86: X, G87: Z)
//               \______ pass k _______./ exit        s  along the thread (G86: Z, G87: X)
//
// Depth of pass n: first * sqrt(n), each step at least `least` (first > 0), or n * |first| (first <
// 0); what would go beyond depth - allowance ends there. Then the finishing pass at the full depth.
// All passes of one start, then those of the next.
#pragma once
#include <vector>

#include "channels/cycles/contour.hpp"
#include "channels/state/core.hpp"

namespace polyturn::channels::cycles {

struct ThreadSection {
    bool face = false;
    Point start, end;
    double depth = 0.0;  // signed: > 0 the part lies towards smaller h
    double first = 0.0, least = 0.0;
    double finishing = 0.0;       // depth of the last pass; < 0 it is fed in straight
    double safety = 0.0;          // >= 0
    bool square_corners = false;  // the return with exact stops
    double lead = 0.0;            // along s
    double lead_change = 0.0;     // a revolution
    // length along s; > 0 straight to the safety level, < 0 to the end point first
    double exit = 0.0;
    double angle_deg = 30.0;  // of the infeed
    int entry = -1;           // table 9.9.3; -1 by the angle
    int starts = 1;
    double spindle_deg = 0.0;  // of the first start
    bool run_in = false;       // every pass grows into and out of the part within one lead
};

std::vector<double> section_depths(const ThreadSection& thread);  // empty: endless
bool cut_thread_section(Core& core, const ThreadSection& thread);

}  // namespace polyturn::channels::cycles
