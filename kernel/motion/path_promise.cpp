// The committed profile: motion to standstill that was found safe as a whole. It consists of a push
// of up to kPush ticks (or none) and a braking behind it. While it is valid and nothing else is
// wanted a tick only follows it; decisions are made near its ends.
//
//   v |      push     .----.  braking, perhaps by way of
//     |          . - '      \   a slower stretch
//     |     . - '            '------.        promise_time_ counts from the end of the push
//     +---'--------------------------'---> t
#include <cmath>

#include "kernel/motion/path_planner.hpp"

namespace polyturn::kernel {
namespace {
constexpr double kFast = 1e6;             // mm/s: as hard as can be
constexpr std::uint32_t kMaxTimeout = 4;  // ticks
// ticks before standstill: every one is looked at, for the landing
constexpr double kNearEnd = 8;
constexpr double kEntering = 2e-3;  // as in braking.cpp
}  // namespace

void PathPlanner::forget_promise() noexcept {
    promise_time_ = -1;
    pushed_ = push_end_ = timeout_ = failures_ = 0;
    stride_ = 1;
    promise_aims_ = other_wanted_ = false;
    promise_end_ = kNone;
}

// tried_ is found safe.
void PathPlanner::promise(Ceilings which) noexcept {
    std::swap(promise_, tried_);
    promise_time_ = 0;
    promise_wanted_ = which == Ceilings::Wanted;
    promise_aims_ = promise_.aims();
    promise_end_ = view_.closed() ? view_.end_record : kNone;
    pushed_ = push_end_ = 0;
}

PathState PathPlanner::keep_promise() noexcept {
    if (pushed_ < push_end_) return push_[pushed_++];
    const PathState next = promise_.follow(promise_time_, dt_);
    promise_time_ += dt_;
    return next;
}

// Nothing to gain from another thought in this tick?
bool PathPlanner::follows_blindly() const noexcept {
    if (promise_time_ < 0 || other_wanted_ || landing_end_ != kNone) return false;
    if (pushed_ < push_end_) return true;
    return timeout_ > 0 && !at_rest() &&
           (promise_aims_ || promise_end_ == kNone || stops_at_end(promise_end_));
}

// No better step than the committed one was found, or hardly a better one: the next is looked for
// later.
void PathPlanner::keep_braking_profile() noexcept {
    timeout_ = failures_ < 3 ? 1u << failures_ : kMaxTimeout;
    ++failures_;
    stride_ = 1;
    // But before its end: where it comes to the speed of the slower stretch, or lands.
    const double left = promise_aims_ ? promise_.aim_time() - promise_time_
                                      : promise_.duration() - promise_time_ - kNearEnd * dt_;
    timeout_ =
        std::min(timeout_, left > 0 ? static_cast<std::uint32_t>(std::min(left / dt_, 100.0)) : 0u);
}

// The wanted speed has changed while the committed profile would accelerate first or pass a slower
// stretch: brake from here instead. False: that cannot be committed.
bool PathPlanner::promise_braking(const PathInput& input) noexcept {
    view_.begin(*this, Ceilings::Hard, input);
    tried_.along(view_, {0, state_.v, state_.a});
    pieces_ += tried_.pieces();
    if (!tried_.possible()) return false;
    promise(Ceilings::Hard);
    return true;
}

// Several ticks towards the limits ahead. False: not possible, or not worth while.
bool PathPlanner::push(View& view) noexcept {
    const std::uint32_t ticks = std::min(kPush, 2 * stride_);
    if (ticks < 2) return false;
    std::array<PathState, kPush>& steps = push_;  // pushed_ == push_end_: it is not followed
    const Limits tick = view.tick;
    const double ceiling = view.ceiling;
    PathState x{0, state_.v, state_.a};
    std::uint32_t count = 0;
    for (; count < ticks; ++count) {
        if (!view.around(x)) break;
        const double goal = view.rises(x) ? kFast : view.ceiling;
        if (x.v > view.ceiling * (1 + 1e-7)) break;
        if (x.a < 0 && release_speed(x.v, x.a, view.tick.j) < -1e-9) break;
        const PathState y = towards_speed({0, x.v, x.a}, goal, view.tick.a, view.tick.j, dt_);
        if (y.v < 0 || y.s < 0 || y.v > view.ceiling) break;  // of all that the tick touches
        if (x.a > 0 && y.a <= 0 && release_speed(x.v, x.a, view.tick.j) > view.ceiling * (1 + 1e-6))
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
    const bool possible = count >= 2 && comes_to_rest(view, Ceilings::Wanted, x);
    view.tick = tick;
    view.ceiling = ceiling;
    view.within = 0;
    if (!possible) return false;
    promise(Ceilings::Wanted);
    push_end_ = count;
    return true;
}

}  // namespace polyturn::kernel
