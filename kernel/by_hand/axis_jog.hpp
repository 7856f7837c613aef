// One axis moved by hand (jog, step, handwheel): asynchronous motion that needs no channel process
// (architecture 5.7). Within the axis' velocity, acceleration and jerk; stops before the end of the
// stroke.
#pragma once
#include <cstdint>

#include "kernel/motion/landing.hpp"

namespace polyturn::kernel {

class AxisJog {
public:
    struct Limits {
        double speed = 0, acceleration = 0, jerk = 0;  // jerk may be infinite
    };
    // Away from `from` in the direction of `sign`: for `ticks` (then it brakes), or exactly
    // `distance`; never beyond `room`.
    // `may_wait`: a speed of 0 waits for limit_speed().
    void start(double from, double sign, const Limits& limits, std::int64_t ticks, double distance,
               double room, double tick_s, bool may_wait = false) noexcept;
    // brakes
    void stop() noexcept {
        ticks_ = 0;
        aims_ = false;
    }
    // The key is still held: at least so many ticks more in that direction. A jog that has begun to
    // brake stays at it.
    void keep(std::int64_t ticks, double sign) noexcept {
        if (active_ && !aims_ && sign == sign_ && ticks_ > 0 && ticks > ticks_) ticks_ = ticks;
    }
    // Of a jog by distance: at least so far from the present position, if it goes in that
    // direction. The present target is not added to.
    void keep_distance(double distance, double sign) noexcept;
    bool active() const noexcept { return active_; }
    // of what is still to be driven; 0: it is stopped and waits
    void limit_speed(double speed) noexcept { limits_.speed = speed; }
    bool stands() const noexcept { return state_.v == 0 && limits_.speed == 0; }
    double sign() const noexcept { return sign_; }
    bool ran() const noexcept { return state_.s > 0; }
    void shift(double by) noexcept { from_ += by; }  // the axis' coordinate was moved
    // The position at the end of this tick.
    double step(double tick_s) noexcept;

private:
    bool active_ = false, aims_ = false, landing_now_ = false;
    double from_ = 0, sign_ = 1, end_ = 0;  // end_: s at which it must be stopped
    double room_ = 0;
    Limits limits_;
    std::int64_t ticks_ = 0;
    PathState state_;
    Landing landing_;
};

}  // namespace polyturn::kernel
