#include "kernel/channel/path/standstill.hpp"

#include <algorithm>
#include <cmath>

#include "ipc/image/interrupt_inputs.hpp"
#include "kernel/records/record_kinds.hpp"

namespace polyturn::kernel {
namespace {

constexpr double kStandingRevS = 1e-3;
constexpr double kSpindleTimeoutS = 15.0;  // from the end of its ramp on

void raise_not_in_position(Channel& c) noexcept {
    for (std::uint32_t i = 0; i < c.axes.last_count; ++i)
        if (!c.core.axes[c.axes.last[i]].in_position())
            return c.raise(Alarm::NotInPosition, name_of('A', c.axes.last[i]).view(),
                           c.core.axes[c.axes.last[i]].error());
}

}  // namespace

std::uint32_t awaited_spindle(const Channel& c) noexcept {
    if (!(c.core.config.channels[c.index].feed_needs_spindle ||
          (c.program.control & kControlOwnSpindleOverride)) ||
        !c.path.planner->at_rest() || c.path.cursor >= c.path.planner->next_record())
        return 0;
    const PathRecord& r = c.path.here();
    if (!is_motion(r) || (r.flags & (kRapid | kThread | kTapping))) return 0;
    const bool follows =
        static_cast<FeedMode>(r.feed_mode) == FeedMode::PerRevolution && r.spindle != 0;
    const std::uint32_t number = follows ? r.spindle : c.core.selected_spindle(c.number);
    if (number == 0 || number > kMaxSpindles || !c.core.spindles[number - 1].exists()) return 0;
    const SpindleUnit& spindle = c.core.spindles[number - 1];
    const bool foreign = spindle.owner != c.number;
    if (foreign && (!follows || spindle.owner == 0 || spindle.locked_by != 0)) return 0;
    return spindle.at_speed(c.core.signals.plc(signals::sp_rot(number))) ? 0 : number;
}

bool refuses_detached(Channel& c, std::uint32_t spindle) noexcept {
    if (!c.core.signals.plc(signals::sp_sdetchr(spindle))) return false;
    const double waited_s =
        static_cast<double>(c.core.tick - std::max(c.standing.phase == RecordPhase::None
                                                       ? c.axes.stands_since
                                                       : c.standing.since,
                                                   std::int64_t{0})) *
        c.core.config.tick_s;
    if (waited_s < 3.0 * static_cast<double>(c.core.config.plc_cycle_ticks) * c.core.config.tick_s)
        return false;
    if (!c.program.interrupted()) c.raise(Alarm::SpindleDetached, name_of('S', spindle - 1).view());
    return true;
}

bool waits_for_drive(Channel& c) noexcept {
    if (!c.path.planner->at_rest() || c.path.cursor >= c.path.planner->next_record() ||
        !is_motion(c.path.here()))
        return false;
    const PathRecord& r = c.path.here();
    for (std::uint32_t i = 0; i < r.axis_count; ++i) {
        if (r.axis[i] >= kMaxAxes || (r.start[i] == r.end[i] && r.transform == 0)) continue;
        const std::uint32_t s = c.core.config.axes[r.axis[i]].on_spindle;
        if (!s ||
            (c.core.shared_axes[r.axis[i]].has_drive && !c.core.shared_axes[r.axis[i]].displaced))
            continue;
        const std::int32_t rotation = c.core.signals.plc(signals::sp_rot(s));
        ShortText text = name_of('A', r.axis[i]);
        text << " on S" << s;
        if (c.core.shared_axes[r.axis[i]].displaced)
            c.raise(Alarm::AxisDisplaced, text.view());
        else if (rotation == 3 || rotation == 4 ||
                 c.core.signals.plc(signals::ap_detchr(r.axis[i] + 1)))
            c.raise(Alarm::AxisIsSpindle, text.view());
        return true;
    }
    return false;
}

bool drive_is_coming(const Core& core, std::uint32_t number) noexcept {
    for (std::uint32_t a = 0; a < core.config.axis_count; ++a)
        if (core.config.axes[a].on_spindle && core.config.axes[a].channel == number &&
            core.drive_is_for_axis(a) && !core.shared_axes[a].has_drive)
            return true;
    return false;
}

void know_positions(Core& core, std::uint32_t number) noexcept {
    for (std::uint32_t a = 0; a < core.config.axis_count; ++a)
        if (core.config.axes[a].on_spindle && core.config.axes[a].channel == number &&
            core.shared_axes[a].has_drive)
            core.shared_axes[a].displaced = false;
}

void watch_standstill(Channel& c, const PathRecord* running) noexcept {
    // nothing was driven meanwhile: this standstill begins now
    if (c.core.tick > c.axes.watched + 1) c.axes.stands_since = c.core.tick;
    c.axes.watched = c.core.tick;
    if (c.path.step.stands != Stands::NoFeed && c.path.step.stands != Stands::InPosition) {
        c.axes.stands_since = c.core.tick;
        return;
    }
    const double stood_s =
        static_cast<double>(c.core.tick - c.axes.stands_since) * c.core.config.tick_s;
    if (c.path.step.stands == Stands::InPosition) {
        const double limit = c.core.config.channels[c.index].in_position_timeout_s;
        if (limit > 0 && stood_s > limit) raise_not_in_position(c);
        return;
    }
    if (const std::uint32_t number = awaited_spindle(c)) {
        if (refuses_detached(c, number)) return;
        const SpindleUnit& waited = c.core.spindles[number - 1];
        if (waited.ramping()) c.axes.stands_since = c.core.tick;
        if (waited.command() != 0.0 && stood_s > kSpindleTimeoutS)
            return c.raise(Alarm::SpindleTooSlow, name_of('S', number - 1).view(),
                           waited.shown_speed());
    }
    if (!running) return;
    const PathRecord& r = *running;
    const bool per_revolution = static_cast<FeedMode>(r.feed_mode) == FeedMode::PerRevolution;
    if (!per_revolution || r.spindle == 0 || r.spindle > kMaxSpindles) return;
    if (refuses_detached(c, r.spindle)) return;
    const SpindleUnit& spindle = c.core.spindles[r.spindle - 1];
    // The PLC may still be writing SP_ROT: some of its cycles of grace before this is an alarm
    // rather than a hang.
    const double grace_s =
        3.0 * static_cast<double>(c.core.config.plc_cycle_ticks) * c.core.config.tick_s;
    if (spindle.command() == 0.0 && std::abs(c.core.spindle_rev_s[r.spindle - 1]) < kStandingRevS &&
        stood_s > grace_s)
        c.raise(Alarm::SpindleStands, name_of('S', r.spindle - 1u).view());
}

bool axes_in_position(const Channel& c) noexcept {
    for (std::uint32_t i = 0; i < c.axes.last_count; ++i)
        if (!c.core.axes[c.axes.last[i]].in_position()) return false;
    return true;
}

}  // namespace polyturn::kernel
