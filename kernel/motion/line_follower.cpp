#include "kernel/motion/line_follower.hpp"

#include <algorithm>
#include <cmath>

namespace polyturn::kernel {
namespace {
constexpr double kPole = 120;  // 1/s, of what is left to the line
// of the acceleration: the largest step of it that the line makes
constexpr double kStepShare = 0.3;
constexpr double kShareA = 0.6, kShareJ = 0.6;  // of the limits for closing a gap
constexpr double kLongest = 600;                // s
constexpr int kTries = 64;
constexpr double kGrowth = 1.2;
// of the quintic that bridges a distance in unit time
constexpr double kPeakA = 5.78, kPeakJ = 60, kPeakV = 1.875;
// of the one that bridges a step of speed
constexpr double kStepA = 1.5, kStepJ = 6;
}  // namespace

double LineFollower::fitting_time(double e, double e1, double e2,
                                  double line_speed) const noexcept {
    const double a = kShareA * limits_.acceleration, j = kShareJ * limits_.jerk;
    double time =
        std::max({kStepA * std::fabs(e1) / a, std::sqrt(kStepJ * std::fabs(e1) / j), 0.01});
    for (int i = 0; i < kTries && time < kLongest; ++i, time *= kGrowth) {
        const double rest = std::fabs(e + e1 * time / 2);
        const bool fits_a =
            kStepA * std::fabs(e1) / time + kPeakA * rest / (time * time) + std::fabs(e2) <=
            a + std::fabs(e2);
        const bool fits_j =
            kStepJ * std::fabs(e1) / (time * time) + kPeakJ * rest / (time * time * time) <= j;
        const bool fits_v = kPeakV * rest / time <=
                            std::max(limits_.speed - std::fabs(line_speed), 0.05 * limits_.speed);
        if (fits_a && fits_j && fits_v) break;
    }
    return time;
}

void LineFollower::begin(const PathState& now, const PathState& line, const Limits& limits, Aim aim,
                         double period, double dt) noexcept {
    limits_ = limits;
    limits_.jerk = std::min(limits.jerk, 100 * limits.acceleration / dt);
    state_ = now;
    sum_ = e_ = 0;
    too_slow_ = false;
    const double e1 = now.v - line.v, e2 = now.a - line.a;
    // The offset with which nothing but the step of speed is left to bridge.
    const double a = kShareA * limits_.acceleration, j = kShareJ * limits_.jerk;
    const double gentlest =
        std::max(kStepA * std::fabs(e1) / a, std::sqrt(kStepJ * std::fabs(e1) / j));
    const double ideal = now.s - line.s + e1 * gentlest / 2;
    offset_ = aim == Aim::Anywhere               ? ideal
              : aim == Aim::Period && period > 0 ? std::round(ideal / period) * period
                                                 : 0.0;
    const double e = now.s - line.s - offset_;
    if (e == 0 && e1 == 0 && e2 == 0) {
        gap_.clear();
        return;
    }
    gap_.begin({e, e1, e2}, fitting_time(e, e1, e2, line.v));
}

PathState LineFollower::tick(const PathState& line, double dt) noexcept {
    const ClosingGap::Value gap = gap_.tick(dt);
    e_ = gap.e;
    // Where it would be at the tick's end without jerk, and what is then left.
    const PathState free = advanced(state_, 0, dt);
    const double d = line.s + offset_ + e_ - free.s, d1 = line.v + gap.e1 - free.v,
                 d2 = line.a + gap.e2 - free.a;
    // The line's acceleration may step; the answer to it, 4 p d'', must stay within the jerk or the
    // whole would swing.
    const double p = std::min(kPole, limits_.jerk / (5.0 * kStepShare * limits_.acceleration));
    const double limit = 0.99 * limits_.jerk, most = limits_.acceleration;
    double jerk = p * p * p * (p * sum_ + 4 * d) + 6 * p * p * d1 + 4 * p * d2;
    if (std::fabs(jerk) < limit) sum_ += d * dt;
    jerk = std::clamp(jerk, std::max(-limit, (-most - state_.a) / dt),
                      std::min(limit, (most - state_.a) / dt));
    PathState next = advanced(state_, jerk, dt);
    const double way = next.v < 0 ? -1.0 : 1.0;
    too_slow_ = way * release_speed(next.v, next.a * way > 0 ? next.a : 0.0, limit) > limits_.speed;
    if (too_slow_) {
        const PathState held =
            towards_speed({0, way * state_.v, way * state_.a}, limits_.speed, most, limit, dt);
        next = {state_.s + way * held.s, way * held.v, way * held.a};
    }
    return state_ = next;
}

PathState LineFollower::brake(double dt) noexcept {
    const double way = state_.v < 0 || (state_.v == 0 && state_.a < 0) ? -1.0 : 1.0;
    PathState next = towards_speed({0, way * state_.v, way * state_.a}, 0.0, limits_.acceleration,
                                   0.98 * limits_.jerk, dt);
    if (next.v < 0) next = {next.s, 0, 0};
    return state_ = {state_.s + way * next.s, way * next.v, way * next.a};
}

}  // namespace polyturn::kernel
