// What operator, machine and supervision ask of a channel; acts at a tick's start.
#include <utility>

#include "ipc/image/interrupt_inputs.hpp"
#include "kernel/channel/channel_runner.hpp"
#include "kernel/channel/path/retrace_drive.hpp"
#include "kernel/channel/path/supply.hpp"
#include "kernel/channel/program/blocks_by_hand.hpp"
#include "kernel/channel/program/settle.hpp"
#include "kernel/channel/program/start.hpp"
#include "kernel/gate/start_conditions.hpp"

namespace polyturn::kernel {

void ChannelRunner::overlay_moves(std::uint32_t axis, bool moves) noexcept {
    if (moves)
        c_.path.overlays |= std::uint64_t{1} << (axis % 64);
    else
        c_.path.overlays &= ~(std::uint64_t{1} << (axis % 64));
}

void ChannelRunner::cycle_start(bool only_by_hand) noexcept {
    if (only_by_hand && !line_is_next(c_)) {
        if (c_.hand.lines.waiting() == 0) return;  // why the block was not taken has been said
        if (c_.program.runs()) return c_.core.alarm(Alarm::MdiRefused, c_.number, "a program runs");
    }
    start_by(c_, {});
}

void ChannelRunner::dialogue_value(double value, std::string_view variable) noexcept {
    const bool asks = c_.program.stopped_by(StopReason::Dialogue);
    // of the outbox, for the key and what a tick reports besides
    constexpr std::size_t kKeptFree = 4;
    if (!asks)
        c_.core.alarm(Alarm::NotReady, c_.number, "no dialogue of the program is open");
    else if (!c_.outbox.has_room_for(kKeptFree))
        c_.core.alarm(Alarm::NotReady, c_.number, "too many answers at a time");
    else
        c_.tell(ChannelEventKind::DialogueValue, c_.path.cursor, value, variable);
}

// The answer goes to the channel first, then the path goes on: the barrier behind the stop comes
// after it.
void ChannelRunner::dialogue_key(double key) noexcept {
    if (!c_.program.is(ChannelState::ProgramStop) || c_.program.reason() != StopReason::Dialogue) {
        c_.core.alarm(Alarm::NotReady, c_.number, "no dialogue of the program is open");
        return;
    }
    start_by(c_, Door::DialogueKey);
    if (c_.program.is(ChannelState::Running))
        c_.tell(ChannelEventKind::DialogueKey, c_.path.cursor, key);
}

std::uint32_t ChannelRunner::check_start_conditions() noexcept {
    return c_.panel.start_missing = rows_missing_for_start(c_.core, kernel::start_view(c_));
}

bool ChannelRunner::restart(double block, ChannelSet together, std::uint32_t group) noexcept {
    if (!c_.program.is(ChannelState::Reset) && !c_.program.is(ChannelState::Ended)) {
        c_.core.alarm(Alarm::NotReady, c_.number,
                      "a program is restarted at a block only in reset or after the end");
        return false;
    }
    if (c_.program.mode !=
        ChannelMode::Auto) {  // the mode is the operator's: a restart does not change it
        c_.core.alarm(Alarm::NotReady, c_.number,
                      "a program is restarted at a block only in automatic mode (choose it)");
        return false;
    }
    StartView view = kernel::start_view(c_);
    view.others_search = false;
    view.lacks_program = !c_.process.selected;
    const auto permit = permit_of(c_, Door::Restart, view);
    if (!permit) return false;
    c_.restart.search(group);
    c_.core.waits.begin_search(c_.index);
    begin_program(c_, *permit, ChannelEventKind::Restart, block,
                  together | ChannelSet{1} << c_.index, {});
    return true;
}

void ChannelRunner::end_restart() noexcept {
    reset();
    c_.restart.refused = !c_.process.dead();
}

bool ChannelRunner::allow_jog_in_hold() noexcept {
    if (!c_.program.is(ChannelState::Held) || !c_.at_rest()) return false;
    step_aside();
    return true;
}

void ChannelRunner::step_aside() noexcept {
    if (std::exchange(c_.resume.aside, true)) return;
    for (std::uint32_t a = 0; a < c_.core.config.axis_count; ++a)
        if (c_.core.config.axes[a].channel == c_.number || c_.core.axes[a].owner == c_.number)
            // P1: before the event that makes the channel read it
            c_.core.image.left_at[a].store(c_.core.axes[a].own(), std::memory_order_release);
}

void ChannelRunner::feed_hold() noexcept {
    c_.resume.start_wanted = false;
    if (c_.program.is(ChannelState::Ended)) c_.hand.lines.stand();  // between two blocks by hand
    if (c_.program.control & kControlNoHold)
        c_.program.hold_put_off = c_.program.runs();
    else
        safe_hold();
}

void ChannelRunner::safe_hold() noexcept {
    if (c_.program.drives()) c_.program.brake_for(Brake::Hold);
}

void ChannelRunner::reset() noexcept {
    if (!c_.process.segment) return;
    c_.program.cut_off = c_.restart.refused = false;
    if (c_.process.dead() ||
        c_.process.frozen()) {  // nothing to report; a successor attaches in reset state
        c_.program.alarm = false;
        return;
    }
    c_.program.brake_for(Brake::Reset);
}

void ChannelRunner::select(std::string_view file, double language) noexcept {
    if (!c_.process.segment || c_.process.dead()) return;
    if (c_.program.runs()) {
        c_.core.alarm(Alarm::NotReady, c_.number,
                      "another program is selected only in reset or after the end");
        return;
    }
    c_.production.forget_cycles();
    c_.process.selected = !file.empty();
    c_.restart.refused = false;
    c_.shown.broken_off = 0;
    c_.process.language = static_cast<Dialect>(language);
    c_.tell(ChannelEventKind::SelectProgram, c_.path.cursor, language, file);
}

// START of another channel's program. One that runs already, or is held, goes on as it is.
void ChannelRunner::start_program() noexcept {
    if (!idle()) return;
    // the selected program is meant, not the block that was entered last; the mode is the
    // operator's
    if (c_.program.mode == ChannelMode::Mdi) {
        c_.core.alarm(
            Alarm::NotReady, c_.number,
            "the program of another channel was to start this one, whose mode is MDI (choose automatic)");
        return;
    }
    start_by(c_, Door::ProgramStart);
}

void ChannelRunner::set_mode(ChannelMode mode, bool for_block) noexcept {
    if (mode == c_.program.mode) return;
    // of this very tick: it comes first, as it was pressed
    if (c_.program.resets() && c_.at_rest()) finish_reset(c_);
    // a block for which it was meant says itself why it does not run, or runs in the hold
    if (c_.program.runs()) {
        if (!for_block)
            c_.core.alarm(Alarm::NotReady, c_.number,
                          "the mode is changed only in reset or after the end (press reset)", 0,
                          c_.shown.line);
        return;
    }
    c_.hand.lines.clear();  // a block of before is not what a start in MDI means
    c_.program.mode = mode;
}

void ChannelRunner::quit() noexcept {
    if (c_.process.segment && !c_.process.dead()) c_.tell(ChannelEventKind::Quit, c_.path.cursor);
}

void ChannelRunner::process_died(Alarm reason, std::string_view detail) noexcept {
    if (!c_.process.segment || c_.process.dead()) return;
    // path.limit is what was visible at this tick: records beyond the horizon do not exist.
    c_.process.life = ProcessLink::Life::Dead;
    c_.program.alarm = true;
    // its program is gone and cannot restore the override: a spindle that still turns obeys the
    // override
    c_.program.control = 0;
    c_.core.waits.leave(c_.index);
    ++c_.program.run;
    const bool ran = c_.program.runs();
    c_.program.cut_off = c_.program.cut_off || ran || c_.program.is(ChannelState::Interrupted);
    c_.program.enter(ChannelState::Dead, StopReason::Death);
    c_.core.alarm(reason, c_.number, detail.empty() ? name_of('L', c_.index).view() : detail, 0,
                  c_.shown.line);
    if (ran)
        c_.core.event(KernelEventKind::CycleEnded, c_.number,
                      static_cast<std::int32_t>(StopReason::Death), c_.production.times.cycle_s,
                      c_.shown.line);
}

void ChannelRunner::process_stopped(bool stopped) noexcept {
    if (!c_.process.segment || c_.process.dead()) return;
    c_.process.life = stopped ? ProcessLink::Life::Frozen : ProcessLink::Life::Live;
    c_.process.stopped_since = c_.core.tick;
}

void ChannelRunner::interrupt() noexcept {
    if (!c_.program.runs()) return;
    c_.program.alarm = true;
    c_.program.brake_for(Brake::Alarm);
}

void ChannelRunner::emergency() noexcept {
    c_.program.brake_for(Brake::Emergency);
    interrupt();
}

void ChannelRunner::enter(std::string_view text) noexcept {
    const auto refuse = [&](std::string_view why) {
        c_.core.alarm(Alarm::MdiRefused, c_.number, why);
    };
    // of this very tick: it comes first, as it was pressed
    if (c_.program.resets() && c_.at_rest()) finish_reset(c_);
    if (c_.program.resets()) return refuse("a reset is under way");
    if (c_.program.mode != ChannelMode::Mdi && !c_.program.is(ChannelState::Held))
        return refuse(c_.program.runs() ? "a program runs" : "the mode is not MDI");
    if (c_.program.mode != ChannelMode::Mdi && (c_.resume.start_wanted || !may_leave_for_block(c_)))
        return refuse("no block by hand can run where the program is held");
    if (!c_.hand.lines.enter(text)) refuse("the list is full of blocks that have not run");
}

void ChannelRunner::clear_entered() noexcept {
    // it was about to be left for one of them
    if (c_.hand.block.wanted == HandBlock::Of::List) {
        c_.hand.block.wanted = HandBlock::Of::Nobody;
        c_.resume.start_wanted = false;
    }
    c_.hand.lines.clear();
}

// Refused exactly as a start is, but that the modes for moving by hand are those in which such keys
// are pressed.
void ChannelRunner::hand_key(std::string_view text) noexcept {
    const auto refuse = [&](std::string_view why) {
        c_.core.alarm(Alarm::MdiRefused, c_.number, why);
    };
    const bool held = c_.program.is(ChannelState::Held);
    if (c_.program.runs() && !held) return refuse("a program runs");
    if (c_.program.mode == ChannelMode::Auto && !held) return refuse("the mode is automatic");
    if (c_.hand.lines.goes_on()) return refuse("the blocks entered before have not run");
    take_keys(c_);
    if (c_.program.resets() && c_.at_rest()) finish_reset(c_);
    StartView view = kernel::start_view(c_);
    view.by_hand_mode = view.lacks_program = view.lacks_block = false;
    const auto permit = permit_of(c_, Door::HandKey, view);
    if (!permit) return;
    if (held && (c_.resume.question || c_.core.store.value_open() || !may_leave_for_block(c_)))
        return refuse("no block by hand can run where the program is held");
    copy_text(c_.hand.block.of_key, text);
    if (held) return begin_in_hold(c_, *permit, HandBlock::Of::Key);
    c_.hand.block.runs = HandBlock::Of::Key;
    begin_program(c_, *permit, ChannelEventKind::CycleStart, 1, c_.path.cursor,
                  std::string_view(c_.hand.block.of_key.data()));
}

void ChannelRunner::retrace(bool on) noexcept {
    if (!on) {
        c_.retrace.way = c_.retrace.trail.active() ? Retrace::Way::Forth : Retrace::Way::None;
        return;
    }
    if (line_is_next(c_)) {  // what a start takes must be one thing
        c_.core.alarm(Alarm::RetraceRefused, c_.number,
                      "a block entered by hand waits for the start", 0, c_.shown.line);
        return;
    }
    const bool held =
        c_.program.is(ChannelState::Held) || (c_.program.is(ChannelState::ProgramStop) &&
                                              (c_.program.reason() == StopReason::SingleBlock ||
                                               c_.program.reason() == StopReason::Retrace));
    if (!held || c_.retrace.wheel.on || !(c_.retrace.trail.active() || may_leave_path(c_))) {
        c_.core.alarm(Alarm::RetraceRefused, c_.number,
                      held ? "not in this block" : "the program is not held", 0, c_.shown.line);
        return;
    }
    c_.retrace.way = Retrace::Way::Back;
}

// -1 .. 1: speed at which the handwheel drives the programs of the group; 0: standstill.
void ChannelRunner::set_handwheel(bool on, double rate) noexcept {
    // the next start is a new one
    if (c_.retrace.wheel.on && !on && c_.retrace.trail.active() &&
        c_.program.is(ChannelState::Ended))
        c_.retrace.trail.clear();
    // back on the path by hand: cycle start goes there
    if (c_.retrace.wheel.on && !on && c_.retrace.trail.active()) {
        c_.program.brake_for(Brake::Hold);
        c_.retrace.way = Retrace::Way::Forth;
    }
    c_.retrace.set_wheel(on, rate);
}

void ChannelRunner::superpose(bool on) noexcept {
    if (on && !superposes() && c_.path.planner)
        c_.path.superposed_from = c_.path.planner->next_record();
    c_.panel.pressed = on ? c_.panel.pressed | kKeySuperpose
                          : c_.panel.pressed & ~static_cast<std::uint32_t>(kKeySuperpose);
}

void ChannelRunner::turn_away() noexcept {
    const RecordInbox::Refusal& why = c_.path.inbox.refusal();
    ShortText text = name_of('L', c_.index);
    text << ": record " << static_cast<std::int64_t>(why.record);
    if (why.line != 0) text << ", line " << why.line;
    text << ": " << why.field;
    if (why.axis < kMaxAxes) text << " " << name_of('A', why.axis).view();
    process_died(Alarm::ChannelHostile, text.view());
}

}  // namespace polyturn::kernel
