#include "kernel/channel/path/retrace_drive.hpp"

#include <cmath>

#include "kernel/channel/path/drive.hpp"
#include "kernel/channel/path/place_axes.hpp"
#include "kernel/channel/program/wait_place.hpp"
#include "kernel/records/record_kinds.hpp"

namespace polyturn::kernel {
namespace {

constexpr double kOnPath = 1e-3;  // mm, degrees: further off the axes have been moved since

// The axes of the piece that is left here are where the path left them.
bool leave_path(Channel& c) noexcept {
    const bool within = c.path.cursor < c.path.visible_end && is_motion(c.path.here()) &&
                        !c.standing.begun && c.path.within();
    c.retrace.trail.enter(within ? &c.path.here() : nullptr, within ? c.path.step.s : 0.0);
    return true;
}

bool axes_are_on(const Channel& c, const PathRecord& r, double s) noexcept {
    // its slots are no axes; locked ones take no part in any path
    if (r.transform || c.panel.has(kKeyMachineLock)) return true;
    SlotVector there;
    position_at(r, s, there);
    for (std::uint32_t i = 0; i < r.axis_count; ++i)
        if (r.axis[i] < kMaxAxes && !c.core.axes[r.axis[i]].slave &&
            std::fabs(c.core.axes[r.axis[i]].own() - there[i]) > kOnPath)
            return false;
    return true;
}

}  // namespace

bool may_leave_path(const Channel& c) noexcept {
    if (!c.process.segment || !c.retrace.trail.ready() || c.process.dead() || c.process.frozen() ||
        c.program.interrupted() || c.program.resets() || c.resume.aside ||
        c.resume.runs_by_hand() || c.resume.program_left() || c.thread.retract.active() ||
        c.thread.moving())
        return false;
    if (c.resume.question || c.standing.wait.owed || !c.path.planner->at_rest()) return false;
    return c.standing.phase == RecordPhase::None || c.standing.phase == RecordPhase::Dwell ||
           c.standing.phase == RecordPhase::Waiting;
}

bool start_retrace(Channel& c, StartPermit) noexcept {
    if (c.retrace.way == Retrace::Way::None) return false;
    if (c.retrace.way == Retrace::Way::Forth && !c.retrace.trail.active()) {
        c.retrace.way = Retrace::Way::None;
        return false;
    }
    if (!c.retrace.trail.active()) leave_path(c);
    c.retrace.trail.turn(static_cast<int>(c.retrace.way), false);
    return true;
}

bool handwheel_drives_trail(Channel& c) noexcept {
    if (c.retrace.trail.active()) return true;
    if (c.retrace.wheel.rate >= 0 || !drives_by_handwheel(c) ||
        c.program.is(ChannelState::ProgramStop) || !may_leave_path(c))
        return false;
    if (c.standing.phase == RecordPhase::Waiting) {
        if (c.standing.wait.released) return false;
        c.core.waits.leave(c.index);  // it comes again
        c.retrace.came_back = true;
    }
    leave_path(c);
    return true;
}

bool drives_by_handwheel(const Channel& c) noexcept {
    return c.program.runs() ||
           (c.retrace.wheel.on && c.program.is(ChannelState::Ended) && !c.resume.runs_by_hand());
}

void drive_trail(Channel& c) noexcept {
    const int wanted = c.retrace.wheel.on ? (c.retrace.wheel.rate < 0   ? -1
                                             : c.retrace.wheel.rate > 0 ? 1
                                                                        : 0)
                                          : c.retrace.trail.direction();
    if (wanted > 0) c.retrace.wheel.reported = false;
    if (wanted != 0 && wanted != c.retrace.trail.direction() && c.retrace.trail.at_rest())
        c.retrace.trail.turn(wanted, c.retrace.wheel.on);
    PathInput input = path_input(c);
    input.single_block = false;
    input.in_position = true;
    input.hold = input.hold || wanted == 0 || wanted != c.retrace.trail.direction();
    if (c.retrace.wheel.on) {
        input.feed_override *= std::fabs(c.retrace.wheel.rate);
        input.rapid_override *= std::fabs(c.retrace.wheel.rate);
    }
    const bool was_at_rest = c.retrace.trail.at_rest();
    const bool drives = c.retrace.trail.tick(input);
    if (drives && was_at_rest && !c.retrace.trail.at_rest() &&
        !axes_are_on(c, c.retrace.trail.record(), c.retrace.trail.s()) && !c.retrace.on_trail) {
        // The first step is one tick long: what is further off has been moved by hand or by another
        // program. Retrace starts here at standstill: the next tick would otherwise find it in
        // motion and set the axes onto it.
        c.raise(Alarm::RecordInvalid, "the axes are not on the path that is to be driven back");
        c.retrace.trail.turn(0, false);
        return;
    }
    c.retrace.on_trail = drives && !c.retrace.trail.at_rest();
    if (drives && (!was_at_rest || !c.retrace.trail.at_rest())) {
        const PathRecord& r = c.retrace.trail.record();
        c.axes.record = kNoRecord;
        place_axes(c, r, c.retrace.trail.s());
        c.shown.show(r);
        c.path.moving = c.retrace.trail.speed() > 0;
        c.path.rapid = (r.flags & kRapid) != 0;
    }
    if (!c.retrace.trail.at_rest()) return;
    // back where the program was left: it goes on
    if (c.retrace.trail.at_end() && c.retrace.trail.direction() > 0) {
        c.retrace.trail.leave();
        c.retrace.way = Retrace::Way::None;
        c.retrace.on_trail = false;
        if (std::exchange(c.retrace.came_back, false)) stand_at_wait(c, c.path.here());
        return;
    }
    if (!c.retrace.wheel.on && c.retrace.trail.stands() && c.retrace.trail.direction() < 0 &&
        c.program.is(ChannelState::Running)) {
        tell_obstacle(c);
        c.retrace.way = Retrace::Way::Forth;  // from here it goes forwards only
        c.stand(ChannelState::Held, StopReason::Retrace);
    }
}

void tell_obstacle(Channel& c) noexcept {
    const PathRecord* r = c.retrace.trail.obstacle();
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
    c.core.alarm(Alarm::RetraceEnds, c.number, text.view(), 0, r ? r->line : 0);
}

}  // namespace polyturn::kernel
