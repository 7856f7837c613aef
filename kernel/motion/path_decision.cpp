// How the planner decides. Its window and the carrying over records: path_planner.cpp; what it
// sees: path_view.cpp.
//
//   v |        stretch 2                     Every tick asks: which is the fastest step from
//     |  ----.                    .------    which the path can still come to standstill, below
//     |       '-.                 |          every speed limit and within every limit ahead?
//     |          '-. arrives      |
//     |        .    '-------------'-----.    A step is one tick of the time-optimal approach to
//     |         ' .  brakes             |    the speed limit here. If it is not allowed, a step
//     +-----------'---------------------'--> s   between it and braking as hard as can be, by
//                                            bisection.
//
// What is not planned yet, an exact stop, a record that the kernel executes: standstill.
//
// Given    (s, v, a) now; speed limits and limits of each stretch of the road; feeds, which are
//          wanted but not at any price.
//
// Two questions are asked of the state after a step.
//   safe     Does braking as hard as can be from there (braking.hpp) keep every hard speed limit
//            and every limit and end before the path must stop? No other braking is slower at any
//            place, so if it does not fall below a speed limit in time, none does. That braking is
//            remembered: it is committed. If no faster step is safe at the next tick, it is
//            followed, as it was computed. So there always is a safe step, and the path can always
//            stop within what is in the window; the committed profile stays good when the view
//            changes, for records are final.
//   arrives  (wanted speed limits only) Is each speed limit reached without the speed having to
//            fall below it afterwards? Full braking would carry its acceleration into the slow
//            record and undershoot there, which is safe but slower.
// A feed that is lowered is no longer "wanted" in time; then the hard question alone is asked, of
// steps towards the lowest limit that is violated.
//
// Rounding The last part before standstill is a landing, whose end is exact (landing.hpp).
// Right    tests: raw differences of the position on random records, feeds, overrides, holds at
//          random ticks; anomalies() counts the ticks without a committed profile or a safe step.
// Time     tests/bench/motion_bench: 0.5 % above the least time on lines, 6 to 10 % on curves.
// Cost     Most ticks follow the committed profile (committed_profile.cpp): 0.1 us on lines, 0.8 us
//          with a slow blend every few millimetres or lines and blends of 0.1 mm in turn. A tick
//          that thinks tries at most kPiecesPerTick pieces of brakings, some 6 us.
// Weakness Acceleration ends before a wanted speed limit, however steadily it sinks (a spiral).
//          Nothing is seen behind the horizon: 1024 records of 1/20 mm are 50 mm to brake in.
// Source   Committed profile: as in invariant-set filters of model predictive control.
//          Rest: jerk_profile.hpp.
#include <cmath>

#include "kernel/motion/path_planner.hpp"

