#include "kernel/motion/path_planner.hpp"

#include <cmath>

namespace polyturn::kernel {
namespace {

constexpr double kInfinity = std::numeric_limits<double>::infinity();
// Planning uses a little less jerk than allowed; the rest is what landing() needs to end exactly at a point.
constexpr double kPlannedJerk = 0.995;
// Of comparisons, mm and relative. What a step promised is computed anew from where it led; so keeping a promise is judged
// more mildly than giving one, or rounding could break it.
constexpr double kGiving = 1e-9, kKeeping = 1e-8;
// A promise to be steady or to stand before limits fall keeps this far from there, mm: a tail that rounding carries over
// the border would be judged by the other limits.
constexpr double kBefore = 1e-7;

// Ceiling c from distance d on: can it be kept so that the speed need not fall below c afterwards?
bool arrives(double v, double a, double d, double c, double a_max, double j_max, double rounding) noexcept {
    const double limit = d + rounding;
    if (release_speed(v, a, j_max) > c * (1 + rounding)) return distance_to_speed(v, a, c, a_max, j_max) <= limit;
    if (a >= 0 || v <= c * (1 + rounding)) return true;
    if (release_distance_to(v, a, c, j_max) <= limit) return true;
    return -a <= a_max && 2 * j_max * c >= a * a && v * v - c * c <= -2 * a * limit;  // held so long, then released
}

// Does a braking come below it in time, however far it then falls?
bool falls_below(const Braking& braking, double d, double c, double rounding) noexcept {
    const double way = braking.falling_distance(c * (1 + rounding));
    return way == 0 || way <= d + rounding;
}

}  // namespace

PlannedRecord PlannedRecord::from(const PathRecord& record, bool stop_before) noexcept {
    PlannedRecord planned;
    planned.length = record.length;
    planned.v_max = record.v_max;
    planned.a_max = record.a_max;
    planned.j_max = record.j_max;
    planned.feed = record.feed;
    planned.spindle = record.spindle;
    planned.feed_mode = (record.flags & kRapid) != 0 ? FeedMode::Rapid : static_cast<FeedMode>(record.feed_mode);
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
    witness_ = {kNone, 0, 0, 0};
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
    } else {
        slot.v_max = std::max(record.v_max, 1e-6);
        slot.a_max = std::max(record.a_max, 1e-6);
        // No jerk limit: change acceleration within a hundredth of a tick.
        slot.j_max = kPlannedJerk * std::clamp(record.j_max, 1e-6, 100 * slot.a_max / dt_);
    }
    add_to_group(end_);
    ++end_;
    ++appended_;
}

void PathPlanner::add_to_group(std::uint64_t record) noexcept {
    Group& group = groups_[record % kPlannerWindow / kGroup];
    const Slot& slot = at(record);
    // Begun anew with its first record. One that clear() left half filled keeps what it has: lower limits only cost time
    // to look at, but a length would be wrong, so it counts as stopping.
    if (record % kGroup == 0) {
        group = {0, kInfinity, kInfinity, kInfinity, kInfinity, slot.feed_mode, slot.spindle, slot.override_locked, false, false, false};
    }
    group.stops = group.stops || slot.stop_after || slot.stop_before;
    group.block_ends = group.block_ends || slot.block_end;
    if (!(slot.length > 0)) return;
    group.length += slot.length;
    group.v_max = std::min(group.v_max, slot.v_max);
    group.a_max = std::min(group.a_max, slot.a_max);
    group.j_max = std::min(group.j_max, slot.j_max);
    group.feed = std::min(group.feed, slot.feed);
    group.mixed = group.mixed || group.feed_mode != slot.feed_mode || group.spindle != slot.spindle || group.override_locked != slot.override_locked;
}

void PathPlanner::skip(std::uint64_t to) noexcept {
    first_ = std::max(first_, std::min(to, end_));
    state_ = {};
    began_ = done_ = false;
    landing_end_ = kNone;
    if (block_latch_ != kNone && block_latch_ < first_) block_latch_ = kNone;
}

void PathPlanner::let_pass(std::uint64_t record) noexcept {
    if (record >= first_ && record < end_) at(record).stop_before = false;
}

