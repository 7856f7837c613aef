// G41 N, G42 N: what the search for loops has found out about the blocks ahead, and how far it has
// looked. A plan changes its block when the block really comes.
#pragma once
#include <cstdint>
#include <map>
#include <optional>

#include "channels/cycles/contour.hpp"

namespace polyturn::channels::fagor {

struct LoopPlan {
    // the block's travel in the plane; the first one of its loop decides
    bool left_out = false, first = false;
    std::optional<cycles::Point> end;  // otherwise where it ends instead
    // only the chamfer or rounding at its end is left out
    bool sharp = false;
};

struct LoopPlans {
    std::map<std::uint64_t, LoopPlan> plans;  // by the serial of their blocks
    // serial of the last block that has been looked at; 0 none
    std::uint64_t scanned_to = 0;
    bool due = false;  // the next scan is behind this block
};

}  // namespace polyturn::channels::fagor
