// Drilling cycles along one axis, once for every language.
//
//   initial level  ---.                 . return (or at the R level)
//                     | rapid           :
//   R level        ---+--.  rapid back after each peck (full), or a short distance up (chip break)
//                     |  :
//   bottom         ---v  : dwell
#pragma once
#include "channels/state/core.hpp"

namespace polyturn::channels::cycles {

struct Drilling {
    unsigned axis = 0;                                  // index of the drilling axis
    double initial = 0.0, r_level = 0.0, bottom = 0.0;  // workpiece system, true mm
    double peck = 0.0;                                  // depth of one peck; 0: in one go
    double clearance = 0.0;   // above the last depth (full), or the distance up (chip break)
    bool chip_break = false;  // stay in the hole between pecks
    bool dwells = false;
    double dwell = 0.0;  // seconds, or revolutions
    bool dwell_revolutions = false;
    bool dwells_at_r = true;  // Tap: there too
    // Back: boring from behind. Beside the wall, with the spindle oriented, through the hole to the
    // R level below it; there the spindle turns and cuts up to `bottom`; then beside the wall out
    // to the initial level.
    enum class Way : std::uint8_t {
        Rapid,
        Feed,
        StopRapid,
        Tap,
        Fine,
        Back
    } travel_out = Way::Rapid;
    // Fine, Back: from the wall, with the spindle oriented, during the retract; and back above
    AxisValues aside{};
    double travel_out_factor = 1.0;  // of the feed
    bool left_hand = false;          // Tap: turns anticlockwise during infeed
    bool to_r_level = false;         // ends at the R level
    double out_factor = 1.0;         // Tap: speed out of the thread
    // Tap: at the R level the spindle is positioned (M19) or its loop closed by a code, then it
    // turns along with the axis, `pitch` mm a revolution; back at the R level the loop is opened
    // (nct part 1, 16.4).
    bool rigid = false, orients = false;
    double closing_code = 0.0;
    double pitch = 0.0;
    bool feedforward = false, own_acceleration_out = false;  // N1503 RFF, EAE
    double return_factor = 1.0;  // Tap in pecks that leave the thread: speed back to the cut
};

// A hole on the turning axis with depths counted from the surface (fagor G83): the approach point
// lies in front of it.
//
//   approach ---.  G00 from the call point
//   surface  ---+--   the first cut begins here
//   bottom   ---v
//
// Peck k: `peck` * factor^(k-1), not below `least`. After each the tool goes back by `retract` (0:
// to the approach point), then in rapid to `clearance` before the last depth.
struct AxialHole {
    AxisValues approach{};  // point
    unsigned axis = 0;
    double surface = 0.0, bottom = 0.0;
    double peck = 0.0, factor = 1.0, least = 0.0;
    double retract = 0.0, clearance = 1.0;
    double dwell = 0.0;  // seconds; 0 none
    // of tap_axial: the last two are rigid
    enum class Tap : std::uint8_t { Floating, Oriented, Turning } tap = Tap::Floating;
};
bool drill_axial(Core& core, const AxialHole& hole);
bool tap_axial(Core& core, const AxialHole& hole);

// From the present point: the hole's position is reached already, the axis is on the initial
// level.
bool drill(Core& core, const Drilling& hole);

}  // namespace polyturn::channels::cycles
