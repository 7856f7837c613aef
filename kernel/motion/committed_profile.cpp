// The committed profile: motion to standstill that was found safe as a whole. It consists of a push
// of up to kPush ticks (or none) and a braking behind it. While it is valid and nothing else is
// wanted a tick only follows it; decisions are made near its ends.
//
//   v |      push     .----.  braking, perhaps by way of
//     |          . - '      \   a slower stretch
//     |     . - '            '------.        committed_time_ counts from the end of the push
//     +---'--------------------------'---> t
#include <cmath>

#include "kernel/motion/path_planner.hpp"

namespace polyturn::kernel {
namespace {
constexpr double kFast = 1e6;             // mm/s: as hard as can be
constexpr std::uint32_t kMaxTimeout = 4;  // ticks
// ticks before standstill: each one is checked, for the landing
constexpr double kNearEnd = 8;
constexpr double kEntering = 2e-3;  // as in braking.cpp
}  // namespace

void PathPlanner::drop_committed() noexcept {
    committed_time_ = -1;
    pushed_ = push_end_ = timeout_ = failures_ = 0;
    stride_ = 1;
    committed_aims_ = other_wanted_ = false;
    committed_end_ = kNone;
}

// tried_ is found safe.
void PathPlanner::commit(SpeedLimits which) noexcept {
    std::swap(committed_, tried_);
    committed_time_ = 0;
    committed_wanted_ = which == SpeedLimits::Wanted;
    committed_aims_ = committed_.aims();
    committed_end_ = view_.closed() ? view_.end_record : kNone;
    pushed_ = push_end_ = 0;
}

PathState PathPlanner::follow_committed() noexcept {
    if (pushed_ < push_end_) return push_[pushed_++];
    const PathState next = committed_.follow(committed_time_, dt_);
    committed_time_ += dt_;
    return next;
}

// Nothing to gain from another thought in this tick?
bool PathPlanner::follows_blindly() const noexcept {
    if (committed_time_ < 0 || other_wanted_ || landing_end_ != kNone) return false;
    if (pushed_ < push_end_) return true;
    return timeout_ > 0 && !at_rest() &&
           (committed_aims_ || committed_end_ == kNone || stops_at_end(committed_end_));
}

// No better step than the committed one was found, or hardly a better one: the next is looked for
// later.
void PathPlanner::keep_braking_profile() noexcept {
    timeout_ = failures_ < 3 ? 1u << failures_ : kMaxTimeout;
    ++failures_;
    stride_ = 1;
    // But before its end: where it comes to the speed of the slower stretch, or lands.
    const double left = committed_aims_ ? committed_.aim_time() - committed_time_
                                        : committed_.duration() - committed_time_ - kNearEnd * dt_;
    timeout_ =
        std::min(timeout_, left > 0 ? static_cast<std::uint32_t>(std::min(left / dt_, 100.0)) : 0u);
}

// The wanted speed has changed while the committed profile would accelerate first or pass a slower
// stretch: brake from here instead. False: that cannot be committed.
bool PathPlanner::commit_braking(const PathInput& input) noexcept {
    view_.begin(*this, SpeedLimits::Hard, input);
    tried_.along(view_, {0, state_.v, state_.a});
    pieces_ += tried_.pieces();
    if (!tried_.possible()) return false;
    commit(SpeedLimits::Hard);
    return true;
}

// Several ticks towards the limits ahead. False: not possible, or not worth while.
bool PathPlanner::push(View& view) noexcept {
    const std::uint32_t ticks = std::min(kPush, 2 * stride_);
    if (ticks < 2) return false;
    std::array<PathState, kPush>& steps = push_;  // pushed_ == push_end_: it is not followed
    const Limits tick = view.tick;
    const double speed_limit = view.speed_limit;
    PathState x{0, state_.v, state_.a};
    std::uint32_t count = 0;
    for (; count < ticks; ++count) {
        if (!view.around(x)) break;
        const double goal = view.rises(x) ? kFast : view.speed_limit;
        if (x.v > view.speed_limit * (1 + 1e-7)) break;
        if (x.a < 0 && release_speed(x.v, x.a, view.tick.j) < -1e-9) break;
        const PathState y = towards_speed({0, x.v, x.a}, goal, view.tick.a, view.tick.j, dt_);
        if (y.v < 0 || y.s < 0 || y.v > view.speed_limit) break;  // of all that the tick touches
        if (x.a > 0 && y.a <= 0 &&
            release_speed(x.v, x.a, view.tick.j) > view.speed_limit * (1 + 1e-6))
            break;
        const PathState end{x.s + y.s, y.v, y.a};
        std::uint32_t there = view.within;
        while (view.end_of(there) < end.s && view.stretch(there + 1) != nullptr) ++there;
        const Stretch* const stretch = view.stretch(there);
        if (view.end_of(there) < end.s ||
            std::abs(y.a) > stretch->limits.acceleration(y.v) * (1 + kEntering))
            break;
        steps[count] = y;
        x = end;
    }
    const bool possible = count >= 2 && comes_to_rest(view, SpeedLimits::Wanted, x);
    view.tick = tick;
    view.speed_limit = speed_limit;
    view.within = 0;
    if (!possible) return false;
    commit(SpeedLimits::Wanted);
    push_end_ = count;
    return true;
}

}  // namespace polyturn::kernel
