// Stock removal along a profile in passes of equal depth: fagor G68 (passes along Z), G69 (along
// X); and G66, which cuts the profile itself several times. Once for every language.
//
//    h ^  - - - - - - - - - - - - - - - call point
//      |      <-------------- level 1
//      |  .-. <-------------- level 2
//      | /   \     .--------- level 3
//      |/     '._.'
//      +--------------------------> s
//
// Main passes come from the call point's side and end at the profile with its allowance. What lies
// lower behind a rise (a hollow) is cut afterwards: down along the contour, across, out again;
// hollows within hollows likewise. Last level: the lowest point of the profile.
#pragma once
#include "channels/cycles/contour.hpp"
#include "channels/cycles/section.hpp"
#include "channels/state/core.hpp"

namespace polyturn::channels::cycles {

struct ProfileRoughing {
    bool facing = false;
    double depth = 0.0;  // of a pass
    Retract retract = Retract::Along;
    double safety = 0.0;
    double plunge_feed = 0.0;      // into hollows; 0: the roughing feed
    double semi_feed = 0.0;        // of a pass along the profile with its allowance; 0 none
    double finishing_feed = 0.0;   // of a pass along the profile with nose compensation; 0 none
    bool finishing_square = true;  // exact stops there
    double arc_tolerance = 0.01;
};

// `allowed` is the profile with its allowance, `blank` what is there before (absent: all up to the
// call point).
bool rough_profile(Core& core, const Contour& part, const Contour& allowed, const Contour* blank,
                   const ProfileRoughing& cycle);

struct ProfileRepeat {
    std::vector<Contour> passes;  // in the order of cutting
    bool along_x = true;          // displaced along X
    double finishing_feed = 0.0;
    bool finishing_square = true;
    double arc_tolerance = 0.01;
};

bool repeat_profile(Core& core, const Contour& part, const ProfileRepeat& cycle);

}  // namespace polyturn::channels::cycles
