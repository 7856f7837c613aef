// The planner's window of records, and the motion of one tick over them. How it decides:
// path_decision.cpp.
#include "kernel/motion/path_planner.hpp"

#include <cmath>

#include "ipc/diagnosis/assert.hpp"

namespace polyturn::kernel {
namespace {
constexpr double kInfinity = std::numeric_limits<double>::infinity();
// mm/s, mm/s2, mm/s3: a record that allows less, or nothing, still has an end; it takes hours, and
// no quotient becomes infinite.
constexpr double kLeastLimit = 1e-6;
// Without a jerk limit, acceleration may rise to all that is allowed within a tick divided by this:
// a step for the axes, and still a finite jerk for the formulas.
constexpr double kJerkSteps = 100;
// mm: less than this before an exact stop is rounding of the stop before, and not driven.
constexpr double kNothingLeft = 1e-9;
// mm/s: where the path must stop it may arrive with no more; more is counted (anomalies()).
constexpr double kStandstillSpeed = 1e-3;
}  // namespace

PlannedRecord PlannedRecord::from(const PathRecord& record, bool stop_before) noexcept {
    PlannedRecord planned;
    planned.length = record.length;
    planned.v_max = record.v_max;
    planned.a_max = record.a_max;
    planned.j_max = record.j_max;
    planned.bend = record.bend;
    planned.turning = record.bend_turning;
    planned.along = record.bend_along;
    planned.across = record.bend_across;
    planned.feed = record.feed;
    planned.spindle = record.spindle;
    planned.feed_mode =
        (record.flags & kRapid) != 0 ? FeedMode::Rapid : static_cast<FeedMode>(record.feed_mode);
    planned.override_locked = (record.flags & (kOverrideLocked | kThread)) != 0;
    planned.stop_before = stop_before;
    planned.stop_after = (record.flags & (kExactStop | kInPosition)) != 0;
    planned.wait_in_position = (record.flags & kInPosition) != 0;
    planned.block_end = (record.flags & kBlockEnd) != 0;
    return planned;
}

void PathPlanner::configure(double dt, std::uint32_t horizon) noexcept {
    dt_ = dt;
    horizon_ = std::clamp<std::uint32_t>(horizon, 2, kPlannerWindow - 2);
}

void PathPlanner::clear(std::uint64_t next) noexcept {
    first_ = end_ = next;
    groups_[next % kPlannerWindow / kGroup].stops = true;  // the group that begins half filled
    state_ = {};
    began_ = done_ = false;
    drop_committed();
    block_latch_ = landing_end_ = kNone;
    block_done_ = false;
    appended_ = 0;
}

void PathPlanner::append(const PlannedRecord& record) noexcept {
    Slot& slot = at(end_);
    static_cast<PlannedRecord&>(slot) = record;
    slot.begin_fraction = slot.end_fraction = 0;
    slot.length = std::max(record.length, 0.0);
    if (!(slot.length > 0)) {  // a note: narrows nothing
        slot.v_max = slot.a_max = slot.j_max = kInfinity;
        slot.bend = slot.turning = slot.along = slot.across = 0;
    } else {
        slot.v_max = std::max(record.v_max, kLeastLimit);
        slot.a_max = std::max(record.a_max, kLeastLimit);
        slot.j_max =
            kPlannedJerk * std::clamp(record.j_max, kLeastLimit, kJerkSteps * slot.a_max / dt_);
    }
    add_to_group(end_);
    ++end_;
    PT_ASSERT(first_ < end_ && end_ - first_ < kPlannerWindow, "I1 the window holds its records");
    ++appended_;
}

void PathPlanner::add_to_group(std::uint64_t record) noexcept {
    Group& group = groups_[record % kPlannerWindow / kGroup];
    const Slot& slot = at(record);
    // Begun anew with its first record. One that clear() left half filled keeps what it has: lower
    // limits only cost time to look at, but a length would be wrong, so it counts as stopping.
    if (record % kGroup == 0) {
        group = {0,
                 kInfinity,
                 kInfinity,
                 {kInfinity, kInfinity},
                 {0, 0, kInfinity, kInfinity, kInfinity, kInfinity},
                 0,
                 slot.feed_mode,
                 slot.spindle,
                 slot.override_locked,
                 false,
                 false,
                 false};
    }
    group.stops = group.stops || slot.stop_after || slot.stop_before;
    group.block_ends = group.block_ends || slot.block_end;
    if (!(slot.length > 0)) return;
    group.length += slot.length;
    group.v_max = std::min(group.v_max, slot.v_max);
    group.least.narrow(slot.limits());
    group.most.widen(slot.limits());
    group.feed = std::min(group.feed, slot.feed);
    group.longest = std::max(group.longest, slot.length);
    group.mixed = group.mixed || group.feed_mode != slot.feed_mode ||
                  group.spindle != slot.spindle || group.override_locked != slot.override_locked;
}

void PathPlanner::skip(std::uint64_t to) noexcept {
    first_ = std::max(first_, std::min(to, end_));
    state_ = {};
    began_ = done_ = false;
    landing_end_ = kNone;
    drop_committed();
    if (block_latch_ != kNone && block_latch_ < first_) block_latch_ = kNone;
}

void PathPlanner::let_pass(std::uint64_t record) noexcept {
    if (record >= first_ && record < end_) at(record).stop_before = false;
}

void PathPlanner::stand_before(std::uint64_t record) noexcept {
    if (record >= first_ && record < end_) at(record).stop_before = true;
}

double PathPlanner::speed_limit_of(const PlannedRecord& slot, SpeedLimits which,
                                   const PathInput& input) const noexcept {
    if (which == SpeedLimits::Hard || !(slot.length > 0)) return slot.v_max;
    double wanted = slot.feed;
    if (slot.feed_mode == FeedMode::Rapid) {
        wanted = slot.v_max * input.rapid_override;
    } else {
        if (slot.feed_mode == FeedMode::PerRevolution || slot.feed_mode == FeedMode::Thread) {
            const bool known =
                input.spindle_rev_s != nullptr && slot.spindle >= 1 && slot.spindle <= kMaxSpindles;
            wanted *= known ? std::abs(input.spindle_rev_s[slot.spindle - 1]) : 0.0;
        }
        if (input.dry_run_feed > 0) wanted = input.dry_run_feed;
        if (!slot.override_locked) wanted *= input.feed_override;
    }
    return std::max(0.0, std::min({wanted, slot.v_max, input.speed_ceiling}));
}

bool PathPlanner::stops_at_end(std::uint64_t record) const noexcept {
    return at(record).stop_after || record + 1 == end_ || at(record + 1).stop_before;
}

// At rest: which record is next, or why none.
Stands PathPlanner::leave_standstill(const PathInput& input, PathStep& step) noexcept {
    if (!input.single_block) {
        block_latch_ = kNone;
        block_done_ = false;
    }
    for (;;) {
        if (first_ == end_) return Stands::NoRecord;
        if (done_) {
            if (at(first_).wait_in_position && !input.in_position) return Stands::InPosition;
            if (block_done_) return Stands::BlockEnd;
            if (first_ + 1 == end_) return Stands::NoRecord;
            ++first_;
            state_ = {};
            began_ = done_ = false;
        }
        const Slot& slot = at(first_);
        if (state_.s == 0 && slot.stop_before) return Stands::BeforeRecord;
        if (slot.length - state_.s > 0) {
            if (input.hold) return Stands::Held;
            return speed_limit_of(slot, SpeedLimits::Wanted, input) > 0 ? Stands::Moving
                                                                        : Stands::NoFeed;
        }
        // A note: over as soon as it is reached.
        if (!began_) {
            if (step.began_to == step.began_from) step.began_from = first_;
            step.began_to = first_ + 1;
            at(first_).begin_fraction = 0;
        }
        if (step.ended_to == step.ended_from) step.ended_from = first_;
        step.ended_to = first_ + 1;
        at(first_).end_fraction = 0;
        began_ = done_ = true;
        if (input.single_block && slot.block_end) block_done_ = true;
    }
}

void PathPlanner::carry(const PathState& next, PathStep& step) noexcept {
    const double v0 = state_.v, v1 = next.v, moved = next.s;
    // Part of the tick after which a distance is done, with the speed taken as linear in time: from
    // v0 to u = sqrt(v0^2 + (v1^2 - v0^2) ratio) with the mean (v0 + u)/2, against (v0 + v1)/2 for
    // all of it.
    const auto part_at = [&](double distance) {
        if (!(moved > 0)) return 1.0;
        const double ratio = std::clamp(distance / moved, 0.0, 1.0);
        const double root = std::sqrt(std::max(0.0, v0 * v0 + (v1 * v1 - v0 * v0) * ratio));
        return v0 + root > 0 ? std::min(1.0, ratio * (v0 + v1) / (v0 + root)) : 1.0;
    };
    const bool landed = landing_end_ != kNone && v1 == 0 && next.a == 0 && landing_.landed();
    // done: from the tick's beginning to the beginning of the record
    double s = state_.s + moved, done = -state_.s;
    double fraction = 0;
    state_ = {s, v1, next.a};
    // Record by record: `s` is what is driven of the running one and behind. It ends where it is
    // passed, or where the landing says so: that end is exact, `s` is not.
    for (;;) {
        Slot& slot = at(first_);
        if (!began_) {
            if (step.began_to == step.began_from) step.began_from = first_;
            step.began_to = first_ + 1;
            slot.begin_fraction = fraction;
            began_ = true;
        }
        const bool lands_here = landed && first_ == landing_end_;
        if (!lands_here && !(landed && first_ < landing_end_) && s < slot.length) break;
        done += slot.length;
        s -= slot.length;
        fraction = part_at(done);
        slot.end_fraction = fraction;
        if (step.ended_to == step.ended_from) step.ended_from = first_;
        step.ended_to = first_ + 1;
        if (lands_here || stops_at_end(first_)) {
            if (!lands_here && v1 > kStandstillSpeed) ++anomalies_;
            state_ = {slot.length, 0, 0};
            done_ = true;
            if (first_ == block_latch_) {
                block_done_ = true;
                block_latch_ = kNone;
            }
            landing_end_ = kNone;
            return;
        }
        ++first_;
        began_ = false;
    }
    state_.s = std::max(s, 0.0);
}

PathStep PathPlanner::tick(const PathInput& input) noexcept {
    appended_ = 0;
    // Taken back before it has stopped the path; pressed again, the block that runs then is meant.
    if (!input.single_block || (block_latch_ != kNone && block_latch_ < first_))
        block_latch_ = kNone;
    PathStep step;
    step.began_from = step.began_to = step.ended_from = step.ended_to = first_;
    step.stands = Stands::Moving;
    if (at_rest()) step.stands = leave_standstill(input, step);
    if (step.stands == Stands::Moving) {
        if (input.emergency_dec > 0) {
            landing_end_ = kNone;
            drop_committed();
            const double time = std::min(dt_, state_.v / input.emergency_dec);
            carry({time * (state_.v - input.emergency_dec * time / 2),
                   time < dt_ ? 0.0 : state_.v - input.emergency_dec * time, 0},
                  step);
        } else {
            const double left = at(first_).length - state_.s;
            // nothing to drive: rounding of an earlier stop
            if (at_rest() && left < kNothingLeft && stops_at_end(first_)) {
                landing_end_ = first_;
                landing_.at_once(left);
                carry({left, 0, 0}, step);
            } else {
                carry(choose(input), step);
            }
        }
        if (at_rest() && !done_ && input.hold) step.stands = Stands::Held;
    }
    PT_ASSERT(state_.v >= 0, "I2 the path never goes backwards");
    PT_ASSERT(committed_time_ < 0 || committed_.possible(), "I3 what is committed was possible");
    step.record = first_;
    step.s = state_.s;
    step.speed = state_.v;
    step.acceleration = state_.a;
    step.over = done_;
    return step;
}

}  // namespace polyturn::kernel
