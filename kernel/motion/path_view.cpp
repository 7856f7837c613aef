// What lies ahead of the path, as far as it can matter to this tick: ceilings lower than all before them, places where
// limits fall, the place where it must stand.
#include "kernel/motion/path_planner.hpp"

#include <cmath>

namespace polyturn::kernel {
namespace {
constexpr double kInfinity = std::numeric_limits<double>::infinity();
}  // namespace

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

}  // namespace polyturn::kernel
