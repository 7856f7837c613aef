// The two axes of the inclined slide (G46), as the machine parameters named them when it was
// switched on last.
#pragma once

namespace polyturn::channels::fagor {

struct InclinedAxes {
    int axis = -1, orthogonal = -1;  // places
};

}  // namespace polyturn::channels::fagor
