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
    program_.enter(state, reason);
    core_.event(KernelEventKind::Stopped, number_, static_cast<std::int32_t>(reason), 0,
                shown_.line);
}

void ChannelRunner::raise(Alarm number, std::string_view detail, double value) noexcept {
    if (program_.alarm) return;  // the first one is the cause
    program_.alarm = true;
    program_.brake_for(Brake::Alarm);  // settle() makes it the state once the path rests
    core_.alarm(number, number_, detail, value, shown_.line);
}

void ChannelRunner::interrupt() noexcept {
    if (!program_.runs()) return;
    program_.alarm = true;
    program_.brake_for(Brake::Alarm);
}

StartView ChannelRunner::start_view() const noexcept {
    StartView view{number_};
    view.process_there = process_.listens();
    view.resting = !program_.resets();
    view.alarmed = program_.is(ChannelState::Interrupted);
    view.by_hand_mode = program_.mode == ChannelMode::Jog ||
                        program_.mode == ChannelMode::Handwheel ||
                        program_.mode == ChannelMode::Reference;
    view.away = resume_.aside && !resumes_elsewhere();
    const bool begins = program_.begins();
    const bool at_block = program_.stopped_by(StopReason::Restart);
    view.others_search = begins ? restart_.refused && program_.mode == ChannelMode::Auto
                                : at_block && (restart_.refused || !restart_.complete);
    view.lacks_program = begins && program_.mode == ChannelMode::Auto && !process_.selected;
    // the selected program is not what an operator in this mode means
    view.lacks_block = begins && program_.mode == ChannelMode::Mdi && hand_.lines.waiting() == 0;
    return view;
}

bool ChannelRunner::lacks_program_or_block() const noexcept {
    const StartView view = start_view();
    return view.lacks_program || view.lacks_block;
}

std::uint32_t ChannelRunner::check_start_conditions() noexcept {
    return panel_.start_missing = rows_missing_for_start(core_, start_view());
}

