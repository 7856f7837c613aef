// What lies ahead of the path: records of the window joined to stretches of like limits, as far as
// a braking looks.
#include <cmath>

#include "kernel/motion/path_planner.hpp"

namespace polyturn::kernel {
namespace {

// limits of one stretch differ by no more, as parts of what there is
constexpr double kAlike = 0.1;
constexpr double kLevel = 0.98;  // speed limits likewise, if they can matter at all
constexpr double kBrief = 2;     // ticks: what is passed in less is no stretch of its own
constexpr double kLeastShare = 0.05;

// Do two records have about the same limits at a speed? What they lose by being joined is paid in
// time only.
bool alike(const Limits& x, const Limits& y, double v) noexcept {
    if (x.a == y.a && x.j == y.j && x.bend == y.bend && x.turning == y.turning &&
        x.along == y.along && x.across == y.across)
        return true;
    if (x.flat() != y.flat()) return false;
    const auto near = [](double p, double q) { return std::abs(p - q) <= kAlike; };
    if (!(std::min(x.a, y.a) >= 0.98 * std::max(x.a, y.a)) ||
        !(std::min(x.j, y.j) >= 0.98 * std::max(x.j, y.j)))
        return false;
    if (x.flat()) return true;
    const double v2 = v * v, v3 = v2 * v;
    return near(x.bend * v2 / x.a, y.bend * v2 / y.a) &&
           near(x.along * v3 / x.j, y.along * v3 / y.j) &&
           near(x.across * v3 / x.j, y.across * v3 / y.j);
}

}  // namespace

void PathPlanner::View::begin(PathPlanner& planner, SpeedLimits which,
                              const PathInput& input) noexcept {
    clear();
    planner_ = &planner;
    input_ = &input;
    which_ = which;
    end_record = kNone;
    const double v = planner.state_.v, a = planner.state_.a, dt = planner.dt_;
    record_ = planner.first_;
    const Slot& running = planner.at(record_);
    known_ = running.length - planner.state_.s;
    const double up = std::min(std::max(a, 0.0) + running.j_max * dt, std::max(running.a_max, a));
    const double v_next = v + std::max(up, 0.0) * dt;
    reach_ = v_next * dt;
    fast_ = 1.05 * v_next + 2 * up * up / running.j_max;
    chunk_ = 1.5 * v_next * (v_next / (2 * running.a_max) + running.a_max / running.j_max) + 0.1;
    begin_stretch(0, planner.speed_limit_of(running, which, input), running.limits());
    // What this tick can touch.
    within = 0;
    Limits touched = running.limits();
    speed_limit = stretches_[0].speed_limit;
    double hard = running.v_max;
    double at = known_;
    for (std::uint64_t record = record_; at <= reach_ && !planner.stops_at_end(record);) {
        const Slot& slot = planner.at(++record);
        if (!(slot.length > 0)) continue;
        touched.narrow(slot.limits());
        speed_limit = std::min(speed_limit, planner.speed_limit_of(slot, which, input));
        hard = std::min(hard, slot.v_max);
        at += slot.length;
    }
    narrow_tick(touched, planner.state_, std::max(v, std::min(v_next, hard)));
    if (input.single_block && which == SpeedLimits::Wanted && planner.block_latch_ == kNone &&
        (planner.committed_time_ >= 0 || planner.at_rest())) {
        // The first end of a block at which the path can still stop: not before the end of the
        // committed distance.
        const double stands = planner.at_rest()
                                  ? 0
                                  : planner.committed_.distance() -
                                        planner.committed_.follow(0, planner.committed_time_).s;
        double end = known_;
        for (std::uint64_t record = planner.first_;; end += planner.at(++record).length) {
            if (planner.at(record).block_end && end >= stands) {
                planner.block_latch_ = record;
                break;
            }
            if (planner.stops_at_end(record)) break;
        }
    }
}

void PathPlanner::View::narrow_tick(const Limits& touched, const PathState& x,
                                    double highest) noexcept {
    tick = touched.at(highest, std::abs(x.a) + touched.j * planner_->dt_);
    if (touched.flat()) return;
    // never so little that nothing could be changed
    tick.a = std::max(tick.a, kLeastShare * touched.a);
    tick.j = std::max(tick.j, kLeastShare * touched.j);
}

bool PathPlanner::View::around(const PathState& x) noexcept {
    while (end_of(within) <= x.s) {
        if (stretch(within + 1) == nullptr) return false;
        ++within;
    }
    const double dt = planner_->dt_;
    Limits touched = stretches_[within].limits;
    speed_limit = stretches_[within].speed_limit;
    const double up = std::min(std::max(x.a, 0.0) + touched.j * dt, std::max(touched.a, x.a));
    const double v_next = x.v + up * dt, reach = x.s + v_next * dt;
    for (std::uint32_t i = within; end_of(i) <= reach; ++i) {
        const Stretch* const next = stretch(i + 1);
        if (next == nullptr) break;
        touched.narrow(next->limits);
        speed_limit = std::min(speed_limit, next->speed_limit);
    }
    narrow_tick(touched, x, std::max(x.v, std::min(v_next, speed_limit)));
    return true;
}

bool PathPlanner::View::rises(const PathState& now) noexcept {
    const double a = std::min(std::max(now.a, 0.0) + tick.j * planner_->dt_,
                              std::max(tick.a, now.a)),
                 v = now.v + a * planner_->dt_;
    if (release_speed(v, a, tick.j) <= speed_limit) return false;
    const double way = now.s + (v + a * a / (2 * tick.j)) * a / tick.j;
    for (std::uint32_t i = within; end_of(i) < way; ++i) {
        const Stretch* const next = stretch(i + 1);
        if (next == nullptr) return false;
        if (next->speed_limit > speed_limit * (1 + 1e-9)) return true;
    }
    return false;
}

void PathPlanner::View::join(const PlannedRecord& record, double other) noexcept {
    Stretch& last = stretches_[count_ - 1];
    last.speed_limit = std::min(last.speed_limit, other);
    last.limits.narrow(record.limits());
}

// Sixteen records that change nothing in one step.
bool PathPlanner::View::pass_group() noexcept {
    if ((record_ + 1) % kGroup != 0 || record_ + kGroup + 1 >= planner_->end_) return false;
    const Group& group = planner_->groups_[(record_ + 1) % kPlannerWindow / kGroup];
    const bool blocks = which_ == SpeedLimits::Wanted && input_->single_block;
    if (group.stops || (blocks && group.block_ends) ||
        (which_ == SpeedLimits::Wanted && group.mixed) || !(group.length > 0))
        return false;
    PlannedRecord least;
    least.length = group.length;
    least.v_max = group.v_max;
    least.feed = group.feed;
    least.feed_mode = group.feed_mode;
    least.spindle = group.spindle;
    least.override_locked = group.override_locked;
    const double other = planner_->speed_limit_of(least, which_, *input_);
    const Stretch& last = stretches_[count_ - 1];
    if (other < std::min(last.speed_limit, fast_)) return false;
    if (group.least.narrower_than(last.limits) || last.limits.narrower_than(group.most))
        return false;
    known_ += group.length;
    record_ += kGroup;
    return true;
}

void PathPlanner::View::more() noexcept {
    const bool blocks = which_ == SpeedLimits::Wanted && input_->single_block;
    for (;;) {
        if (planner_->stops_at_end(record_) || (blocks && record_ == planner_->block_latch_)) {
            end_record = record_;
            return close(known_);
        }
        const bool long_enough = known_ - stretches_[count_ - 1].begin > chunk_;
        if (!long_enough && known_ > reach_ && pass_group()) continue;
        const Slot& slot = planner_->at(++record_);
        if (!(slot.length > 0)) continue;
        const double other = planner_->speed_limit_of(slot, which_, *input_);
        const Stretch& last = stretches_[count_ - 1];
        const double before = std::min(last.speed_limit, fast_), now = std::min(other, fast_);
        const bool level = now >= kLevel * before && before >= kLevel * now;
        // the tick's own records: nothing is taken from them
        const bool exactly = known_ <= reach_ || count_ == 1;
        const Limits own = slot.limits();
        const bool brief =
            known_ - last.begin < kBrief * planner_->dt_ * std::min(before, now) && !exactly;
        const bool same =
            exactly ? now == before && !own.narrower_than(last.limits) &&
                          !last.limits.narrower_than(own)
                    : level && alike(last.limits, own, std::min({before, now, slot.v_max}));
        const bool joins = brief || (!long_enough && same);
        if (joins) {
            join(slot, other);
            known_ += slot.length;
            continue;
        }
        // full: stop here rather than drop something
        if (!begin_stretch(known_, other, own)) return close(known_);
        known_ += slot.length;
        return;
    }
}

}  // namespace polyturn::kernel