namespace polyturn::kernel {
namespace {

constexpr double kInfinity = std::numeric_limits<double>::infinity();
// Steps between braking and full speed: the best is found to 1/128 of what a tick can change. What
// is lost is made up for in the next tick.
constexpr int kBisections = 7;
// The time within a tick at which a distance is reached: 2^-40 of the tick, 1e-12 of it.
constexpr int kTimeBisections = 40;
// The same for a landing's piece, which may last seconds: 2^-30 of it, nanoseconds.
constexpr int kLandingBisections = 30;

constexpr double kRounding = 1e-8;  // mm, of a place on the road
// A speed limit is kept but for this part of it: within a tick, where the speed is interpolated,
// and on a landing, which is computed.
constexpr double kSpeedInTick = 1e-4, kSpeedOnLanding = 1e-7;
// Not even on the way to a lower speed within a tick is the record's own speed limit passed by
// more.
constexpr double kOwnSpeedLimit = 1.001;
// Two speed limits are the same if they differ by less than this part.
constexpr double kSameSpeedLimit = 1e-9;
// mm/s: a step whose release would lead below minus this goes backwards.
constexpr double kBackwards = 1e-9;

// At rest at the end of a step: mm/s, and of the acceleration that a tick can change. A stop that
// ends just behind the tick would need another tick for less than the thousandth of one.
constexpr double kStopSpeed = 1e-6, kStopAcceleration = 0.02;

// Braking that takes more than this part of the travel that is left is asked for by the stop, not
// by a speed limit before it.
constexpr double kStands = 0.85;
// Braking to a crawl can be longer than to standstill (jerk_profile.hpp, the trap): speed limits
// matter as far behind its end as this part of it and A^3 / (4 J^2). More would only cost a look.
constexpr double kLonger = 0.15;
// Of the acceleration allowed: with it the limits at a lower speed limit are estimated, for it is
// entered with less than all and the jerk allowed depends on it.
constexpr double kHalfBraking = 0.5;
constexpr double kFast = 1e6;  // mm/s, above every speed limit: as hard as can be

// A rest is too short to be driven when a tick at the full jerk would go 10 times as far: j t^3 is
// the travel that a change of jerk makes in a tick, but for a factor.
constexpr double kRest = 0.1;
// mm and of the travel: the end of the braking and the end of the road are the same place.
constexpr double kSameEnd = 1e-6;
// Of the acceleration allowed: above it is rounding.
constexpr double kAccelerationRounding = 1e-12;
// Ticks to standstill: with fewer the landing may begin although limits change on the way (they
// grow as the speed falls, and the least are taken), and with fewer than the second it begins
// although more speed could still be had.
constexpr double kSoonTicks = 6, kNowTicks = 3;
// Of the jerk: a stop that is possible with this much is not due yet; what is left to the full jerk
// is the play with which the landing can still meet its end.
constexpr double kSofter = 0.95;
constexpr double kDueRounding = 1e-9;  // of the way
// A landing may be as much softer than the limit as this: the softest that is still worth driving.
constexpr double kSoftestLanding = 100;

PathState between(const PathState& low, const PathState& high, double part) noexcept {
    return {low.s + part * (high.s - low.s), low.v + part * (high.v - low.v),
            low.a + part * (high.a - low.a)};
}

}  // namespace

PathPlanner::Step PathPlanner::step_towards(double speed, const Limits& limits) const noexcept {
    Step step{towards_speed({0, state_.v, state_.a}, speed, limits.a, limits.j, dt_), speed,
              limits};
    PathState& next = step.next;
    // The last thousandth of a stop that ends just behind the tick: at rest.
    if (state_.a < 0 && next.a <= 0 && next.v < kStopSpeed && next.v > -kStopSpeed &&
        -next.a < kStopAcceleration * limits.j * dt_)
        next.v = next.a = 0;
    return step;
}

// How fast is a step where it has come to a distance?
double PathPlanner::speed_at(const Step& step, double distance) const noexcept {
    const double v0 = state_.v, v1 = step.next.v;
    if (!(step.limits.a > 0))
        return std::sqrt(
            std::max(0.0, v0 * v0 + (v1 * v1 - v0 * v0) * std::min(1.0, distance / step.next.s)));
    const PathState start{0, v0, state_.a};
    double low = 0, high = dt_;
    for (int i = 0; i < kTimeBisections; ++i) {
        const double middle = (low + high) / 2;
        (towards_speed(start, step.speed, step.limits.a, step.limits.j, middle).s < distance
             ? low
             : high) = middle;
    }
    return towards_speed(start, step.speed, step.limits.a, step.limits.j, high).v;
}

// Is a step safe, and if speed limits are wanted, does it arrive at each? tried_ is the braking
// from there.
bool PathPlanner::safe(View& view, SpeedLimits which, const Step& step) noexcept {
    const PathState& next = step.next;
    if (next.v < 0 || next.s < 0) return false;
    // backwards within it
    if (step.limits.a > 0 && state_.a < 0 &&
        release_speed(state_.v, state_.a, step.limits.j) < -kBackwards)
        return false;
    // Limits that are passed within the tick.
    const double highest = std::max(
        {state_.v, next.v,
         state_.a > 0 && next.a <= 0 ? release_speed(state_.v, state_.a, view.tick.j) : 0.0});
    if (highest > kOwnSpeedLimit * at(first_).v_max && highest > std::max(state_.v, next.v))
        return false;
    for (std::uint32_t i = 0; view.end_of(i) < next.s; ++i) {
        const Stretch* const entered = view.stretch(i + 1);
        if (entered == nullptr) break;
        const double speed_limit = entered->speed_limit * (1 + kSpeedInTick);
        if (highest > speed_limit && speed_at(step, entered->begin) > speed_limit) return false;
    }
    return comes_to_rest(view, which, next);
}

// From a point on the road: can it come to standstill, and if speed limits are wanted, by way of
// each of them?
bool PathPlanner::comes_to_rest(View& view, SpeedLimits which, const PathState& next) noexcept {
    if (next.v == 0 && next.a == 0 && next.s <= view.end_of(view.within)) {
        tried_.stand();
        return true;
    }
    if (committed_time_ >= 0 && pieces_ > kPiecesPerTick) return false;
    // Straight to standstill, if the standstill determines the speed.
    tried_.along(view, next);
    pieces_ += tried_.pieces();
    const bool stands = tried_.possible();
    if (stands && (which == SpeedLimits::Hard ||
                   (view.closed() && tried_.distance() >= kStands * (view.end() - next.s))))
        return true;
    const double speed =
        stands ? tried_.peak()
               : std::max(next.v, release_speed(next.v, std::max(next.a, 0.0), view.tick.j));
    // mm, what the trap of jerk_profile.hpp adds at the most, twice
    const double crawl = view.tick.a * view.tick.a * view.tick.a / (4 * view.tick.j * view.tick.j);
    const double end = stands ? tried_.end() + kLonger * tried_.distance() + crawl
                              : next.s + speed * (speed / view.tick.a + view.tick.a / view.tick.j);
    // The first slower stretch from whose speed the next slower one, or standstill, can still be
    // reached.
    Braking::Aim first{kInfinity, 0};
    Limits there;
    double lowest = speed;
    for (std::uint32_t i = 0; view.end_of(i) < end; ++i) {
        const Stretch* const ahead = view.stretch(i + 1);
        if (ahead == nullptr) break;
        if (ahead->begin <= next.s || ahead->speed_limit >= lowest * (1 - kSameSpeedLimit) ||
            (stands && ahead->begin <= tried_.falls_from()))
            continue;
        lowest = ahead->speed_limit;
        if (first.at < kInfinity &&
            distance_to_speed(first.speed, 0, lowest, there.a, there.j) <= ahead->begin - first.at)
            break;
        first = {ahead->begin, lowest};
        there = ahead->limits.at(lowest, kHalfBraking * ahead->limits.a);
        if (!(there.a > 0) || !(there.j > 0)) break;
    }
    if (stands && (first.at == kInfinity ||
                   (view.closed() &&
                    stopping_distance(first.speed, 0, there.a, there.j) > view.end() - first.at)))
        return true;
    // By way of the next slower stretches, at their speed.
    if (!(first.speed > 0)) return false;
    tried_.by_way_of(first, view, next);
    pieces_ += tried_.pieces();
    return tried_.possible();
}

bool PathPlanner::take(View& view, SpeedLimits which, const Step& step) noexcept {
    if (!safe(view, which, step)) return false;
    commit(which);
    return true;
}

// The step nearest to `high` that can be taken; `low` is as good as committed. False: none but
// that.
bool PathPlanner::best_between(View& view, SpeedLimits which, const PathState& low,
                               const PathState& high, PathState& next) noexcept {
    double good = 0, bad = 1;
    for (int i = 0; i < kBisections; ++i) {
        const double part = (good + bad) / 2;
        (take(view, which, {between(low, high, part), 0, {}}) ? good : bad) = part;
    }
    next = between(low, high, good);
    return good > 0;
}

// Of the wanted limits that braking from a state does not arrive at.
double PathPlanner::lowest_violated(View& view, const PathState& next) noexcept {
    tried_.along(view, next, false);
    double lowest = std::max(next.v, tried_.peak()), violated = kInfinity;
    for (std::uint32_t i = 0;
         i == 0 || view.end_of(i - 1) < tried_.end() + kLonger * tried_.distance(); ++i) {
        const Stretch* const ahead = view.stretch(i);
        if (ahead == nullptr) break;
        if (ahead->speed_limit >= lowest) continue;
        lowest = ahead->speed_limit;
        if (!tried_.possible() || !tried_.arrives(lowest, ahead->begin + kRounding))
            violated = lowest;
    }
    return violated;
}

// Has what is wanted changed since the last tick? (Of spindles the one of the running record: with
// another one's the limits of later records may differ from the announced ones, which is seen when
// they are near.)
bool PathPlanner::want(const PathInput& input) noexcept {
    const Slot& running = at(first_);
    const bool turns = running.feed_mode == FeedMode::PerRevolution &&
                       input.spindle_rev_s != nullptr && running.spindle >= 1 &&
                       running.spindle <= kMaxSpindles;
    const std::array<double, 7> now{input.feed_override,
                                    input.rapid_override,
                                    input.dry_run_feed,
                                    input.speed_ceiling,
                                    turns ? input.spindle_rev_s[running.spindle - 1] : 0,
                                    static_cast<double>(input.single_block),
                                    static_cast<double>(input.hold)};
    const bool changed = now != wanted_;
    wanted_ = now;
    return changed;
}

PathState PathPlanner::choose(const PathInput& input) noexcept {
    if (landing_end_ != kNone &&
        (stops_at_end(landing_end_) || (input.single_block && landing_end_ == block_latch_)))
        return landing_.step(dt_);
    const bool wants_changed = want(input);
    other_wanted_ = other_wanted_ || wants_changed;
    if (follows_blindly()) {
        if (pushed_ == push_end_) --timeout_;
        return follow_committed();
    }
    pieces_ = 0;
    if (other_wanted_ && committed_time_ >= 0 && (pushed_ < push_end_ || committed_aims_) &&
        !commit_braking(input) && pushed_ < push_end_)
        return follow_committed();
    other_wanted_ = false;
    timeout_ = 0;
    view_.begin(*this, SpeedLimits::Wanted, input);
    const double goal = input.hold ? 0 : view_.speed_limit;
    Step step = step_towards(goal, view_.tick);
    PathState next;
    if (!input.hold && !wants_changed && landing_end_ == kNone) {
        if (push(view_)) {
            stride_ = push_end_;
            failures_ = 0;
            return follow_committed();
        }
    }
    // a slow record that ends before its limit could be passed
    if (!input.hold && view_.rises({0, state_.v, state_.a})) {
        const Step most = step_towards(kFast, view_.tick);
        bool taken = true;
        if (take(view_, SpeedLimits::Wanted, most))
            next = most.next;
        else if (!take(view_, SpeedLimits::Wanted, step))
            taken = false;
        else if (!best_between(view_, SpeedLimits::Wanted, step.next, most.next, next))
            next = step.next;
        if (taken) {
            landing_end_ = kNone;
            return next;
        }
    }
    if (landing_end_ != kNone) {  // the path goes on; but a landing is safe until something else is
        Landing landing = landing_;
        const PathState low = landing.step(dt_);
        if (take(view_, SpeedLimits::Wanted, step)) {
            next = step.next;
        } else if (!best_between(view_, SpeedLimits::Wanted, low, step.next, next)) {
            landing_ = landing;
            return low;
        }
        landing_end_ = kNone;
        return next;
    }
    if (take(view_, SpeedLimits::Wanted, step)) {
        stride_ = 1;
        return step.next;
    }
    if (begin_landing(view_)) return landing_.step(dt_);
    if (step_over_rest(view_)) return {view_.end(), 0, 0};
    // As hard as can be: as committed, or found now.
    const bool committed = committed_time_ >= 0;
    const PathState low =
        committed ? committed_.follow(committed_time_, dt_) : step_towards(0, view_.tick).next;
    const auto best = [&](SpeedLimits which) {
        if (!best_between(view_, which, low, step.next, next))
            next = committed ? follow_committed() : low;
        if (which == SpeedLimits::Wanted || input.hold) keep_braking_profile();
        return next;
    };
    const bool arrives = committed && committed_wanted_ && !wants_changed;
    if (arrives || (committed ? safe(view_, SpeedLimits::Wanted, {low, 0, {}})
                              : take(view_, SpeedLimits::Wanted, {low, 0, {}})))
        return best(SpeedLimits::Wanted);
    // What is wanted cannot be kept (a feed has been lowered): brake to the lowest that is
    // violated, as the hard limits allow.
    const double wanted = std::min({goal, state_.v, lowest_violated(view_, low)});
    view_.begin(*this, SpeedLimits::Hard, input);
    if (begin_landing(view_)) return landing_.step(dt_);
    step = step_towards(wanted, view_.tick);
    if (take(view_, SpeedLimits::Hard, step)) return step.next;
    if (!committed && !take(view_, SpeedLimits::Hard, {low, 0, {}})) {
        ++anomalies_;
        return low;
    }
    return best(SpeedLimits::Hard);
}

// What an earlier stop left: too short to be driven, and far below what any limit would notice.
bool PathPlanner::step_over_rest(View& view) noexcept {
    if (!at_rest() || !(view.speed_limit > 0)) return false;
    const double most = kRest * view.tick.j * dt_ * dt_ * dt_;
    for (std::uint32_t i = 0; view.end_of(i) <= most; ++i) {
        if (view.stretch(i + 1) != nullptr) continue;
        if (view.end_record == kNone) return false;
        landing_end_ = view.end_record;
        drop_committed();
        landing_.at_once(view.end());
        return true;
    }
    return false;
}

// The remaining distance to standstill as one profile that ends exactly there, if it is short or
// nothing changes on it.
bool PathPlanner::begin_landing(View& view) noexcept {
    const double v = state_.v, a = state_.a;
    if (!(v > 0) || committed_time_ < 0) return false;
    const double left = committed_.duration() - committed_time_;
    // Is the end in sight of the braking, and how soon?
    const double stands = committed_.distance() - committed_.follow(0, committed_time_).s;
    std::uint32_t last = 0;
    Limits least = view.stretch(0)->limits;
    bool alike = true;
    while (view.end_of(last) < stands * (1 + kSameEnd) + kSameEnd) {
        const Stretch* const next = view.stretch(last + 1);
        if (next == nullptr) break;
        alike = alike && !next->limits.narrower_than(least) && !least.narrower_than(next->limits);
        least.narrow(next->limits);
        ++last;
    }
    const double distance = view.end_of(last);
    if (!view.closed() || view.stretch(last + 1) != nullptr || view.end_record == kNone)
        return false;
    Limits limits = least.at(v, std::abs(a));  // they grow as the speed falls
    if (!(limits.j > 0)) return false;
    const double highest = a > 0 ? v + a * a / limits.j : v;  // before it falls, it rises
    if (a > 0) limits = least.at(highest, a);
    if (!(limits.a > 0) || !(limits.j > 0) || std::abs(a) > limits.a * (1 + kAccelerationRounding))
        return false;
    if (left > kSoonTicks * dt_ && (!alike || !limits.flat() || !least.flat())) return false;
    // Now, or can more speed still be had?
    const double softer = std::max(kSofter * limits.j, a < 0 ? a * a / (2 * v) : 0.0);
    if (stopping_distance(v, a, limits.a, softer) <= distance * (1 - kDueRounding) &&
        stopping_time(v, a, limits.a, limits.j) > kNowTicks * dt_)
        return false;
    if (!landing_.aim(v, a, distance, limits.a, limits.j / kSoftestLanding,
                      limits.j / kPlannedJerk))
        return false;
    if (a > 0 && !least.flat() && release_speed(v, a, landing_.jerk()) > highest) return false;
    // It never rises above where it is by more than the limits allow, and comes below each in
    // time.
    const double rises_until =
        a > 0 ? advanced({0, v, a}, -landing_.jerk(), a / landing_.jerk()).s : 0;
    const SpeedProfile profile = profile_to_speed(v, a, 0, limits.a, landing_.jerk());
    for (std::uint32_t i = 0; i <= last; ++i) {
        const Stretch& stretch = *view.stretch(i);
        PathState x{0, v, a};
        for (int piece = 0; piece < 3; ++piece) {
            const PathState end = advanced(x, profile.jerk[piece], profile.time[piece]);
            if (x.s >= stretch.begin && x.v > stretch.speed_limit * (1 + kSpeedOnLanding))
                return false;
            if (end.s > stretch.begin && x.s < stretch.begin) {
                double low = 0, high = profile.time[piece];
                for (int k = 0; k < kLandingBisections; ++k) {
                    const double middle = (low + high) / 2;
                    (advanced(x, profile.jerk[piece], middle).s < stretch.begin ? low : high) =
                        middle;
                }
                if (advanced(x, profile.jerk[piece], high).v >
                    stretch.speed_limit * (1 + kSpeedOnLanding))
                    return false;
            }
            x = end;
        }
        if (a > 0 && stretch.begin <= rises_until &&
            release_speed(v, a, landing_.jerk()) > stretch.speed_limit)
            return false;
    }
    landing_end_ = view.end_record;
    drop_committed();
    return true;
}

}  // namespace polyturn::kernel
