#include "kernel/channel/thread_retract.hpp"

#include <algorithm>
#include <cmath>

namespace polyturn::kernel {
namespace {

constexpr double kNothing = 1e-9;  // mm
// of an axis' speed that is left to the retract from the thread
constexpr double kLeastShare = 0.1;
// of acceleration and jerk: the thread follows the encoder with the rest
constexpr double kMargin = 0.9;

// The slot of the axis that the thread travels along.
std::uint32_t lead_slot(const PathRecord& r) noexcept {
    std::uint32_t most = 0;
    for (std::uint32_t k = 1; k < r.axis_count; ++k)
        if (std::fabs(r.end[k] - r.start[k]) > std::fabs(r.end[most] - r.start[most])) most = k;
    return most;
}

}  // namespace

bool ThreadRetract::begin(const PathRecord& r, const std::array<AxisUnit, kMaxAxes>& axes,
                          double path_speed, double tick_s) noexcept {
    double square = 0;
    for (std::uint32_t k = 0; k < r.axis_count; ++k) square += of(r, k) * of(r, k);
    length_ = std::sqrt(square);
    if (length_ < kNothing) return false;
    AxisJog::Limits limits{kUnlimited, kUnlimited, kUnlimited};
    slots_ = 0;
    for (std::uint32_t k = 0; k < r.axis_count; ++k) {
        const double way = of(r, k);
        if (way == 0.0) continue;
        const AxisConfig& axis = axes[r.axis[k]].config();
        const double share = std::fabs(way) / length_;
        const double taken =
            r.length > 0 ? path_speed * std::fabs(r.end[k] - r.start[k]) / r.length : 0.0;
        limits.speed =
            std::min(limits.speed, std::max(axis.rapid - taken, kLeastShare * axis.rapid) / share);
        limits.acceleration = std::min(limits.acceleration, kMargin * axis.acceleration / share);
        limits.jerk = std::min(limits.jerk, kMargin * axis.jerk / share);
        axis_[slots_] = r.axis[k];
        share_[slots_++] = way / length_;
    }
    offset_ = 0;
    jog_.start(0.0, 1.0, limits, 0, length_, kUnlimited, tick_s);
    if (!jog_.active()) return false;
    phase_ = Phase::Leaving;
    return true;
}

void ThreadRetract::move_axes(std::array<AxisUnit, kMaxAxes>& axes, double tick_s) noexcept {
    if (phase_ != Phase::Leaving && phase_ != Phase::Clear) return;
    if (jog_.active()) offset_ = jog_.step(tick_s);
    if (phase_ == Phase::Leaving && !jog_.active() && offset_ >= length_ - kNothing)
        phase_ = Phase::Clear;
    for (std::uint32_t k = 0; k < slots_; ++k)
        axes[axis_[k]].move_to(axes[axis_[k]].own_target() + share_[k] * offset_);
}

// The travel of this leg; false: it has none.
bool ThreadRetract::begin_leg(const PathRecord& r, const std::array<AxisUnit, kMaxAxes>& axes,
                              double tick_s) noexcept {
    const std::uint32_t lead = lead_slot(r);
    double square = 0;
    slots_ = 0;
    for (std::uint32_t k = 0; k < r.axis_count; ++k) {
        const bool across = k != lead && of(r, k) != 0.0;
        if (across != (phase_ == Phase::Across)) continue;
        const double way = r.start[k] - axes[r.axis[k]].own();
        if (std::fabs(way) < kNothing) continue;
        axis_[slots_] = r.axis[k];
        from_[slots_] = axes[r.axis[k]].own();
        share_[slots_++] = way;
        square += way * way;
    }
    length_ = std::sqrt(square);
    if (slots_ == 0) return false;
    AxisJog::Limits limits{kUnlimited, kUnlimited, kUnlimited};
    for (std::uint32_t k = 0; k < slots_; ++k) {
        share_[k] /= length_;
        const AxisConfig& axis = axes[axis_[k]].config();
        const double share = std::fabs(share_[k]);
        limits.speed = std::min(limits.speed, axis.rapid / share);
        limits.acceleration = std::min(limits.acceleration, axis.acceleration / share);
        limits.jerk = std::min(limits.jerk, axis.jerk / share);
    }
    jog_.start(0.0, 1.0, limits, 0, length_, kUnlimited, tick_s);
    return jog_.active();
}

bool ThreadRetract::step_back(const PathRecord& r, std::array<AxisUnit, kMaxAxes>& axes, bool go,
                              double tick_s) noexcept {
    if (!jog_.active()) {
        if (!go) return false;
        if (phase_ == Phase::Out) phase_ = Phase::Along;
        if (!begin_leg(r, axes, tick_s)) {
            if (phase_ == Phase::Across) return true;
            phase_ = Phase::Across;
            if (!begin_leg(r, axes, tick_s)) return true;
        }
    }
    if (!go) jog_.stop();
    offset_ = jog_.step(tick_s);
    for (std::uint32_t k = 0; k < slots_; ++k)
        axes[axis_[k]].move_to(from_[k] + share_[k] * offset_);
    return false;
}

}  // namespace polyturn::kernel
