#include "kernel/records/program_records.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

#include "ipc/image/balance.hpp"
#include "ipc/image/interrupt_inputs.hpp"
#include "ipc/image/program_start.hpp"
#include "kernel/channel/path/standstill.hpp"
#include "kernel/channel/program/production.hpp"
#include "kernel/channel/program/wait_place.hpp"
#include "kernel/records/aux_records.hpp"
#include "kernel/records/record_kinds.hpp"

namespace polyturn::kernel {
namespace {

constexpr double kStandingRevS = 1e-3;

}  // namespace

void set_flag(Channel& c, const PathRecord& r) noexcept {
    switch (r.code) {
        case kFlagTapping:
            c.core.signals.set_nc(signals::tapping(c.number), r.value != 0);
            break;
        case kFlagControl:
            c.program.control = static_cast<std::uint32_t>(r.value);
            c.program.release(Brake::GroupEnd);
            if ((c.program.control & kControlGroupEnds) &&
                ((c.panel.pressed & kKeySingleBlock) ||
                 c.core.signals.plc(signals::m5008(c.number))))
                c.program.brake_for(Brake::GroupEnd);
            // pressed while it did not count
            if (!(c.program.control & kControlNoHold) &&
                std::exchange(c.program.hold_put_off, false))
                c.program.brake_for(Brake::Hold);
            break;
        case kFlagStroke2:
            if (r.value != 0)
                c.core.stroke2_off &= ~(ChannelSet{1} << c.index);
            else
                c.core.stroke2_off |= ChannelSet{1} << c.index;
            break;
        case kFlagBalance:
            c.core.signals.set_nc(signals::cn_balance(c.number),
                                  static_cast<std::int32_t>(r.value));
            break;
        case kFlagProgram: {
            if (r.mask < 1 || r.mask > kMaxChannels) break;
            Core::ProgramCall& call = c.core.program_calls[r.mask - 1];
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
                if (r.mask >> l & 1u) c.core.program_calls[l].started = true;
            break;
        case kFlagOutputs:
            c.core.signals.set_nc(signals::cn_uout(c.number),
                                  static_cast<std::int32_t>(static_cast<std::uint32_t>(r.value)));
            break;
        case kFlagOutputsWide:
            c.core.signals.set_nc(signals::cn_uoutw(c.number), static_cast<std::int32_t>(r.value));
            break;
        default:
            break;
    }
}

bool dwell(Channel& c, const PathRecord& r, double& left) noexcept {
    if (c.standing.phase != RecordPhase::Dwell) {
        c.standing.phase = RecordPhase::Dwell;
        c.standing.dwell.left = r.value != 0 ? std::min(c.standing.dwell.broken, r.feed) : r.feed;
        c.standing.dwell.since = c.core.tick;
    }
    if (c.program.holds() || c.program.interrupted() || c.core.all_stop ||
        !c.program.is(ChannelState::Running))
        return false;
    double rate = 1.0;  // seconds or revolutions a second
    if (static_cast<FeedMode>(r.feed_mode) == FeedMode::Revolutions) {
        const bool known = r.spindle >= 1 && r.spindle <= kMaxSpindles;
        rate = known ? std::fabs(c.core.spindle_rev_s[r.spindle - 1]) : 0.0;
        if (known && refuses_detached(c, r.spindle)) return false;
        // The PLC may still be writing SP_ROT, as with a feed per revolution.
        const bool answered =
            c.core.tick > c.standing.dwell.since + 3 * c.core.config.plc_cycle_ticks;
        if (!known ||
            (answered && c.core.spindles[r.spindle - 1].command() == 0.0 && rate < kStandingRevS)) {
            c.raise(Alarm::SpindleStands, name_of('S', r.spindle ? r.spindle - 1u : 0u).view());
            return false;
        }
    }
    if ((r.flags & kSkipMove) && r.code >= 0 && static_cast<std::size_t>(r.code) < kInputs &&
        c.core.signals.input(static_cast<std::size_t>(r.code))) {
        for (std::uint32_t a = 0; a < c.core.config.axis_count; ++a)
            c.core.axes[a].skip = c.core.axes[a].measured();
        return c.standing.skip.came = true;  // its signal ends it (G4 Q)
    }
    if (c.retrace.wheel.on) rate *= std::max(c.retrace.wheel.rate, 0.0);
    const double available = rate * left * c.core.config.tick_s;
    // A dwell of whole ticks ends with the last of them, whatever the rounding of the sum.
    if (c.standing.dwell.left > available + 1e-9 * rate) {
        c.standing.dwell.left -= available;
        left = 0.0;
        return false;
    }
    left = available > 0 ? std::fmax(0.0, left * (1.0 - c.standing.dwell.left / available)) : left;
    return true;
}

bool arrive_at_wait(Channel& c, const PathRecord& r) noexcept {
    if (c.standing.phase == RecordPhase::Waiting) {
        if (!c.standing.wait.released) return false;
        // opened while held: goes on after the start
        if (c.program.holds() || !c.program.is(ChannelState::Running)) return false;
        c.standing.wait.released = false;
        return true;
    }
    c.standing.phase = RecordPhase::Waiting;
    c.standing.wait.released = false;
    c.standing.wait.begin(c.core.tick);
    stand_at_wait(c, r);
    c.program.enter(ChannelState::Waiting);
    return false;
}

bool stop_program(Channel& c, const PathRecord& r) noexcept {
    if (c.standing.passes_stop) return true;
    c.production.ends_with_part = false;  // the program stops by itself
    const auto reason = static_cast<StopReason>(r.code);
    if (c.standing.phase == RecordPhase::Stopped) return std::exchange(c.standing.goes_on, false);
    switch (reason) {
        case StopReason::M00:
        case StopReason::M01:
        case StopReason::Dialogue:
            c.standing.phase = RecordPhase::Stopped;
            c.standing.goes_on = false;
            c.stand(ChannelState::ProgramStop, reason);
            return false;
        case StopReason::Restart:
            c.restart.stage = RestartState::AtBlock;
            c.standing.phase = RecordPhase::Stopped;
            c.standing.goes_on = false;
            c.stand(ChannelState::ProgramStop, reason);
            return false;
        case StopReason::Alarm:  // the program cannot be read on; the channel has said why
            c.program.alarm = true;
            ++c.core.alarm_count;
            c.program.brake_for(Brake::Alarm);
            c.stand(ChannelState::Interrupted, reason);
            c.core.event(KernelEventKind::CycleEnded, c.number, r.code, c.production.times.cycle_s,
                         r.line);
            return true;
        default:
            if (c.resume.runs_by_hand()) {  // the block by hand is over, the program is still held
                c.resume.by_hand = Resume::ByHand::Done;
                c.hand.block_is_over();
                c.stand(ChannelState::Held, StopReason::Held);
                return true;
            }
            c.restart.stage = RestartState::None;  // its block did not come
            if (!c.production.lap_ended) end_lap(c);
            c.hand.block_is_over();
            strobe_program_end(c, reason);
            c.stand(ChannelState::Ended, reason);
            c.core.event(KernelEventKind::CycleEnded, c.number, r.code, c.production.times.cycle_s,
                         r.line);
            return true;
    }
}

void interrupts_record(Channel& c, const PathRecord& r) noexcept {
    c.interrupts.bits = r.mask;
    c.interrupts.inputs =
        r.value > 0 && r.value < 0x1p32 ? static_cast<std::uint32_t>(r.value) : 0u;
    c.interrupts.on = r.code != 0;
    // the channel is in the interrupt program already
    c.interrupts.due = c.interrupts.due && c.interrupts.ahead != kNoRecord;
    c.interrupts.seen = c.interrupts.signals_now(c.core.signals, c.number);
}

void message_record(Channel& c, const PathRecord& r, double offset_s) noexcept {
    KernelEvent* const event =
        c.core.log.claim(KernelEventKind::Message, c.number, c.core.tick, offset_s);
    if (!event) return;
    event->note = r.note;
    event->line = r.line;
    event->code = -1;  // no row of the catalogue
    copy_text(event->text, text_of(r));
    c.core.log.put();
}

void marker_record(Channel& c, const PathRecord& r) noexcept {
    if (c.restart.searches())
        c.core.waits.mark_in_search(c.index, r.code, r.value != 0.0);
    else
        c.core.waits.mark(c.index, r.code, r.value != 0.0);
}

void flying_wait(Channel& c, const PathRecord& r) noexcept {
    c.core.waits.arrive(c.index, r.code, r.mask, c.program.run, wait_phase(c));
    c.standing.wait.passing = true;
}

}  // namespace polyturn::kernel
