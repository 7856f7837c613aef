#include "kernel/channel/path/thread_run.hpp"

#include <algorithm>
#include <cmath>

#include "kernel/channel/path/drive.hpp"
#include "kernel/channel/path/place_axes.hpp"
#include "kernel/channel/path/standstill.hpp"
#include "kernel/channel/path/supply.hpp"
#include "kernel/records/record_executor.hpp"
#include "kernel/records/record_kinds.hpp"

namespace polyturn::kernel {
namespace {

// All of it is visible and planned: it can be driven to its end whatever happens to the channel.
// False: not yet.
bool commit_thread(Channel& c) noexcept {
    const std::uint64_t most = c.path.cursor + kThreadRecords;
    for (std::uint64_t i = c.path.cursor; i < std::min(c.path.planner->next_record(), most); ++i) {
        if (!(c.record(i).flags & kThreadEnd)) continue;
        c.thread.follower->clear(c.path.cursor);
        for (std::uint64_t k = c.path.cursor; k <= i; ++k)
            if (!is_motion(c.record(k)) || !c.thread.follower->append(c.record(k))) {
                c.raise(Alarm::RecordInvalid, "thread");
                return false;
            }
        c.thread.end = i;
        return true;
    }
    if (c.path.planner->next_record() >= most)
        c.raise(Alarm::RecordInvalid, "a thread of too many steps");
    return false;
}

// Says why it cannot begin, or that it can.
bool thread_may_start(Channel& c, const PathRecord& r) noexcept {
    if (r.spindle == 0 || r.spindle > kMaxSpindles || !c.core.spindles[r.spindle - 1].exists()) {
        c.raise(Alarm::SpindleUnknown, name_of('S', r.spindle ? r.spindle - 1u : 0u).view());
        return false;
    }
    if (refuses_detached(c, r.spindle)) return false;
    SpindleUnit& spindle = c.core.spindles[r.spindle - 1];
    if (spindle.command() == 0.0) {
        const double stood_s =
            static_cast<double>(c.core.tick - c.standing.since) * c.core.config.tick_s;
        const double grace_s =
            3.0 * static_cast<double>(c.core.config.plc_cycle_ticks) * c.core.config.tick_s;
        if (stood_s > grace_s)
            c.raise(Alarm::ThreadSpindleStands, name_of('S', r.spindle - 1u).view());
        return false;
    }
    double allowed_rpm = kUnlimited, lead = 0;
    for (std::uint64_t i = c.path.cursor; i <= c.thread.end; ++i) {
        const PathRecord& piece = c.record(i);
        const double end_lead = std::sqrt(
            std::max(0.0, piece.lead * piece.lead + 2.0 * piece.lead_change * piece.length));
        lead = std::max({lead, piece.lead, end_lead});
        allowed_rpm =
            std::min(allowed_rpm, piece.v_max / std::max({piece.lead, end_lead, 1e-9}) * 60.0);
    }
    if (std::fabs(spindle.command()) > allowed_rpm) {
        ShortText text;
        text << "lead " << lead << " mm at " << std::fabs(spindle.command())
             << " 1/min, the axes allow " << std::floor(allowed_rpm) << " 1/min";
        c.raise(Alarm::ThreadSpindleTooFast, text.view());
        return false;
    }
    return spindle.reached();
}

void report_thread(Channel& c, const ThreadStep& step) noexcept {
    const double dt = c.core.config.tick_s;
    const bool any_began = step.began_to > step.began_from,
               any_ended = step.ended_to > step.ended_from;
    if (!any_began && !any_ended) return;
    const std::uint64_t from = !any_began   ? step.ended_from
                               : !any_ended ? step.began_from
                                            : std::min(step.began_from, step.ended_from);
    for (std::uint64_t i = from; i < std::max(step.began_to, step.ended_to); ++i) {
        if (i >= step.began_from && i < step.began_to)
            begin_record(c, c.record(i), c.thread.follower->begin_fraction(i) * dt);
        if (i < step.ended_from || i >= step.ended_to) continue;
        place_axes(c, c.record(i), c.record(i).length);
        end_record(c, c.record(i), i, c.thread.follower->end_fraction(i) * dt);
    }
}

bool withdraws(const Channel& c, const PathRecord&) noexcept {
    return c.thread.moving() && !c.program.emergency() &&
           (c.program.holds() || c.program.resets() || c.process.dead() || c.program.interrupted());
}

void begin_withdrawal(Channel& c, const PathRecord& r, const ThreadStep& step) noexcept {
    // A retract direction that is blocked is none: the hold then acts behind the thread.
    for (std::uint32_t k = 0; k < r.axis_count; ++k)
        if (const double way = ThreadRetract::of(r, k);
            way != 0.0 && c.core.stroke.room(c.core, r.axis[k], way) < std::fabs(way))
            return;
    if (!c.panel.has(kKeyMachineLock))
        (void)c.thread.retract.begin(r, c.core.axes, step.speed, c.core.config.tick_s);
}

// Out and at rest: the hold, the reset or the end may act; the thread's records wait to be driven
// once more.
void end_withdrawal(Channel& c, const ThreadStep& step) noexcept {
    const PathRecord& first = c.path.here();
    const bool whole = step.ended_to == c.thread.end + 1 && step.ended_to > step.ended_from;
    if (!whole) c.report(KernelEventKind::RecordEnd, c.record(step.record), 0);
    SpindleUnit& spindle = c.core.spindles[first.spindle - 1];
    spindle.override_locked = false;
    if (spindle.locked_by == c.number && spindle.mode() != SpindleUnit::Mode::SurfaceSpeed)
        spindle.locked_by = 0;
    c.thread.empty();
    c.path.moving = false;
    c.path.step.speed = 0;
    c.thread.retract.stands_out();
}

bool go_back_to_pass(Channel& c, const PathRecord& first) noexcept {
    if (c.program.emergency()) {
        bool moves = false;
        for (std::uint32_t k = 0; k < first.axis_count; ++k)
            moves = c.core.axes[first.axis[k]].brake(c.core.config.tick_s) || moves;
        c.thread.moves(moves);
        return moves;
    }
    const bool go = c.program.is(ChannelState::Running) && !c.program.holds() &&
                    !c.program.interrupted() && !c.program.resets() && !c.process.dead() &&
                    !c.core.all_stop && c.core.on();
    const bool there = c.thread.retract.step_back(first, c.core.axes, go, c.core.config.tick_s);
    c.path.moving = c.thread.retract.moving();
    c.thread.moves(c.path.moving);
    c.path.rapid = true;
    if (there) {
        c.thread.retract.clear();
        c.thread.empty();
    }
    return there;
}

}  // namespace

bool drive_thread(Channel& c, double& left) noexcept {
    if (c.standing.phase != RecordPhase::Thread) {
        c.standing.phase = RecordPhase::Thread;
        c.thread.empty();
        c.thread.retract.clear();
    }
    const PathRecord& first = c.path.here();
    // held out of the thread: back to where the pass begins
    if (c.thread.retract.out()) {
        go_back_to_pass(c, first);
        return false;
    }
    if (!c.thread.moving()) {
        if (c.program.holds() || c.program.interrupted() || c.program.resets() ||
            c.process.dead() || c.core.all_stop || !c.program.is(ChannelState::Running))
            return false;
        if (!c.thread.committed()) {
            if (!commit_thread(c)) return false;
            c.thread.stage = ThreadExecutor::Stage::Committed;
        }
        if (!thread_may_start(c, first)) return false;
        SpindleUnit& spindle = c.core.spindles[first.spindle - 1];
        spindle.override_locked = true;
        if (spindle.owner == c.number) spindle.locked_by = c.number;
    }
    SpindleUnit& spindle = c.core.spindles[first.spindle - 1];
    const SpindleObserver& seen = spindle.observer();
    ThreadInput input;
    input.angle = seen.angle(c.core.config.tick_s);
    input.acceleration = seen.acceleration();
    input.speed = seen.speed() + input.acceleration * c.core.config.tick_s;
    // When everything stops, the axis follows the spindle down and leaves the thread only with it.
    input.brake = (c.thread.moving() && spindle.command() == 0.0 && spindle.standing()) ||
                  c.thread.retract.clear_of_part();
    if (c.program.emergency()) {
        input.emergency_dec = emergency_deceleration(c.core, c.number);
        c.thread.retract.stop();
    }
    const ThreadStep step = c.thread.follower->tick(input);
    if (step.lost_line)
        c.raise(Alarm::ThreadSpindleTooFast, "the spindle has become too fast for the axes");
    if (step.phase == ThreadPhase::Waiting || step.phase == ThreadPhase::Idle) return false;
    c.thread.moves(true);
    c.path.moving = step.speed > 0;
    c.path.rapid = false;
    report_thread(c, step);
    const PathRecord& r = c.record(step.record);
    place_axes(c, r, step.s);
    if (!c.thread.retract.active() && withdraws(c, r)) begin_withdrawal(c, r, step);
    c.thread.retract.move_axes(c.core.axes, c.core.config.tick_s);
    c.shown.show(r);
    c.path.step.speed = step.speed;
    c.path.step.s = step.s;
    if (step.phase != ThreadPhase::Done) return false;
    if (c.thread.retract.active()) {
        if (c.thread.retract.clear_of_part() || !c.thread.retract.moving()) end_withdrawal(c, step);
        return false;
    }
    const bool whole = step.ended_to == c.thread.end + 1 && step.ended_to > step.ended_from;
    spindle.override_locked = false;
    if (spindle.locked_by == c.number && spindle.mode() != SpindleUnit::Mode::SurfaceSpeed)
        spindle.locked_by = 0;
    if (!whole && !c.program.interrupted() && !c.program.resets() && !c.process.dead())
        c.raise(Alarm::ThreadSpindleStands, name_of('S', first.spindle - 1u).view());
    left = whole ? 1.0 - c.thread.follower->end_fraction(c.thread.end) : 0.0;
    const bool block_end = block_ends_at(c, c.thread.end);
    c.path.cursor = c.thread.end + 1;
    c.path.planner->skip(c.path.cursor);
    c.standing.phase = RecordPhase::None;
    c.standing.begun = false;
    c.thread.empty();
    if (block_end && c.panel.has(kKeySingleBlock) && c.program.is(ChannelState::Running))
        c.stand(ChannelState::ProgramStop, StopReason::SingleBlock);
    return true;
}

}  // namespace polyturn::kernel
