// How the planner decides. Its window and the carrying over records: path_planner.cpp; what it sees: path_view.cpp.
//
//   v |        target 1                          Every tick asks: which is the fastest step after which everything
//     |  ----.                    .------        ahead can still be kept?
//     |       '-.                 |
//     |          '-. arrives      |  target 2    A step is one tick of the time-optimal way to some speed w. If w = the
//     |        .    '-------------'-----.        ceiling here is not allowed, w is bisected. What is not planned yet, an
//     |         ' .  falls              |        exact stop, a record that the kernel executes: standstill.
//     +-----------'---------------------'---> s
//
// Given    (s, v, a) now; ceilings c_k, A_k, J_k of each record in view; feeds, which are wanted but not at any price.
//
// Two questions are asked of the state after a step.
//   safe     Is there a way to go on that keeps every hard ceiling whatever comes? Two kinds of way are tried:
//            (A) full braking to a standstill under the least A, J of the whole view. At every point of the path no other
//                way under these limits is slower, so if it does not fall below some c_k in time, none does.
//            (B) braking under the limits up to a border, a place where limits fall or rise, to a speed with acceleration 0
//                there from which the rest can be kept: from border to border or to a standstill, each leg under the
//                limits of its own stretch (settle_borders). Without (B) a slow blend's low limits would count for the
//                long lines around it.
//            That way is remembered leg by leg (Witness). It needs nothing but to be followed, so if no faster step is safe
//            at the next tick, following it is: by induction there always is a safe step, and the path can always stop
//            within what is in the window. A witness stays good when the view changes, for records are final.
//   arrives  (wanted ceilings only) Is each ceiling reached without the speed having to fall below it afterwards? Full
//            braking would carry its acceleration into the slow record and undershoot there, which is safe but slower.
//            Where a ceiling sinks steadily (a spiral) the acceleration is carried, for its release still ends below.
// A feed that is lowered is no longer "wanted" in time; then the hard question alone is asked, of steps towards the lowest
// ceiling that is violated.
//
// Rounding The way promised is computed anew each tick. Promises are given with kGiving and kept with kKeeping, which is
//          milder; a promise that ends at a border ends kBefore in front of it. The last way to a stand is a landing, whose
//          end is exact (landing.hpp).
// Right    tests: raw differences of the position on random records, feeds, overrides, holds at random ticks; anomalies()
//          counts the ticks in which the induction failed (none in ten thousands of random programs but for roundings in the
//          last tick of a stop); such a tick brakes.
// Time     tests/bench/motion_bench: 0.5 % above the least time where limits do not change along the path, 10 % where each
//          of some hundred short records has its own.
// Cost     One pass over the view (groups of 16 that change nothing in one step each), then 1 (steady, accelerating) to some
//          15 (braking) judgements of a step; each costs a square root or two for each ceiling in view that is lower than
//          all before it. 0.3 us on long lines, 0.7 to 2 us on lines and blends of 0.1 mm.
// Weakness Acceleration is 0 at a border that is used. A spiral of many records, each slower than the last, is in view with
//          all its ceilings (up to kTargets; beyond them counts as standstill) and costs some ten microseconds. Nothing is
//          seen behind the horizon: 1024 records of 1/20 mm are 50 mm to brake in.
// Source   Witness: as in invariant-set filters of model predictive control. Rest: jerk_profile.hpp.
#include "kernel/motion/path_planner.hpp"

#include <cmath>

