#include "kernel/motion/spindle_observer.hpp"

#include <algorithm>
#include <cmath>

namespace polyturn::kernel {
namespace {
constexpr double kFastPole = 60, kSlowPole = 10;  // 1/s
constexpr double kTrust = 1.1;                    // counts; half a count is the staircase itself
// the slow filter's pole is this over its age, from kFastPole down to kSlowPole
constexpr double kMemoryGrowth = 3;
constexpr std::int32_t kSettled = 300;  // ticks
constexpr double kFade = 1.0 / 100;     // a tick
}  // namespace

void SpindleObserver::Filter::predict(double t) noexcept {
    angle = at(t);
    speed = speed_at(t);
    acceleration += t * jerk;
}

void SpindleObserver::configure(double dt, double counts_per_rev, double delay) noexcept {
    dt_ = dt;
    degrees_per_count_ = 360.0 / counts_per_rev;
    delay_ = delay;
    fast_pole_ = std::exp(-kFastPole * dt);
    slow_pole_ = std::exp(-kSlowPole * dt);
    known_ = false;
}

void SpindleObserver::reset(std::int64_t counts) noexcept {
    origin_ = counts;
    turned_ = static_cast<double>(counts) * degrees_per_count_;
    fast_ = slow_ = {degrees_per_count_ / 2, 0, 0, 0};
    trust_ = 0;
    calm_ = 0;
    known_ = true;
}

void SpindleObserver::update(std::int64_t counts) noexcept {
    if (!known_) reset(counts);
    fast_.predict(dt_);
    slow_.predict(dt_);
    const double measured = (static_cast<double>(counts - origin_) + 0.5) * degrees_per_count_;
    {
        const double p = fast_pole_, u = 1 - p, error = measured - fast_.angle;
        fast_.angle += (1 - p * p * p * p) * error;
        fast_.speed += u * u * (11 + 14 * p + 11 * p * p) / 6 / dt_ * error;
        fast_.acceleration += 2 * u * u * u * (1 + p) / (dt_ * dt_) * error;
        fast_.jerk += u * u * u * u / (dt_ * dt_ * dt_) * error;
    }
    const double error = measured - slow_.angle;
    if (std::abs(error) > kTrust * degrees_per_count_) {
        slow_ = {fast_.angle, fast_.speed, fast_.acceleration, 0};
        calm_ = 0;
    } else {
        const double p =
            calm_ < kSettled
                ? std::exp(-std::max(kSlowPole, kMemoryGrowth / (dt_ * (calm_ + 1) +
                                                                 kMemoryGrowth / kFastPole)) *
                           dt_)
                : slow_pole_;
        const double u = 1 - p;
        slow_.angle += (1 - p * p * p) * error;
        slow_.speed += 1.5 * u * u * (1 + p) / dt_ * error;
        slow_.acceleration += u * u * u / (dt_ * dt_) * error;
        if (calm_ < kSettled) ++calm_;
    }
    trust_ = calm_ < kSettled ? std::max(0.0, trust_ - 5 * kFade) : std::min(1.0, trust_ + kFade);
    // A revolution at a time, so that relative angles stay small.
    const double revolution = 360;
    const auto counts_per_rev =
        static_cast<std::int64_t>(std::llround(revolution / degrees_per_count_));
    const auto whole = (counts - origin_) / counts_per_rev;
    if (whole != 0) {
        origin_ += whole * counts_per_rev;
        const double shift =
            static_cast<double>(whole) * static_cast<double>(counts_per_rev) * degrees_per_count_;
        turned_ = static_cast<double>(origin_) * degrees_per_count_;
        fast_.angle -= shift;
        slow_.angle -= shift;
    }
}

double SpindleObserver::angle(double ahead) const noexcept {
    const double t = delay_ + ahead;
    return turned_ + (1 - trust_) * fast_.at(t) + trust_ * slow_.at(t);
}

double SpindleObserver::speed(double ahead) const noexcept {
    const double t = delay_ + ahead;
    return (1 - trust_) * fast_.speed_at(t) + trust_ * slow_.speed_at(t);
}

double SpindleObserver::acceleration(double ahead) const noexcept {
    return (1 - trust_) * (fast_.acceleration + (delay_ + ahead) * fast_.jerk) +
           trust_ * slow_.acceleration;
}

}  // namespace polyturn::kernel