void ChannelRunner::cycle_start(bool only_by_hand) noexcept {
    if (only_by_hand && !line_is_next()) {
        if (hand_.lines.waiting() == 0) return;  // why the block was not taken has been said
        if (program_.runs()) return core_.alarm(Alarm::MdiRefused, number_, "a program runs");
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
    if (idle()) return program_.mode == ChannelMode::Mdi ? Door::EnteredLine : Door::Start;
    if (line_is_next()) return Door::LineInHold;
    return retrace_.chosen() ? Door::Retrace : Door::GoOn;
}

// `door`: another one than the key of cycle start.
void ChannelRunner::start_by(std::optional<Door> door) noexcept {
    const bool drives = program_.drives();
    if (drives && !program_.holds()) return;
    // machine lock of this very tick: it counts before the program runs, or not at all
    if (!drives) take_keys();
    // a reset of this very tick, on a computer that is late: it comes first, as it was pressed
    if (program_.resets() && at_rest() && !restart_.refused) finish_reset();
    const auto permit = permit_of(door.value_or(door_of_start()), start_view());
    if (!permit) return;
    switch (program_.state()) {
        case ChannelState::Running:
        // pressed hold and start before it came to rest
        case ChannelState::Waiting:
            program_.release(Brake::Hold);
            return;
        case ChannelState::Reset:
        case ChannelState::Ended:
            if (program_.mode == ChannelMode::Mdi) {
                hand_.lines.begin(!(panel_.keys & kKeySingleBlock));
                begin_line(*permit);
            } else
                begin_program(*permit, ChannelEventKind::CycleStart,
                              static_cast<double>(core_.supervisor.options.parts
                                                      ? core_.supervisor.options.parts
                                                      : 1),
                              path_.cursor, {});
            return;
        case ChannelState::Held:
            if (line_is_next()) return begin_in_hold(*permit, HandBlock::Of::List);
            return go_on(*permit);
        case ChannelState::ProgramStop:
            if (program_.reason() == StopReason::Dialogue && door != Door::DialogueKey) {
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
    const bool at_stop = program_.is(ChannelState::ProgramStop);
    if (retrace_.chosen())
        (void)start_retrace(permit);
    else if (!ready_to_continue())
        return;
    program_.release(Brake::Hold);
    if (at_stop) {
        if (program_.reason() == StopReason::Restart) {
            core_.waits.take_search(index_);
            restart_.stage = RestartState::None;
        }
        standing_.goes_on = standing_.phase == Phase::Stopped;
        if (program_.reason() == StopReason::SingleBlock) path_.planner->step_block();
        program_.enter(ChannelState::Running);
    } else {
        program_.enter(standing_.phase == Phase::Waiting && !standing_.wait.released
                           ? ChannelState::Waiting
                           : ChannelState::Running);
    }
    program_.no_reason();
}

void ChannelRunner::dialogue_value(double value, std::string_view variable) noexcept {
    const bool asks = program_.stopped_by(StopReason::Dialogue);
    // of the outbox, for the key and what a tick reports besides
    constexpr std::size_t kKeptFree = 4;
    if (!asks)
        core_.alarm(Alarm::NotReady, number_, "no dialogue of the program is open");
    else if (!outbox_.has_room_for(kKeptFree))
        core_.alarm(Alarm::NotReady, number_, "too many answers at a time");
    else
        tell(ChannelEventKind::DialogueValue, path_.cursor, value, variable);
}

// The answer goes to the channel first, then the path goes on: the barrier behind the stop comes
// after it.
void ChannelRunner::dialogue_key(double key) noexcept {
    if (!program_.is(ChannelState::ProgramStop) || program_.reason() != StopReason::Dialogue) {
        core_.alarm(Alarm::NotReady, number_, "no dialogue of the program is open");
        return;
    }
    start_by(Door::DialogueKey);
    if (program_.is(ChannelState::Running)) tell(ChannelEventKind::DialogueKey, path_.cursor, key);
}

void ChannelRunner::begin_program(StartPermit, ChannelEventKind how, double value,
                                  std::uint64_t record, std::string_view text) noexcept {
    know_positions();
    ++program_.run;
    program_.cut_off = false;
    for (std::uint32_t a = 0; a < core_.config.axis_count; ++a)
        // its program reads parameters and couplings as they are now
        if (core_.config.axes[a].channel == number_) core_.axes[a].take_limits();
    program_.enter(ChannelState::Running, StopReason::None);
    program_.hold_put_off = resume_.change_due = false;
    program_.brakes.remove(Brake::Hold, Brake::GroupEnd);
    program_.control = 0;  // what a program has put off holds to its end
    core_.stroke2_off &= ~(ChannelSet{1} << index_);
    production_.begin();
    retrace_.trail.clear();
    if (text.empty()) {  // a block by hand begins no program and no part
        shown_.broken_off = 0;
        hand_.block = {};
        hand_.lines.clear();
        core_.totals.part_begins(index_);
    }
    core_.event(KernelEventKind::CycleStarted, number_);
    tell(how, record, value, text);
}

bool ChannelRunner::restart(double block, ChannelSet together, std::uint32_t group) noexcept {
    if (!program_.is(ChannelState::Reset) && !program_.is(ChannelState::Ended)) {
        core_.alarm(Alarm::NotReady, number_,
                    "a program is restarted at a block only in reset or after the end");
        return false;
    }
    if (program_.mode !=
        ChannelMode::Auto) {  // the mode is the operator's: a restart does not change it
        core_.alarm(Alarm::NotReady, number_,
                    "a program is restarted at a block only in automatic mode (choose it)");
        return false;
    }
    StartView view = start_view();
    view.others_search = false;
    view.lacks_program = !process_.selected;
    const auto permit = permit_of(Door::Restart, view);
    if (!permit) return false;
    restart_.search(group);
    core_.waits.begin_search(index_);
    begin_program(*permit, ChannelEventKind::Restart, block, together | ChannelSet{1} << index_,
                  {});
    return true;
}

void ChannelRunner::end_restart() noexcept {
    reset();
    restart_.refused = !process_.dead();
}

RestartFate ChannelRunner::restart_fate() const noexcept {
    using Fate = RestartFate;
    if (!process_.segment || process_.dead()) return Fate::Dead;
    if (program_.resets() || program_.is(ChannelState::Reset)) return Fate::Reset;
    if (program_.interrupted()) return Fate::Alarm;
    if (!program_.runs()) return Fate::Ended;
    return restart_.stage == RestartState::Searching ? Fate::Searching
           : restart_.stage == RestartState::AtBlock ? Fate::AtBlock
                                                     : Fate::Started;
}

bool ChannelRunner::allow_jog_in_hold() noexcept {
    if (!program_.is(ChannelState::Held) || !at_rest()) return false;
    step_aside();
    return true;
}

void ChannelRunner::step_aside() noexcept {
    if (std::exchange(resume_.aside, true)) return;
    for (std::uint32_t a = 0; a < core_.config.axis_count; ++a)
        if (core_.config.axes[a].channel == number_ || core_.axes[a].owner == number_)
            // P1: before the event that makes the channel read it
            core_.image.left_at[a].store(core_.axes[a].own(), std::memory_order_release);
}

void ChannelRunner::feed_hold() noexcept {
    resume_.start_wanted = false;
    if (program_.is(ChannelState::Ended)) hand_.lines.stand();  // between two blocks by hand
    if (program_.control & kControlNoHold)
        program_.hold_put_off = program_.runs();
    else
        safe_hold();
}

void ChannelRunner::safe_hold() noexcept {
    if (program_.drives()) program_.brake_for(Brake::Hold);
}

void ChannelRunner::reset() noexcept {
    if (!process_.segment) return;
    program_.cut_off = restart_.refused = false;
    if (process_.dead() ||
        process_.frozen()) {  // nothing to report; a successor attaches in reset state
        program_.alarm = false;
        return;
    }
    program_.brake_for(Brake::Reset);
}

// The path rests: what was pushed and not executed is void, the channel begins again behind it.
void ChannelRunner::finish_reset() noexcept {
    program_.release(Brake::Reset);
    core_.tools.forget(index_);
    core_.tools.end_search(index_);
    core_.waits.leave(index_);
    ++program_.run;
    const bool ran = program_.runs() || program_.is(ChannelState::Interrupted);
    const std::uint64_t not_begun = first_not_begun();
    ++path_.epoch;
    ++program_.reset_count;
    begin_behind_all();
    path_.step = {};
    path_.step.record = path_.cursor;
    path_.flying = path_.let_pass = standing_.handshake.early = kNoRecord;
    standing_.wait.owed = false;
    path_.cut = {};
    standing_.phase = Phase::None;
    path_.at_boundary = true;
    thread_.empty();
    thread_.retract.clear();
    standing_.begun = standing_.goes_on = standing_.wait.released = standing_.wait.passing =
        standing_.skip.ending = standing_.handshake.unfinished = interrupts_.on = interrupts_.due =
            program_.alarm = program_.hold_put_off = false;
    program_.brakes.remove(Brake::Hold, Brake::Alarm, Brake::Emergency, Brake::GroupEnd);
    program_.control = 0;
    release_stops();
    path_.superposed_from = 0;
    core_.signals.set_nc(signals::cn_balance(number_), 0);
    core_.stroke2_off &= ~(ChannelSet{1} << index_);
    resume_.clear();
    hand_.lines.broken_off();
    hand_.block = {};
    interrupts_.nothing_ahead();
    restart_.stage = RestartState::None;
    retrace_.forget();
    // «Stop after this part»: what was to follow is void, but the program has come to its end.
    const StopReason why =
        std::exchange(production_.ends_with_part, false) ? StopReason::End : StopReason::Reset;
    program_.enter(why == StopReason::End ? ChannelState::Ended : ChannelState::Reset, why);
    for (SpindleUnit& spindle : core_.spindles)
        if (spindle.locked_by == number_) {
            spindle.locked_by = 0;
            spindle.override_locked = false;
        }
    for (AxisUnit& axis : core_.axes)
        if (axis.owner == number_) axis.owner = 0;
    core_.event(KernelEventKind::Stopped, number_, static_cast<std::int32_t>(why), 0, shown_.line);
    if (ran)
        core_.event(KernelEventKind::CycleEnded, number_, static_cast<std::int32_t>(why),
                    production_.times.cycle_s, shown_.line);
    if (ran && why == StopReason::Reset && program_.mode == ChannelMode::Auto)
        shown_.broken_off = shown_.line;
    shown_.line = 0;
    tell(ChannelEventKind::Reset, path_.cursor, static_cast<double>(not_begun));
}

void ChannelRunner::select(std::string_view file, double language) noexcept {
    if (!process_.segment || process_.dead()) return;
    if (program_.runs()) {
        core_.alarm(Alarm::NotReady, number_,
                    "another program is selected only in reset or after the end");
        return;
    }
    production_.forget_cycles();
    process_.selected = !file.empty();
    restart_.refused = false;
    shown_.broken_off = 0;
    process_.language = static_cast<Dialect>(language);
    tell(ChannelEventKind::SelectProgram, path_.cursor, language, file);
}

// START of another channel's program. One that runs already, or is held, goes on as it is.
void ChannelRunner::start_program() noexcept {
    if (!idle()) return;
    // the selected program is meant, not the block that was entered last; the mode is the
    // operator's
    if (program_.mode == ChannelMode::Mdi) {
        core_.alarm(
            Alarm::NotReady, number_,
            "the program of another channel was to start this one, whose mode is MDI (choose automatic)");
        return;
    }
    start_by(Door::ProgramStart);
}

void ChannelRunner::set_mode(ChannelMode mode, bool for_block) noexcept {
    if (mode == program_.mode) return;
    // of this very tick: it comes first, as it was pressed
    if (program_.resets() && at_rest()) finish_reset();
    // a block for which it was meant says itself why it does not run, or runs in the hold
    if (program_.runs()) {
        if (!for_block)
            core_.alarm(Alarm::NotReady, number_,
                        "the mode is changed only in reset or after the end (press reset)", 0,
                        shown_.line);
        return;
    }
    hand_.lines.clear();  // a block of before is not what a start in MDI means
    program_.mode = mode;
}

void ChannelRunner::quit() noexcept {
    if (process_.segment && !process_.dead()) tell(ChannelEventKind::Quit, path_.cursor);
}

void ChannelRunner::process_died(Alarm reason, std::string_view detail) noexcept {
    if (!process_.segment || process_.dead()) return;
    // limit_ is what was visible at this tick: records beyond the horizon do not exist.
    process_.life = ProcessLink::Life::Dead;
    program_.alarm = true;
    // its program is gone and cannot restore the override: a spindle that still turns obeys the
    // override
    program_.control = 0;
    core_.waits.leave(index_);
    ++program_.run;
    const bool ran = program_.runs();
    program_.cut_off = program_.cut_off || ran || program_.is(ChannelState::Interrupted);
    program_.enter(ChannelState::Dead, StopReason::Death);
    core_.alarm(reason, number_, detail.empty() ? name_of('L', index_).view() : detail, 0,
                shown_.line);
    if (ran)
        core_.event(KernelEventKind::CycleEnded, number_,
                    static_cast<std::int32_t>(StopReason::Death), production_.times.cycle_s,
                    shown_.line);
}

void ChannelRunner::process_stopped(bool stopped) noexcept {
    if (!process_.segment || process_.dead()) return;
    process_.life = stopped ? ProcessLink::Life::Frozen : ProcessLink::Life::Live;
    process_.stopped_since = core_.tick;
}

bool ChannelRunner::silent_too_long() const noexcept {
    return process_.frozen() &&
           static_cast<double>(core_.tick - process_.stopped_since) * core_.config.tick_s >=
               core_.config.channel_timeout_s;
}

void ChannelRunner::emergency() noexcept {
    program_.brake_for(Brake::Emergency);
    interrupt();
}

void ChannelRunner::release_wait(Permit) noexcept {
    if (standing_.wait.passing) retrace_.trail.met(core_.meetings);
    standing_.wait.passing = false;
    if (program_.is(ChannelState::Waiting)) program_.enter(ChannelState::Running);
    if (std::exchange(standing_.wait.owed, false)) return retrace_.trail.met(core_.meetings);
    if (standing_.phase != Phase::Waiting) return;
    retrace_.meeting = core_.meetings;
    standing_.wait.released = true;
}

WaitBoard::Standing ChannelRunner::standing() const noexcept {
    const bool over = program_.begins();
    return {program_.run,
            program_.runs() && !program_.interrupted() && !process_.dead() && !program_.resets(),
            (panel_.keys & kKeyDryRun) != 0, over && !program_.cut_off};
}

// It executes blocks towards its target: during a block search, or a block entered by hand, it does
// not rendezvous with channels that cut.
WaitBoard::Phase ChannelRunner::wait_phase() const noexcept {
    if (restart_.stage == RestartState::Searching) return {WaitBoard::Kind::Search, restart_.group};
    return {program_.mode == ChannelMode::Mdi || resume_.runs_by_hand() ? WaitBoard::Kind::ByHand
                                                                        : WaitBoard::Kind::Cut,
            0};
}

// Of those that still wait after all rendezvous of this tick.
void ChannelRunner::after_waits(std::span<ChannelRunner* const> all) noexcept {
    // Its partner stopped between releasing this channel and its arrival: the channel stops as soon
    // as it can and waits there.
    if (std::exchange(standing_.wait.passing, false)) {
        standing_.wait.owed = true;
        standing_.wait.begin(core_.tick);
    }
    if (standing_.wait.owed && program_.is(ChannelState::Running) && at_rest() &&
        !program_.holds() && !program_.interrupted())
        program_.enter(ChannelState::Waiting);
    if ((standing_.phase != Phase::Waiting && !standing_.wait.owed) || standing_.wait.released ||
        program_.interrupted() || program_.resets())
        return;
    if (!standing_.wait.judged) {
        standing_.wait.judged = true;
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
        if (restart_.stage == RestartState::Searching && all[k]->at_restart_block()) {
            ShortText text;
            describe_wait(text);
            text << ", and L" << k + 1 << " restarts in front of it";
            raise(Alarm::RestartMismatch, text.view());
            return;
        }
        if (all[k]->program_runs() && !(unlike & bit)) {
            standing_.wait.warned &= ~bit;
            continue;
        }
        if (standing_.wait.warned & bit) continue;
        standing_.wait.warned |= bit;
        ShortText text;
        text << "L" << k + 1 << " (";
        write_code(text);
        text << ")";
        if (unlike & bit)
            text << why_unlike(core_.waits.phase(index_).kind, core_.waits.phase(k).kind);
        core_.alarm(Alarm::WaitPartnerAbsent, number_, text.view(), 0, shown_.line);
    }
    const double limit = core_.config.channels[index_].wait_timeout_s;
    if (limit > 0 &&
        static_cast<double>(core_.tick - standing_.wait.since) * core_.config.tick_s >= limit) {
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
    text << ":" << shown_.line << " ";
    write_code(text);
    text << " (";
    text.channels(core_.waits.at(index_).set);
    text << ")";
}

}  // namespace polyturn::kernel
