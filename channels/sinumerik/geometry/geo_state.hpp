// What the geometry half of the language keeps from block to block: part of a resume state.
#pragma once
#include <optional>

#include "channels/sinumerik/frames/frame_value.hpp"
#include "channels/state/frame.hpp"

namespace polyturn::channels::sinumerik {

// A first straight line that is given by its angle alone: the next line decides where it ends
// (sinumerik_part2 10.9.3).
struct OpenLine {
    double angle_deg = 0.0;
    BlockContext at;
    double feed = 0.0;
    bool rapid = false;
    double corner_size = 0.0, corner_feed = 0.0;  // RND CHR CHF of its end; 0 none
    std::uint8_t corner_shape = 0;
};

// Soft approach: made when the contour block behind it is known (sinumerik_part2 11.4.1).
struct SoftApproach {
    std::uint8_t form = 0;            // 0 line, 1 quarter, 2 half circle
    bool in_plane = false;            // G341
    std::uint8_t side = 0, comp = 0;  // groups 43 and 7
    double radius = 0.0;              // DISR
    double safety = 0.0, retract = 0.0;
    bool has_safety = false, safety_absolute = false, has_retract = false, retract_absolute = false;
    double infeed = 0.0;           // FAD; 0 none
    std::uint8_t infeed_mode = 0;  // 0 the active type, 1 per minute, 2 per revolution
    double feed = 0.0;
    bool has_feed = false, rapid = false;
    AxisValues from{}, target{};
    AxisSet named = 0;
    bool complete = false;  // the begin of the contour is known
    BlockContext at;
};

// WALCS: one group of limits (sinumerik_part2 15.3.2).
struct AreaGroup {
    bool workpiece = true;        // 1: in the workpiece system; 3: in the settable one
    AxisSet plus = 0, minus = 0;  // limits that act
    AxisValues high{}, low{};
};

struct GeoModal {
    FrameValue frame;        // $P_PFRAME as its components
    Frame exact;             // and as the rule that it is
    FrameValue basic_value;  // $P_ACTBFRAME as its components
    Frame basic;
    bool approach_known = false;  // $P_APDV: the last soft approach has these points
    AxisValues approach_start{}, approach_end{};  // $P_APR, $P_AEP
    double lift_mm = -1.0;                        // DILF; < 0: MD21200
    unsigned lift_angle = 1;                      // ALF
    AxisSet lift_axes = 0;                        // POLFMASK, POLFMLIN
    AxisSet lift_set = 0, lift_incremental = 0;   // POLF has named a position
    AxisValues lift_to{};                         // POLF, workpiece system
    std::array<double, 2> pole{};                 // in the plane, workpiece system
    double polar_angle_deg = 0.0, polar_radius = 0.0;
    double rounding = 0.0;     // RNDM
    double corner_feed = 0.0;  // FRCM, as F counts
    // of the last traversing block at its end, workpiece system; 0 none
    Point3 tangent{};
    double allowance = 0.0;               // OFFN
    double disc = 0.0;                    // DISC
    double thread_angle = -1.0;           // SF; < 0: the setting datum
    AxisSet area_high = 0, area_low = 0;  // G26, G25 have set them
    AxisValues high{}, low{};
    std::array<AreaGroup, 10> areas{};
    std::uint8_t side_before = 1;  // group 7 before this block's own command
    double last_feed = 0.0;        // of the last move of the contour
    std::optional<OpenLine> open_line;
    std::optional<SoftApproach> approach;
    std::uint64_t approach_serial = 0;  // block of the last one whose contour has begun
};

}  // namespace polyturn::channels::sinumerik
