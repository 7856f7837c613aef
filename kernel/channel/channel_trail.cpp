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
    if (!process_.segment || !retrace_.trail.ready() || process_.dead() || process_.frozen() ||
        program_.interrupted() || program_.resets() || resume_.aside || resume_.runs_by_hand() ||
        resume_.program_left() || thread_.retract.active() || thread_.moving())
        return false;
    if (resume_.question || standing_.wait.owed || !path_.planner->at_rest()) return false;
    return standing_.phase == Phase::None || standing_.phase == Phase::Dwell ||
           standing_.phase == Phase::Waiting;
}

void ChannelRunner::retrace(bool on) noexcept {
    if (!on) {
        retrace_.way = retrace_.trail.active() ? Retrace::Way::Forth : Retrace::Way::None;
        return;
    }
    if (line_is_next()) {  // what a start takes must be one thing
        core_.alarm(Alarm::RetraceRefused, number_, "a block entered by hand waits for the start",
                    0, shown_.line);
        return;
    }
    const bool held =
        program_.is(ChannelState::Held) ||
        (program_.is(ChannelState::ProgramStop) && (program_.reason() == StopReason::SingleBlock ||
                                                    program_.reason() == StopReason::Retrace));
    if (!held || retrace_.wheel.on || !(retrace_.trail.active() || may_leave_path())) {
        core_.alarm(Alarm::RetraceRefused, number_,
                    held ? "not in this block" : "the program is not held", 0, shown_.line);
        return;
    }
    retrace_.way = Retrace::Way::Back;
}

// The axes of the piece that is left here are where the path left them.
bool ChannelRunner::leave_path() noexcept {
    const bool within = path_.cursor < path_.visible_end && is_motion(record(path_.cursor)) &&
                        !standing_.begun && !path_.step.over && path_.step.s > 0 &&
                        path_.step.record == path_.cursor;
    retrace_.trail.enter(within ? &record(path_.cursor) : nullptr, within ? path_.step.s : 0.0);
    return true;
}

bool ChannelRunner::axes_are_on(const PathRecord& r, double s) const noexcept {
    // its slots are no axes; locked ones take no part in any path
    if (r.transform || (panel_.keys & kKeyMachineLock)) return true;
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
    if (retrace_.way == Retrace::Way::None) return false;
    if (retrace_.way == Retrace::Way::Forth && !retrace_.trail.active()) {
        retrace_.way = Retrace::Way::None;
        return false;
    }
    if (!retrace_.trail.active()) leave_path();
    retrace_.trail.turn(static_cast<int>(retrace_.way), false);
    return true;
}

// -1 .. 1: speed at which the handwheel drives the programs of the group; 0: standstill.
void ChannelRunner::set_handwheel(bool on, double rate) noexcept {
    // the next start is a new one
    if (retrace_.wheel.on && !on && retrace_.trail.active() && program_.is(ChannelState::Ended))
        retrace_.trail.clear();
    // back on the path by hand: cycle start goes there
    if (retrace_.wheel.on && !on && retrace_.trail.active()) {
        program_.brake_for(Brake::Hold);
        retrace_.way = Retrace::Way::Forth;
    }
    retrace_.set_wheel(on, rate);
}

// The handwheel turns backwards, or the retraced path has been left already.
bool ChannelRunner::handwheel_drives_trail() noexcept {
    if (retrace_.trail.active()) return true;
    if (retrace_.wheel.rate >= 0 || !drives_by_handwheel() ||
        program_.is(ChannelState::ProgramStop) || !may_leave_path())
        return false;
    if (standing_.phase == Phase::Waiting) {
        if (standing_.wait.released) return false;
        core_.waits.leave(index_);  // it comes again
        retrace_.came_back = true;
    }
    leave_path();
    return true;
}

void ChannelRunner::tell_obstacle() noexcept {
    const PathRecord* r = retrace_.trail.obstacle();
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
    const std::uint64_t meeting = retrace_.trail.obstacle_meeting();
    const PathRecord* wait = retrace_.trail.obstacle();
    if (!meeting || !wait) return false;
    for (unsigned k = 0; k < kMaxChannels; ++k) {
        if (k == index_ || !(wait->mask >> k & 1u) || !all[k]->attached()) continue;
        const Trail& other = all[k]->retrace_.trail;
        if (other.beside(meeting)) continue;
        const bool before = other.last_meeting() < meeting;
        if (retrace_.trail.direction() < 0 ? !before : before) return false;
    }
    return true;
}

