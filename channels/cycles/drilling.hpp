// Drilling cycles along one axis, once for every language.
//
//   initial level  ---.                 . return (or at the R level)
//                     | rapid           :
//   R level        ---+--.  rapid back after each peck (full), or a short way up (chip break)
//                     |  :
//   bottom         ---v  : dwell
#pragma once
#include "channels/state/core.hpp"

namespace polyturn::channels::cycles {

struct Drilling {
    unsigned axis = 0;              // place of the drilling axis
    double initial = 0.0, r_level = 0.0, bottom = 0.0;   // workpiece system, true mm
    double peck = 0.0;              // depth of one peck; 0: in one go
    double clearance = 0.0;         // above the last depth (full), or the way up (chip break)
    bool chip_break = false;        // stay in the hole between pecks
    bool dwells = false;
    double dwell = 0.0;             // seconds, or revolutions
    bool dwell_revolutions = false;
    enum class Way : std::uint8_t { Rapid, Feed, StopRapid, Tap } way_out = Way::Rapid;
    double way_out_factor = 1.0;    // of the feed
    bool left_hand = false;         // Tap: turns anticlockwise on the way in
    bool to_r_level = false;        // ends at the R level
};

// From the present point: the hole's position is reached already, the axis stands on the initial level.
bool drill(Core& core, const Drilling& hole);

}  // namespace polyturn::channels::cycles
