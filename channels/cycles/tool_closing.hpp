// A contour without the hollows that the tool's flanks cannot reach (fagor_8037t part 2, 9.1.5).
//
//    \  .       descending steeper than the trailing edge allows: from the last reachable point a
//     \   '.    line at that angle, until the contour is met again; ascending steeper than the
//      '----'.-- leading edge: likewise, seen from the other end
#pragma once
#include "channels/cycles/contour.hpp"

namespace polyturn::channels::cycles {

struct Flanks {
    // steepest direction into the material, against the direction of the cut; 90 and more: all of
    // it
    double descent_deg = 180.0;
    double ascent_deg = 180.0;
};

// `changed` says whether anything was closed.
Contour closed_for(const Contour& contour, bool facing, double s_sign, double h_sign,
                   const Flanks& flanks, bool& changed);

}  // namespace polyturn::channels::cycles