// Between the channels' runs: a channel that waits during retrace passes the wait when the others
// are there.
void ChannelRunner::pass_waits(std::span<ChannelRunner* const> all) noexcept {
    retrace_.wheel.blocked = false;
    if (!retrace_.trail.active() || !retrace_.wheel.on || retrace_.wheel.rate == 0 ||
        !retrace_.trail.stands() || retrace_.trail.at_end())
        return;
    if (partners_let_through(all)) {
        retrace_.trail.pass();
        return;
    }
    // A wait that its partners have not reached yet holds nothing up, nor does a program that is
    // back at its start; anything else ends retrace for all.
    const bool at_start = !retrace_.trail.obstacle() && retrace_.trail.from_the_start();
    retrace_.wheel.blocked =
        retrace_.wheel.rate < 0 && retrace_.trail.obstacle_meeting() == 0 && !at_start;
    if (retrace_.wheel.blocked && !retrace_.wheel.reported) tell_obstacle();
    retrace_.wheel.reported = retrace_.wheel.blocked || retrace_.wheel.reported;
}

void ChannelRunner::drive_trail() noexcept {
    const int wanted = retrace_.wheel.on ? (retrace_.wheel.rate < 0   ? -1
                                            : retrace_.wheel.rate > 0 ? 1
                                                                      : 0)
                                         : retrace_.trail.direction();
    if (wanted > 0) retrace_.wheel.reported = false;
    if (wanted != 0 && wanted != retrace_.trail.direction() && retrace_.trail.at_rest())
        retrace_.trail.turn(wanted, retrace_.wheel.on);
    PathInput input = path_input();
    input.single_block = false;
    input.in_position = true;
    input.hold = input.hold || wanted == 0 || wanted != retrace_.trail.direction();
    if (retrace_.wheel.on) {
        input.feed_override *= std::fabs(retrace_.wheel.rate);
        input.rapid_override *= std::fabs(retrace_.wheel.rate);
    }
    const bool was_at_rest = retrace_.trail.at_rest();
    const bool drives = retrace_.trail.tick(input);
    if (drives && was_at_rest && !retrace_.trail.at_rest() &&
        !axes_are_on(retrace_.trail.record(), retrace_.trail.s()) && !retrace_.on_trail) {
        // The first step is one tick long: what is further off has been moved by hand or by another
        // program. Retrace starts here at standstill: the next tick would otherwise find it in
        // motion and set the axes onto it.
        raise(Alarm::RecordInvalid, "the axes are not on the path that is to be driven back");
        retrace_.trail.turn(0, false);
        return;
    }
    retrace_.on_trail = drives && !retrace_.trail.at_rest();
    if (drives && (!was_at_rest || !retrace_.trail.at_rest())) {
        const PathRecord& r = retrace_.trail.record();
        axes_.record = kNoRecord;
        place_axes(r, retrace_.trail.s());
        shown_.show(r);
        path_.moving = retrace_.trail.speed() > 0;
        path_.rapid = (r.flags & kRapid) != 0;
    }
    if (!retrace_.trail.at_rest()) return;
    // back where the program was left: it goes on
    if (retrace_.trail.at_end() && retrace_.trail.direction() > 0) {
        retrace_.trail.leave();
        retrace_.way = Retrace::Way::None;
        retrace_.on_trail = false;
        if (std::exchange(retrace_.came_back, false)) stand_at(record(path_.cursor));
        return;
    }
    if (!retrace_.wheel.on && retrace_.trail.stands() && retrace_.trail.direction() < 0 &&
        program_.is(ChannelState::Running)) {
        tell_obstacle();
        retrace_.way = Retrace::Way::Forth;  // from here it goes forwards only
        stand(ChannelState::Held, StopReason::Retrace);
    }
}

}  // namespace polyturn::kernel
