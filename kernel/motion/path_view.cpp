// What lies ahead of the path, as far as it can matter to this tick: ceilings lower than all before them, places where
// limits fall, the place where it must stand.
#include "kernel/motion/path_planner.hpp"

#include <cmath>

namespace polyturn::kernel {
namespace {
constexpr double kInfinity = std::numeric_limits<double>::infinity();
constexpr double kFall = 0.8, kRise = 1.25;  // that much is a border
}  // namespace

void PathPlanner::look_ahead(View& view, Ceilings which, const PathInput& input) noexcept {
    view.target_count = view.border_count = 0;
    view.leg_count = 0;
    // Legs that have been driven; one to a stand is so once it stands, though rounding may carry it over the border before.
    std::uint32_t driven = 0;
    const bool tail = state_.s <= kBefore / 4 && !at_rest();
    const auto is_driven = [&](const Leg& leg) { return leg.record < first_ || (leg.record == first_ && !(tail && leg.speed == 0)); };
    while (driven < witness_.count && is_driven(witness_.legs[driven])) ++driven;
    if (driven > 0) {
        for (std::uint32_t i = driven; i < witness_.count; ++i) witness_.legs[i - driven] = witness_.legs[i];
        witness_.count -= driven;
    }
    view.which = which;
    view.rounding = kGiving;
    view.end = kInfinity;
    view.end_record = kNone;
    view.beyond = first_ + 1;
    const double v = state_.v, a = state_.a;
    const Slot& running = at(first_);
    if (which == Ceilings::Hard && witness_.count > 0 && witness_.legs[0].record == first_) view.legs[view.leg_count++] = -state_.s;
    double run_a = running.a_max, run_j = running.j_max;
    view.tick_a = run_a;
    view.tick_j = run_j;
    view.ceiling = ceiling_of(running, which, input);
    // Of the targets so far. A ceiling that is violated already rules out nothing.
    double lowest = release_speed(v, std::max(a, 0.0), run_j) <= view.ceiling * (1 + kGiving) ? view.ceiling : running.v_max;
    view.top = lowest;
    double on_a = run_a, on_j = run_j, last_ceiling = view.ceiling;  // of the stretch since the last border; of the last record
    double distance = running.length - state_.s;
    double reach = 0, need = 0;
    // How far this tick can lead, and how far from there to a standstill.
    const auto measure = [&] {
        const double up = std::min(std::max(a, 0.0) + running.j_max * dt_, std::max(running.a_max, a));
        const double v_next = v + std::max(up, 0.0) * dt_;
        reach = v_next * dt_;
        need = reach + longest_braking(v_next, up, run_a, run_j);
        for (std::uint32_t i = 0; i < view.border_count; ++i) {
            need = std::max(need, view.borders[i].distance + longest_braking(view.borders[i].speed, 0, run_a, run_j));
        }
    };
    measure();
    const bool blocks = which == Ceilings::Wanted && input.single_block;
    const auto relief = [&](double speed) { return 2 * dt_ * speed; };
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
            const bool witness_inside = which == Ceilings::Hard && view.leg_count < witness_.count && witness_.legs[view.leg_count].record <= record + kGroup;
            const bool plain = !group.stops && !(blocks && group.block_ends) && (which == Ceilings::Hard || !group.mixed);
            if (plain && !witness_inside && group.a_max >= on_a && group.j_max >= on_j) {
                const double ceiling = which == Ceilings::Hard ? group.v_max : group_ceiling(group);
                const bool rises = (group.a_most > kRise * on_a || group.j_most > kRise * on_j) && group.longest > relief(std::min(last_ceiling, ceiling));
                if (ceiling >= lowest && !rises) {
                    distance += group.length;
                    record += kGroup;
                    view.beyond = record + 1;
                    if (at(record).length > 0) last_ceiling = ceiling_of(at(record), which, input);
                    continue;
                }
            }
        }
        const Slot& slot = at(++record);
        if (which == Ceilings::Hard && view.leg_count < witness_.count && record == witness_.legs[view.leg_count].record) {
            view.legs[view.leg_count++] = distance;
        }
        view.beyond = record + 1;
        if (slot.length > 0) {
            const double ceiling = ceiling_of(slot, which, input), before_a = run_a, before_j = run_j;
            // A border: limits fall below all before, or differ much from those of the stretch since the last border. A
            // short relief is none: it is over before it could be used.
            const bool least = slot.a_max < run_a || slot.j_max < run_j;
            const bool falls = slot.a_max < kFall * on_a || slot.j_max < kFall * on_j;
            const bool rises = (slot.a_max > kRise * on_a || slot.j_max > kRise * on_j) && slot.length > relief(std::min(last_ceiling, ceiling));
            if ((least || falls || rises) && view.border_count < kBorders) {
                if (view.border_count > 0) view.borders[view.border_count - 1].on_a = on_a, view.borders[view.border_count - 1].on_j = on_j;
                view.borders[view.border_count++] = {distance, std::min(last_ceiling, ceiling), run_a, run_j, 0, 0, record, kBorders, 0, 0};
                on_a = slot.a_max;
                on_j = slot.j_max;
                run_a = std::min(run_a, on_a);
                run_j = std::min(run_j, on_j);
                measure();
            } else {
                on_a = std::min(on_a, slot.a_max);
                on_j = std::min(on_j, slot.j_max);
                if (least) {
                    run_a = std::min(run_a, on_a);
                    run_j = std::min(run_j, on_j);
                    measure();
                }
            }
            last_ceiling = ceiling;
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
    view.rises = false;
    if (which == Ceilings::Hard) view.last = witness_;
    // Legs that end beyond the view, which is longer than any braking.
    while (which == Ceilings::Hard && view.leg_count < witness_.count) view.legs[view.leg_count++] = kInfinity;
    if (view.border_count > 0) {
        view.borders[view.border_count - 1].on_a = on_a;
        view.borders[view.border_count - 1].on_j = on_j;
        settle_borders(view);
    }
}

// From the last border backwards: lower each one's speed until everything behind it can be kept from there with acceleration
// 0; more exactly from a tick behind it, for braking goes on at the tick's end. Ways on: to a standstill under the least
// limits of all that follows, or to another border under the limits up to there. The fastest counts.
void PathPlanner::settle_borders(View& view) const noexcept {
    double rest_a = kInfinity, rest_j = kInfinity;
    for (std::uint32_t b = view.border_count; b-- > 0;) {
        Border& border = view.borders[b];
        rest_a = std::min(rest_a, border.on_a);
        rest_j = std::min(rest_j, border.on_j);
        view.rises = view.rises || rest_a > 1.05 * view.a || rest_j > 1.05 * view.j;
        const auto lowered = [&](double speed, double distance, double ceiling, double a_max, double j_max) {
            const double gap = distance - border.distance;
            if (distance_to_speed(speed, 0, ceiling, a_max, j_max) <= gap - speed * dt_) return speed;
            const double most = std::min(speed, top_speed(gap, ceiling, a_max, j_max));
            return std::min(most, top_speed(gap - most * dt_, ceiling, a_max, j_max));
        };
        const double ceiling = border.speed;
        double best = ceiling;
        const double enough = longest_braking(ceiling, 0, rest_a, rest_j) + ceiling * dt_;
        std::uint32_t behind = 0;  // first target behind the border
        while (behind < view.target_count && view.targets[behind].distance <= border.distance) ++behind;
        for (std::uint32_t i = behind; i < view.target_count && view.targets[i].distance - border.distance <= enough; ++i) {
            if (view.targets[i].ceiling < best) best = lowered(best, view.targets[i].distance, view.targets[i].ceiling, rest_a, rest_j);
        }
        if (view.end < kInfinity) best = lowered(best, view.end, 0, rest_a, rest_j);
        border.via = kBorders;
        border.via_a = rest_a;
        border.via_j = rest_j;
        double way_a = kInfinity, way_j = kInfinity, least = kInfinity;
        std::uint32_t i = behind;
        for (std::uint32_t m = b + 1; m < view.border_count && best < ceiling; ++m) {
            way_a = std::min(way_a, view.borders[m - 1].on_a);
            way_j = std::min(way_j, view.borders[m - 1].on_j);
            double speed = ceiling;
            for (; i < view.target_count && view.targets[i].distance < view.borders[m].distance; ++i) least = view.targets[i].ceiling;
            for (std::uint32_t k = behind; k < i; ++k) {
                if (view.targets[k].ceiling < speed) speed = lowered(speed, view.targets[k].distance, view.targets[k].ceiling, way_a, way_j);
            }
            const double there = std::min(view.borders[m].speed, least);
            if (there < speed) speed = lowered(speed, view.borders[m].distance - 2 * kBefore, there, way_a, way_j);
            if (speed > best) {
                best = speed;
                border.via = m;
                border.via_a = way_a;
                border.via_j = way_j;
            }
        }
        border.speed = best;
    }
}

}  // namespace polyturn::kernel
