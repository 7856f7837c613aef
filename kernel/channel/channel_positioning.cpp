// Asynchronous motion that a program starts and later waits for: positioning axes, positioned
// spindles; torque limits for fixed stops; reference points that a program finds (G28). Also the
// share of the axis limits that a path leaves to a superposed handwheel.
#include <algorithm>
#include <cmath>

#include "ipc/image/interrupt_inputs.hpp"
#include "kernel/channel/channel_runner.hpp"

namespace polyturn::kernel {

// False: the program of the axis is so long that it must get on first.
bool ChannelRunner::begin_positioning(const PathRecord& r) noexcept {
    if (r.axis_count == 0 || r.axis[0] >= kMaxAxes) return true;
    const auto step = static_cast<PositioningStep>(r.code);
    if ((step == PositioningStep::Begin || step == PositioningStep::Room) &&
        !positioning_.has_room())
        return false;
    if (step == PositioningStep::Room) return true;
    if (step != PositioningStep::Plain) {
        take_step(r);
        return true;
    }
    core_.axes[r.axis[0]].beside = true;
    Core::PositioningRequest wish;
    wish.asked = true;
    wish.target = r.end[0];
    wish.per_turn = static_cast<FeedMode>(r.feed_mode) == FeedMode::PerRevolution;
    wish.speed = wish.per_turn ? r.feed : r.v_max;
    wish.channel = number_;
    wish.spindle = r.spindle;
    wish.note = r.note;
    wish.line = r.line;
    wish.since = core_.tick;
    core_.beside[r.axis[0]] = wish;
    return true;
}

// A step of the program that the axis runs by itself; it waits behind those before it
// (beside_program.hpp).
void ChannelRunner::take_step(const PathRecord& r) noexcept {
    PositioningTask task;
    task.what = static_cast<PositioningStep>(r.code);
    task.axis = r.axis[0];
    task.letter = static_cast<char>(r.mask);
    task.by_way = task.what == PositioningStep::MoveBy;
    if (task.by_way) task.what = PositioningStep::Move;
    if (task.what == PositioningStep::Begin) task.turn = core_.positioning_starts++;
    task.per_turn = static_cast<FeedMode>(r.feed_mode) == FeedMode::PerRevolution;
    task.value = task.what == PositioningStep::Move    ? r.end[0]
                 : task.what == PositioningStep::Dwell ? r.feed
                                                       : r.value;
    task.speed = task.per_turn ? r.feed : r.v_max;
    task.spindle = r.spindle;
    task.line = r.line;
    task.note = r.note;
    if (task.note) report_step(KernelEventKind::RecordBegin, task, kStepHandedOver);
    if (task.what == PositioningStep::Begin &&
        positioning_.started() >= PositioningProgram::kMostStarted)
        raise(Alarm::BStartsTooMany, {}, PositioningProgram::kMostStarted);
    else if (!positioning_.put(task))
        raise(Alarm::BMemoryFull);
}

// Moves of another channel's program in between are none of ours.
bool ChannelRunner::runs_positioning(std::uint32_t axis) const noexcept {
    const std::uint32_t whose = core_.positioning_turn[axis].channel;
    return (core_.axes[axis].beside && (whose == 0 || whose == number_)) ||
           positioning_.moves(axis);
}

void ChannelRunner::queue_up() noexcept {
    const PositioningTask* const task = positioning_.now();
    if (!task || task->what != PositioningStep::Begin) return;
    Core::PositioningTurn& turn = core_.positioning_turn[task->axis];
    turn.first = std::min(turn.first, task->turn);
}

// The next program of an axis is the one that was started first, whichever channel did it.
bool ChannelRunner::takes_axis(const PositioningTask& task) noexcept {
    Core::PositioningTurn& turn = core_.positioning_turn[task.axis];
    if (turn.channel != 0 || turn.first < task.turn || !axis_enabled(task.axis)) return false;
    turn.channel = number_;
    positioning_.base = core_.axes[task.axis].own();
    return true;
}

void ChannelRunner::leave_axis() noexcept {
    Core::PositioningTurn& turn = core_.positioning_turn[positioning_.axis()];
    if (turn.channel == number_) turn.channel = 0;
}

bool ChannelRunner::axis_enabled(std::uint32_t axis) noexcept {
    if (core_.signals.plc(signals::ap_paxena(axis + 1u))) return true;
    raise(Alarm::BNotEnabled, name_of('A', axis).view());
    return false;
}

// One step at a time; several that take no time in one tick.
void ChannelRunner::run_steps() noexcept {
    if (!positioning_.busy()) return;
    if (!program_.runs() || breaks_off_positioning()) {
        leave_axis();
        return positioning_.clear();
    }
    if (const std::uint32_t axis = positioning_.axis();
        core_.signals.plc(signals::ap_paxrst(axis + 1u))) {
        leave_axis();
        axes_.limited = axis;
        return positioning_.drop();
    }
    constexpr int kMostInATick = 8;
    for (int k = 0; k < kMostInATick; ++k) {
        const PositioningTask* const task = positioning_.now();
        if (!task || !step_done(*task)) return;
        // a move's is reported by the axis
        if (task->note && task->what != PositioningStep::Move)
            report_step(KernelEventKind::RecordEnd, *task);
        positioning_.next();
    }
}

bool ChannelRunner::step_done(const PositioningTask& task) noexcept {
    PositioningProgram& program = positioning_;
    const bool begins = !program.begun;
    switch (task.what) {
        case PositioningStep::Begin:
            return takes_axis(task);
        case PositioningStep::End:
            leave_axis();
            return true;
        case PositioningStep::Move: {
            if (!begins) return !core_.beside[task.axis].asked && !core_.axes[task.axis].beside;
            if (core_.axes[task.axis].beside || !axis_enabled(task.axis)) return false;
            if (task.note) report_step(KernelEventKind::RecordBegin, task);
            core_.axes[task.axis].beside = program.begun = true;
            Core::PositioningRequest wish;
            wish.asked = wish.own = true;
            wish.target = task.by_way ? program.base + task.value : task.value;
            wish.per_turn = task.per_turn;
            wish.speed = task.speed;
            wish.channel = number_;
            wish.spindle = task.spindle;
            wish.note = task.note;
            wish.line = task.line;
            wish.since = core_.tick;
            core_.beside[task.axis] = wish;
            return false;
        }
        case PositioningStep::Dwell:
            if (begins) {
                if (task.note) report_step(KernelEventKind::RecordBegin, task);
                program.begun = true;
                program.left_s = task.value;
                return task.value <= 0;
            }
            if (holds_positioning()) return false;
            program.left_s -= core_.config.tick_s;
            return program.left_s < 1e-9;
        case PositioningStep::Function:
            return give_function(task);
        default:
            return true;
    }
}

// M, S and T of the axis have signals of their own (fanuc_lathe 10.4.2): the path may give a code
// at the same time.
bool ChannelRunner::give_function(const PositioningTask& task) noexcept {
    const std::uint32_t a = task.axis + 1u;
    const bool answered =
        core_.signals.plc(signals::ap_paxffin(a)) == core_.signals.nc(signals::an_paxfstr(a));
    if (positioning_.begun) return answered;
    if (!answered) return false;  // a code that a reset has left to the PLC
    if (task.note) report_step(KernelEventKind::RecordBegin, task);
    positioning_.begun = true;
    core_.signals.set_nc(signals::an_paxflet(a), task.letter);
    core_.signals.set_nc(signals::an_paxfcode(a),
                         static_cast<std::int32_t>(std::lround(task.value)));
    core_.signals.set_nc(signals::an_paxfstr(a), core_.signals.nc(signals::an_paxfstr(a)) + 1);
    return false;
}

void ChannelRunner::report_step(KernelEventKind kind, const PositioningTask& task,
                                std::int32_t code) noexcept {
    KernelEvent* const event = core_.log.claim(kind, number_, core_.tick, 0);
    if (!event) return;
    event->note = task.note;
    event->line = task.line;
    event->code = code;
    core_.log.put();
}

bool ChannelRunner::holds_positioning() const noexcept {
    const bool plc_stops =
        core_.signals.plc(signals::cp_stop(number_)) && !(program_.control & kControlNoPlcStop);
    return plc_stops || program_.holds() || program_.is(ChannelState::Held) ||
           retrace_.wheel.holds();
}

// Axes rest at their targets; spindles are in position, or have the speed or the standstill that
// they were commanded.
bool ChannelRunner::await(const PathRecord& r) noexcept {
    for (std::uint32_t i = 0; i < r.axis_count; ++i) {
        if (r.axis[i] < kMaxAxes) {
            if (runs_positioning(r.axis[i])) return false;
            continue;
        }
        const std::uint32_t s = r.axis[i] - static_cast<std::uint32_t>(kMaxAxes);
        if (s >= kMaxSpindles || !core_.spindles[s].exists()) continue;
        // The PLC may still be at the code that positions it, and what it said acts with the next
        // tick.
        if (standing_.handshake.unfinished && core_.signals.plc(signals::cp_mfin(number_)) !=
                                                  core_.signals.nc(signals::cn_mstr(number_)))
            return false;
        if (core_.tick < standing_.since + 2) return false;
        const SpindleUnit& spindle = core_.spindles[s];
        const std::int32_t rotation = core_.signals.plc(signals::sp_rot(s + 1));
        if (refuses_detached(s + 1)) return false;
        if (spindle.loop() == SpindleUnit::Loop::Approach ||
            spindle.loop() == SpindleUnit::Loop::Searching)
            return false;
        if (spindle.closed()                 ? !spindle.in_position()
            : rotation == 3 || rotation == 4 ? !spindle.at_speed(rotation)
                                             : !spindle.standing())
            return false;
    }
    return true;
}

// A limit acts at once. When it is removed, the command returns to the slide's actual position, and
// the program waits for that.
bool ChannelRunner::limit_torque(const PathRecord& r) noexcept {
    if (r.axis_count == 0 || r.axis[0] >= kMaxAxes) return true;
    const std::uint32_t a = r.axis[0];
    if (standing_.phase != Phase::Released) {
        core_.program_torque[a] = static_cast<std::uint16_t>(std::clamp(r.value, 0.0, 1000.0));
        core_.program_window[a] = r.value > 0 ? r.shape[0] : 0.0;
        // a new window is around its position
        if (core_.axes[a].pressing && r.shape[0] > 0)
            core_.axes[a].pressed_at = core_.axes[a].measured();
        if (r.value > 0) return true;
        allow_torque(nullptr);  // the move that ended here is over
        standing_.phase = Phase::Released;
        return false;
    }
    return core_.tick > standing_.since + 1 && !core_.axes[a].pressing && !core_.axes[a].beside &&
           !core_.axes[a].moving();
}

void ChannelRunner::release_stops() noexcept {
    for (std::uint32_t a = 0; a < core_.config.axis_count; ++a)
        if (core_.config.axes[a].channel == number_) {
            core_.program_torque[a] = 0;
            core_.program_window[a] = 0;
        }
}

// Axes that have no reference point yet find it as reference mode would do it; the others stay
// where they are.
bool ChannelRunner::find_reference(const PathRecord& r) noexcept {
    const bool begins = standing_.phase != Phase::Home;
    standing_.phase = Phase::Home;
    bool all = true;
    for (std::uint32_t i = 0; i < r.axis_count; ++i) {
        const std::uint32_t a = r.axis[i];
        if (a >= kMaxAxes || !core_.axes[a].exists()) continue;
        if (begins) {
            core_.home_failed[a] = false;
            core_.home_request[a] = !core_.axes[a].referenced;
        }
        if (core_.home_failed[a]) {
            raise(Alarm::ReferenceRefused, name_of('A', a).view());
            return false;
        }
        all = all && core_.axes[a].referenced && !core_.home_request[a] && !core_.home_busy[a] &&
              !core_.axes[a].moving();
    }
    return all;
}

void ChannelRunner::superpose(bool on) noexcept {
    if (on && !superposes() && path_.planner) path_.superposed_from = path_.planner->next_record();
    panel_.pressed = on ? panel_.pressed | kKeySuperpose
                        : panel_.pressed & ~static_cast<std::uint32_t>(kKeySuperpose);
}

bool ChannelRunner::leaves_room() const noexcept {
    if (!superposes() || thread_.moving() || standing_.phase == Phase::Thread) return false;
    if (at_rest())
        return path_.cursor >= path_.superposed_from ||
               path_.planner->next_record() == path_.cursor;
    return path_.cursor >= path_.superposed_from &&
           !(path_.cursor < path_.visible_end &&
             (record(path_.cursor).flags & (kThread | kTapping)));
}

}  // namespace polyturn::kernel
