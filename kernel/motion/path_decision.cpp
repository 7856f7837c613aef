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
//                way is slower, so if it has not fallen below some c_k in time, nothing could have.
//            (B) braking under the better limits that hold before A or J fall ("drop"), to a speed w with acceleration 0
//                where they do. w is the greatest from which the rest can be kept (settle_drops), by (A) from there.
//            That way is remembered (Witness). It needs nothing but to be followed, so if no faster step is safe at the
//            next tick, following it is: by induction there always is a safe step, and the path always can stop within
//            what is in the window. A witness stays valid when the view changes, for records are final.
//   arrives  (wanted ceilings only) Is each ceiling reached without the speed having to fall below it afterwards? Full
//            braking would carry its acceleration into the slow record and undershoot there, which is safe but slower.
//            Where a ceiling sinks steadily (a spiral) the acceleration is carried, for its release still ends below.
// A feed that is lowered is no longer "wanted" in time; then the hard question alone is asked, of steps towards the lowest
// ceiling that is violated.
//
// Rounding The way promised is computed anew each tick. Promises are given with kGiving and kept with kKeeping, which is
//          milder; near a stop a profile whose last phase is computed from its end takes over (landing.hpp).
// Right    tests: raw differences of the position on random records, feeds, overrides, holds at random ticks; anomalies() is
//          the number of ticks in which the induction failed, and stays 0.
// Cost     One pass over the view (groups of 16 that change nothing in one step each), then 1 (steady, accelerating) to some
//          15 (braking) judgements of a step; each costs a square root or two for each ceiling in view lower than all
//          before it.
// Weakness Acceleration is 0 where a slow record with lower limits begins. A spiral of many records, each slower than the
//          last, is in view with all its ceilings (up to kTargets; beyond them counts as standstill) and costs tens of
//          microseconds. Within the horizon only: 1024 records of 1/20 mm are 50 mm to brake in.
// Source   Witness: as in invariant-set filters of model predictive control. Rest: jerk_profile.hpp.
#include "kernel/motion/path_planner.hpp"

#include <cmath>

namespace polyturn::kernel {
namespace {

constexpr double kInfinity = std::numeric_limits<double>::infinity();
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

}  // namespace polyturn::kernel
