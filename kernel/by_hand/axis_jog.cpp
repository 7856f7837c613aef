#include "kernel/by_hand/axis_jog.hpp"

#include <algorithm>

namespace polyturn::kernel {

void AxisJog::start(double from, double sign, const Limits& limits, std::int64_t ticks,
                    double distance, double room, double tick_s, bool may_wait) noexcept {
    from_ = from;
    sign_ = sign;
    limits_ = limits;
    limits_.jerk = std::min(limits.jerk, 100.0 * limits.acceleration / tick_s);  // as good as none
    aims_ = distance > 0;
    ticks_ = aims_ ? 0 : ticks;
    room_ = room;
    end_ = std::max(0.0, aims_ ? std::min(distance, room) : room);
    state_ = {};
    landing_now_ = false;
    active_ = end_ > 0 && (limits.speed > 0 || may_wait) && limits.acceleration > 0;
}

void AxisJog::keep_distance(double distance, double sign) noexcept {
    const double end = std::min(state_.s + distance, room_);
    if (!active_ || !aims_ || sign != sign_ || end <= end_) return;
    end_ = end;
    landing_now_ = false;  // if it can stop at the nearer end, it can at the farther one
}

double AxisJog::step(double tick_s) noexcept {
    if (!landing_now_) {
        const bool wanted = aims_ || ticks_-- > 0;
        const PathState next = towards_speed(state_, wanted ? limits_.speed : 0.0,
                                             limits_.acceleration, 0.98 * limits_.jerk, tick_s);
        const double left = end_ - state_.s;
        // The next state must still be able to stop at the end; if it is not, land now: this state
        // still can.
        if (left < 1e300 && stopping_distance(next.v, next.a, limits_.acceleration,
                                              0.98 * limits_.jerk) > end_ - next.s) {
            landing_now_ = landing_.aim(state_.v, state_.a, left, limits_.acceleration,
                                        limits_.jerk * 1e-6, limits_.jerk);
            // shorter than a tick can resolve
            if (!landing_now_ && state_.v == 0) {
                landing_.at_once(left);
                landing_now_ = true;
            }
        }
        if (!landing_now_) {
            state_ = next;
            if (!wanted && state_.v == 0 && state_.a == 0) active_ = false;
        }
    }
    if (landing_now_) {
        const PathState moved = landing_.step(tick_s);
        state_ = {state_.s + moved.s, moved.v, moved.a};
        if (landing_.landed()) {
            state_ = {end_, 0, 0};
            active_ = false;
        }
    }
    return from_ + sign_ * state_.s;
}

}  // namespace polyturn::kernel
