#include "kernel/channel/program/settle.hpp"

#include <utility>

#include "kernel/channel/program/blocks_by_hand.hpp"
#include "kernel/channel/program/hold.hpp"
#include "kernel/channel/program/interrupt.hpp"
#include "kernel/records/axis_records.hpp"

namespace polyturn::kernel {

void settle_program(Channel& c) noexcept {
    if (!c.at_rest()) return;
    if (c.program.resets()) finish_reset(c);
    if (c.interrupts.due && is_stopped_for_interrupt(c)) break_off(c);
    settle_hold(c);
    if (c.hand.lines.goes_on()) next_line(c);
    if (c.process.life == ProcessLink::Life::Dead) {
        c.process.life = ProcessLink::Life::DeadAtRest;
        c.core.waits.leave(c.index);
        c.core.event(KernelEventKind::Stopped, c.number,
                     static_cast<std::int32_t>(StopReason::Death), 0, c.shown.line);
    }
    if (c.program.interrupted() && !c.program.is(ChannelState::Interrupted) && !c.process.dead()) {
        c.restart.stage = RestartState::None;
        c.core.waits.leave(c.index);
        c.stand(ChannelState::Interrupted, StopReason::Alarm);
    }
    if (c.program.holds() && !c.program.interrupted() && c.program.is(ChannelState::Running) &&
        c.standing.phase != RecordPhase::Handshake)
        c.stand(ChannelState::Held, StopReason::Held);
    if (c.program.is(ChannelState::Running) &&
        ((c.path.step.stands == Stands::BlockEnd && c.panel.has(kKeySingleBlock)) ||
         c.program.take_group_end()))
        c.stand(ChannelState::ProgramStop, StopReason::SingleBlock);
}

void finish_reset(Channel& c) noexcept {
    c.program.release(Brake::Reset);
    c.core.tools.forget(c.index);
    c.core.tools.end_search(c.index);
    c.core.waits.leave(c.index);
    ++c.program.run;
    const bool ran = c.program.runs() || c.program.is(ChannelState::Interrupted);
    const std::uint64_t not_begun = first_not_begun(c);
    ++c.path.epoch;
    ++c.program.reset_count;
    c.path.begin_behind_all();
    c.path.stand_here();
    c.path.cut = {};
    c.standing.forget();
    c.standing.goes_on = c.standing.wait.owed = c.standing.handshake.unfinished = false;
    c.thread.empty();
    c.thread.retract.clear();
    c.program.alarm = c.program.hold_put_off = false;
    c.program.brakes.remove(Brake::Hold, Brake::Alarm, Brake::Emergency, Brake::GroupEnd);
    c.program.control = 0;
    release_stops(c.core, c.number);
    c.path.superposed_from = 0;
    c.core.signals.set_nc(signals::cn_balance(c.number), 0);
    c.core.stroke2_off &= ~(ChannelSet{1} << c.index);
    c.resume.clear();
    c.hand.lines.broken_off();
    c.hand.block = {};
    c.interrupts.off();
    c.interrupts.nothing_ahead();
    c.restart.stage = RestartState::None;
    c.retrace.forget();
    // «Stop after this part»: what was to follow is void, but the program has come to its end.
    const StopReason why =
        std::exchange(c.production.ends_with_part, false) ? StopReason::End : StopReason::Reset;
    c.program.enter(why == StopReason::End ? ChannelState::Ended : ChannelState::Reset, why);
    for (SpindleUnit& spindle : c.core.spindles)
        if (spindle.locked_by == c.number) {
            spindle.locked_by = 0;
            spindle.override_locked = false;
        }
    for (AxisUnit& axis : c.core.axes)
        if (axis.owner == c.number) axis.owner = 0;
    c.core.event(KernelEventKind::Stopped, c.number, static_cast<std::int32_t>(why), 0,
                 c.shown.line);
    if (ran)
        c.core.event(KernelEventKind::CycleEnded, c.number, static_cast<std::int32_t>(why),
                     c.production.times.cycle_s, c.shown.line);
    if (ran && why == StopReason::Reset && c.program.mode == ChannelMode::Auto)
        c.shown.broken_off = c.shown.line;
    c.shown.line = 0;
    c.tell(ChannelEventKind::Reset, c.path.cursor, static_cast<double>(not_begun));
}

}  // namespace polyturn::kernel
