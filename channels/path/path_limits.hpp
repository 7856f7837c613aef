// What the path maker needs of the machine: the limits of each axis and the channel's rules for
// corners. Copied at barriers, because parameters that a channel uses change there only
// (architecture 8).
#pragma once
#include <array>

#include "ipc/model/machine/machine_config.hpp"

namespace polyturn::channels {

struct PathAxis {
    double rapid = 0, feed = 0;                 // mm/s (deg/s): N0304, N0305
    double accel = 0, normal = 0;               // mm/s2: N0400, N0402
    double jerk = 0;                            // mm/s3: N0400 / N0401, infinite without limit
    double speed_step = 0;                      // mm/s: N0309; 0 no limit
    double accel_step = 0, accel_step_arc = 0;  // mm/s2: N0403, N0404; 0 no limit
    bool rotary = false;
    // N0422: share of rapid below which the next rapid move may begin
    double overlap = 0.5;
};

struct PathLimits {
    std::array<PathAxis, kMaxAxes> axis{};  // by machine axis (from 0)
    double tolerance = 0.005;               // mm (deg): PT_PATH_TOL; 0: every corner is a stop
    // rad: corners that turn by more are driven exactly (fagor G51 B); 4: none for this
    double square_turn = 4;
    bool corner_by_axis_step = false;  // N0306 FDF: N0309 decides, not N0307 and N0308
    double corner_angle = 0;           // rad: N0307; 0 no limit
    double corner_feed = 0;            // mm/s: N0308
    double arc_feed_min = 0;           // mm/s: N0310
    bool rapid_overlaps = false;       // N0421 ROL: rapid moves need no stop at their ends
    bool rapid_in_position = false;    // N1337 PCH
};

// What the program asks of runs of short lines beyond PT_PATH_TOL (nct part 2 32: G5.1 Q2, Q3).
struct Smoothing {
    bool on = false;
    double tolerance = 0;              // mm: N3104 (Q2), N3106 (Q3)
    double rotary = 0;                 // deg: N3108 for angles; 0 as the tolerance
    double longest = 0, shortest = 0;  // mm: N3100, N3101; other lines stay lines
    double turn = 0;                   // rad: N3102; sharper corners interrupt
    double least = 0;                  // mm: N3105; what would bend by less stays a line
    // mm: N3107; lines shorter than this are smoothed whatever their corners (Q3)
    double always_below = 0;
};
Smoothing smoothing_of(const params::Table& parameters, const MachineConfig& machine,
                       unsigned channel, int kind);

PathLimits path_limits(const MachineConfig& machine, const params::Table& parameters,
                       unsigned channel);

}  // namespace polyturn::channels
