// What the path maker must know of the machine: the limits of each axis and the channel's rules for corners.
// Copied at barriers, because parameters that a channel uses change there only (architecture 8).
#pragma once
#include <array>

#include "ipc/machine/machine_config.hpp"

namespace polyturn::channels {

struct PathAxis {
    double rapid = 0, feed = 0;          // mm/s (deg/s): N0304, N0305
    double accel = 0, normal = 0;        // mm/s2: N0400, N0402
    double jerk = 0;                     // mm/s3: N0400 / N0401, infinite without limit
    double speed_step = 0;               // mm/s: N0309; 0 no ceiling
    double accel_step = 0, accel_step_arc = 0;  // mm/s2: N0403, N0404; 0 no ceiling
    bool rotary = false;
};

struct PathLimits {
    std::array<PathAxis, kMaxAxes> axis{};   // by machine axis (from 0)
    double tolerance = 0.005;            // mm (deg): PT_PATH_TOL; 0: every corner is a stop
    bool corner_by_axis_step = false;    // N0306 FDF: N0309 decides, not N0307 and N0308
    double corner_angle = 0;             // rad: N0307; 0 no ceiling
    double corner_feed = 0;              // mm/s: N0308
    double arc_feed_min = 0;             // mm/s: N0310
    bool rapid_overlaps = false;         // N0421 ROL: rapid moves need no stop at their ends
    bool rapid_in_position = false;      // N1337 PCH
};

PathLimits path_limits(const MachineConfig& machine, const params::Table& parameters, unsigned channel);

}  // namespace polyturn::channels
