#include "kernel/motion/spindle_positioner.hpp"

#include <cmath>

namespace polyturn::kernel {
namespace {
// so that the landing, which fits its jerk to the distance, always has some left
constexpr double kJerkShare = 0.98;
constexpr double kSame = 1e-12;  // rev
}  // namespace

void SpindlePositioner::take_over(double s, double v) noexcept {
    state_ = {s, v, 0};
    aims_ = landing_now_ = false;
}

void SpindlePositioner::follow(double s, double dt) noexcept {
    state_ = {s, (s - state_.s) / dt, 0};
    aims_ = landing_now_ = false;
}

double SpindlePositioner::stop_travel() const noexcept {
    return std::fabs(state_.v) > 0
               ? std::copysign(stopping_distance(std::fabs(state_.v), 0, limits_.acceleration,
                                                 kJerkShare * limits_.jerk),
                               state_.v)
               : 0.0;
}

double SpindlePositioner::beyond(double angle, bool positive) const noexcept {
    const double from = state_.s + (positive == (state_.v > 0) ? stop_travel() : 0.0);
    const double rest =
        positive ? std::ceil(from - angle - kSame) : std::floor(from - angle + kSame);
    return angle + rest;
}

double SpindlePositioner::next_in_direction(double angle) const noexcept {
    return state_.v == 0 ? nearest(angle) : beyond(angle, state_.v > 0);
}

double SpindlePositioner::nearest(double angle) const noexcept {
    const double turns = state_.s - angle;
    return angle + std::ceil(turns - 0.5 - kSame) +
           (std::ceil(turns - 0.5 - kSame) == turns - 0.5 ? 1.0 : 0.0);
}

void SpindlePositioner::go(double target) noexcept {
    if (landing_now_ && target == target_) return;
    target_ = target;
    landing_now_ = false;
    aims_ = true;
}

double SpindlePositioner::step(double dt) noexcept {
    if (landing_now_) {
        const PathState moved = landing_.step(dt);
        state_ = {state_.s + sign_ * moved.s, sign_ * moved.v, sign_ * moved.a};
        if (landing_.landed()) {
            state_ = {target_, 0, 0};
            landing_now_ = aims_ = false;
        }
        return state_.s;
    }
    const double way = aims_ ? target_ - state_.s : 0.0;
    if (aims_ && state_.v == 0 && state_.a == 0 && std::fabs(way) <= kSame) {
        state_.s = target_;
        aims_ = false;
        return state_.s;
    }
    // Mirrored so that it goes forwards.
    double sign = state_.v != 0 ? std::copysign(1.0, state_.v)
                  : way != 0    ? std::copysign(1.0, way)
                                : 1.0;
    const PathState here{0, sign * state_.v, sign * state_.a};
    const double left = sign * way;
    const double jerk = kJerkShare * limits_.jerk;
    const bool on = aims_ && left > 0;
    PathState next = towards_speed(here, on ? limits_.speed : 0.0, limits_.acceleration, jerk, dt);
    if (next.v < 0) next = {next.s, 0, 0};
    if (on && stopping_distance(next.v, next.a, limits_.acceleration, jerk) > left - next.s) {
        landing_now_ = landing_.aim(here.v, here.a, left, limits_.acceleration, limits_.jerk * 1e-6,
                                    limits_.jerk);
        // shorter than a tick can resolve
        if (!landing_now_ && here.v == 0) {
            landing_.at_once(left);
            landing_now_ = true;
        }
        if (landing_now_) {
            sign_ = sign;
            const PathState moved = landing_.step(dt);
            state_ = {state_.s + sign * moved.s, sign * moved.v, sign * moved.a};
            if (landing_.landed()) {
                state_ = {target_, 0, 0};
                landing_now_ = aims_ = false;
            }
            return state_.s;
        }
        // too fast for it: comes back from behind
        next = towards_speed(here, 0, limits_.acceleration, jerk, dt);
        if (next.v < 0) next = {next.s, 0, 0};
    }
    state_ = {state_.s + sign * next.s, sign * next.v, sign * next.a};
    return state_.s;
}

}  // namespace polyturn::kernel
