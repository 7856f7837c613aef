// What an execution is for that only looks ahead in a text which another one runs: at the profile
// of a cycle, or at the contour that is about to be compensated. Its values are copies, and its
// events end in a recorder; it asks for no tool, keeps no program and arms no interrupt.
#pragma once

namespace polyturn::channels::fagor {

struct LookAhead {
    bool reads_profile = false;
    bool scans_loops = false;
    bool over = false;  // what comes behind is no part of the contour
};

}  // namespace polyturn::channels::fagor
