#include "kernel/channel/program/start.hpp"

#include "kernel/channel/path/retrace_drive.hpp"
#include "kernel/channel/path/standstill.hpp"
#include "kernel/channel/path/supply.hpp"
#include "kernel/channel/program/blocks_by_hand.hpp"
#include "kernel/channel/program/hold.hpp"
#include "kernel/channel/program/settle.hpp"
#include "kernel/gate/start_conditions.hpp"

namespace polyturn::kernel {
namespace {

// What a start means just now.
Door door_of_start(const Channel& c) noexcept {
    if (c.program.idle())
        return c.program.mode == ChannelMode::Mdi ? Door::EnteredLine : Door::Start;
    if (line_is_next(c)) return Door::LineInHold;
    return c.retrace.chosen() ? Door::Retrace : Door::GoOn;
}

// From where it stands, in a hold or at a stop.
void go_on(Channel& c, StartPermit permit) noexcept {
    const bool at_stop = c.program.is(ChannelState::ProgramStop);
    if (c.retrace.chosen())
        (void)start_retrace(c, permit);
    else if (!ready_to_continue(c))
        return;
    c.program.release(Brake::Hold);
    if (at_stop) {
        if (c.program.reason() == StopReason::Restart) {
            c.core.waits.take_search(c.index);
            c.restart.stage = RestartState::None;
        }
        c.standing.goes_on = c.standing.phase == RecordPhase::Stopped;
        if (c.program.reason() == StopReason::SingleBlock) c.path.planner->step_block();
        c.program.enter(ChannelState::Running);
    } else {
        c.program.enter(c.standing.phase == RecordPhase::Waiting && !c.standing.wait.released
                            ? ChannelState::Waiting
                            : ChannelState::Running);
    }
    c.program.no_reason();
}

}  // namespace

StartView start_view(const Channel& c) noexcept {
    StartView view{c.number};
    view.process_there = c.process.listens();
    view.resting = !c.program.resets();
    view.alarmed = c.program.is(ChannelState::Interrupted);
    view.by_hand_mode = c.program.mode == ChannelMode::Jog ||
                        c.program.mode == ChannelMode::Handwheel ||
                        c.program.mode == ChannelMode::Reference;
    view.away = c.resume.aside && !resumes_elsewhere(c);
    const bool begins = c.program.begins();
    const bool at_block = c.program.stopped_by(StopReason::Restart);
    view.others_search = begins ? c.restart.refused && c.program.mode == ChannelMode::Auto
                                : at_block && (c.restart.refused || !c.restart.complete);
    view.lacks_program = begins && c.program.mode == ChannelMode::Auto && !c.process.selected;
    // the selected program is not what an operator in this mode means
    view.lacks_block = begins && c.program.mode == ChannelMode::Mdi && c.hand.lines.waiting() == 0;
    return view;
}

std::optional<StartPermit> permit_of(Channel& c, Door door, const StartView& view) noexcept {
    const auto permit = MotionGate::ask(c.core, door, view);
    if (!permit) c.core.alarm(Alarm::NotReady, c.number, missing_for_start(c.core, view).view());
    return permit;
}

void start_by(Channel& c, std::optional<Door> door) noexcept {
    const bool drives = c.program.drives();
    if (drives && !c.program.holds()) return;
    // machine lock of this very tick: it counts before the program runs, or not at all
    if (!drives) take_keys(c);
    // a reset of this very tick, on a computer that is late: it comes first, as it was pressed
    if (c.program.resets() && c.at_rest() && !c.restart.refused) finish_reset(c);
    const auto permit = permit_of(c, door.value_or(door_of_start(c)), start_view(c));
    if (!permit) return;
    switch (c.program.state()) {
        case ChannelState::Running:
        // pressed hold and start before it came to rest
        case ChannelState::Waiting:
            c.program.release(Brake::Hold);
            return;
        case ChannelState::Reset:
        case ChannelState::Ended:
            if (c.program.mode == ChannelMode::Mdi) {
                c.hand.lines.begin(!c.panel.has(kKeySingleBlock));
                begin_line(c, *permit);
            } else
                begin_program(c, *permit, ChannelEventKind::CycleStart,
                              static_cast<double>(c.core.supervisor.options.parts
                                                      ? c.core.supervisor.options.parts
                                                      : 1),
                              c.path.cursor, {});
            return;
        case ChannelState::Held:
            if (line_is_next(c)) return begin_in_hold(c, *permit, HandBlock::Of::List);
            return go_on(c, *permit);
        case ChannelState::ProgramStop:
            if (c.program.reason() == StopReason::Dialogue && door != Door::DialogueKey) {
                c.core.alarm(Alarm::NotReady, c.number,
                             "the program waits for an answer to its dialogue");
                return;
            }
            return go_on(c, *permit);
        default:
            return;
    }
}

void begin_program(Channel& c, StartPermit, ChannelEventKind how, double value,
                   std::uint64_t record, std::string_view text) noexcept {
    know_positions(c.core, c.number);
    ++c.program.run;
    c.program.cut_off = false;
    for (std::uint32_t a = 0; a < c.core.config.axis_count; ++a)
        // its program reads parameters and couplings as they are now
        if (c.core.config.axes[a].channel == c.number) c.core.axes[a].take_limits();
    c.program.enter(ChannelState::Running, StopReason::None);
    c.program.hold_put_off = c.resume.change_due = false;
    c.program.brakes.remove(Brake::Hold, Brake::GroupEnd);
    c.program.control = 0;  // what a program has put off holds to its end
    c.core.stroke2_off &= ~(ChannelSet{1} << c.index);
    c.production.begin();
    c.retrace.trail.clear();
    if (text.empty()) {  // a block by hand begins no program and no part
        c.shown.broken_off = 0;
        c.hand.block = {};
        c.hand.lines.clear();
        c.core.totals.part_begins(c.index);
    }
    c.core.event(KernelEventKind::CycleStarted, c.number);
    c.tell(how, record, value, text);
}

}  // namespace polyturn::kernel
