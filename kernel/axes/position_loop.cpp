#include "kernel/axes/position_loop.hpp"

#include <algorithm>
#include <cmath>

namespace polyturn::kernel {
namespace {
constexpr double kPi = 3.14159265358979323846;
// the backlash is taken up within about this time, not in one step
constexpr double kPlayS = 0.01;
constexpr double kSettleS = 0.2;   // a stop's lag has died out by then, if the drive follows
constexpr double kFadeEnd = 0.01;  // below this share a fading boost is over
// First-order filter over a tick; no time constant: through.
double low_pass(double now, double in, double tick_s, double time_s) noexcept {
    return time_s > 0 ? now + (in - now) * tick_s / (time_s + tick_s) : in;
}
}  // namespace

void PositionLoop::configure(const ServoConfig& config, double tick_s) noexcept {
    config_ = config;
    tick_s_ = tick_s;
    lag_s_ = 2.0 * config.drive_damping / (2.0 * kPi * config.drive_hz);
    standing_ticks_ = std::llround(std::max(kSettleS, 5.0 * config.model_s) / tick_s);
}

void PositionLoop::reset(double position) noexcept {
    command_ = p1_ = p2_ = pe_ = slide_ = filtered_ = model_ = position;
    delay_.fill(position);
    past_.fill(position);
    lag_ = 0;
    v1_ = error_ = correction_ = 0;
    still_ticks_ = 2;
    reversal_ = start_ = {};
    dual_differs_ = false;
}

void PositionLoop::shift(double by) noexcept {
    for (double* p : {&command_, &p1_, &p2_, &pe_, &slide_, &filtered_, &model_}) *p += by;
    for (double& p : delay_) p += by;
    for (double& p : past_) p += by;
    reversal_.from += by;
    start_.from += by;
}

double PositionLoop::faded(Boost& boost) noexcept {
    if (!boost.fading) return 0.0;
    const double share = config_.fade / static_cast<double>(++boost.ticks);
    if (share < kFadeEnd || share > 1e6) boost.fading = false;
    return boost.speed * std::min(share, 1.0);
}

// N0525 to N0532: a speed that does not wait for the following error to grow.
double PositionLoop::boosts(double target, double ordinary) noexcept {
    const double way = target - command_;
    const std::int32_t direction = way > 0 ? 1 : way < 0 ? -1 : 0;
    if (direction != 0) {
        if (config_.reversal_boost && direction_ != 0 && direction != direction_)
            reversal_ = {config_.reversal_speed * direction, 0, command_, true, false};
        if (config_.start_boost && static_cast<double>(still_ticks_) * tick_s_ >= config_.stood_s)
            start_ = {config_.start_speed * direction, 0, command_, true, false};
        direction_ = direction;
    }
    double sum = 0;
    if (reversal_.on) {
        sum += reversal_.speed;
        ++reversal_.ticks;
        const bool late = static_cast<double>(reversal_.ticks) * tick_s_ >= config_.reversal_s;
        if (late || (config_.boost_ends_by_way &&
                     std::fabs(target - reversal_.from) >= config_.reversal_travel))
            reversal_.end(config_.fade);
    } else {
        sum += faded(reversal_);
    }
    if (start_.on) {
        sum += start_.speed;
        const bool reached = std::fabs(ordinary) >= std::fabs(start_.speed);
        if (reached ||
            (config_.start_ends_by_way && std::fabs(target - start_.from) >= config_.start_travel))
            start_.end(config_.fade);
    } else {
        sum += faded(start_);
    }
    return sum;
}

// The mean of the last commands: what has steps in its third derivative has none behind it, and
// nothing else grows. Another length acts from a standstill.
double PositionLoop::smoothed(double target) noexcept {
    const auto wanted = static_cast<std::uint32_t>(std::clamp<long>(
        std::lround(config_.smooth_s / tick_s_), 1, static_cast<long>(past_.size())));
    if (wanted != mean_of_ && still_ticks_ > 1 && lag_ == 0) mean_of_ = wanted;
    past_at_ = (past_at_ + 1) % static_cast<std::uint32_t>(past_.size());
    past_[past_at_] = target;
    if (mean_of_ <= 1) {
        lag_ = 0;
        return target;
    }
    bool same = true;
    // of what the commands lie off the newest one: nothing is left when they are alike
    double sum = 0;
    for (std::uint32_t n = 0; n < mean_of_; ++n) {
        const double p = past_[(past_at_ + past_.size() - n) % past_.size()];
        sum += p - target;
        same = same && p == target;
    }
    lag_ = same ? 0.0 : -sum / mean_of_;
    return target - lag_;
}

double PositionLoop::speed(double target, bool rapid) noexcept {
    target = smoothed(target);
    fed_forward_ = config_.feedforward > 0 &&
                   (tap_gain_ > 0 ? tap_feedforward_ : !rapid || config_.feedforward_in_rapid);
    double e = error_ + config_.offset + drift_;
    if (e != 0 && std::fabs(e) <= config_.threshold) e = std::copysign(config_.threshold, e);
    const double p1 = low_pass(p1_, target, tick_s_, config_.filter_s);
    const double v1 = (p1 - p1_) / tick_s_, a1 = (v1 - v1_) / tick_s_;
    const double ordinary = (tap_gain_ > 0 ? tap_gain_ : config_.gain) * e;
    double out = ordinary;
    if (fed_forward_) out += config_.feedforward * (v1 + lag_s_ * a1);
    out += boosts(target, ordinary);
    if (config_.full_speed > 0) out = std::clamp(out, -config_.full_speed, config_.full_speed);

    still_ticks_ = target != command_ ? 0 : still_ticks_ + 1;
    if (config_.drift_s > 0 && standing()) drift_ += error_ * tick_s_ / config_.drift_s;
    // What the error of this moment is measured against; the next tick uses it.
    pe_ = fed_forward_ && config_.dead_s > 0
              ? delay_[(delay_at_ + delay_.size() -
                        std::min<std::size_t>(
                            static_cast<std::size_t>(std::llround(config_.dead_s / tick_s_)),
                            delay_.size() - 1)) %
                       delay_.size()]
          : fed_forward_ && config_.equal_s > 0 ? p2_
                                                : p1_;
    // The loop's lag as far as feed-forward leaves it, and the drive's own where nothing makes up
    // for it.
    const double left = 1.0 - (fed_forward_ ? config_.feedforward : 0.0);
    filtered_ = low_pass(filtered_, command_, tick_s_, config_.model_s * lag_scale() * left);
    model_ = low_pass(model_, filtered_, tick_s_, fed_forward_ ? 0.0 : lag_s_);
    command_ = target;
    p1_ = p1;
    v1_ = v1;
    p2_ = low_pass(p2_, p1, tick_s_, config_.equal_s);
    delay_at_ = (delay_at_ + 1) % static_cast<std::uint32_t>(delay_.size());
    delay_[delay_at_] = p2_;
    return out;
}

// Motor to slide: the backlash that the direction of travel has taken up.
double PositionLoop::compensated(double motor) noexcept {
    if (config_.backlash == 0) return motor;
    const double wanted = direction_ < 0 ? -config_.backlash : 0.0;
    play_ = low_pass(play_, wanted, tick_s_, kPlayS);
    return motor - play_;
}

void PositionLoop::measured(double motor) noexcept {
    slide_ = compensated(motor);
    error_ = pe_ - slide_;
}

void PositionLoop::measured_direct(double motor, double slide) noexcept {
    const double indirect = pe_ - compensated(motor), direct = pe_ - slide;
    double difference = direct - indirect;
    if (std::fabs(difference) < config_.dual_least) difference = 0;
    correction_ = low_pass(correction_, difference, tick_s_, config_.dual_s);
    if (config_.dual_most > 0)
        correction_ = std::clamp(correction_, -config_.dual_most, config_.dual_most);
    dual_differs_ = config_.dual_error > 0 && std::fabs(slide - motor) > config_.dual_error;
    slide_ = slide;
    error_ = indirect + correction_;
}

}  // namespace polyturn::kernel
