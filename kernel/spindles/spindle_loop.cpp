#include "kernel/spindles/spindle_loop.hpp"

#include <algorithm>
#include <cmath>

namespace polyturn::kernel {
namespace {
double share(double dt, double time_s) noexcept {
    return time_s > 0 ? 1.0 - std::exp(-dt / time_s) : 1.0;
}
}  // namespace

double SpindleLoop::close(double measured, double speed, const SpindleRange& range, double gain,
                          double feedforward) noexcept {
    error_ = gain > 0 ? speed * (1.0 - feedforward) / gain : 0.0;
    command_ = filtered_ = equalised_ = reference_ = measured + error_;
    model_ = measured;
    drift_ = 0;
    delayed_.fill(command_);
    (void)range;
    return command_;
}

double SpindleLoop::output(double command, double dt, const SpindleRange& range, double gain,
                           double feedforward) noexcept {
    const double before = filtered_;
    command_ = command;
    filtered_ += (command - filtered_) * share(dt, range.command_filter_s);
    // error_ and the reference it was taken from are of the tick's start, as in AxisUnit.
    return gain * (error_ + drift_) + feedforward * (filtered_ - before) / dt;
}

SpindleLoop::Fault SpindleLoop::observe(double measured, double dt, bool moving,
                                        const SpindleRange& range, double scale,
                                        double lag) noexcept {
    error_ = reference_ - measured;
    const double deviation = std::fabs(measured - model_);
    // What the next measurement is compared with: the reference of the end of this tick.
    equalised_ += (filtered_ - equalised_) * share(dt, range.equalise_s);
    delayed_[delay_at_] = equalised_;
    const auto ticks =
        std::min<std::size_t>(static_cast<std::size_t>(range.dead_time_s / dt + 0.5), kDelay - 1);
    reference_ = delayed_[(delay_at_ + kDelay - ticks) % kDelay];
    delay_at_ = (delay_at_ + 1) % kDelay;
    model_ += (command_ - model_) * share(dt, range.model_s * lag);
    if (range.error_absolute > 0 && std::fabs(error_) > range.error_absolute * scale)
        return Fault::Absolute;
    // N0709: what an analogue output drifts
    if (range.drift_s > 0 && !moving) drift_ += error_ * dt / range.drift_s;
    const double limit = moving ? range.error_moving : range.error_standing;
    if (limit > 0 && deviation > limit) return moving ? Fault::Moving : Fault::Standstill;
    return Fault::None;
}

}  // namespace polyturn::kernel