double PathPlanner::ceiling_of(const PlannedRecord& slot, Ceilings which, const PathInput& input) const noexcept {
    if (which == Ceilings::Hard || !(slot.length > 0)) return slot.v_max;
    double wanted = slot.feed;
    if (slot.feed_mode == FeedMode::Rapid) {
        wanted = slot.v_max * input.rapid_override;
    } else {
        if (slot.feed_mode == FeedMode::PerRevolution || slot.feed_mode == FeedMode::Thread) {
            const bool known = input.spindle_rev_s != nullptr && slot.spindle >= 1 && slot.spindle <= kMaxSpindles;
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

void PathPlanner::look_ahead(View& view, Ceilings which, const PathInput& input) noexcept {
    view.target_count = view.drop_count = 0;
    view.has_witness = false;
    Drop kept{};
    view.which = which;
    view.rounding = kGiving;
    view.end = kInfinity;
    view.end_record = kNone;
    view.beyond = first_ + 1;
    const double v = state_.v, a = state_.a;
    const Slot& running = at(first_);
    double run_a = running.a_max, run_j = running.j_max;
    view.tick_a = run_a;
    view.tick_j = run_j;
    view.ceiling = ceiling_of(running, which, input);
    // Of the targets so far. A ceiling that is violated already rules out nothing.
    double lowest = release_speed(v, std::max(a, 0.0), run_j) <= view.ceiling * (1 + kGiving) ? view.ceiling : running.v_max;
    view.top = lowest;
    double distance = running.length - state_.s;
    double reach = 0, need = 0;
    // How far this tick can lead, and how far from there to a standstill.
    const auto measure = [&] {
        const double up = std::min(std::max(a, 0.0) + running.j_max * dt_, std::max(running.a_max, a));
        const double v_next = v + std::max(up, 0.0) * dt_;
        reach = v_next * dt_;
        need = reach + longest_braking(v_next, up, run_a, run_j);
        for (std::uint32_t i = 0; i < view.drop_count; ++i) {
            need = std::max(need, view.drops[i].distance + longest_braking(view.drops[i].speed, 0, run_a, run_j));
        }
    };
    measure();
    const bool blocks = which == Ceilings::Wanted && input.single_block;
    const auto group_ceiling = [&](const Group& group) {
        PlannedRecord least;
        least.length = group.length;
        least.v_max = group.v_max;
        least.feed = group.feed;
        least.feed_mode = group.feed_mode;
        least.spindle = group.spindle;
        least.override_locked = group.override_locked;
        return ceiling_of(least, which, input);
    };
    for (std::uint64_t record = first_;;) {
        if (blocks && at(record).block_end && block_latch_ == kNone && distance >= stopping_distance(v, a, run_a, run_j)) {
            block_latch_ = record;
        }
        if (stops_at_end(record) || (blocks && record == block_latch_)) {
            view.end = distance;
            view.end_record = record;
            break;
        }
        if (distance >= need) break;
        if ((record + 1) % kGroup == 0 && record + kGroup + 1 < end_ && distance > reach) {
            const Group& group = groups_[(record + 1) % kPlannerWindow / kGroup];
            const bool witness_inside = which == Ceilings::Hard && witness_.record > record && witness_.record <= record + kGroup;
            if (!group.stops && !(blocks && group.block_ends) && !witness_inside && group.a_max >= run_a && group.j_max >= run_j &&
                (which == Ceilings::Hard ? group.v_max >= lowest : !group.mixed && group_ceiling(group) >= lowest)) {
                distance += group.length;
                record += kGroup;
                view.beyond = record + 1;
                continue;
            }
        }
        const Slot& slot = at(++record);
        if (record == witness_.record && which == Ceilings::Hard) {
            kept = {distance, witness_.speed, witness_.a, witness_.j, record};
            view.has_witness = true;
        }
        view.beyond = record + 1;
        if (slot.length > 0) {
            const double ceiling = ceiling_of(slot, which, input), before_a = run_a, before_j = run_j;
            if (slot.a_max < run_a || slot.j_max < run_j) {
                if (view.drop_count < kDrops) view.drops[view.drop_count++] = {distance, ceiling, run_a, run_j, record};
                run_a = std::min(run_a, slot.a_max);
                run_j = std::min(run_j, slot.j_max);
                measure();
            }
            if (distance <= reach) {
                view.tick_a = run_a;
                view.tick_j = run_j;
                view.ceiling = std::min(view.ceiling, ceiling);
            }
            if (ceiling < lowest) {
                if (view.target_count == kTargets) {  // full: stand here rather than forget something
                    view.end = distance;
                    break;
                }
                view.targets[view.target_count++] = {distance, ceiling, before_a, before_j};
                lowest = ceiling;
            }
            distance += slot.length;
        }
    }
    view.a = run_a;
    view.j = run_j;
    if (view.drop_count > 0) settle_drops(view);
    view.drops[view.drop_count] = kept;
}

// Lower each drop's speed until everything behind it can be kept from there with acceleration 0; more exactly from a tick
// behind it, for braking goes on at the tick's end.
void PathPlanner::settle_drops(View& view) const noexcept {
    const auto lower = [&](Drop& drop, double distance, double ceiling) {
        const double gap = distance - drop.distance - drop.speed * dt_;
        if (distance_to_speed(drop.speed, 0, ceiling, view.a, view.j) <= gap) return;
        const double most = std::min(drop.speed, top_speed(distance - drop.distance, ceiling, view.a, view.j));
        drop.speed = std::min(most, top_speed(distance - drop.distance - most * dt_, ceiling, view.a, view.j));
    };
    for (std::uint32_t d = 0; d < view.drop_count; ++d) {
        Drop& drop = view.drops[d];
        for (std::uint32_t i = 0; i < view.target_count; ++i) {
            const Target& target = view.targets[i];
            if (target.distance > drop.distance && target.ceiling < drop.speed) lower(drop, target.distance, target.ceiling);
        }
        if (view.end < kInfinity) lower(drop, view.end, 0);
    }
}

PathPlanner::Step PathPlanner::step_towards(double speed, double a, double j) const noexcept {
    return {speed, a, j, towards_speed({0, state_.v, state_.a}, speed, a, j, dt_)};
}

// Where a step has come to a distance, found by bisection: how fast is it there?
double PathPlanner::speed_at(const Step& step, double distance) const noexcept {
    const PathState start{0, state_.v, state_.a};
    double low = 0, high = dt_;
    for (int i = 0; i < 40; ++i) {
        const double middle = (low + high) / 2;
        (towards_speed(start, step.speed, step.a, step.j, middle).s < distance ? low : high) = middle;
    }
    return towards_speed(start, step.speed, step.a, step.j, high).v;
}

// Can everything in view be kept after this step, and is it kept in it?
bool PathPlanner::safe(const View& view, const Step& step, Witness& witness) const noexcept {
    const PathState& next = step.next;
    const double v = next.v, a = next.a;
    if (v < 0 || (state_.a < 0 && release_speed(state_.v, state_.a, step.j) < -1e-9)) return false;
    for (std::uint32_t i = 0; i < view.target_count && view.targets[i].distance < next.s; ++i) {
        if (speed_at(step, view.targets[i].distance) > view.targets[i].ceiling * (1 + 1e-4)) return false;
    }
    // Limits of this side of a border must not act beyond it, but to be steady there.
    if (step.j > view.tick_j || step.a > view.tick_a) {
        double side = kInfinity;
        for (std::uint32_t d = view.drop_count; d-- > 0;) {
            const bool last = d + 1 == view.drop_count;
            if ((last ? view.a : view.drops[d + 1].a) < step.a || (last ? view.j : view.drops[d + 1].j) < step.j) side = view.drops[d].distance;
        }
        if (next.s > side && (a != 0 || distance_to_speed(state_.v, state_.a, step.speed, step.a, step.j) > side)) return false;
    }
    if (view.which == Ceilings::Wanted) {
        for (std::uint32_t i = 0; i < view.target_count; ++i) {
            const Target& target = view.targets[i];
            if (!arrives(v, a, target.distance - next.s, target.ceiling, target.a, target.j, view.rounding)) return false;
        }
    }
    const auto all_kept = [&] {
        if (a > 0 && release_speed(v, a, view.j) > view.top * (1 + view.rounding)) return false;
        const Braking braking(v, a, 0, view.a, view.j);
        if (view.end < kInfinity && braking.distance() > (view.end - next.s) * (1 + view.rounding / 10) + view.rounding * 1e-4) return false;
        for (std::uint32_t i = 0; i < view.target_count; ++i) {
            const Target& target = view.targets[i];
            if (!falls_below(braking, target.distance - next.s, target.ceiling, view.rounding)) return false;
        }
        return true;
    };
    const auto cannot_but_reverse = [&](double j_max) { return a < 0 && release_speed(v, a, j_max) < -1e-9; };
    // Acceleration above a limit that holds from some drop on must have gone before the first such drop.
    double border = kInfinity;
    for (std::uint32_t d = view.drop_count; d-- > 0;) {
        const double after = d + 1 < view.drop_count ? view.drops[d + 1].a : view.a;
        if (std::abs(a) > after * (1 + 1e-12)) border = view.drops[d].distance;
    }
    const auto within = [&](double a_max, double j_max) {
        if (std::abs(a) <= a_max * (1 + 1e-12)) return true;
        return border < kInfinity && advanced(next, a > 0 ? -j_max : j_max, (std::abs(a) - a_max) / j_max).s <= border;
    };
    // Under the least limits of the whole view.
    if (within(view.a, view.j) && !cannot_but_reverse(view.j) && all_kept()) {
        witness = {view.beyond, 0, view.a, view.j};
        return true;
    }
    // Or down to the speed of a drop, under the limits before it.
    for (std::uint32_t d = 0; d < view.drop_count + (view.has_witness ? 1 : 0); ++d) {
        const Drop& drop = view.drops[d];
        const double gap = drop.distance - next.s;
        if (gap < 0 || !within(drop.a, drop.j) || cannot_but_reverse(drop.j)) continue;
        // One braking to where acceleration is gone, below everything before the drop; or a standstill.
        const auto braked_to = [&](double w) {
            if (a > 0 && release_speed(v, a, drop.j) > view.top * (1 + view.rounding)) return false;
            const Braking braking(v, a, w, drop.a, drop.j);
            if (braking.distance() > gap - kBefore + 10 * view.rounding) return false;
            for (std::uint32_t i = 0; i < view.target_count && view.targets[i].distance < drop.distance; ++i) {
                const Target& target = view.targets[i];
                if (!falls_below(braking, target.distance - next.s, target.ceiling, view.rounding)) return false;
            }
            return true;
        };
        double w = std::min(drop.speed, std::max(0.0, release_speed(v, a, drop.j)));
        for (std::uint32_t i = 0; i < view.target_count && view.targets[i].distance < drop.distance; ++i) w = std::min(w, view.targets[i].ceiling);
        if (braked_to(w) || (view.which == Ceilings::Hard && braked_to(w = 0))) {
            witness = {drop.record, w, drop.a, drop.j};
            return true;
        }
    }
    return false;
}

bool PathPlanner::take(const View& view, const Step& step) noexcept {
    Witness witness;
    if (!safe(view, step, witness)) return false;
    witness_ = witness;
    return true;
}

// The fastest safe step among those towards a speed up to goal.
bool PathPlanner::best_towards(const View& view, double goal, double a, double j, PathState& next) noexcept {
    const Step most = step_towards(goal, a, j);
    next = most.next;
    if (take(view, most)) return true;
    const Step least = step_towards(0, a, j);
    next = least.next;
    if (!take(view, least)) return false;
    // What a tick of full jerk either way leads to bounds the speeds worth asking for.
    const double up_a = std::min(state_.a + j * dt_, a);
    const double highest = release_speed(state_.v + std::max(state_.a, up_a) * dt_, up_a, j);
    double low = std::clamp(release_speed(least.next.v, least.next.a, j), 0.0, goal), high = std::min(goal, highest);
    const double lowest = low;
    for (int i = 0; i < (low > lowest ? 12 : 40) && low < high; ++i) {  // next to an end the first hit can be far down
        const double middle = (low + high) / 2;
        const Step tried = step_towards(middle, a, j);
        if (take(view, tried)) {
            next = tried.next;
            low = middle;
        } else {
            high = middle;
        }
    }
    return true;
}

PathState PathPlanner::choose(const PathInput& input) noexcept {
    look_ahead(view_, Ceilings::Wanted, input);
    if (landing_end_ != kNone && view_.end_record == landing_end_) return landing_.step(dt_);
    const double goal = input.hold ? 0 : view_.ceiling;
    PathState next;
    if (landing_end_ != kNone) {  // the way goes on; but a landing is safe until something else is
        if (!best_towards(view_, goal, view_.tick_a, view_.tick_j, next)) return landing_.step(dt_);
        landing_end_ = kNone;
        return next;
    }
    Step step = step_towards(goal, view_.tick_a, view_.tick_j);
    if (take(view_, step)) return step.next;
    if (view_.end < kInfinity && begin_landing(view_)) return landing_.step(dt_);
    if (best_towards(view_, goal, view_.tick_a, view_.tick_j, next)) return next;
    if (best_towards(view_, goal, view_.a, view_.j, next)) return next;
    // What is wanted cannot be kept (a feed has been lowered): brake to the lowest that is violated, as the hard limits allow.
    const PathState down = step_towards(0, view_.tick_a, view_.tick_j).next;
    double wanted = std::min(goal, state_.v);
    for (std::uint32_t i = 0; i < view_.target_count; ++i) {
        const Target& target = view_.targets[i];
        if (!arrives(down.v, down.a, target.distance - down.s, target.ceiling, target.a, target.j, kKeeping)) wanted = std::min(wanted, target.ceiling);
    }
    look_ahead(view_, Ceilings::Hard, input);
    if (begin_landing(view_)) return landing_.step(dt_);
    if (best_towards(view_, wanted, view_.tick_a, view_.tick_j, next)) return next;
    if (best_towards(view_, wanted, view_.a, view_.j, next)) return next;
    // As the last step promised.
    view_.rounding = kKeeping;
    for (const double speed : {witness_.speed, 0.0}) {
        if (witness_.record <= first_ || witness_.record == kNone) break;
        step = step_towards(speed, witness_.a, witness_.j);
        if (take(view_, step)) return step.next;
    }
    for (std::uint32_t d = 0; d < view_.drop_count; ++d) {
        const Drop& drop = view_.drops[d];
        for (const double speed : {std::min(wanted, drop.speed), 0.0}) {
            step = step_towards(speed, drop.a, drop.j);
            if (take(view_, step)) return step.next;
        }
    }
#ifdef PLANNER_TRACE
    PLANNER_TRACE
#endif
    ++anomalies_;
    return step_towards(0, view_.a, view_.j).next;
}

bool PathPlanner::begin_landing(const View& view) noexcept {
    const double v = state_.v, a = state_.a, distance = view.end;
    if (view.end_record == kNone || !(v > 0) || std::abs(a) > view.a * (1 + 1e-12)) return false;
    // Now, or can more speed still be had?
    const double softer = std::max(0.95 * view.j, a < 0 ? a * a / (2 * v) : 0.0);
    if (stopping_distance(v, a, view.a, softer) <= distance * (1 - 1e-9) && stopping_time(v, a, view.a, view.j) > 3 * dt_) return false;
    if (!landing_.aim(v, a, distance, view.a, view.j / 100, view.j / kPlannedJerk)) return false;
    if (release_speed(v, std::max(a, 0.0), landing_.jerk()) > view.top) return false;
    const Braking braking(v, a, 0, view.a, landing_.jerk());
    for (std::uint32_t i = 0; i < view.target_count; ++i) {
        if (!falls_below(braking, view.targets[i].distance, view.targets[i].ceiling, kKeeping)) return false;
    }
    landing_end_ = view.end_record;
    return true;
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
            return ceiling_of(slot, Ceilings::Wanted, input) > 0 ? Stands::Moving : Stands::NoFeed;
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
    // Part of the tick after which a distance is done, with the speed taken as linear in time.
    const auto part_at = [&](double distance) {
        if (!(moved > 0)) return 1.0;
        const double ratio = std::clamp(distance / moved, 0.0, 1.0);
        const double root = std::sqrt(std::max(0.0, v0 * v0 + (v1 * v1 - v0 * v0) * ratio));
        return v0 + root > 0 ? std::min(1.0, ratio * (v0 + v1) / (v0 + root)) : 1.0;
    };
    const bool landed = landing_end_ != kNone && v1 == 0 && next.a == 0 && landing_.landed();
    double s = state_.s + moved, done = -state_.s;  // done: from the tick's beginning to the beginning of the record
    double fraction = 0;
    state_ = {s, v1, next.a};
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
            if (!lands_here && v1 > 1e-3) ++anomalies_;
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
    PathStep step;
    step.began_from = step.began_to = step.ended_from = step.ended_to = first_;
    step.stands = Stands::Moving;
    if (at_rest()) step.stands = leave_standstill(input, step);
    if (step.stands == Stands::Moving) {
        if (input.emergency_dec > 0) {
            landing_end_ = kNone;
            const double time = std::min(dt_, state_.v / input.emergency_dec);
            carry({time * (state_.v - input.emergency_dec * time / 2), time < dt_ ? 0.0 : state_.v - input.emergency_dec * time, 0}, step);
        } else {
            const double left = at(first_).length - state_.s;
            if (at_rest() && left < 1e-9 && stops_at_end(first_)) {  // nothing to drive: rounding of an earlier stop
                landing_end_ = first_;
                landing_.at_once(left);
                carry({left, 0, 0}, step);
            } else {
                carry(choose(input), step);
            }
        }
        if (at_rest() && !done_ && input.hold) step.stands = Stands::Held;
    }
    step.record = first_;
    step.s = state_.s;
    step.speed = state_.v;
    step.acceleration = state_.a;
    return step;
}

}  // namespace polyturn::kernel
