// The path driven back and forth by the operator: retrace in a hold, and a handwheel that is the
// time base of the programs of a machine group (prove-out). Both drive the retrace memory; the
// channel's own planner keeps its position and continues from there.
#include <algorithm>
#include <cmath>

#include "kernel/channel/channel_runner.hpp"

namespace polyturn::kernel {
namespace {
constexpr double kOnPath = 1e-3;  // mm, degrees: further off the axes have been moved since
}  // namespace

// No function, thread or rendezvous is in progress: the path may be left here and resumed.
bool ChannelRunner::may_leave_path() const noexcept {
    if (!segment_ || !trail_.ready() || dead_ || stopped_ || interrupted_ || resetting_ ||
        jog_in_hold_ || held_mdi_ || program_left_ || retract_.active() || thread_moving_)
        return false;
    if (question_ || owes_rendezvous_ || !planner_->at_rest()) return false;
    return phase_ == Phase::None || phase_ == Phase::Dwell || phase_ == Phase::Waiting;
}

void ChannelRunner::retrace(bool on) noexcept {
    if (!on) {
        retrace_ = trail_.active() ? 1 : 0;
        return;
    }
    if (line_is_next()) {  // what a start takes must be one thing
        core_.alarm(Alarm::RetraceRefused, number_, "a block entered by hand waits for the start",
                    0, line_);
        return;
    }
    const bool held =
        state_ == ChannelState::Held ||
        (state_ == ChannelState::ProgramStop &&
         (stop_reason_ == StopReason::SingleBlock || stop_reason_ == StopReason::Retrace));
    if (!held || handwheel_ || !(trail_.active() || may_leave_path())) {
        core_.alarm(Alarm::RetraceRefused, number_,
                    held ? "not in this block" : "the program is not held", 0, line_);
        return;
    }
    retrace_ = -1;
}

// The axes of the piece that is left here are where the path left them.
bool ChannelRunner::leave_path() noexcept {
    const bool within = cursor_ < visible_end_ && is_motion(record(cursor_)) && !begun_ &&
                        !step_.over && step_.s > 0 && step_.record == cursor_;
    trail_.enter(within ? &record(cursor_) : nullptr, within ? step_.s : 0.0);
    return true;
}

bool ChannelRunner::axes_are_on(const PathRecord& r, double s) const noexcept {
    // its slots are no axes; locked ones take no part in any path
    if (r.transform || (keys & kKeyMachineLock)) return true;
    SlotVector there;
    position_at(r, s, there);
    for (std::uint32_t i = 0; i < r.axis_count; ++i)
        if (r.axis[i] < kMaxAxes && !core_.axes[r.axis[i]].slave &&
            std::fabs(core_.axes[r.axis[i]].own() - there[i]) > kOnPath)
            return false;
    return true;
}

// Cycle start while a way back is chosen. True: the trail is driven.
bool ChannelRunner::start_retrace(StartPermit) noexcept {
    if (retrace_ == 0) return false;
    if (retrace_ > 0 && !trail_.active()) {
        retrace_ = 0;
        return false;
    }
    if (!trail_.active()) leave_path();
    trail_.turn(retrace_, false);
    return true;
}

// -1 .. 1: speed at which the handwheel drives the programs of the group; 0: standstill.
void ChannelRunner::set_handwheel(bool on, double rate) noexcept {
    // the next start is a new one
    if (handwheel_ && !on && trail_.active() && state_ == ChannelState::Ended) trail_.clear();
    // back on the path by hand: cycle start goes there
    if (handwheel_ && !on && trail_.active()) {
        hold_ = true;
        retrace_ = 1;
    }
    handwheel_ = on;
    handwheel_rate_ = on ? rate : 0.0;
    if (!on) handwheel_blocked_ = false;
    if (handwheel_ && retrace_ != 0) retrace_ = 0;
}

// The handwheel turns backwards, or the retraced path has been left already.
bool ChannelRunner::handwheel_drives_trail() noexcept {
    if (trail_.active()) return true;
    if (handwheel_rate_ >= 0 || !drives_by_handwheel() || state_ == ChannelState::ProgramStop ||
        !may_leave_path())
        return false;
    if (phase_ == Phase::Waiting) {
        if (released_) return false;
        core_.waits.leave(index_);  // it comes again
        came_back_ = true;
    }
    leave_path();
    return true;
}

void ChannelRunner::tell_obstacle() noexcept {
    const PathRecord* r = trail_.obstacle();
    ShortText text;
    if (!r)
        text << "older records are not kept";
    else if (r->flags & kThread)
        text << "thread in line " << r->line;
    else if (r->flags & kTapping)
        text << "tapping in line " << r->line;
    else if (static_cast<RecordKind>(r->kind) == RecordKind::Wait)
        text << "wait M" << r->code << " in line " << r->line;
    else
        text << "line " << r->line;
    core_.alarm(Alarm::RetraceEnds, number_, text.view(), 0, r ? r->line : 0);
}

// All channels of a wait go through it together, in either direction.
bool ChannelRunner::partners_let_through(std::span<ChannelRunner* const> all) const noexcept {
    const std::uint64_t meeting = trail_.obstacle_meeting();
    const PathRecord* wait = trail_.obstacle();
    if (!meeting || !wait) return false;
    for (unsigned k = 0; k < kMaxChannels; ++k) {
        if (k == index_ || !(wait->mask >> k & 1u) || !all[k]->attached()) continue;
        const Trail& other = all[k]->trail_;
        if (other.beside(meeting)) continue;
        const bool before = other.last_meeting() < meeting;
        if (trail_.direction() < 0 ? !before : before) return false;
    }
    return true;
}

// Between the channels' runs: a channel that waits during retrace passes the wait when the others
// are there.
void ChannelRunner::pass_waits(std::span<ChannelRunner* const> all) noexcept {
    handwheel_blocked_ = false;
    if (!trail_.active() || !handwheel_ || handwheel_rate_ == 0 || !trail_.stands() ||
        trail_.at_end())
        return;
    if (partners_let_through(all)) {
        trail_.pass();
        return;
    }
    // A wait that its partners have not reached yet holds nothing up, nor does a program that is
    // back at its start; anything else ends retrace for all.
    const bool at_start = !trail_.obstacle() && trail_.from_the_start();
    handwheel_blocked_ = handwheel_rate_ < 0 && trail_.obstacle_meeting() == 0 && !at_start;
    if (handwheel_blocked_ && !handwheel_reported_) tell_obstacle();
    handwheel_reported_ = handwheel_blocked_ || handwheel_reported_;
}

void ChannelRunner::drive_trail() noexcept {
    const int wanted = handwheel_ ? (handwheel_rate_ < 0   ? -1
                                     : handwheel_rate_ > 0 ? 1
                                                           : 0)
                                  : trail_.direction();
    if (wanted > 0) handwheel_reported_ = false;
    if (wanted != 0 && wanted != trail_.direction() && trail_.at_rest())
        trail_.turn(wanted, handwheel_);
    PathInput input = path_input();
    input.single_block = false;
    input.in_position = true;
    input.hold = input.hold || wanted == 0 || wanted != trail_.direction();
    if (handwheel_) {
        input.feed_override *= std::fabs(handwheel_rate_);
        input.rapid_override *= std::fabs(handwheel_rate_);
    }
    const bool was_at_rest = trail_.at_rest();
    const bool drives = trail_.tick(input);
    if (drives && was_at_rest && !trail_.at_rest() && !axes_are_on(trail_.record(), trail_.s()) &&
        !on_trail_) {
        // The first step is one tick long: what is further off has been moved by hand or by another
        // program. Retrace starts here at standstill: the next tick would otherwise find it in
        // motion and set the axes onto it.
        raise(Alarm::RecordInvalid, "the axes are not on the path that is to be driven back");
        trail_.turn(0, false);
        return;
    }
    on_trail_ = drives && !trail_.at_rest();
    if (drives && (!was_at_rest || !trail_.at_rest())) {
        const PathRecord& r = trail_.record();
        cursor_record_ = kNoRecord;
        place_axes(r, trail_.s());
        line_ = r.line;
        block_ = r.block;
        file_ = r.file;
        moving_ = trail_.speed() > 0;
        moving_rapid_ = (r.flags & kRapid) != 0;
    }
    if (!trail_.at_rest()) return;
    // back where the program was left: it goes on
    if (trail_.at_end() && trail_.direction() > 0) {
        trail_.leave();
        retrace_ = 0;
        on_trail_ = false;
        if (std::exchange(came_back_, false)) stand_at(record(cursor_));
        return;
    }
    if (!handwheel_ && trail_.stands() && trail_.direction() < 0 &&
        state_ == ChannelState::Running) {
        tell_obstacle();
        retrace_ = 1;  // from here it goes forwards only
        stand(ChannelState::Held, StopReason::Retrace);
    }
}

}  // namespace polyturn::kernel
