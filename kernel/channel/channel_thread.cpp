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
    const std::uint64_t most = cursor_ + kThreadRecords;
    for (std::uint64_t i = cursor_; i < std::min(planner_->next_record(), most); ++i) {
        if (!(record(i).flags & kThreadEnd)) continue;
        thread_->clear(cursor_);
        for (std::uint64_t k = cursor_; k <= i; ++k)
            if (!is_motion(record(k)) || !thread_->append(record(k))) {
                raise(Alarm::RecordInvalid, "thread");
                return false;
            }
        thread_end_ = i;
        return true;
    }
    if (planner_->next_record() >= most) raise(Alarm::RecordInvalid, "a thread of too many steps");
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
        const double stood_s = static_cast<double>(core_.tick - phase_since_) * core_.config.tick_s;
        const double grace_s =
            3.0 * static_cast<double>(core_.config.plc_cycle_ticks) * core_.config.tick_s;
        if (stood_s > grace_s)
            raise(Alarm::ThreadSpindleStands, name_of('S', r.spindle - 1u).view());
        return false;
    }
    double allowed_rpm = kUnlimited, lead = 0;
    for (std::uint64_t i = cursor_; i <= thread_end_; ++i) {
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
    if (phase_ != Phase::Thread) {
        phase_ = Phase::Thread;
        thread_moving_ = thread_committed_ = false;
        retract_.clear();
    }
    const PathRecord& first = record(cursor_);
    // held out of the thread: back to where the pass begins
    if (retract_.out()) {
        go_back(first);
        return false;
    }
    if (!thread_moving_) {
        if (hold_ || interrupted_ || resetting_ || dead_ || core_.all_stop ||
            state_ != ChannelState::Running)
            return false;
        if (!thread_committed_ && !(thread_committed_ = commit_thread())) return false;
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
    input.brake = (thread_moving_ && spindle.command() == 0.0 && spindle.standing()) ||
                  retract_.clear_of_part();
    if (emergency_) {
        input.emergency_dec = emergency_deceleration();
        retract_.stop();
    }
    const ThreadStep step = thread_->tick(input);
    if (step.lost_line)
        raise(Alarm::ThreadSpindleTooFast, "the spindle has become too fast for the axes");
    if (step.phase == ThreadPhase::Waiting || step.phase == ThreadPhase::Idle) return false;
    thread_moving_ = true;
    moving_ = step.speed > 0;
    moving_rapid_ = false;
    report_thread(step);
    const PathRecord& r = record(step.record);
    place_axes(r, step.s);
    if (!retract_.active() && withdraws(r)) begin_withdrawal(r, step);
    retract_.move_axes(core_.axes, core_.config.tick_s);
    line_ = r.line;
    block_ = r.block;
    file_ = r.file;
    step_.speed = step.speed;
    step_.s = step.s;
    if (step.phase != ThreadPhase::Done) return false;
    if (retract_.active()) {
        if (retract_.clear_of_part() || !retract_.moving()) withdrawn(step);
        return false;
    }
    const bool whole = step.ended_to == thread_end_ + 1 && step.ended_to > step.ended_from;
    spindle.override_locked = false;
    if (spindle.locked_by == number_ && spindle.mode() != SpindleUnit::Mode::SurfaceSpeed)
        spindle.locked_by = 0;
    if (!whole && !interrupted_ && !resetting_ && !dead_)
        raise(Alarm::ThreadSpindleStands, name_of('S', first.spindle - 1u).view());
    left = whole ? 1.0 - thread_->end_fraction(thread_end_) : 0.0;
    const bool block_end = block_ends_at(thread_end_);
    cursor_ = thread_end_ + 1;
    planner_->skip(cursor_);
    phase_ = Phase::None;
    begun_ = thread_moving_ = thread_committed_ = false;
    if (block_end && (keys & kKeySingleBlock) && state_ == ChannelState::Running)
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
            begin_record(record(i), thread_->begin_fraction(i) * dt);
        if (i < step.ended_from || i >= step.ended_to) continue;
        place_axes(record(i), record(i).length);
        finished(record(i), i, thread_->end_fraction(i) * dt);
    }
}

}  // namespace polyturn::kernel
