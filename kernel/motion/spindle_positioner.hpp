// The commanded position of a spindle whose position loop is closed: from any position and speed to
// rest at an angle, within speed, acceleration and jerk. All in revolutions, counted over all
// revolutions.
//
//   take_over(s, v)   the loop closes on a spindle, turning or at standstill
//   go(target)        by the shortest travel that a spindle of this speed has: it brakes and comes
//                     back only if it must
//   follow(s)         somebody else says where it is (tapping, interpolation)
#pragma once
#include "kernel/motion/landing.hpp"

namespace polyturn::kernel {

class SpindlePositioner {
public:
    struct Limits {
        double speed = 0, acceleration = 0, jerk = 0;  // rev/s, rev/s2, rev/s3
    };
    void take_over(double s, double v) noexcept;
    void limits(const Limits& limits) noexcept { limits_ = limits; }
    void go(double target) noexcept;
    void stop() noexcept { aims_ = landing_now_ = false; }  // brakes and stays
    void follow(double s, double dt) noexcept;
    // the position at the end of this tick
    double step(double dt) noexcept;

    // Where a spindle that turns now comes to rest at an angle (part of a revolution) without
    // turning back.
    [[nodiscard]] double next_in_direction(double angle) const noexcept;
    // half a revolution: positive
    [[nodiscard]] double nearest(double angle) const noexcept;
    // the angle is reached in that direction
    [[nodiscard]] double beyond(double angle, bool positive) const noexcept;

    [[nodiscard]] bool resting() const noexcept {
        return state_.v == 0 && state_.a == 0 && !aims_ && !landing_now_;
    }
    [[nodiscard]] double position() const noexcept { return state_.s; }
    [[nodiscard]] double speed() const noexcept { return state_.v; }
    [[nodiscard]] double target() const noexcept {
        return aims_ || landing_now_ ? target_ : state_.s;
    }

private:
    [[nodiscard]] double stop_travel() const noexcept;
    PathState state_;
    Limits limits_;
    double target_ = 0, sign_ = 1;
    bool aims_ = false, landing_now_ = false;
    Landing landing_;
};

}  // namespace polyturn::kernel
