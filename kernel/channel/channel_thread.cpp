// Threads: the records from the first kThread to kThreadEnd are one motion that follows a spindle.
// It begins only when all of them are there and the spindle turns at its speed; feed hold, reset
// and the channel's death act behind it, because leaving a thread halfway breaks the tool.
#include <algorithm>
#include <cmath>

#include "kernel/channel/channel_runner.hpp"

namespace polyturn::kernel {
namespace {
constexpr double kDegPerSecOfRpm = 6.0;
}

// All of it is visible and planned: it can be driven to its end whatever happens to the channel.
// False: not yet.
bool ChannelRunner::commit_thread() noexcept {
    const std::uint64_t most = path_.cursor + kThreadRecords;
    for (std::uint64_t i = path_.cursor; i < std::min(path_.planner->next_record(), most); ++i) {
        if (!(record(i).flags & kThreadEnd)) continue;
        thread_.follower->clear(path_.cursor);
        for (std::uint64_t k = path_.cursor; k <= i; ++k)
            if (!is_motion(record(k)) || !thread_.follower->append(record(k))) {
                raise(Alarm::RecordInvalid, "thread");
                return false;
            }
        thread_.end = i;
        return true;
    }
    if (path_.planner->next_record() >= most)
        raise(Alarm::RecordInvalid, "a thread of too many steps");
    return false;
}

// Says why it cannot begin, or that it can.
bool ChannelRunner::thread_may_start(const PathRecord& r) noexcept {
    if (r.spindle == 0 || r.spindle > kMaxSpindles || !core_.spindles[r.spindle - 1].exists()) {
        raise(Alarm::SpindleUnknown, name_of('S', r.spindle ? r.spindle - 1u : 0u).view());
        return false;
    }
    if (refuses_detached(r.spindle)) return false;
    SpindleUnit& spindle = core_.spindles[r.spindle - 1];
    if (spindle.command() == 0.0) {
        const double stood_s =
            static_cast<double>(core_.tick - standing_.since) * core_.config.tick_s;
        const double grace_s =
            3.0 * static_cast<double>(core_.config.plc_cycle_ticks) * core_.config.tick_s;
        if (stood_s > grace_s)
            raise(Alarm::ThreadSpindleStands, name_of('S', r.spindle - 1u).view());
        return false;
    }
    double allowed_rpm = kUnlimited, lead = 0;
    for (std::uint64_t i = path_.cursor; i <= thread_.end; ++i) {
        const PathRecord& piece = record(i);
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
        raise(Alarm::ThreadSpindleTooFast, text.view());
        return false;
    }
    return spindle.reached();
}

// True when the thread is done and the path is stopped behind it.
bool ChannelRunner::thread(double& left) noexcept {
    if (standing_.phase != Phase::Thread) {
        standing_.phase = Phase::Thread;
        thread_.empty();
        thread_.retract.clear();
    }
    const PathRecord& first = record(path_.cursor);
    // held out of the thread: back to where the pass begins
    if (thread_.retract.out()) {
        go_back(first);
        return false;
    }
    if (!thread_.moving()) {
        if (program_.holds() || program_.interrupted() || program_.resets() || process_.dead() ||
            core_.all_stop || !program_.is(ChannelState::Running))
            return false;
        if (!thread_.committed()) {
            if (!commit_thread()) return false;
            thread_.stage = ThreadExecutor::Stage::Committed;
        }
        if (!thread_may_start(first)) return false;
        SpindleUnit& spindle = core_.spindles[first.spindle - 1];
        spindle.override_locked = true;
        if (spindle.owner == number_) spindle.locked_by = number_;
    }
    SpindleUnit& spindle = core_.spindles[first.spindle - 1];
    const SpindleObserver& seen = spindle.observer();
    ThreadInput input;
    input.angle = seen.angle(core_.config.tick_s);
    input.acceleration = seen.acceleration();
    input.speed = seen.speed() + input.acceleration * core_.config.tick_s;
    // When everything stops, the axis follows the spindle down and leaves the thread only with it.
    input.brake = (thread_.moving() && spindle.command() == 0.0 && spindle.standing()) ||
                  thread_.retract.clear_of_part();
    if (program_.emergency()) {
        input.emergency_dec = emergency_deceleration();
        thread_.retract.stop();
    }
    const ThreadStep step = thread_.follower->tick(input);
    if (step.lost_line)
        raise(Alarm::ThreadSpindleTooFast, "the spindle has become too fast for the axes");
    if (step.phase == ThreadPhase::Waiting || step.phase == ThreadPhase::Idle) return false;
    thread_.moves(true);
    path_.moving = step.speed > 0;
    path_.rapid = false;
    report_thread(step);
    const PathRecord& r = record(step.record);
    place_axes(r, step.s);
    if (!thread_.retract.active() && withdraws(r)) begin_withdrawal(r, step);
    thread_.retract.move_axes(core_.axes, core_.config.tick_s);
    shown_.show(r);
    path_.step.speed = step.speed;
    path_.step.s = step.s;
    if (step.phase != ThreadPhase::Done) return false;
    if (thread_.retract.active()) {
        if (thread_.retract.clear_of_part() || !thread_.retract.moving()) withdrawn(step);
        return false;
    }
    const bool whole = step.ended_to == thread_.end + 1 && step.ended_to > step.ended_from;
    spindle.override_locked = false;
    if (spindle.locked_by == number_ && spindle.mode() != SpindleUnit::Mode::SurfaceSpeed)
        spindle.locked_by = 0;
    if (!whole && !program_.interrupted() && !program_.resets() && !process_.dead())
        raise(Alarm::ThreadSpindleStands, name_of('S', first.spindle - 1u).view());
    left = whole ? 1.0 - thread_.follower->end_fraction(thread_.end) : 0.0;
    const bool block_end = block_ends_at(thread_.end);
    path_.cursor = thread_.end + 1;
    path_.planner->skip(path_.cursor);
    standing_.phase = Phase::None;
    standing_.begun = false;
    thread_.empty();
    if (block_end && (panel_.keys & kKeySingleBlock) && program_.is(ChannelState::Running))
        stand(ChannelState::ProgramStop, StopReason::SingleBlock);
    return true;
}

void ChannelRunner::report_thread(const ThreadStep& step) noexcept {
    const double dt = core_.config.tick_s;
    const bool any_began = step.began_to > step.began_from,
               any_ended = step.ended_to > step.ended_from;
    if (!any_began && !any_ended) return;
    const std::uint64_t from = !any_began   ? step.ended_from
                               : !any_ended ? step.began_from
                                            : std::min(step.began_from, step.ended_from);
    for (std::uint64_t i = from; i < std::max(step.began_to, step.ended_to); ++i) {
        if (i >= step.began_from && i < step.began_to)
            begin_record(record(i), thread_.follower->begin_fraction(i) * dt);
        if (i < step.ended_from || i >= step.ended_to) continue;
        place_axes(record(i), record(i).length);
        finished(record(i), i, thread_.follower->end_fraction(i) * dt);
    }
}

bool ChannelRunner::withdraws(const PathRecord&) const noexcept {
    return thread_.moving() && !program_.emergency() &&
           (program_.holds() || program_.resets() || process_.dead() || program_.interrupted());
}

void ChannelRunner::begin_withdrawal(const PathRecord& r, const ThreadStep& step) noexcept {
    // A retract direction that is blocked is none: the hold then acts behind the thread.
    for (std::uint32_t k = 0; k < r.axis_count; ++k)
        if (const double way = ThreadRetract::of(r, k);
            way != 0.0 && core_.stroke.room(core_, r.axis[k], way) < std::fabs(way))
            return;
    if (!(panel_.keys & kKeyMachineLock))
        (void)thread_.retract.begin(r, core_.axes, step.speed, core_.config.tick_s);
}

// Out and at rest: the hold, the reset or the end may act; the thread's records wait to be driven
// once more.
void ChannelRunner::withdrawn(const ThreadStep& step) noexcept {
    const PathRecord& first = record(path_.cursor);
    const bool whole = step.ended_to == thread_.end + 1 && step.ended_to > step.ended_from;
    if (!whole) report(KernelEventKind::RecordEnd, record(step.record), 0);
    SpindleUnit& spindle = core_.spindles[first.spindle - 1];
    spindle.override_locked = false;
    if (spindle.locked_by == number_ && spindle.mode() != SpindleUnit::Mode::SurfaceSpeed)
        spindle.locked_by = 0;
    thread_.empty();
    path_.moving = false;
    path_.step.speed = 0;
    thread_.retract.stands_out();
}

bool ChannelRunner::go_back(const PathRecord& first) noexcept {
    if (program_.emergency()) {
        bool moves = false;
        for (std::uint32_t k = 0; k < first.axis_count; ++k)
            moves = core_.axes[first.axis[k]].brake(core_.config.tick_s) || moves;
        thread_.moves(moves);
        return moves;
    }
    const bool go = program_.is(ChannelState::Running) && !program_.holds() &&
                    !program_.interrupted() && !program_.resets() && !process_.dead() &&
                    !core_.all_stop && core_.on();
    const bool there = thread_.retract.step_back(first, core_.axes, go, core_.config.tick_s);
    path_.moving = thread_.retract.moving();
    thread_.moves(path_.moving);
    path_.rapid = true;
    if (there) {
        thread_.retract.clear();
        thread_.empty();
    }
    return there;
}

}  // namespace polyturn::kernel
