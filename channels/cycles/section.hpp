// Turning and facing of one section, a line or an arc: fagor G81, G82, G84, G85. Once for every
// language.
//
//   h ^   end - - - - - - - - - - - - - - call point      h  height, towards the call point
//     |     \   <-------------- level 1   .               s  along the passes
//     |      \    <------------ level 2   .
//     |       '--. <----------- level 3   .
//     |           start                   .
//     +---------------------------------> s (towards the call point)
//
// All passes are equal and not deeper than `most`; each is cut up to the section with its
// allowance, then the tool goes back.
#pragma once
#include "channels/cycles/contour.hpp"
#include "channels/state/core.hpp"

namespace polyturn::channels::cycles {

// How a pass is left (fagor_8037t part 2, 9.2.2).
enum class Retract : std::uint8_t {
    Along,    // up along the contour to the pass before
    Oblique,  // at 45 degrees by the safety distance
    Same,     // back along the pass
};

struct Section {
    bool facing = false;  // passes along X
    Point start, end;
    bool arc = false;
    Point centre;       // of the arc of less than half a turn
    double most = 0.0;  // deepest pass
    Retract retract = Retract::Along;
    double safety = 0.0;          // Oblique, mm on each axis
    Point allowance;              // lengths
    double roughing_feed = 0.0;   // of a pass along the section with its allowance; 0 none
    double finishing_feed = 0.0;  // of a pass along the section; 0 none
    double arc_tolerance = 0.01;
};

bool cut_section(Core& core, const Section& section);

}  // namespace polyturn::channels::cycles
