// A drive that exists only as numbers: its speed follows the commanded one as a second-order system, it counts whole
// increments, latches them at the start of the tick, and it can be told to fail. It speaks through drive.h like any other.
#pragma once
#include <array>
#include <cstdint>

#include "kernel/drives/drive.h"

namespace polyturn::kernel {

const PolyturnDriveApi& simulated_drive_api();

// State x = (position, speed, acceleration) in units (mm, degrees, revolutions), u the commanded speed, held for a tick:
//     p' = v    v' = a    a' = w^2 (u - v) - 2 d w a
// The step over one tick is exact: x(t+T) = A x(t) + B u with A = exp(F T), so the result does not depend on the tick,
// and a stiff drive (w T near 1) stays stable, which an Euler step would not.
class SimulatedDrive {
public:
    explicit SimulatedDrive(const PolyturnDriveSetup& setup);
    void exchange(const PolyturnDriveCommand& command, PolyturnDriveStatus& status) noexcept;
    void fail(bool on) noexcept { failing_ = on; }
    // What no real drive could tell: the truth behind the encoder. Units and units per second, now.
    double true_position() const noexcept { return position_; }
    double true_speed() const noexcept { return speed_; }

private:
    void step(double commanded) noexcept;
    std::array<std::array<double, 3>, 3> a_{};
    std::array<double, 3> b_{};
    double increments_per_unit_;
    double position_, speed_ = 0, acceleration_ = 0;
    double rounding_;  // fine scales are read to the nearest increment; coarse encoders count the lines passed
    std::uint16_t state_ = POLYTURN_DRIVE_SWITCH_ON_DISABLED;
    std::uint16_t last_control_ = 0;
    bool failing_ = false;
};

}  // namespace polyturn::kernel
