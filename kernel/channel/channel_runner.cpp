#include "kernel/channel/channel_runner.hpp"

#include <algorithm>
#include <utility>

#include "kernel/channel/path/drive.hpp"
#include "kernel/channel/path/place_axes.hpp"
#include "kernel/channel/path/retrace_drive.hpp"
#include "kernel/channel/path/supply.hpp"
#include "kernel/channel/program/interrupt.hpp"
#include "kernel/channel/program/positioning_steps.hpp"
#include "kernel/channel/program/production.hpp"
#include "kernel/channel/program/settle.hpp"
#include "kernel/channel/program/wait_place.hpp"
#include "kernel/records/record_executor.hpp"
#include "kernel/records/record_kinds.hpp"

namespace polyturn::kernel {
namespace {
// Both are there, and yet it is no rendezvous.
std::string_view why_unlike(WaitBoard::Kind one, WaitBoard::Kind other) noexcept {
    using Kind = WaitBoard::Kind;
    if (one == Kind::Search || other == Kind::Search) return ", one of the two restarts";
    if (one == Kind::ByHand || other == Kind::ByHand)
        return ", one of the two is there by a block entered by hand";
    return ", one of the two is in dry run";
}
}  // namespace

void ChannelRunner::prepare() {
    if (c_.path.planner) return;
    c_.path.planner = std::make_unique<PathPlanner>();
    c_.thread.follower = std::make_unique<ThreadFollower>();
    c_.retrace.trail.prepare(c_.core.config.history);
    c_.path.inbox.prepare();
}

void ChannelRunner::attach(const ChannelSegment& segment) {
    prepare();
    c_.thread.follower->configure(c_.core.config.tick_s);
    c_.thread.empty();
    c_.path.planner->configure(c_.core.config.tick_s,
                               std::min<std::uint32_t>(c_.core.config.horizon, kPlannerWindow - 2));
    c_.retrace.trail.configure(c_.core.config.tick_s,
                               std::min<std::uint32_t>(c_.core.config.horizon, kPlannerWindow - 2));
    c_.retrace.way = Retrace::Way::None;
    c_.resume.question = 0;
    c_.interrupts.nothing_ahead();
    // P1: the first one was stored before the segment was published
    c_.path.epoch = segment.epoch.load(std::memory_order_acquire);
    c_.path.cursor = 0;
    c_.path.inbox.attach(segment);
    c_.axes.off_path = c_.axes.placed = {};
    // P2: nothing of its ring was taken
    c_.core.image.path_tail[c_.index].tail.store(0, std::memory_order_release);
    c_.path.plan_anew(0);
    // A successor has seen none of the events of its predecessor and must not: it starts with the
    // next one.
    // P4: own head
    c_.outbox.begin_at(c_.core.image.events[c_.index].head.load(std::memory_order_relaxed));
    c_.path.limit = ~0ull;
    c_.standing.handshake.early = kNoRecord;
    c_.path.at_boundary = true;
    c_.standing.phase = RecordPhase::None;
    c_.standing.begun = c_.program.alarm = c_.standing.wait.owed = c_.restart.refused = false;
    c_.program.brakes.remove(Brake::Hold, Brake::Reset, Brake::Alarm);
    c_.process.life = ProcessLink::Life::Live;
    c_.path.flying = c_.path.let_pass = kNoRecord;
    c_.restart.stage = RestartState::None;
    c_.core.waits.leave(c_.index);
    ++c_.program.run;
    c_.program.control = 0;  // a predecessor's program put off what the operator's switches do
    c_.hand.lines.broken_off();
    c_.hand.block = {};
    c_.process.selected = false;  // it knows nothing of its predecessor's commands
    c_.shown.broken_off = 0;
    c_.program.enter(ChannelState::Reset, StopReason::None);
    c_.process.segment = &segment;
}

void ChannelRunner::run() noexcept {
    c_.path.moving = false;
    if (!c_.process.segment) return;
    double left = 1.0;  // part of the tick that is still to be used
    if (c_.axes.off_path.any()) return brake_off_path(c_);
    c_.axes.placed_before = std::exchange(c_.axes.placed, {});
    watch_interrupt(c_);
    const bool back =
        c_.retrace.trail.active() || (c_.retrace.wheel.on && handwheel_drives_trail(c_));
    if (back) {
        if (!((c_.program.interrupted() || c_.process.dead() || c_.resume.aside ||
               !drives_by_handwheel(c_)) &&
              c_.at_rest()))
            drive_trail(c_);
        left = 0.0;
    }
    if (c_.path.at_boundary && !back) execute_standing(c_, left);
    // What took a part of the tick ends within it: motion begins with the next one.
    const bool frozen =
        (c_.program.interrupted() || c_.process.dead() || c_.resume.aside) && c_.at_rest();
    if (c_.standing.phase == RecordPhase::None && left == 1.0 && !frozen && !back) {
        drive_path(c_);
        if (c_.path.at_boundary) {
            if (c_.path.step.ended_to > c_.path.step.ended_from)
                left = 1.0 - c_.path.planner->end_fraction(c_.path.step.ended_to - 1);
            execute_standing(c_, left);
        }
    }
    watch_commands(c_);
    settle_program(c_);
    watch_production(c_);
    if (c_.program.runs()) c_.production.times.cycle_s += c_.core.config.tick_s;
    if (c_.program.start_lamp()) c_.production.times.lit_s += c_.core.config.tick_s;
    if (c_.path.moving)
        (c_.path.rapid ? c_.production.times.rapid_s : c_.production.times.cutting_s) +=
            c_.core.config.tick_s;
    if (c_.program.is(ChannelState::Waiting))
        c_.production.times.waiting_s += c_.core.config.tick_s;
    const auto& tail = c_.core.image.path_tail[c_.index].tail;
    // P4: own tail. P2: the records before the cursor are needed no more
    if (tail.load(std::memory_order_relaxed) != c_.path.cursor)
        c_.core.image.path_tail[c_.index].tail.store(c_.path.cursor, std::memory_order_release);
}

void ChannelRunner::release_wait(Permit) noexcept {
    if (c_.standing.wait.passing) c_.retrace.trail.met(c_.core.meetings);
    c_.standing.wait.passing = false;
    if (c_.program.is(ChannelState::Waiting)) c_.program.enter(ChannelState::Running);
    if (std::exchange(c_.standing.wait.owed, false)) return c_.retrace.trail.met(c_.core.meetings);
    if (c_.standing.phase != RecordPhase::Waiting) return;
    c_.retrace.meeting = c_.core.meetings;
    c_.standing.wait.released = true;
}

// Of those that still wait after all rendezvous of this tick.
void ChannelRunner::after_waits(std::span<ChannelRunner* const> all) noexcept {
    // Its partner stopped between releasing this channel and its arrival: the channel stops as soon
    // as it can and waits there.
    if (std::exchange(c_.standing.wait.passing, false)) {
        c_.standing.wait.owed = true;
        c_.standing.wait.begin(c_.core.tick);
    }
    if (c_.standing.wait.owed && c_.program.is(ChannelState::Running) && c_.at_rest() &&
        !c_.program.holds() && !c_.program.interrupted())
        c_.program.enter(ChannelState::Waiting);
    if ((c_.standing.phase != RecordPhase::Waiting && !c_.standing.wait.owed) ||
        c_.standing.wait.released || c_.program.interrupted() || c_.program.resets())
        return;
    if (!c_.standing.wait.judged) {
        c_.standing.wait.judged = true;
        const auto verdict = c_.core.waits.judge(c_.index, c_.core.no_wait());
        if (verdict.fault != WaitBoard::Fault::None) {
            ShortText text;
            describe_wait(c_, text);
            for (unsigned k = 0; k < kMaxChannels; ++k)
                if (verdict.with >> k & 1u) {
                    text << "; ";
                    describe_wait(all[k]->c_, text);
                }
            c_.raise(verdict.fault == WaitBoard::Fault::OtherSet ? Alarm::WaitOtherSet
                                                                 : Alarm::WaitDeadlock,
                     text.view());
            return;
        }
    }
    const ChannelSet missing = c_.core.waits.missing(c_.index, c_.core.no_wait()),
                     unlike = c_.core.waits.unlike(c_.index, c_.core.no_wait());
    for (unsigned k = 0; k < kMaxChannels; ++k) {
        const ChannelSet bit = ChannelSet{1} << k;
        if (!(missing & bit)) continue;
        if (c_.restart.searches() && all[k]->c_.restart.at_block()) {
            ShortText text;
            describe_wait(c_, text);
            text << ", and L" << k + 1 << " restarts in front of it";
            c_.raise(Alarm::RestartMismatch, text.view());
            return;
        }
        if (all[k]->program_runs() && !(unlike & bit)) {
            c_.standing.wait.warned &= ~bit;
            continue;
        }
        if (c_.standing.wait.warned & bit) continue;
        c_.standing.wait.warned |= bit;
        ShortText text;
        text << "L" << k + 1 << " (";
        write_code(c_, text);
        text << ")";
        if (unlike & bit)
            text << why_unlike(c_.core.waits.phase(c_.index).kind, c_.core.waits.phase(k).kind);
        c_.core.alarm(Alarm::WaitPartnerAbsent, c_.number, text.view(), 0, c_.shown.line);
    }
    const double limit = c_.core.config.channels[c_.index].wait_timeout_s;
    if (limit > 0 &&
        static_cast<double>(c_.core.tick - c_.standing.wait.since) * c_.core.config.tick_s >=
            limit) {
        ShortText text;
        describe_wait(c_, text);
        text << ", missing ";
        text.channels(missing);
        c_.raise(Alarm::WaitTimeout, text.view());
    }
}

void ChannelRunner::publish(ChannelStatus& status) noexcept {
    status.state = static_cast<std::uint32_t>(c_.program.state());
    status.mode = static_cast<std::uint32_t>(c_.program.mode);
    status.feed_override = c_.panel.feed_override;
    status.rapid_override = c_.panel.rapid_override;
    status.path_speed = c_.path.moving ? c_.path.step.speed : 0.0;
    const bool motion =
        c_.process.segment && c_.path.cursor < c_.path.visible_end && is_motion(c_.path.here());
    status.path_left =
        motion ? c_.path.here().length -
                     (c_.path.step.record == c_.path.cursor && !c_.path.step.over ? c_.path.step.s
                                                                                  : 0.0)
               : 0.0;
    status.record = c_.path.cursor;
    status.line = c_.shown.line;
    status.file = c_.shown.file;
    status.block = c_.shown.block;
    c_.core.tools.publish(c_.index, status);
    const auto& arrival = c_.core.waits.at(c_.index);
    status.wait_code = arrival.here ? arrival.code : 0;
    status.wait_set = arrival.here ? arrival.set : 0;
    status.wait_missing = arrival.here ? c_.core.waits.missing(c_.index, c_.core.no_wait()) : 0;
    status.wait_since = arrival.here ? c_.standing.wait.since : 0;
    status.parts = c_.production.parts;
    status.cutting_s = c_.production.times.cutting_s;
    status.rapid_s = c_.production.times.rapid_s;
    status.waiting_s = c_.production.times.waiting_s;
    status.cycle_s = c_.production.times.cycle_s;
    status.blocks = c_.production.blocks;
    status.epoch = c_.path.epoch;
    status.stop_reason = static_cast<std::int32_t>(c_.program.reason());
    // Counted by command, not by key: the first and the last end by themselves, the PLC may set the
    // second one.
    status.keys = c_.panel.keys | (c_.production.stops_after_part ? kKeyStopAfterPart : 0u) |
                  (c_.core.signals.plc(signals::cp_nowt(c_.number)) ? kKeyIgnoreWaits : 0u) |
                  (c_.retrace.way == Retrace::Way::Back ? kKeyRetrace : 0u);
    // of the selected program, in MDI too
    status.speaks = static_cast<std::uint32_t>(c_.process.says_language()
                                                   ? c_.process.language
                                                   : c_.core.config.channels[c_.index].language);
    status.skipped = c_.standing.skip.came ? 1 : 0;
    status.retrace = c_.retrace.trail.active() ? (c_.retrace.trail.direction() < 0 ? -1 : 1) : 0;
    status.wheel = c_.retrace.wheel.on ? 1 : 0;
    status.start_missing = c_.panel.start_missing;
    status.broken_off = c_.shown.broken_off;
    status.cycles = c_.production.cycles;
    status.last_cycle_s = c_.production.last_cycle_s;
    status.mean_cycle_s =
        c_.production.cycles ? c_.production.cycles_s / c_.production.cycles : 0.0;
    status.lit_s = c_.production.times.lit_s;
    status.restart = static_cast<std::uint32_t>(c_.restart.stage);
    status.mdi_waiting = c_.hand.lines.waiting();
    status.by_hand = by_hand() ? 1 : 0;
    c_.hand.lines.publish(c_.core.image.mdi[c_.index]);
    c_.core.signals.set_nc(signals::cn_state(c_.number),
                           static_cast<std::int32_t>(c_.program.state()));
    c_.core.signals.set_nc(signals::cn_run(c_.number), c_.program.drives());
    c_.core.signals.set_nc(signals::cn_hold(c_.number), c_.program.holds());
    c_.core.signals.set_nc(signals::stl(c_.number), c_.program.start_lamp());
    c_.core.signals.set_nc(signals::den(c_.number), distribution_ended());
    c_.core.signals.set_nc(signals::cn_wtng(c_.number), arrival.here);
    c_.core.signals.set_nc(signals::cn_alarm(c_.number), c_.program.alarm);
    c_.core.signals.set_nc(signals::cn_reset(c_.number), c_.program.reset_count);
    c_.core.signals.set_nc(signals::cn_end(c_.number), c_.program.is(ChannelState::Ended));
}

void ChannelRunner::send_events() noexcept {
    if (!c_.process.segment) return;
    if (c_.outbox.store_changed) {
        c_.outbox.store_changed = false;
        c_.tell(ChannelEventKind::StoreChanged, c_.path.cursor);
    }
    if (c_.outbox.send(c_.core.image.events[c_.index], c_.process.segment->event_tail,
                       c_.path.cursor))
        wake();
}

// Between the channels' runs: a channel that waits during retrace passes the wait when the others
// are there.
void ChannelRunner::pass_waits(std::span<ChannelRunner* const> all) noexcept {
    c_.retrace.wheel.blocked = false;
    if (!c_.retrace.trail.active() || !c_.retrace.wheel.on || c_.retrace.wheel.rate == 0 ||
        !c_.retrace.trail.stands() || c_.retrace.trail.at_end())
        return;
    if (partners_let_through(all)) {
        c_.retrace.trail.pass();
        return;
    }
    // A wait that its partners have not reached yet holds nothing up, nor does a program that is
    // back at its start; anything else ends retrace for all.
    const bool at_start = !c_.retrace.trail.obstacle() && c_.retrace.trail.from_the_start();
    c_.retrace.wheel.blocked =
        c_.retrace.wheel.rate < 0 && c_.retrace.trail.obstacle_meeting() == 0 && !at_start;
    if (c_.retrace.wheel.blocked && !c_.retrace.wheel.reported) tell_obstacle(c_);
    c_.retrace.wheel.reported = c_.retrace.wheel.blocked || c_.retrace.wheel.reported;
}

bool ChannelRunner::supplied() noexcept {
    if (!listens()) return true;
    // Quiet first: what it pushed before it became quiet is then visible in the head that supply()
    // reads (P1).
    if (const std::uint64_t asked = std::max(c_.resume.question, c_.interrupts.ahead_asked);
        asked && c_.process.segment->answered.load(std::memory_order_acquire) < asked)
        return false;
    // P1: as above. Both before the head is looked at
    const bool quiet =
        c_.process.segment->quiet.load(std::memory_order_acquire) >= c_.outbox.sent();
    drop_old_epochs(c_, kPathRing);  // between two ticks: all of them
    return quiet || c_.path.inbox.refusal().field ||
           c_.path.inbox.head(c_.path.cursor) - c_.path.cursor >= c_.core.config.horizon;
}

// All channels of a wait go through it together, in either direction.
bool ChannelRunner::partners_let_through(std::span<ChannelRunner* const> all) const noexcept {
    const std::uint64_t meeting = c_.retrace.trail.obstacle_meeting();
    const PathRecord* wait = c_.retrace.trail.obstacle();
    if (!meeting || !wait) return false;
    for (unsigned k = 0; k < kMaxChannels; ++k) {
        if (k == c_.index || !(wait->mask >> k & 1u) || !all[k]->attached()) continue;
        const Trail& other = all[k]->c_.retrace.trail;
        if (other.beside(meeting)) continue;
        const bool before = other.last_meeting() < meeting;
        if (c_.retrace.trail.direction() < 0 ? !before : before) return false;
    }
    return true;
}

void ChannelRunner::supply() noexcept { supply_path(c_); }

void ChannelRunner::queue_up() noexcept { kernel::queue_up(c_); }

void ChannelRunner::run_steps() noexcept { kernel::run_steps(c_); }

}  // namespace polyturn::kernel
