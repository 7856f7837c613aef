// Coming to rest exactly at a point: a braking profile whose jerk is chosen so that its length is
// the distance left, then driven to its end without another decision. The last phase is computed
// backwards from the end, so the end is exact.
#pragma once
#include "kernel/motion/jerk_profile.hpp"

namespace polyturn::kernel {

class Landing {
public:
    // From (v, a), distance before the point, with a jerk between j_least and j_most. False if none
    // of them fits.
    [[nodiscard]] bool aim(double v, double a, double distance, double a_max, double j_least,
                           double j_most) noexcept;
    // The next dt: s is what is moved in it. At rest exactly when landed().
    PathState step(double dt) noexcept;
    [[nodiscard]] bool landed() const noexcept { return landed_; }
    [[nodiscard]] double jerk() const noexcept { return jerk_; }
    // A rest too short to be driven (rounding of an earlier stop) is taken at once.
    void at_once(double distance) noexcept;

private:
    SpeedProfile profile_;
    PathState start_;
    double time_ = 0, distance_ = 0, moved_ = 0, jerk_ = 0;
    bool landed_ = false;
};

}  // namespace polyturn::kernel