namespace polyturn::kernel {
namespace {

constexpr double kInfinity = std::numeric_limits<double>::infinity();
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

PathPlanner::Step PathPlanner::step_towards(double speed, double a, double j) const noexcept {
    Step step{speed, a, j, towards_speed({0, state_.v, state_.a}, speed, a, j, dt_)};
    PathState& next = step.next;
    // The last thousandth of a stop that ends just behind the tick: at rest.
    if (state_.a < 0 && next.a <= 0 && next.v < 1e-6 && next.v > -1e-6 && -next.a < 0.02 * j * dt_) next.v = next.a = 0;
    return step;
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
bool PathPlanner::safe(const View& view, const Step& step, Way& way) const noexcept {
    const PathState& next = step.next;
    const double v = next.v, a = next.a;
    if (v < 0 || (state_.a < 0 && release_speed(state_.v, state_.a, step.j) < -1e-9)) return false;
    for (std::uint32_t i = 0; i < view.target_count && view.targets[i].distance < next.s; ++i) {
        const double ceiling = view.targets[i].ceiling * (1 + 1e-4);
        const double highest = std::max(state_.a > 0 ? release_speed(state_.v, state_.a, step.j) : state_.v, v);
        if (highest <= ceiling) continue;
        if (std::min(state_.v, v) > ceiling || speed_at(step, view.targets[i].distance) > ceiling) return false;
    }
    // Limits of this side of a border must not act beyond it, but to be steady there.
    if (step.j > view.tick_j || step.a > view.tick_a) {
        double side = kInfinity;
        for (std::uint32_t d = view.border_count; d-- > 0;) {
            const bool last = d + 1 == view.border_count;
            if ((last ? view.a : view.borders[d + 1].a) < step.a || (last ? view.j : view.borders[d + 1].j) < step.j) side = view.borders[d].distance;
        }
        if (next.s > side + kBefore / 4 && (a != 0 || distance_to_speed(state_.v, state_.a, step.speed, step.a, step.j) > side + kBefore)) return false;
    }
    if (v == 0 && a == 0 && next.s <= view.end + kBefore / 4) {  // whoever stands can go on at any pace
        way = {kLeast, 0};
        return true;
    }
    const auto all_arrived_at = [&](double until) {
        for (std::uint32_t i = 0; view.which == Ceilings::Wanted && i < view.target_count && view.targets[i].distance < until; ++i) {
            const Target& target = view.targets[i];
            if (!arrives(v, a, target.distance - next.s - 2 * kBefore, target.ceiling, target.a, target.j, view.rounding)) return false;
        }
        return true;
    };
    const auto stands_in_time = [&](const Braking& braking) {
        return view.end == kInfinity || braking.distance() <= (view.end - next.s) * (1 + view.rounding / 10) + view.rounding * 1e-4;
    };
    const auto all_kept = [&] {
        if (a > 0 && release_speed(v, a, view.j) > view.top * (1 + view.rounding)) return false;
        const Braking braking(v, a, 0, view.a, view.j);
        if (!stands_in_time(braking)) return false;
        for (std::uint32_t i = 0; i < view.target_count; ++i) {
            const Target& target = view.targets[i];
            if (!falls_below(braking, target.distance - next.s, target.ceiling, view.rounding)) return false;
        }
        return true;
    };
    const auto cannot_but_reverse = [&](double j_max) { return a < 0 && release_speed(v, a, j_max) < -1e-9; };
    // Acceleration above a limit that holds from some drop on must have gone before the first such border.
    double gone_by = kInfinity;
    for (std::uint32_t d = view.border_count; d-- > 0;) {
        const double after = d + 1 < view.border_count ? view.borders[d + 1].a : view.a;
        if (std::abs(a) > after * (1 + 1e-12)) gone_by = view.borders[d].distance;
    }
    const auto within = [&](double a_max, double j_max) {
        if (std::abs(a) <= a_max * (1 + 1e-12)) return true;
        return gone_by < kInfinity && advanced(next, a > 0 ? -j_max : j_max, (std::abs(a) - a_max) / j_max).s <= gone_by;
    };
    // Under the least limits of the whole view.
    if (within(view.a, view.j) && !cannot_but_reverse(view.j) && all_arrived_at(kInfinity) && all_kept()) {
        way = {kLeast, 0};
        return true;
    }
    // One braking to a speed without acceleration at a distance, below everything before it; or to a stand before it.
    const auto braked = [&](double distance, double speed, double a_max, double j_max, double before, double& w) {
        const double gap = distance - next.s;
        if (gap < std::min(before, 0.0) || !within(a_max, j_max) || cannot_but_reverse(j_max)) return false;
        if (a > 0 && release_speed(v, a, j_max) > view.top * (1 + view.rounding)) return false;
        w = std::min(speed, std::max(0.0, release_speed(v, a, j_max)));
        for (std::uint32_t i = 0; i < view.target_count && view.targets[i].distance < distance; ++i) w = std::min(w, view.targets[i].ceiling);
        for (;;) {
            const Braking braking(v, a, w, a_max, j_max);
            bool kept = gap < kInfinity ? braking.distance() <= (gap - before) * (1 + view.rounding / 10) + view.rounding * 1e-4 : stands_in_time(braking);
            for (std::uint32_t i = 0; kept && i < view.target_count && view.targets[i].distance < distance; ++i) {
                kept = falls_below(braking, view.targets[i].distance - next.s, view.targets[i].ceiling, view.rounding);
            }
            if (kept) return true;
            if (w == 0 || view.which == Ceilings::Wanted) return false;
            w = 0;
        }
    };
    for (std::uint32_t b = 0; b < view.border_count; ++b) {
        const Border& border = view.borders[b];
        if (border.distance < next.s) continue;
        if (!all_arrived_at(border.distance)) break;  // nor would it for one further away
        if (braked(border.distance, border.speed, border.a, border.j, view.rounding > kGiving ? kBefore / 2 : kBefore, way.speed)) {
            way.by = b;
            return true;
        }
    }
    // Or on the way of the step before.
    for (std::uint32_t i = 0; i < view.leg_count; ++i) {
        const Leg& leg = view.last.legs[i];
        if (view.legs[i] + kBefore / 4 < next.s) continue;
        if (braked(view.legs[i], leg.speed, leg.a, leg.j, view.rounding > kGiving ? -kBefore / 4 : 0, way.speed)) {
            way.by = kKept + i;
            return true;
        }
        break;  // a later leg begins where this one ends
    }
    return false;
}

// If a step is safe, remember why.
bool PathPlanner::take(const View& view, const Step& step) noexcept {
    Way way{};
    if (!safe(view, step, way)) return false;
    if (way.by >= kKept) {
        const std::uint32_t from = way.by - kKept;
        for (std::uint32_t i = from; i < view.last.count; ++i) witness_.legs[i - from] = view.last.legs[i];
        witness_.count = view.last.count - from;
        witness_.legs[0].speed = way.speed;
        return true;
    }
    Witness& w = witness_;
    w.count = 0;
    double a = view.a, j = view.j;
    if (way.by != kLeast) {
        const Border* border = &view.borders[way.by];
        w.legs[w.count++] = {border->record, way.speed, border->a, border->j};
        for (;;) {
            a = border->via_a;
            j = border->via_j;
            if (border->via == kBorders) break;
            border = &view.borders[border->via];
            w.legs[w.count++] = {border->record, border->speed, a, j};
        }
    }
    w.legs[w.count++] = {view.beyond, 0, a, j};
    return true;
}

// The fastest safe step among those towards a speed up to goal.
bool PathPlanner::best_towards(View& view, double goal, double a, double j, PathState& next) noexcept {
    const Step most = step_towards(goal, a, j);
    next = most.next;
    if (take(view, most)) return true;
    Step least = step_towards(0, a, j);
    if (!take(view, least)) {
        // Too hard can be wrong too: acceleration could no longer be gone where limits fall. What was promised is not.
        if (witness_.count == 0) return false;
        least = step_towards(witness_.legs[0].speed, a, j);
        view.rounding = kKeeping;
        const bool kept = take(view, least);
        view.rounding = kGiving;
        if (!kept) return false;
    }
    next = least.next;
    // What a tick of full jerk either way leads to bounds the speeds worth asking for.
    const double up_a = std::min(state_.a + j * dt_, a);
    const double highest = release_speed(state_.v + std::max(state_.a, up_a) * dt_, up_a, j);
    double low = least.speed > 0 ? least.speed : std::clamp(release_speed(next.v, next.a, j), 0.0, goal), high = std::min(goal, highest);
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
    if (view_.end < kInfinity && begin_landing(view_, false)) return landing_.step(dt_);
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
    if (begin_landing(view_, false)) return landing_.step(dt_);
    if (best_towards(view_, wanted, view_.tick_a, view_.tick_j, next)) return next;
    if (best_towards(view_, wanted, view_.a, view_.j, next)) return next;
    // As the last step promised.
    view_.rounding = 3 * kKeeping;
    if (view_.last.count > 0) {
        const Leg leg = view_.last.legs[0];
        for (const double speed : {leg.speed, 0.0}) {
            step = step_towards(speed, leg.a, leg.j);
            if (take(view_, step)) return step.next;
        }
    }
    for (std::uint32_t d = 0; d < view_.border_count; ++d) {
        const Border& border = view_.borders[d];
        for (const double speed : {std::min(wanted, border.speed), 0.0}) {
            step = step_towards(speed, border.a, border.j);
            if (take(view_, step)) return step.next;
        }
    }
    if (begin_landing(view_, true)) return landing_.step(dt_);
    ++anomalies_;
    return step_towards(0, view_.a, view_.j).next;
}

bool PathPlanner::begin_landing(const View& view, bool before_rises) noexcept {
    const double v = state_.v, a = state_.a, distance = view.end;
    if (view.end_record == kNone || (view.rises && !before_rises) || !(v > 0) || std::abs(a) > view.a * (1 + 1e-12)) return false;
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

}  // namespace polyturn::kernel
