#include "kernel/channel/path/place_axes.hpp"

#include <algorithm>
#include <cmath>

#include "kernel/channel/program/settle.hpp"
#include "kernel/records/record_kinds.hpp"

namespace polyturn::kernel {
namespace {

constexpr double kMoves = 1e-9;  // mm, degrees in a tick: less is how transformations round

// 1/s that spindle and axes of a tapping move have in common (N1532); 0: it is none.
double tap_gain_of(const Core& core, const PathRecord& r) noexcept {
    if (!(r.flags & kTapping)) return 0.0;
    const std::uint32_t s = r.axis[r.axis_count] - static_cast<std::uint32_t>(kMaxAxes);
    return s < kMaxSpindles ? core.spindles[s].range().tap_gain : 0.0;
}

// The spindle's share of a tapping move; false: it has no closed loop.
bool place_spindle(Channel& c, const PathRecord& r, double s) noexcept {
    const std::uint32_t number = r.axis[r.axis_count] - static_cast<std::uint32_t>(kMaxAxes);
    if (number >= kMaxSpindles || !c.core.spindles[number].closed()) {
        c.raise(Alarm::SpindleNotClosed,
                name_of('S', std::min<std::uint32_t>(number, kMaxSpindles - 1)).view());
        return false;
    }
    SpindleUnit& spindle = c.core.spindles[number];
    if (c.axes.tapped != c.axes.record) {  // a new move begins where the last one ended
        c.axes.tapped = c.axes.record;
        c.axes.tap_from = spindle.position();
    }
    spindle.tapping(true, r.value != 0);
    spindle.interpolate(c.axes.tap_from + r.end[r.axis_count] * s / r.length);
    return true;
}

bool brake_axes(Channel& c) noexcept {
    bool moves = false;
    c.axes.off_path.each([&](std::size_t a) {
        AxisUnit& axis = c.core.axes[a];
        if (!axis.bound() && !axis.beside) moves = axis.brake(c.core.config.tick_s) || moves;
    });
    return moves;
}

void leave_off_path(Channel& c, std::size_t axis) noexcept {
    c.path.inbox.refuse(
        {axis < kMaxAxes ? "command" : "transform", c.path.cursor, c.shown.line, axis});
    c.axes.off_path = c.axes.placed;
    c.axes.off_path.add(c.axes.placed_before);
    (void)brake_axes(c);
}

}  // namespace

void place_axes(Channel& c, const PathRecord& r, double s) noexcept {
    if ((r.flags & kTapping) && !place_spindle(c, r, s)) return;
    SlotVector position;
    if (!drives_at(r, c.kinematics_of(r), s, position)) return leave_off_path(c, kMaxAxes);
    const double tap_gain = tap_gain_of(c.core, r);
    for (std::uint32_t i = 0; i < r.axis_count; ++i) {
        if (c.core.config.axes[r.axis[i]].on_spindle &&
            position[i] != c.core.axes[r.axis[i]].command() &&
            !c.core.shared_axes[r.axis[i]].has_drive) {
            c.raise(Alarm::AxisIsSpindle, name_of('A', r.axis[i]).view());
            continue;
        }
        AxisUnit& axis = c.core.axes[r.axis[i]];
        axis.owner = c.number;
        c.axes.placed.add(r.axis[i]);
        axis.rapid = (r.flags & kRapid) != 0;
        axis.tap_with(tap_gain, tap_gain > 0 && r.value != 0);
        if (!c.panel.has(kKeyMachineLock) && !axis.bound() && !axis.beside && !axis.detached &&
            r.axis[i] != c.axes.limited) {
            // lost in transit
            if (!axis.referenced && !c.program.interrupted() &&
                c.core.must_be_referenced(r.axis[i]) &&
                std::fabs(position[i] - axis.command()) > kMoves) {
                c.shown.show(r);
                c.raise(Alarm::AxisUnreferenced, name_of('A', r.axis[i]).view());
            }
            axis.move_to(position[i]);
        }
        c.axes.last[i] = r.axis[i];
    }
    c.axes.last_count = r.axis_count;
}

void refuse_bound(Channel& c, const PathRecord& r) noexcept {
    for (std::uint32_t i = 0; is_motion(r) && i < r.axis_count; ++i)
        if (r.axis[i] == c.axes.limited) {
            c.shown.show(r);
            c.raise(Alarm::PositioningRefused, name_of('A', r.axis[i]).view());
        } else if (r.end[i] != r.start[i]) {
            const AxisUnit& axis = c.core.axes[r.axis[i]];
            const bool away = axis.detached && !axis.config().on_spindle,
                       lost = !axis.referenced && c.core.must_be_referenced(r.axis[i]);
            if (!axis.bound() && !axis.beside && !away && !lost) continue;
            const Alarm why = axis.bound()  ? Alarm::SlaveCommanded
                              : axis.beside ? Alarm::PositioningRefused
                              : away        ? Alarm::AxisDetached
                                            : Alarm::AxisUnreferenced;
            // the refused block, not the one before it
            c.shown.show(r);
            c.raise(why, name_of('A', r.axis[i]).view());
        }
}

void limit_tapping(const Core& core, const PathRecord& r, PlannedRecord& planned) noexcept {
    const std::uint32_t s = r.axis[r.axis_count] - static_cast<std::uint32_t>(kMaxAxes);
    if (s >= kMaxSpindles || !core.spindles[s].exists() || r.end[r.axis_count] == 0) return;
    const SpindleRange& range = core.spindles[s].range();
    const double way = r.length / std::fabs(r.end[r.axis_count]);  // mm a revolution
    const double acceleration =
        (r.flags & kTapOut) ? range.out_acceleration : range.tap_acceleration;
    if (acceleration > 0) planned.a_max = std::min(planned.a_max, acceleration * way);
    if (range.tap_jerk > 0) planned.j_max = std::min(planned.j_max, range.tap_jerk * way);
    if (range.speed_max > 0) planned.v_max = std::min(planned.v_max, range.speed_max / 60.0 * way);
}

void watch_commands(Channel& c) noexcept {
    if (c.thread.retract.active() || c.panel.has(kKeyMachineLock)) return;
    MovedAxes moved = c.axes.placed;
    moved.add(c.axes.placed_before);
    moved.each([&](std::size_t a) {
        const AxisUnit& axis = c.core.axes[a];
        if (!axis.exists() || !axis.closed() || axis.bound() || axis.beside || axis.detached ||
            a == c.axes.limited || c.axes.off_path.any())
            return;
        if (!axis.can_reach(axis.own_target(), c.program.emergency())) leave_off_path(c, a);
    });
}

void brake_off_path(Channel& c) noexcept {
    c.path.planner->clear(c.path.cursor);
    c.thread.empty();
    c.thread.retract.clear();
    c.retrace.trail.clear();
    c.path.step = {};
    c.path.step.record = c.path.cursor;
    if (!brake_axes(c)) c.axes.off_path = c.axes.placed = {};
    settle_program(c);
}

}  // namespace polyturn::kernel
