#include "kernel/channel/program/positioning_steps.hpp"

#include <algorithm>
#include <cmath>

#include "ipc/image/interrupt_inputs.hpp"

namespace polyturn::kernel {
namespace {

bool axis_enabled(Channel& c, std::uint32_t axis) noexcept {
    if (c.core.signals.plc(signals::ap_paxena(axis + 1u))) return true;
    c.raise(Alarm::BNotEnabled, name_of('A', axis).view());
    return false;
}

// The next program of an axis is the one that was started first, whichever channel did it.
bool takes_axis(Channel& c, const PositioningTask& task) noexcept {
    Core::PositioningTurn& turn = c.core.positioning_turn[task.axis];
    if (turn.channel != 0 || turn.first < task.turn || !axis_enabled(c, task.axis)) return false;
    turn.channel = c.number;
    c.positioning.base = c.core.axes[task.axis].own();
    return true;
}

void leave_axis(Channel& c) noexcept {
    Core::PositioningTurn& turn = c.core.positioning_turn[c.positioning.axis()];
    if (turn.channel == c.number) turn.channel = 0;
}

void report_step(
    Channel& c, KernelEventKind kind, const PositioningTask& task,
    std::int32_t code = static_cast<std::int32_t>(RecordKind::PositioningAxis)) noexcept {
    KernelEvent* const event = c.core.log.claim(kind, c.number, c.core.tick, 0);
    if (!event) return;
    event->note = task.note;
    event->line = task.line;
    event->code = code;
    c.core.log.put();
}

// M, S and T of the axis have signals of their own (fanuc_lathe 10.4.2): the path may give a code
// at the same time.
bool give_step_function(Channel& c, const PositioningTask& task) noexcept {
    const std::uint32_t a = task.axis + 1u;
    const bool answered =
        c.core.signals.plc(signals::ap_paxffin(a)) == c.core.signals.nc(signals::an_paxfstr(a));
    if (c.positioning.begun) return answered;
    if (!answered) return false;  // a code that a reset has left to the PLC
    if (task.note) report_step(c, KernelEventKind::RecordBegin, task);
    c.positioning.begun = true;
    c.core.signals.set_nc(signals::an_paxflet(a), task.letter);
    c.core.signals.set_nc(signals::an_paxfcode(a),
                          static_cast<std::int32_t>(std::lround(task.value)));
    c.core.signals.set_nc(signals::an_paxfstr(a), c.core.signals.nc(signals::an_paxfstr(a)) + 1);
    return false;
}

bool step_done(Channel& c, const PositioningTask& task) noexcept {
    PositioningProgram& program = c.positioning;
    const bool begins = !program.begun;
    switch (task.what) {
        case PositioningStep::Begin:
            return takes_axis(c, task);
        case PositioningStep::End:
            leave_axis(c);
            return true;
        case PositioningStep::Move: {
            if (!begins) return !c.core.beside[task.axis].asked && !c.core.axes[task.axis].beside;
            if (c.core.axes[task.axis].beside || !axis_enabled(c, task.axis)) return false;
            if (task.note) report_step(c, KernelEventKind::RecordBegin, task);
            c.core.axes[task.axis].beside = program.begun = true;
            Core::PositioningRequest wish;
            wish.asked = wish.own = true;
            wish.target = task.by_way ? program.base + task.value : task.value;
            wish.per_turn = task.per_turn;
            wish.speed = task.speed;
            wish.channel = c.number;
            wish.spindle = task.spindle;
            wish.note = task.note;
            wish.line = task.line;
            wish.since = c.core.tick;
            c.core.beside[task.axis] = wish;
            return false;
        }
        case PositioningStep::Dwell:
            if (begins) {
                if (task.note) report_step(c, KernelEventKind::RecordBegin, task);
                program.begun = true;
                program.left_s = task.value;
                return task.value <= 0;
            }
            if (holds_positioning(c)) return false;
            program.left_s -= c.core.config.tick_s;
            return program.left_s < 1e-9;
        case PositioningStep::Function:
            return give_step_function(c, task);
        default:
            return true;
    }
}

}  // namespace

void take_step(Channel& c, const PathRecord& r) noexcept {
    PositioningTask task;
    task.what = static_cast<PositioningStep>(r.code);
    task.axis = r.axis[0];
    task.letter = static_cast<char>(r.mask);
    task.by_way = task.what == PositioningStep::MoveBy;
    if (task.by_way) task.what = PositioningStep::Move;
    if (task.what == PositioningStep::Begin) task.turn = c.core.positioning_starts++;
    task.per_turn = static_cast<FeedMode>(r.feed_mode) == FeedMode::PerRevolution;
    task.value = task.what == PositioningStep::Move    ? r.end[0]
                 : task.what == PositioningStep::Dwell ? r.feed
                                                       : r.value;
    task.speed = task.per_turn ? r.feed : r.v_max;
    task.spindle = r.spindle;
    task.line = r.line;
    task.note = r.note;
    if (task.note) report_step(c, KernelEventKind::RecordBegin, task, kStepHandedOver);
    if (task.what == PositioningStep::Begin &&
        c.positioning.started() >= PositioningProgram::kMostStarted)
        c.raise(Alarm::BStartsTooMany, {}, PositioningProgram::kMostStarted);
    else if (!c.positioning.put(task))
        c.raise(Alarm::BMemoryFull);
}

bool runs_positioning(const Channel& c, std::uint32_t axis) noexcept {
    const std::uint32_t whose = c.core.positioning_turn[axis].channel;
    return (c.core.axes[axis].beside && (whose == 0 || whose == c.number)) ||
           c.positioning.moves(axis);
}

void queue_up(Channel& c) noexcept {
    const PositioningTask* const task = c.positioning.now();
    if (!task || task->what != PositioningStep::Begin) return;
    Core::PositioningTurn& turn = c.core.positioning_turn[task->axis];
    turn.first = std::min(turn.first, task->turn);
}

void run_steps(Channel& c) noexcept {
    if (!c.positioning.busy()) return;
    if (!c.program.runs() || breaks_off_positioning(c)) {
        leave_axis(c);
        return c.positioning.clear();
    }
    if (const std::uint32_t axis = c.positioning.axis();
        c.core.signals.plc(signals::ap_paxrst(axis + 1u))) {
        leave_axis(c);
        c.axes.limited = axis;
        return c.positioning.drop();
    }
    constexpr int kMostInATick = 8;
    for (int k = 0; k < kMostInATick; ++k) {
        const PositioningTask* const task = c.positioning.now();
        if (!task || !step_done(c, *task)) return;
        // a move's is reported by the axis
        if (task->note && task->what != PositioningStep::Move)
            report_step(c, KernelEventKind::RecordEnd, *task);
        c.positioning.next();
    }
}

bool holds_positioning(const Channel& c) noexcept {
    const bool plc_stops =
        c.core.signals.plc(signals::cp_stop(c.number)) && !(c.program.control & kControlNoPlcStop);
    return plc_stops || c.program.holds() || c.program.is(ChannelState::Held) ||
           c.retrace.wheel.holds();
}

bool breaks_off_positioning(const Channel& c) noexcept {
    return c.program.resets() || c.program.interrupted() || c.process.dead() ||
           c.program.emergency();
}

}  // namespace polyturn::kernel
