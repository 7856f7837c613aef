// What operator, machine and supervision ask of a channel; acts at a tick's start.
#include <utility>

#include "ipc/image/interrupt_inputs.hpp"
#include "kernel/channel/channel_runner.hpp"
#include "kernel/gate/start_conditions.hpp"

namespace polyturn::kernel {

namespace {
// Both are there, and yet it is no rendezvous.
std::string_view why_unlike(WaitBoard::Kind one, WaitBoard::Kind other) noexcept {
    using Kind = WaitBoard::Kind;
    if (one == Kind::Search || other == Kind::Search) return ", one of the two restarts";
    if (one == Kind::ByHand || other == Kind::ByHand)
        return ", one of the two is there by a block entered by hand";
    return ", one of the two is in dry run";
}
}  // namespace

void ChannelRunner::stand(ChannelState state, StopReason reason) noexcept {
    state_ = state;
    stop_reason_ = reason;
    core_.event(KernelEventKind::Stopped, number_, static_cast<std::int32_t>(reason), 0, line_);
}

void ChannelRunner::raise(Alarm number, std::string_view detail, double value) noexcept {
    if (alarm_) return;  // the first one is the cause
    alarm_ = true;
    interrupted_ = true;  // settle() makes it the state once the path rests
    core_.alarm(number, number_, detail, value, line_);
}

void ChannelRunner::interrupt() noexcept {
    if (!program_runs()) return;
    alarm_ = true;
    interrupted_ = true;
}

StartView ChannelRunner::start_view() const noexcept {
    StartView view{number_};
    view.process_there = segment_ && !dead_ && !stopped_;
    view.resting = !resetting_;
    view.alarmed = state_ == ChannelState::Interrupted;
    view.by_hand_mode = mode_ == ChannelMode::Jog || mode_ == ChannelMode::Handwheel ||
                        mode_ == ChannelMode::Reference;
    view.away = jog_in_hold_ && !resumes_elsewhere();
    const bool begins = state_ == ChannelState::Reset || state_ == ChannelState::Ended;
    const bool at_block =
        state_ == ChannelState::ProgramStop && stop_reason_ == StopReason::Restart;
    view.others_search = begins ? restart_refused_ && mode_ == ChannelMode::Auto
                                : at_block && (restart_refused_ || !restart_complete_);
    view.lacks_program = begins && mode_ == ChannelMode::Auto && !selected_;
    // the selected program is not what an operator in this mode means
    view.lacks_block = begins && mode_ == ChannelMode::Mdi && lines_.waiting() == 0;
    return view;
}

bool ChannelRunner::lacks_program_or_block() const noexcept {
    const StartView view = start_view();
    return view.lacks_program || view.lacks_block;
}

std::uint32_t ChannelRunner::check_start_conditions() noexcept {
    return start_missing_ = rows_missing_for_start(core_, start_view());
}

void ChannelRunner::cycle_start(bool only_by_hand) noexcept {
    if (only_by_hand && !line_is_next()) {
        if (lines_.waiting() == 0) return;  // why the block was not taken has been said
        if (program_runs()) return core_.alarm(Alarm::MdiRefused, number_, "a program runs");
    }
    start_by({});
}

std::optional<StartPermit> ChannelRunner::permit_of(Door door, const StartView& view) noexcept {
    const auto permit = MotionGate::ask(core_, door, view);
    if (!permit) core_.alarm(Alarm::NotReady, number_, missing_for_start(core_, view).view());
    return permit;
}

// What a start means just now.
Door ChannelRunner::door_of_start() const noexcept {
    if (idle()) return mode_ == ChannelMode::Mdi ? Door::EnteredLine : Door::Start;
    if (line_is_next()) return Door::LineInHold;
    return trail_.active() || retrace_ < 0 ? Door::Retrace : Door::GoOn;
}

// `door`: another one than the key of cycle start.
void ChannelRunner::start_by(std::optional<Door> door) noexcept {
    const bool drives = state_ == ChannelState::Running || state_ == ChannelState::Waiting;
    if (drives && !hold_) return;
    // machine lock of this very tick: it counts before the program runs, or not at all
    if (!drives) take_keys();
    // a reset of this very tick, on a computer that is late: it comes first, as it was pressed
    if (resetting_ && at_rest() && !restart_refused_) finish_reset();
    const auto permit = permit_of(door.value_or(door_of_start()), start_view());
    if (!permit) return;
    switch (state_) {
        case ChannelState::Running:
        // pressed hold and start before it came to rest
        case ChannelState::Waiting:
            hold_ = false;
            return;
        case ChannelState::Reset:
        case ChannelState::Ended:
            if (mode_ == ChannelMode::Mdi) {
                lines_.begin(!(keys & kKeySingleBlock));
                begin_line(*permit);
            } else
                begin_program(*permit, ChannelEventKind::CycleStart,
                              static_cast<double>(core_.supervisor.options.parts
                                                      ? core_.supervisor.options.parts
                                                      : 1),
                              cursor_, {});
            return;
        case ChannelState::Held:
            if (line_is_next()) return begin_in_hold(*permit, HandBlock::Of::List);
            return go_on(*permit);
        case ChannelState::ProgramStop:
            if (stop_reason_ == StopReason::Dialogue && !answered_) {
                core_.alarm(Alarm::NotReady, number_,
                            "the program waits for an answer to its dialogue");
                return;
            }
            return go_on(*permit);
        default:
            return;
    }
}

// From where it stands, in a hold or at a stop.
void ChannelRunner::go_on(StartPermit permit) noexcept {
    const bool at_stop = state_ == ChannelState::ProgramStop;
    if (trail_.active() || retrace_ < 0)
        (void)start_retrace(permit);
    else if (!ready_to_continue())
        return;
    hold_ = false;
    if (at_stop) {
        if (stop_reason_ == StopReason::Restart) {
            core_.waits.take_search(index_);
            restart_ = RestartState::None;
        }
        continue_ = phase_ == Phase::Stopped;
        if (stop_reason_ == StopReason::SingleBlock) planner_->step_block();
        state_ = ChannelState::Running;
    } else {
        state_ =
            phase_ == Phase::Waiting && !released_ ? ChannelState::Waiting : ChannelState::Running;
    }
    stop_reason_ = StopReason::None;
}

void ChannelRunner::dialogue_value(double value, std::string_view variable) noexcept {
    const bool asks = state_ == ChannelState::ProgramStop && stop_reason_ == StopReason::Dialogue;
    // of the outbox, for the key and what a tick reports besides
    constexpr std::size_t kKeptFree = 4;
    if (!asks)
        core_.alarm(Alarm::NotReady, number_, "no dialogue of the program is open");
    else if (outbox_count_ + kKeptFree > outbox_.size())
        core_.alarm(Alarm::NotReady, number_, "too many answers at a time");
    else
        tell(ChannelEventKind::DialogueValue, cursor_, value, variable);
}

// The answer goes to the channel first, then the path goes on: the barrier behind the stop comes
// after it.
void ChannelRunner::dialogue_key(double key) noexcept {
    if (state_ != ChannelState::ProgramStop || stop_reason_ != StopReason::Dialogue) {
        core_.alarm(Alarm::NotReady, number_, "no dialogue of the program is open");
        return;
    }
    answered_ = true;
    start_by(Door::DialogueKey);
    answered_ = false;
    if (state_ == ChannelState::Running) tell(ChannelEventKind::DialogueKey, cursor_, key);
}

void ChannelRunner::begin_program(StartPermit, ChannelEventKind how, double value,
                                  std::uint64_t record, std::string_view text) noexcept {
    know_positions();
    ++run_;
    cut_off_ = false;
    for (std::uint32_t a = 0; a < core_.config.axis_count; ++a)
        // its program reads parameters and couplings as they are now
        if (core_.config.axes[a].channel == number_) core_.axes[a].take_limits();
    state_ = ChannelState::Running;
    stop_reason_ = StopReason::None;
    hold_ = hold_later_ = change_due_ = group_ended_ = false;
    control_ = 0;  // what a program has put off holds to its end
    core_.stroke2_off &= ~(ChannelSet{1} << index_);
    cutting_s_ = rapid_s_ = waiting_s_ = cycle_s_ = part_from_s_ = 0;
    lap_ended_ = false;
    blocks_ = 0;
    trail_.clear();
    if (text.empty()) {  // a block by hand begins no program and no part
        broken_off_ = 0;
        hand_ = {};
        lines_.clear();
        core_.totals.part_begins(index_);
    }
    core_.event(KernelEventKind::CycleStarted, number_);
    tell(how, record, value, text);
}

bool ChannelRunner::restart(double block, ChannelSet together, std::uint32_t group) noexcept {
    if (state_ != ChannelState::Reset && state_ != ChannelState::Ended) {
        core_.alarm(Alarm::NotReady, number_,
                    "a program is restarted at a block only in reset or after the end");
        return false;
    }
    if (mode_ != ChannelMode::Auto) {  // the mode is the operator's: a restart does not change it
        core_.alarm(Alarm::NotReady, number_,
                    "a program is restarted at a block only in automatic mode (choose it)");
        return false;
    }
    StartView view = start_view();
    view.others_search = false;
    view.lacks_program = !selected_;
    const auto permit = permit_of(Door::Restart, view);
    if (!permit) return false;
    restart_ = RestartState::Searching;
    restart_group_ = group;
    restart_complete_ = restart_refused_ = false;
    core_.waits.begin_search(index_);
    begin_program(*permit, ChannelEventKind::Restart, block, together | ChannelSet{1} << index_,
                  {});
    return true;
}

void ChannelRunner::end_restart() noexcept {
    reset();
    restart_refused_ = !dead_;
}

RestartFate ChannelRunner::restart_fate() const noexcept {
    using Fate = RestartFate;
    if (!segment_ || dead_) return Fate::Dead;
    if (resetting_ || state_ == ChannelState::Reset) return Fate::Reset;
    if (interrupted_) return Fate::Alarm;
    if (!program_runs()) return Fate::Ended;
    return restart_ == RestartState::Searching ? Fate::Searching
           : restart_ == RestartState::AtBlock ? Fate::AtBlock
                                               : Fate::Started;
}

bool ChannelRunner::allow_jog_in_hold() noexcept {
    if (state_ != ChannelState::Held || !at_rest()) return false;
    step_aside();
    return true;
}

void ChannelRunner::step_aside() noexcept {
    if (std::exchange(jog_in_hold_, true)) return;
    for (std::uint32_t a = 0; a < core_.config.axis_count; ++a)
        if (core_.config.axes[a].channel == number_ || core_.axes[a].owner == number_)
            // P1: before the event that makes the channel read it
            core_.image.left_at[a].store(core_.axes[a].own(), std::memory_order_release);
}

void ChannelRunner::feed_hold() noexcept {
    start_wanted_ = false;
    if (state_ == ChannelState::Ended) lines_.stand();  // between two blocks by hand
    if (control_ & kControlNoHold)
        hold_later_ = program_runs();
    else
        safe_hold();
}

void ChannelRunner::safe_hold() noexcept {
    if (state_ == ChannelState::Running || state_ == ChannelState::Waiting) hold_ = true;
}

void ChannelRunner::reset() noexcept {
    if (!segment_) return;
    cut_off_ = restart_refused_ = false;
    if (dead_ || stopped_) {  // nothing to report; a successor attaches in reset state
        alarm_ = false;
        return;
    }
    resetting_ = true;
}

// The path rests: what was pushed and not executed is void, the channel begins again behind it.
void ChannelRunner::finish_reset() noexcept {
    resetting_ = false;
    core_.tools.forget(index_);
    core_.tools.end_search(index_);
    core_.waits.leave(index_);
    ++run_;
    const bool ran = program_runs() || state_ == ChannelState::Interrupted;
    const std::uint64_t not_begun = first_not_begun();
    ++epoch_;
    ++resets_;
    begin_behind_all();
    step_ = {};
    step_.record = cursor_;
    flying_ = let_pass_ = early_ = kNoRecord;
    owes_rendezvous_ = false;
    cut_ = {};
    phase_ = Phase::None;
    at_boundary_ = true;
    thread_moving_ = thread_committed_ = false;
    retract_.clear();
    jog_in_hold_ = begun_ = hold_ = interrupted_ = alarm_ = continue_ = released_ = passing_ =
        emergency_ = skipping_ = interrupts_on_ = interrupt_due_ = hold_later_ = unfinished_ =
            group_ended_ = false;
    control_ = 0;
    release_stops();
    superposed_from_ = 0;
    core_.signals.set_nc(signals::cn_balance(number_), 0);
    core_.stroke2_off &= ~(ChannelSet{1} << index_);
    asked_for_ = BackFor::Change;
    change_due_ = start_wanted_ = held_mdi_ = program_left_ = false;
    lines_.broken_off();
    hand_ = {};
    question_ = ahead_asked_ = 0;
    ahead_ = kNoRecord;
    restart_ = RestartState::None;
    trail_.clear();
    retrace_ = 0;
    on_trail_ = came_back_ = false;
    meeting_ = 0;
    // «Stop after this part»: what was to follow is void, but the program has come to its end.
    const StopReason why =
        std::exchange(ends_with_part_, false) ? StopReason::End : StopReason::Reset;
    state_ = why == StopReason::End ? ChannelState::Ended : ChannelState::Reset;
    stop_reason_ = why;
    for (SpindleUnit& spindle : core_.spindles)
        if (spindle.locked_by == number_) {
            spindle.locked_by = 0;
            spindle.override_locked = false;
        }
    for (AxisUnit& axis : core_.axes)
        if (axis.owner == number_) axis.owner = 0;
    core_.event(KernelEventKind::Stopped, number_, static_cast<std::int32_t>(why), 0, line_);
    if (ran)
        core_.event(KernelEventKind::CycleEnded, number_, static_cast<std::int32_t>(why), cycle_s_,
                    line_);
    if (ran && why == StopReason::Reset && mode_ == ChannelMode::Auto) broken_off_ = line_;
    line_ = 0;
    tell(ChannelEventKind::Reset, cursor_, static_cast<double>(not_begun));
}

void ChannelRunner::select(std::string_view file, double language) noexcept {
    if (!segment_ || dead_) return;
    if (program_runs()) {
        core_.alarm(Alarm::NotReady, number_,
                    "another program is selected only in reset or after the end");
        return;
    }
    cycles_ = 0;
    cycles_s_ = last_cycle_s_ = 0;
    selected_ = !file.empty();
    restart_refused_ = false;
    broken_off_ = 0;
    job_language_ = static_cast<Dialect>(language);
    tell(ChannelEventKind::SelectProgram, cursor_, language, file);
}

// START of another channel's program. One that runs already, or is held, goes on as it is.
void ChannelRunner::start_program() noexcept {
    if (!idle()) return;
    // the selected program is meant, not the block that was entered last; the mode is the
    // operator's
    if (mode_ == ChannelMode::Mdi) {
        core_.alarm(
            Alarm::NotReady, number_,
            "the program of another channel was to start this one, whose mode is MDI (choose automatic)");
        return;
    }
    start_by(Door::ProgramStart);
}

void ChannelRunner::set_mode(ChannelMode mode, bool for_block) noexcept {
    if (mode == mode_) return;
    // of this very tick: it comes first, as it was pressed
    if (resetting_ && at_rest()) finish_reset();
    // a block for which it was meant says itself why it does not run, or runs in the hold
    if (program_runs()) {
        if (!for_block)
            core_.alarm(Alarm::NotReady, number_,
                        "the mode is changed only in reset or after the end (press reset)", 0,
                        line_);
        return;
    }
    lines_.clear();  // a block of before is not what a start in MDI means
    mode_ = mode;
}

void ChannelRunner::quit() noexcept {
    if (segment_ && !dead_) tell(ChannelEventKind::Quit, cursor_);
}

void ChannelRunner::process_died(Alarm reason, std::string_view detail) noexcept {
    if (!segment_ || dead_) return;
    // limit_ is what was visible at this tick: records beyond the horizon do not exist.
    dead_ = true;
    alarm_ = true;
    // its program is gone and cannot restore the override: a spindle that still turns obeys the
    // override
    control_ = 0;
    rest_reported_ = false;
    core_.waits.leave(index_);
    ++run_;
    const bool ran = program_runs();
    cut_off_ = cut_off_ || ran || state_ == ChannelState::Interrupted;
    state_ = ChannelState::Dead;
    stop_reason_ = StopReason::Death;
    core_.alarm(reason, number_, detail.empty() ? name_of('L', index_).view() : detail, 0, line_);
    if (ran)
        core_.event(KernelEventKind::CycleEnded, number_,
                    static_cast<std::int32_t>(StopReason::Death), cycle_s_, line_);
}

void ChannelRunner::process_stopped(bool stopped) noexcept {
    if (!segment_ || dead_) return;
    stopped_ = stopped;
    stopped_since_ = core_.tick;
}

bool ChannelRunner::silent_too_long() const noexcept {
    return stopped_ && !dead_ &&
           static_cast<double>(core_.tick - stopped_since_) * core_.config.tick_s >=
               core_.config.channel_timeout_s;
}

void ChannelRunner::emergency() noexcept {
    emergency_ = true;
    interrupt();
}

void ChannelRunner::release_wait(Permit) noexcept {
    if (passing_) trail_.met(core_.meetings);
    passing_ = false;
    if (state_ == ChannelState::Waiting) state_ = ChannelState::Running;
    if (std::exchange(owes_rendezvous_, false)) return trail_.met(core_.meetings);
    if (phase_ != Phase::Waiting) return;
    meeting_ = core_.meetings;
    released_ = true;
}

WaitBoard::Standing ChannelRunner::standing() const noexcept {
    const bool over = state_ == ChannelState::Reset || state_ == ChannelState::Ended;
    return {run_, program_runs() && !interrupted_ && !dead_ && !resetting_,
            (keys & kKeyDryRun) != 0, over && !cut_off_};
}

// It executes blocks towards its target: during a block search, or a block entered by hand, it does
// not rendezvous with channels that cut.
WaitBoard::Phase ChannelRunner::wait_phase() const noexcept {
    if (restart_ == RestartState::Searching) return {WaitBoard::Kind::Search, restart_group_};
    return {mode_ == ChannelMode::Mdi || held_mdi_ ? WaitBoard::Kind::ByHand : WaitBoard::Kind::Cut,
            0};
}

// Of those that still wait after all rendezvous of this tick.
void ChannelRunner::after_waits(std::span<ChannelRunner* const> all) noexcept {
    // Its partner stopped between releasing this channel and its arrival: the channel stops as soon
    // as it can and waits there.
    if (std::exchange(passing_, false)) {
        owes_rendezvous_ = true;
        wait_since_ = core_.tick;
        warned_ = 0;
        judged_ = false;
    }
    if (owes_rendezvous_ && state_ == ChannelState::Running && at_rest() && !hold_ && !interrupted_)
        state_ = ChannelState::Waiting;
    if ((phase_ != Phase::Waiting && !owes_rendezvous_) || released_ || interrupted_ || resetting_)
        return;
    if (!judged_) {
        judged_ = true;
        const auto verdict = core_.waits.judge(index_, core_.no_wait());
        if (verdict.fault != WaitBoard::Fault::None) {
            ShortText text;
            describe_wait(text);
            for (unsigned k = 0; k < kMaxChannels; ++k)
                if (verdict.with >> k & 1u) {
                    text << "; ";
                    all[k]->describe_wait(text);
                }
            raise(verdict.fault == WaitBoard::Fault::OtherSet ? Alarm::WaitOtherSet
                                                              : Alarm::WaitDeadlock,
                  text.view());
            return;
        }
    }
    const ChannelSet missing = core_.waits.missing(index_, core_.no_wait()),
                     unlike = core_.waits.unlike(index_, core_.no_wait());
    for (unsigned k = 0; k < kMaxChannels; ++k) {
        const ChannelSet bit = ChannelSet{1} << k;
        if (!(missing & bit)) continue;
        if (restart_ == RestartState::Searching && all[k]->at_restart_block()) {
            ShortText text;
            describe_wait(text);
            text << ", and L" << k + 1 << " restarts in front of it";
            raise(Alarm::RestartMismatch, text.view());
            return;
        }
        if (all[k]->program_runs() && !(unlike & bit)) {
            warned_ &= ~bit;
            continue;
        }
        if (warned_ & bit) continue;
        warned_ |= bit;
        ShortText text;
        text << "L" << k + 1 << " (";
        write_code(text);
        text << ")";
        if (unlike & bit)
            text << why_unlike(core_.waits.phase(index_).kind, core_.waits.phase(k).kind);
        core_.alarm(Alarm::WaitPartnerAbsent, number_, text.view(), 0, line_);
    }
    const double limit = core_.config.channels[index_].wait_timeout_s;
    if (limit > 0 && static_cast<double>(core_.tick - wait_since_) * core_.config.tick_s >= limit) {
        ShortText text;
        describe_wait(text);
        text << ", missing ";
        text.channels(missing);
        raise(Alarm::WaitTimeout, text.view());
    }
}

// What it waits at, as its language writes it.
void ChannelRunner::write_code(ShortText& text) const noexcept {
    const std::int32_t code = core_.waits.at(index_).code;
    if (speaks() == Dialect::Sinumerik && code == WaitBoard::kProgramEnd)
        text << "WAITE";
    else if (speaks() == Dialect::Sinumerik)
        text << "WAITM(" << code << ")";
    else
        text << "M" << code;
}

// "L2 O2001.nc:17 M502 (L1, L2)"
void ChannelRunner::describe_wait(ShortText& text) noexcept {
    text << "L" << number_ << " ";
    const std::string_view name = program();
    if (!name.empty()) text << name;
    text << ":" << line_ << " ";
    write_code(text);
    text << " (";
    text.channels(core_.waits.at(index_).set);
    text << ")";
}

}  // namespace polyturn::kernel
