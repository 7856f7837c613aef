// Records without motion: those that need standstill (they hold the path until they are done) and
// instant ones (they act between two moves and cost no time).
#include <algorithm>
#include <cmath>
#include <cstring>
#include <utility>

#include "ipc/image/balance.hpp"
#include "ipc/image/interrupt_inputs.hpp"
#include "ipc/image/program_start.hpp"
#include "ipc/machine/store/store_requests.hpp"
#include "kernel/channel/channel_runner.hpp"
#include "kernel/spindles/spindle_couplings.hpp"

namespace polyturn::kernel {
namespace {
// bounds the work of a tick; more stationary records go on with the next one
constexpr int kStandingPerTick = 64;
constexpr double kStandingRevS = 1e-3;
constexpr double kToolChangeCode = 6;  // M06
constexpr double kToolTimeoutS = 5;    // a store that died is started again meanwhile

std::string_view text_of(const PathRecord& r) noexcept {
    return {r.text.data(), ::strnlen(r.text.data(), r.text.size())};
}
}  // namespace

void ChannelRunner::execute_standing(double& left) noexcept {
    for (int i = 0; i < kStandingPerTick; ++i) {
        if (path_.cursor >= path_.planner->next_record()) return;
        const PathRecord& r = record(path_.cursor);
        if (!stops_path(r) && !(path_.cursor == path_.cut.record && path_.cut.s < kOnLimit)) return;
        if (!standing_.begun) {
            // A new step needs a running program; one that has begun is brought to its end in a
            // hold too.
            if (!program_.is(ChannelState::Running) || program_.holds() || program_.interrupted() ||
                program_.resets() || process_.dead() || core_.all_stop)
                return;
            if (retrace_.wheel.holds() || stops_for_tool(r) || standing_.wait.owed) return;
            if (interrupts_.due &&
                (!(interrupts_.bits & kInterruptAtBlockEnd) || r.serial != shown_.ended_serial))
                return;
            shown_.show(r);
            standing_.begun = true;
            standing_.since = core_.tick;
            if (!is_motion(r) && standing_.handshake.early != path_.cursor)
                begin_record(r, (1.0 - left) * core_.config.tick_s);
        }
        // nothing of it may be driven, or it is a thread, which cannot stop within
        if (path_.cursor == path_.cut.record) {
            if (program_.interrupted()) return;
            begin_record(r, (1.0 - left) * core_.config.tick_s);
            stop_at_limit();
            return;
        }
        if (is_motion(r)) {
            if (!thread(left)) return;
            continue;
        }
        if (!execute(r, left)) return;
        const auto kind = static_cast<RecordKind>(r.kind);
        if ((r.flags & kDrains) && (kind == RecordKind::Aux || kind == RecordKind::Barrier) &&
            (drive_is_coming() || leaves_stop()))
            return;
        const std::uint64_t index = path_.cursor++;
        path_.planner->skip(path_.cursor);
        standing_.begun = false;
        standing_.phase = Phase::None;
        path_.at_boundary = true;
        finished(r, index, (1.0 - left) * core_.config.tick_s);
        // a search moves nothing
        if ((panel_.keys & kKeySingleBlock) && block_ends_at(index) &&
            program_.is(ChannelState::Running) && restart_.stage != RestartState::Searching) {
            stand(ChannelState::ProgramStop, StopReason::SingleBlock);
            return;
        }
    }
}

bool ChannelRunner::execute(const PathRecord& r, double& left) noexcept {
    switch (static_cast<RecordKind>(r.kind)) {
        case RecordKind::Dwell:
            return dwell(r, left);
        case RecordKind::Aux:
            return handshake(r);
        case RecordKind::Wait:
            return arrive(r);
        case RecordKind::Barrier:
            return true;
        case RecordKind::PositioningAxis:
            return begin_positioning(r);
        case RecordKind::Parameter:
            return core_.store.ask_parameter(text_of(r), core_.tick, core_.config.answer_ticks);
        case RecordKind::Await:
            return await(r);
        case RecordKind::Torque:
            return limit_torque(r);
        case RecordKind::Home:
            return find_reference(r);
        case RecordKind::Stop:
            return stop(r);
        case RecordKind::Flag:  // the end of a group of blocks: single block stops behind it
            flag(r);
            return true;
        case RecordKind::SpindleMode:
            return static_cast<SpindleModeCode>(r.code) == SpindleModeCode::Position
                       ? position_spindle(r)
                       : couple_spindle(r);
        default:
            raise(Alarm::RecordInvalid, "unknown kind");
            return false;
    }
}

bool ChannelRunner::execute_instant(const PathRecord& r, double offset_s) noexcept {
    switch (static_cast<RecordKind>(r.kind)) {
        case RecordKind::ToolData: {
            const bool edge = r.plane[0] != 0;
            // of no tool: pieces of those that took part
            if (r.mask == 0)
                return !ToolClient::managed(core_) || core_.tools.pieces(core_, index_, r.value);
            return core_.store.ask_tool(
                edge ? StoreRequestKind::EdgeValue : StoreRequestKind::ToolValue, number_,
                static_cast<std::int32_t>(r.mask), edge ? r.plane[0] * 100 + r.code : r.code,
                r.value, edge ? std::string_view{} : text_of(r), core_.tick,
                core_.config.answer_ticks);
        }
        case RecordKind::LifeGroup:
            return core_.store.ask_tool(StoreRequestKind::LifeGroup, number_,
                                        static_cast<std::int32_t>(r.mask), r.code + 16 * r.plane[0],
                                        r.value, text_of(r), core_.tick, core_.config.answer_ticks);
        case RecordKind::Variable:
        case RecordKind::Offset: {
            if (static_cast<RecordKind>(r.kind) == RecordKind::Variable &&
                part_counter(text_of(r), r.value))
                return true;
            const StoreRequest q = request_of_record(number_, r);
            const auto kind = static_cast<StoreRequestKind>(q.kind);
            const std::string_view name(q.name.data(), ::strnlen(q.name.data(), q.name.size()));
            // A tool's life may be its wear: then the operator is notified.
            if (kind == StoreRequestKind::OffsetValue && ToolClient::managed(core_))
                return core_.store.ask_tool(kind, q.channel, q.number, q.field, q.value, name,
                                            core_.tick, core_.config.answer_ticks);
            return core_.store.write(kind, q.channel, q.number, q.field, q.value, name);
        }
        case RecordKind::SpindleMode:
            // nothing waits
            if (static_cast<SpindleModeCode>(r.code) == SpindleModeCode::Position) {
                (void)position_spindle(r);
                standing_.phase = Phase::None;
                return true;
            }
            spindle_mode(r);
            return true;
        case RecordKind::SpindleSpeed:
            spindle_mode(r);
            return true;
        case RecordKind::Message: {
            if (KernelEvent* event =
                    core_.log.claim(KernelEventKind::Message, number_, core_.tick, offset_s)) {
                event->note = r.note;
                event->line = r.line;
                event->code = -1;  // the program's own words, no row of the catalogue
                copy_text(event->text, text_of(r));
                core_.log.put();
            }
            return true;
        }
        case RecordKind::Part:
            part_made();
            return true;
        case RecordKind::Interrupts:
            interrupts_.bits = r.mask;
            interrupts_.inputs =
                r.value > 0 && r.value < 0x1p32 ? static_cast<std::uint32_t>(r.value) : 0u;
            interrupts_.on = r.code != 0;
            // the channel is in the interrupt program already
            interrupts_.due = interrupts_.due && interrupts_.ahead != kNoRecord;
            // An edge counts from here on; a level that is there already counts at once.
            interrupts_.seen = interrupts_.signals_now(core_.signals, number_);
            return true;
        case RecordKind::Flag:
            flag(r);
            return true;
        case RecordKind::PositioningAxis:
            begin_positioning(r);
            return true;
        case RecordKind::Marker:
            if (restart_.stage == RestartState::Searching)
                core_.waits.mark_in_search(index_, r.code, r.value != 0.0);
            else
                core_.waits.mark(index_, r.code, r.value != 0.0);
            return true;
        case RecordKind::Wait:  // a flying wait that was let pass: it is an arrival like any other
            core_.waits.arrive(index_, r.code, r.mask, program_.run, wait_phase());
            standing_.wait.passing = true;
            return true;
        default:
            return true;
    }
}

// Statements of the program outside the path.
void ChannelRunner::flag(const PathRecord& r) noexcept {
    switch (r.code) {
        case kFlagTapping:
            core_.signals.set_nc(signals::tapping(number_), r.value != 0);
            break;
        case kFlagControl:
            program_.control = static_cast<std::uint32_t>(r.value);
            program_.release(Brake::GroupEnd);
            if ((program_.control & kControlGroupEnds) &&
                ((panel_.pressed & kKeySingleBlock) || core_.signals.plc(signals::m5008(number_))))
                program_.brake_for(Brake::GroupEnd);
            // pressed while it did not count
            if (!(program_.control & kControlNoHold) && std::exchange(program_.hold_put_off, false))
                program_.brake_for(Brake::Hold);
            break;
        case kFlagStroke2:
            if (r.value != 0)
                core_.stroke2_off &= ~(ChannelSet{1} << index_);
            else
                core_.stroke2_off |= ChannelSet{1} << index_;
            break;
        case kFlagBalance:
            core_.signals.set_nc(signals::cn_balance(number_), static_cast<std::int32_t>(r.value));
            break;
        case kFlagProgram: {
            if (r.mask < 1 || r.mask > kMaxChannels) break;
            Core::ProgramCall& call = core_.program_calls[r.mask - 1];
            const std::string_view piece = text_of(r);
            if (!(r.value >= 0 && r.value < static_cast<double>(call.file.size()))) break;
            const auto from = static_cast<std::size_t>(r.value);
            if (from == 0) call.file.fill(0);
            if (from + piece.size() < call.file.size())
                std::copy(piece.begin(), piece.end(),
                          call.file.begin() + static_cast<std::ptrdiff_t>(from));
            call.selected = r.plane[0] != 0;
            break;
        }
        case kFlagStart:
            for (unsigned l = 0; l < kMaxChannels; ++l)
                if (r.mask >> l & 1u) core_.program_calls[l].started = true;
            break;
        case kFlagOutputs:
            core_.signals.set_nc(signals::cn_uout(number_),
                                 static_cast<std::int32_t>(static_cast<std::uint32_t>(r.value)));
            break;
        case kFlagOutputsWide:
            core_.signals.set_nc(signals::cn_uoutw(number_), static_cast<std::int32_t>(r.value));
            break;
        default:
            break;
    }
}

// First-part mode: the operator looks at each tool before it comes.
bool ChannelRunner::stops_for_tool(const PathRecord& r) noexcept {
    if (!(panel_.keys & kKeyFirstPart) || restart_.stage == RestartState::Searching ||
        static_cast<RecordKind>(r.kind) != RecordKind::Aux || r.code != 'T' ||
        standing_.tool_shown == path_.cursor)
        return false;
    standing_.tool_shown = path_.cursor;
    shown_.line = r.line;
    stand(ChannelState::ProgramStop, StopReason::FirstPart);
    return true;
}

bool ChannelRunner::dwell(const PathRecord& r, double& left) noexcept {
    if (standing_.phase != Phase::Dwell) {
        standing_.phase = Phase::Dwell;
        standing_.dwell.left = r.value != 0 ? std::min(standing_.dwell.broken, r.feed) : r.feed;
        standing_.dwell.since = core_.tick;
    }
    if (program_.holds() || program_.interrupted() || core_.all_stop ||
        !program_.is(ChannelState::Running))
        return false;
    double rate = 1.0;  // seconds or revolutions a second
    if (static_cast<FeedMode>(r.feed_mode) == FeedMode::Revolutions) {
        const bool known = r.spindle >= 1 && r.spindle <= kMaxSpindles;
        rate = known ? std::fabs(core_.spindle_rev_s[r.spindle - 1]) : 0.0;
        if (known && refuses_detached(r.spindle)) return false;
        // The PLC may still be writing SP_ROT, as with a feed per revolution.
        const bool answered = core_.tick > standing_.dwell.since + 3 * core_.config.plc_cycle_ticks;
        if (!known ||
            (answered && core_.spindles[r.spindle - 1].command() == 0.0 && rate < kStandingRevS)) {
            raise(Alarm::SpindleStands, name_of('S', r.spindle ? r.spindle - 1u : 0u).view());
            return false;
        }
    }
    if ((r.flags & kSkipMove) && r.code >= 0 && static_cast<std::size_t>(r.code) < kInputs &&
        core_.signals.input(static_cast<std::size_t>(r.code))) {
        for (std::uint32_t a = 0; a < core_.config.axis_count; ++a)
            core_.axes[a].skip = core_.axes[a].measured();
        return standing_.skip.came = true;  // its signal ends it (G4 Q)
    }
    if (retrace_.wheel.on) rate *= std::max(retrace_.wheel.rate, 0.0);
    const double available = rate * left * core_.config.tick_s;
    // A dwell of whole ticks ends with the last of them, whatever the rounding of the sum.
    if (standing_.dwell.left > available + 1e-9 * rate) {
        standing_.dwell.left -= available;
        left = 0.0;
        return false;
    }
    left = available > 0 ? std::fmax(0.0, left * (1.0 - standing_.dwell.left / available)) : left;
    return true;
}

// A spindle is still coming to rest before it gives its drive to a C axis of this channel: what is
// read at the barrier must be where that axis stays.
bool ChannelRunner::drive_is_coming() const noexcept {
    for (std::uint32_t a = 0; a < core_.config.axis_count; ++a)
        if (core_.config.axes[a].on_spindle && core_.config.axes[a].channel == number_ &&
            core_.drive_is_for_axis(a) && !core_.shared_axes[a].has_drive)
            return true;
    return false;
}

namespace {
// M, S and T go to the PLC: a new number in the strobe register is a new code, the same number in
// the answer finishes it.
struct Lines {
    NcSignal strobe, code;
    PlcSignal finished;
};
Lines lines_of(const PathRecord& r, const std::array<char, 3>& letters) noexcept {
    const NcSignal second = r.code == letters[2]   ? signals::cn_aux3c
                            : r.code == letters[1] ? signals::cn_aux2c
                                                   : signals::cn_aux1c;
    return r.code == 'S'   ? Lines{signals::cn_sstr, signals::cn_scode, signals::cp_sfin}
           : r.code == 'T' ? Lines{signals::cn_tstr, signals::cn_tcode, signals::cp_tfin}
           : r.code == 'M' ? Lines{signals::cn_mstr, signals::cn_mcode, signals::cp_mfin}
                           : Lines{signals::cn_bstr, second, signals::cp_bfin};
}
}  // namespace

void ChannelRunner::strobe(const PathRecord& r) noexcept {
    // A spindle code that comes before the first S means the spindle of N0604 as well.
    if (const long code = std::lround(r.value); r.code == 'M' &&
                                                ((code >= 3 && code <= 5) || code == 19) &&
                                                core_.signals.nc(signals::cn_ssel(number_)) == 0)
        core_.signals.set_nc(
            signals::cn_ssel(number_),
            static_cast<std::int32_t>(core_.config.channels[index_].default_spindle));
    const Lines lines = lines_of(r, core_.config.channels[index_].aux_letters);
    standing_.handshake.strobe = core_.signals.nc(lines.strobe(number_)) + 1;
    if (r.code == 'T' && ToolClient::managed(core_))
        core_.tools.show(core_, index_);
    else if (r.code == 'T')
        core_.signals.set_nc(signals::cn_mgzno(number_), 0);
    core_.signals.set_nc(lines.code(number_), static_cast<std::int32_t>(std::lround(r.value)));
    core_.signals.set_nc(lines.strobe(number_), standing_.handshake.strobe);
    if (r.code == 'M') {
        standing_.handshake.m_code = static_cast<std::int32_t>(std::lround(r.value));
        core_.newest_m = {standing_.handshake.m_code, number_};
    }
}

// The PLC is notified of the program's end too, and stops what belongs to it; the end itself does
// not wait.
void ChannelRunner::strobe_end(StopReason reason) noexcept {
    if (reason != StopReason::M02 && reason != StopReason::M30) return;
    PathRecord r{};
    r.code = 'M';
    r.value = reason == StopReason::M02 ? 2.0 : 30.0;
    strobe(r);
}

bool ChannelRunner::handshake(const PathRecord& r) noexcept {
    const Lines lines = lines_of(r, core_.config.channels[index_].aux_letters);
    const bool managed = r.code == 'T' && ToolClient::managed(core_);
    if (managed && standing_.phase != Phase::Handshake && !tool_is_known(r)) return false;
    if (r.plane[2] != 0) {  // passed by a restart: the PLC hears nothing of it
        if (managed || r.code == 'M') core_.tools.pass(core_, index_, r.code == 'M');
        if (managed) core_.tools.forget(index_);
        return true;
    }
    if (managed && standing_.phase != Phase::Handshake && core_.tools.differs(index_)) {
        if (!program_.interrupted())
            raise(
                Alarm::ToolNotFound,
                "since the search for the block another sister has taken its place; restart again");
        return false;
    }
    if (standing_.phase != Phase::Handshake) {
        // the code before is still to be seen
        if (standing_.handshake.unfinished &&
            core_.signals.plc(lines.finished(number_)) != core_.signals.nc(lines.strobe(number_)))
            return false;
        standing_.handshake.unfinished =
            (program_.control & kControlNoFinish) != 0 || (r.flags & kPositioning) != 0;
        standing_.phase = Phase::Handshake;
        if (standing_.handshake.early != path_.cursor) {
            strobe(r);
            standing_.since = core_.tick;
            return false;
        }
    }
    // Its end is not waited for, but the PLC has to see it while the spindle that it means is the
    // selected one.
    if ((r.flags & kPositioning) && core_.tick <= standing_.since + core_.config.plc_cycle_ticks)
        return false;
    if (!standing_.handshake.unfinished &&
        core_.signals.plc(lines.finished(number_)) != standing_.handshake.strobe)
        return false;
    standing_.handshake.early =
        kNoRecord;  // until here: the axes may still be coming to rest while the turret turns
    if (managed) {
        if (!core_.tools.in_place(core_, index_)) return false;  // the store's ring is full
        core_.tools.forget(index_);
    } else if (r.code == 'T') {
        core_.signals.set_nc(signals::cn_potno(number_),
                             static_cast<std::int32_t>(std::lround(r.value)));
    } else if (r.code == 'M' && r.value == kToolChangeCode && ToolClient::managed(core_)) {
        return core_.tools.changed(core_, index_);
    }
    return true;
}

// Which tool it is, and its station: asked of the store before the PLC gets the T. A refusal is
// reported once; it is not asked again before a reset, so that nothing moves by itself when the
// reason is gone.
bool ChannelRunner::tool_is_known(const PathRecord& r) noexcept {
    const ToolClient::Call call = core_.tools.call(index_);
    if (call == ToolClient::Call::Answered) return true;
    if (program_.interrupted()) return false;
    if (call == ToolClient::Call::None) {
        (void)core_.tools.ask(core_, index_, r);
    } else if (call == ToolClient::Call::Refused) {
        const ToolAnswer& answer = core_.tools.answer(index_);
        raise(static_cast<Alarm>(answer.alarm),
              {answer.text.data(), ::strnlen(answer.text.data(), answer.text.size())});
    } else if (core_.store_dead &&
               core_.tick - core_.tools.asked_at(index_) >
                   static_cast<std::int64_t>(kToolTimeoutS / core_.config.tick_s)) {
        raise(Alarm::ToolsUnserved, "the store does not run");
    }
    return false;
}

bool ChannelRunner::arrive(const PathRecord& r) noexcept {
    if (standing_.phase == Phase::Waiting) {
        if (!standing_.wait.released) return false;
        // opened while held: goes on after the start
        if (program_.holds() || !program_.is(ChannelState::Running)) return false;
        standing_.wait.released = false;
        return true;
    }
    standing_.phase = Phase::Waiting;
    standing_.wait.released = false;
    standing_.wait.begin(core_.tick);
    stand_at(r);
    program_.enter(ChannelState::Waiting);
    return false;
}

void ChannelRunner::stand_at(const PathRecord& r) noexcept {
    core_.waits.arrive(index_, r.code, r.mask | ChannelSet{1} << index_, program_.run,
                       wait_phase());
}

bool ChannelRunner::stop(const PathRecord& r) noexcept {
    if (standing_.passes_stop) return true;
    production_.ends_with_part = false;  // the program stops by itself
    const auto reason = static_cast<StopReason>(r.code);
    if (standing_.phase == Phase::Stopped) return std::exchange(standing_.goes_on, false);
    switch (reason) {
        case StopReason::M00:
        case StopReason::M01:
        case StopReason::Dialogue:
            standing_.phase = Phase::Stopped;
            standing_.goes_on = false;
            stand(ChannelState::ProgramStop, reason);
            return false;
        case StopReason::Restart:
            restart_.stage = RestartState::AtBlock;
            standing_.phase = Phase::Stopped;
            standing_.goes_on = false;
            stand(ChannelState::ProgramStop, reason);
            return false;
        case StopReason::Alarm:  // the program cannot be read on; the channel has said why
            program_.alarm = true;
            ++core_.alarm_count;
            program_.brake_for(Brake::Alarm);
            stand(ChannelState::Interrupted, reason);
            core_.event(KernelEventKind::CycleEnded, number_, r.code, production_.times.cycle_s,
                        r.line);
            return true;
        default:
            if (resume_.runs_by_hand()) {  // the block by hand is over, the program is still held
                resume_.by_hand = Resume::ByHand::Done;
                block_is_over();
                stand(ChannelState::Held, StopReason::Held);
                return true;
            }
            restart_.stage = RestartState::None;  // its block did not come
            if (!production_.lap_ended) end_lap();
            block_is_over();
            strobe_end(reason);
            stand(ChannelState::Ended, reason);
            core_.event(KernelEventKind::CycleEnded, number_, r.code, production_.times.cycle_s,
                        r.line);
            return true;
    }
}

// Ownership (architecture 5.9): the last commanding channel owns the spindle, unless the PLC
// decides; a channel that needs the spindle's speed just now keeps it.
bool ChannelRunner::take_spindle(const PathRecord& r, std::uint32_t number, bool lock) noexcept {
    if (number == 0 || number > kMaxSpindles || !core_.spindles[number - 1].exists()) {
        raise(Alarm::SpindleUnknown, name_of('S', number ? number - 1 : 0).view());
        return false;
    }
    SpindleUnit& spindle = core_.spindles[number - 1];
    const bool for_release = static_cast<RecordKind>(r.kind) == RecordKind::SpindleMode &&
                             static_cast<SpindleModeCode>(r.code) == SpindleModeCode::Rpm &&
                             (r.mask & 1u);
    if (spindle.coupled() && !for_release) {
        raise(Alarm::SpindleFollows, name_of('S', number - 1).view());
        return false;
    }
    const auto assigned = static_cast<std::uint32_t>(core_.signals.plc(signals::sp_chan(number)));
    const std::uint32_t owner = assigned ? assigned : spindle.locked_by;
    if (owner != 0 && owner != number_) {
        ShortText text = name_of('S', number - 1);
        text << " belongs to L" << owner;
        // the refused block, not the one before it
        shown_.show(r);
        raise(Alarm::SpindleOwned, text.view());
        return false;
    }
    spindle.owner = number_;
    spindle.locked_by = lock ? number_ : 0;
    core_.signals.set_nc(signals::sn_chan(number), static_cast<std::int32_t>(number_));
    core_.signals.set_nc(signals::cn_ssel(number_), static_cast<std::int32_t>(number));
    return true;
}

// An angle for a spindle whose loop is closed is driven at once and waited for; for the others it
// is where the PLC's M19 will take it, and the M code that follows waits.
bool ChannelRunner::position_spindle(const PathRecord& r) noexcept {
    const std::uint32_t number =
        r.spindle ? r.spindle : core_.config.channels[index_].default_spindle;
    if (standing_.phase != Phase::Spindle) {
        if (!take_spindle(r, number, false)) return false;
        const auto how = static_cast<SpindleApproach>(r.plane[0]);
        // the angle would wait for an M19 that never comes
        const bool open =
            r.mask != 0 && core_.spindles[number - 1].loop() == SpindleUnit::Loop::Turning;
        if (open || !core_.spindles[number - 1].demand_position(
                        how == SpindleApproach::Incremental ? r.shape[2] : r.value, how, r.feed)) {
            raise(Alarm::SpindleNotClosed, name_of('S', number - 1).view());
            return false;
        }
        // The PLC may have let it go with this very tick.
        if (!core_.spindles[number - 1].closed() || !core_.signals.plc(signals::sp_oreq(number)))
            return true;
        standing_.phase = Phase::Spindle;
        return false;
    }
    if (refuses_detached(number)) return false;
    if (core_.spindles[number - 1].loop() == SpindleUnit::Loop::Turning)
        raise(Alarm::SpindleNotClosed, name_of('S', number - 1).view());
    return core_.spindles[number - 1].in_position();
}

// Another channel that machines with the follower keeps it: it cuts a thread, taps or turns with
// constant surface speed (locked_by), or its program drives the C axis on that drive. A program in
// hold or at a barrier has it still, one that an alarm has broken off does until its reset: in its
// tool the workpiece is clamped and would turn.
bool ChannelRunner::needed_elsewhere(std::uint32_t follower) const noexcept {
    if (follower < kMaxAxes || follower >= kMaxAxes + kMaxSpindles) return false;
    const std::uint32_t s = follower - static_cast<std::uint32_t>(kMaxAxes);
    if (core_.spindles[s].locked_by != 0 && core_.spindles[s].locked_by != number_) return true;
    for (std::uint32_t a = 0; a < core_.config.axis_count; ++a) {
        const std::uint32_t owner = core_.axes[a].owner;
        if (core_.config.axes[a].on_spindle != s + 1 || !core_.shared_axes[a].has_drive ||
            owner == 0 || owner == number_)
            continue;
        const auto state = static_cast<ChannelState>(core_.signals.nc(signals::cn_state(owner)));
        if (state != ChannelState::Reset && state != ChannelState::Ended) return true;
    }
    return false;
}

// The drive of a spindle that is to follow may be that of a C axis which rests: then it is the
// spindle's as long as it follows. An axis that moves, or that the PLC keeps, is none of this and
// the coupling is refused.
bool ChannelRunner::calls_follower(std::uint32_t follower) noexcept {
    constexpr int kHandOverTicks = 10;
    if (follower < kMaxAxes || follower >= kMaxAxes + kMaxSpindles ||
        core_.tick >= standing_.since + kHandOverTicks)
        return false;
    const std::uint32_t s = follower - static_cast<std::uint32_t>(kMaxAxes);
    for (std::uint32_t a = 0; a < core_.config.axis_count; ++a) {
        if (core_.config.axes[a].on_spindle != s + 1 || core_.axes[a].moving()) continue;
        core_.spindle_called_until[s] = core_.tick + 3;
        return core_.shared_axes[a].has_drive || !core_.spindles[s].may_follow();
    }
    return false;
}

// A program couples something to a spindle, and goes on when it runs synchronously; uncoupled, when
// it is free.
bool ChannelRunner::couple_spindle(const PathRecord& r) noexcept {
    SpindleCouplings& couplings = *core_.spindle_couplings;
    const std::uint32_t follower = r.axis[0];
    const bool on = static_cast<SpindleModeCode>(r.code) == SpindleModeCode::Couple;
    if (standing_.phase == Phase::Spindle) {
        if (!on) return !couplings.follows(follower);
        if (refuses_detached(r.spindle) ||
            (follower >= kMaxAxes &&
             refuses_detached(follower - static_cast<std::uint32_t>(kMaxAxes) + 1)))
            return false;
        if (!couplings.follows(follower))
            raise(Alarm::SpindleCoupleRefused, SpindleCouplings::name_of_follower(follower).view());
        return couplings.synchronous(follower);
    }
    if (on && needed_elsewhere(follower)) {
        ShortText detail = SpindleCouplings::name_of_follower(follower);
        detail << ": " << SpindleCouplings::text(SpindleCouplings::Refusal::Busy);
        raise(Alarm::SpindleCoupleRefused, detail.view());
        return false;
    }
    if (on && calls_follower(follower)) return false;
    standing_.phase = Phase::Spindle;
    if (!on) {
        // M3 was the follower's
        if ((r.mask & 4u) && r.spindle) core_.signals.set_nc(signals::cn_ssel(number_), r.spindle);
        couplings.uncouple(follower);
        return !couplings.follows(follower);
    }
    SpindleCouplings::Wish wish;
    wish.master = r.spindle;
    wish.follower = follower;
    wish.turns = r.shape[0];
    wish.master_turns = r.shape[1];
    wish.phased = !std::isnan(r.shape[2]);
    wish.phase = wish.phased ? r.shape[2] / 360.0 : 0.0;
    wish.gear = (r.mask & 1u) != 0;
    // The cutter's direction is that of the program's sign, whichever way the workpiece turns.
    if ((r.mask & 2u) && wish.master >= 1 && wish.master <= kMaxSpindles &&
        core_.spindles[wish.master - 1].speed() < 0)
        wish.turns = -wish.turns;
    wish.own_rev_s = r.value / 60.0;
    wish.helix = r.axis[1];
    wish.helix_deg_mm = r.shape[3];
    wish.channel = number_;
    const auto why = couplings.couple(core_, wish);
    if (why == SpindleCouplings::Refusal::None) return false;
    ShortText detail = SpindleCouplings::name_of_follower(follower);
    detail << ": " << SpindleCouplings::text(why);
    raise(Alarm::SpindleCoupleRefused, detail.view());
    return false;
}

void ChannelRunner::spindle_mode(const PathRecord& r) noexcept {
    const std::uint32_t number =
        r.spindle ? r.spindle : core_.config.channels[index_].default_spindle;
    const auto mode = static_cast<RecordKind>(r.kind) == RecordKind::SpindleSpeed
                          ? SpindleModeCode::Rpm
                          : static_cast<SpindleModeCode>(r.code);
    // commands nothing
    const bool watches = mode == SpindleModeCode::Watch || mode == SpindleModeCode::WatchOff;
    if (!(watches && number >= 1 && number <= kMaxSpindles) &&
        !take_spindle(r, number, mode == SpindleModeCode::SurfaceSpeed))
        return;
    SpindleUnit& spindle = core_.spindles[number - 1];
    switch (mode) {
        case SpindleModeCode::Rpm:
            // G92 S: the keys do not go beyond (part 1, 4.4.1)
            if (speaks() == Dialect::Fagor && r.shape[0] > 0)
                spindle.demand_speed(std::fabs(r.value), r.shape[0]);
            else
                spindle.demand_speed(std::fabs(r.value));
            // The PLC is notified (a gear range may have to be chosen); the path does not wait for
            // its answer.
            core_.signals.set_nc(signals::cn_scode(number_),
                                 static_cast<std::int32_t>(std::lround(std::fabs(r.value))));
            core_.signals.set_nc(signals::cn_sstr(number_),
                                 core_.signals.nc(signals::cn_sstr(number_)) + 1);
            break;
        case SpindleModeCode::Off:
            spindle.demand_speed(0.0);
            break;
        case SpindleModeCode::Limit:
            spindle.limit_surface_speed(r.shape[0] > 0 ? r.shape[0] : r.value);
            break;
        case SpindleModeCode::SurfaceSpeed:
            spindle.demand_surface_speed(
                r.value, r.shape[0],
                std::max(core_.config.channels[index_].surface_speed_min_rpm, r.shape[2]),
                r.axis[0], r.shape[1]);
            break;
        case SpindleModeCode::Couple:
        case SpindleModeCode::Uncouple:
        case SpindleModeCode::Position:
            break;  // stationary: position_spindle(), couple_spindle()
        case SpindleModeCode::Watch:
            spindle.watch_fluctuation(true, r.value, r.shape[0], r.shape[2], r.shape[3]);
            break;
        case SpindleModeCode::WatchOff:
            spindle.watch_fluctuation(false, 0, 0, 0, 0);
            break;
    }
}

}  // namespace polyturn::kernel
