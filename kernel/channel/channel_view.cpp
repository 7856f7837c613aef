#include "kernel/channel/channel_view.hpp"

#include <algorithm>

#include "ipc/image/interrupt_inputs.hpp"
#include "kernel/channel/program/positioning_steps.hpp"
#include "kernel/channel/program/start.hpp"
#include "kernel/gate/start_conditions.hpp"
#include "kernel/records/record_kinds.hpp"

namespace polyturn::kernel {

WaitBoard::Standing ChannelView::standing() const noexcept {
    const bool over = c_.program.begins();
    return {c_.program.run,
            c_.program.runs() && !c_.program.interrupted() && !c_.process.dead() &&
                !c_.program.resets(),
            c_.panel.has(kKeyDryRun), over && !c_.program.cut_off};
}

RestartFate ChannelView::restart_fate() const noexcept {
    using Fate = RestartFate;
    if (!c_.process.segment || c_.process.dead()) return Fate::Dead;
    if (c_.program.resets() || c_.program.is(ChannelState::Reset)) return Fate::Reset;
    if (c_.program.interrupted()) return Fate::Alarm;
    if (!c_.program.runs()) return Fate::Ended;
    return c_.restart.searches()                       ? Fate::Searching
           : c_.restart.stage == RestartState::AtBlock ? Fate::AtBlock
                                                       : Fate::Started;
}

bool ChannelView::polls() const noexcept {
    return (c_.program.control & kControlPolls) && c_.process.segment &&
           c_.program.is(ChannelState::Running) && c_.standing.phase == RecordPhase::None &&
           c_.path.cursor + 1 == c_.path.inbox.head(c_.path.cursor) &&
           c_.path.inbox.kind_of(c_.path.cursor) == RecordKind::Barrier;
}

bool ChannelView::leaves_room() const noexcept {
    if (!superposes() || c_.thread.moving() || c_.standing.phase == RecordPhase::Thread)
        return false;
    if (c_.at_rest())
        return c_.path.cursor >= c_.path.superposed_from ||
               c_.path.planner->next_record() == c_.path.cursor;
    return c_.path.cursor >= c_.path.superposed_from &&
           !(c_.path.cursor < c_.path.visible_end && (c_.path.here().flags & (kThread | kTapping)));
}

bool ChannelView::silent_too_long() const noexcept {
    return c_.process.frozen() &&
           static_cast<double>(c_.core.tick - c_.process.stopped_since) * c_.core.config.tick_s >=
               c_.core.config.channel_timeout_s;
}

bool ChannelView::can_go_on() const noexcept {
    if (!c_.process.segment) return false;
    if (c_.path.planner && !c_.at_rest()) return true;
    if (c_.program.resets() || !c_.outbox.empty() || c_.resume.question) return true;
    if (c_.process.frozen()) return true;  // the timeout counts
    if (c_.retrace.wheel.on && c_.retrace.wheel.rate == 0)
        return c_.standing.phase == RecordPhase::Handshake;
    if (c_.retrace.trail.active())
        return c_.program.is(ChannelState::Running) || c_.retrace.wheel.on;
    if (c_.program.is(ChannelState::Waiting))
        return c_.core.config.channels[c_.index].wait_timeout_s > 0 && !c_.program.interrupted();
    if (c_.program.is(ChannelState::Ended) && c_.hand.lines.goes_on()) return true;
    if (!c_.program.is(ChannelState::Running)) return c_.standing.phase == RecordPhase::Handshake;
    // a drive may never find it
    if (c_.standing.phase == RecordPhase::Home)
        return static_cast<double>(c_.core.tick - c_.standing.since) * c_.core.config.tick_s <
               600.0;
    if (c_.positioning.now()) return true;
    if (c_.standing.phase != RecordPhase::None) return true;
    if (c_.path.step.stands == Stands::NoFeed)
        return c_.panel.feed_override > 0;  // a spindle may come up to speed
    if (polls()) return false;
    // The ring itself, not what the last tick saw of it: a wait that has just opened is followed by
    // records pushed since.
    return c_.path.cursor < c_.path.inbox.head(c_.path.cursor) ||
           c_.path.step.stands == Stands::Moving;
}

bool ChannelView::holds_surface_speed() const noexcept {
    return c_.traits().rapid_holds_surface_speed && c_.process.segment && c_.path.rapid &&
           !c_.thread.moving() && c_.program.runs();
}

std::optional<double> ChannelView::cut_begins_at(std::uint32_t axis) const noexcept {
    if (c_.path.at_boundary || c_.path.cursor >= c_.path.visible_end ||
        !is_motion(c_.path.here()) || !(c_.path.here().flags & kRapid))
        return std::nullopt;
    // A look per tick: bounded, also where a program puts more between the two (then the speed
    // comes with the cut).
    constexpr std::uint64_t kFar = 32;
    const std::uint64_t end = std::min(c_.path.visible_end, c_.path.cursor + kFar);
    std::uint64_t last = c_.path.cursor;  // of the block under way
    while (!(c_.record(last).flags & kBlockEnd) && last + 1 < end && is_motion(c_.record(last + 1)))
        ++last;
    std::uint64_t next = last + 1;
    // what is only reported
    while (next < end && !is_motion(c_.record(next)) && !stops_path(c_.record(next))) ++next;
    if (next >= end || !is_motion(c_.record(next)) || (c_.record(next).flags & kRapid))
        return std::nullopt;
    const PathRecord& r = c_.record(last);
    SlotVector position;
    if (!drives_at(r, c_.kinematics_of(r), r.length, position)) return std::nullopt;
    for (std::uint32_t i = 0; i < r.axis_count; ++i)
        if (r.axis[i] == axis) return position[i];
    return std::nullopt;
}

bool ChannelView::stands() const noexcept {
    if (!c_.process.segment || !c_.program.runs()) return true;
    if (c_.retrace.trail.active()) return false;
    return c_.path.cursor >= c_.path.inbox.head(c_.path.cursor) ||
           (c_.path.inbox.flags_of(c_.path.cursor) & kDrains) != 0;
}

bool ChannelView::cuts_with(std::uint32_t spindle) const noexcept {
    if (!c_.process.segment || c_.path.cursor >= c_.path.visible_end ||
        !is_motion(c_.path.here()) || c_.path.here().spindle != spindle)
        return false;
    const auto mode = static_cast<FeedMode>(c_.path.here().feed_mode);
    return c_.thread.moving() || (c_.path.moving && !c_.path.rapid &&
                                  mode == FeedMode::PerRevolution && c_.path.step.speed > 0);
}

bool ChannelView::lacks_program_or_block() const noexcept {
    const StartView view = kernel::start_view(c_);
    return view.lacks_program || view.lacks_block;
}

StartView ChannelView::start_view() const noexcept { return kernel::start_view(c_); }

bool ChannelView::holds_positioning() const noexcept { return kernel::holds_positioning(c_); }

bool ChannelView::runs_positioning(std::uint32_t axis) const noexcept {
    return kernel::runs_positioning(c_, axis);
}

bool ChannelView::breaks_off_positioning() const noexcept {
    return kernel::breaks_off_positioning(c_);
}

}  // namespace polyturn::kernel
