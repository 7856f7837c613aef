// Reasons for which a path is stopped or must not begin: spindles and drives that are not ready
// yet, axes that are not in position, feeds that are zero; and what a channel reports about it to
// the operator.
#include <algorithm>
#include <cmath>

#include "kernel/channel/channel_runner.hpp"

namespace polyturn::kernel {
namespace {
constexpr double kStandingRevS = 1e-3;
constexpr double kSpindleTimeoutS = 15.0;  // from the end of its ramp on
}  // namespace

bool ChannelRunner::cuts_with(std::uint32_t spindle) const noexcept {
    if (!process_.segment || path_.cursor >= path_.visible_end ||
        !is_motion(record(path_.cursor)) || record(path_.cursor).spindle != spindle)
        return false;
    const auto mode = static_cast<FeedMode>(record(path_.cursor).feed_mode);
    return thread_.moving() || (path_.moving && !path_.rapid && mode == FeedMode::PerRevolution &&
                                path_.step.speed > 0);
}

// A cut that begins from standstill waits for the spindle's speed (PT_FEED_WAITS); the M3 before it
// did not, whichever channel it was in: a feed per revolution waits for the spindle that it
// follows. A floating tap waits in any case: at the bottom the spindle turns on inward until its
// ramp has reversed it, and Z that left before would pull the tap out of its holder. One whose
// speed changes all the time (constant surface speed of another channel) is only followed. 0:
// nothing is waited for.
std::uint32_t ChannelRunner::awaited_spindle() const noexcept {
    if (!(core_.config.channels[index_].feed_needs_spindle ||
          (program_.control & kControlOwnSpindleOverride)) ||
        !path_.planner->at_rest() || path_.cursor >= path_.planner->next_record())
        return 0;
    const PathRecord& r = record(path_.cursor);
    if (!is_motion(r) || (r.flags & (kRapid | kThread | kTapping))) return 0;
    const bool follows =
        static_cast<FeedMode>(r.feed_mode) == FeedMode::PerRevolution && r.spindle != 0;
    const std::uint32_t number = follows ? r.spindle : core_.selected_spindle(number_);
    if (number == 0 || number > kMaxSpindles || !core_.spindles[number - 1].exists()) return 0;
    const SpindleUnit& spindle = core_.spindles[number - 1];
    const bool foreign = spindle.owner != number_;
    if (foreign && (!follows || spindle.owner == 0 || spindle.locked_by != 0)) return 0;
    return spindle.at_speed(core_.signals.plc(signals::sp_rot(number))) ? 0 : number;
}

// The PLC has detached a spindle that a program waits for, or cuts with: it will never turn. Not
// while the PLC may still be at the code that attaches it again.
bool ChannelRunner::refuses_detached(std::uint32_t spindle) noexcept {
    if (!core_.signals.plc(signals::sp_sdetchr(spindle))) return false;
    const double waited_s = static_cast<double>(core_.tick - std::max(standing_.phase == Phase::None
                                                                          ? axes_.stands_since
                                                                          : standing_.since,
                                                                      std::int64_t{0})) *
                            core_.config.tick_s;
    if (waited_s < 3.0 * static_cast<double>(core_.config.plc_cycle_ticks) * core_.config.tick_s)
        return false;
    if (!program_.interrupted()) raise(Alarm::SpindleDetached, name_of('S', spindle - 1).view());
    return true;
}

// A C axis whose drive is a spindle now: the path waits while that stops, and is refused when it
// turns, or when the spindle has turned the axis since the program last looked where it is.
bool ChannelRunner::waits_for_drive() noexcept {
    if (!path_.planner->at_rest() || path_.cursor >= path_.planner->next_record() ||
        !is_motion(record(path_.cursor)))
        return false;
    const PathRecord& r = record(path_.cursor);
    for (std::uint32_t i = 0; i < r.axis_count; ++i) {
        if (r.axis[i] >= kMaxAxes || (r.start[i] == r.end[i] && r.transform == 0)) continue;
        const std::uint32_t s = core_.config.axes[r.axis[i]].on_spindle;
        if (!s ||
            (core_.shared_axes[r.axis[i]].has_drive && !core_.shared_axes[r.axis[i]].displaced))
            continue;
        const std::int32_t rotation = core_.signals.plc(signals::sp_rot(s));
        ShortText text = name_of('A', r.axis[i]);
        text << " on S" << s;
        if (core_.shared_axes[r.axis[i]].displaced)
            raise(Alarm::AxisDisplaced, text.view());
        else if (rotation == 3 || rotation == 4 ||
                 core_.signals.plc(signals::ap_detchr(r.axis[i] + 1)))
            raise(Alarm::AxisIsSpindle, text.view());
        return true;
    }
    return false;
}

// At a barrier the channel reads where its axes are.
void ChannelRunner::know_positions() noexcept {
    for (std::uint32_t a = 0; a < core_.config.axis_count; ++a)
        if (core_.config.axes[a].on_spindle && core_.config.axes[a].channel == number_ &&
            core_.shared_axes[a].has_drive)
            core_.shared_axes[a].displaced = false;
}

// The path is at standstill though a program runs: must the reason be reported to the operator?
void ChannelRunner::watch_standstill(const PathRecord* running) noexcept {
    // nothing was driven meanwhile: this standstill begins now
    if (core_.tick > axes_.watched + 1) axes_.stands_since = core_.tick;
    axes_.watched = core_.tick;
    if (path_.step.stands != Stands::NoFeed && path_.step.stands != Stands::InPosition) {
        axes_.stands_since = core_.tick;
        return;
    }
    const double stood_s =
        static_cast<double>(core_.tick - axes_.stands_since) * core_.config.tick_s;
    if (path_.step.stands == Stands::InPosition) {
        const double limit = core_.config.channels[index_].in_position_timeout_s;
        if (limit > 0 && stood_s > limit) raise_not_in_position();
        return;
    }
    if (const std::uint32_t number = awaited_spindle()) {
        if (refuses_detached(number)) return;
        const SpindleUnit& waited = core_.spindles[number - 1];
        if (waited.ramping()) axes_.stands_since = core_.tick;
        if (waited.command() != 0.0 && stood_s > kSpindleTimeoutS)
            return raise(Alarm::SpindleTooSlow, name_of('S', number - 1).view(),
                         waited.shown_speed());
    }
    if (!running) return;
    const PathRecord& r = *running;
    const bool per_revolution = static_cast<FeedMode>(r.feed_mode) == FeedMode::PerRevolution;
    if (!per_revolution || r.spindle == 0 || r.spindle > kMaxSpindles) return;
    if (refuses_detached(r.spindle)) return;
    const SpindleUnit& spindle = core_.spindles[r.spindle - 1];
    // The PLC may still be writing SP_ROT: some of its cycles of grace before this is an alarm
    // rather than a hang.
    const double grace_s =
        3.0 * static_cast<double>(core_.config.plc_cycle_ticks) * core_.config.tick_s;
    if (spindle.command() == 0.0 && std::abs(core_.spindle_rev_s[r.spindle - 1]) < kStandingRevS &&
        stood_s > grace_s)
        raise(Alarm::SpindleStands, name_of('S', r.spindle - 1u).view());
}

bool ChannelRunner::axes_in_position() const noexcept {
    for (std::uint32_t i = 0; i < axes_.last_count; ++i)
        if (!core_.axes[axes_.last[i]].in_position()) return false;
    return true;
}

void ChannelRunner::raise_not_in_position() noexcept {
    for (std::uint32_t i = 0; i < axes_.last_count; ++i)
        if (!core_.axes[axes_.last[i]].in_position())
            return raise(Alarm::NotInPosition, name_of('A', axes_.last[i]).view(),
                         core_.axes[axes_.last[i]].error());
}

// Along the path no axis may brake harder than its own emergency deceleration.
double ChannelRunner::emergency_deceleration() const noexcept {
    double least = kUnlimited;
    for (std::uint32_t a = 0; a < core_.config.axis_count; ++a)
        if (core_.axes[a].owner == number_)
            least = std::min(least, core_.config.axes[a].estop_deceleration);
    return least < kUnlimited ? least : 1e4;
}

// In dry run a path feed moves as fast as N0305 lets the axes of the channel go; the limits of
// the records still hold.
double ChannelRunner::dry_run_feed() const noexcept {
    double feed = 0;
    for (std::uint32_t a = 0; a < core_.config.axis_count; ++a)
        if (core_.config.axes[a].channel == number_ && !core_.config.axes[a].rotary)
            feed = std::max(feed, core_.config.axes[a].max_feed);
    return feed;
}

}  // namespace polyturn::kernel
