// The interrupt macro's signal: it is watched between M96 and M97, in path order, and stops the
// path at once or at the end of the running block. What was pushed beyond is void; the channel goes
// on from there with the interrupt program.
#include <algorithm>
#include <utility>

#include "ipc/image/interrupt_inputs.hpp"
#include "ipc/image/positioning_step.hpp"
#include "kernel/channel/channel_runner.hpp"

namespace polyturn::kernel {
namespace {

// Of a record that acts ahead of its position: what comes before it, the rest of the running block,
// has still to begin, and its events are still valid.
void hand_over_event(Core& core, unsigned channel, const PathRecord& r) noexcept {
    if (r.note == 0) return;
    KernelEvent* event = core.log.claim(KernelEventKind::RecordBegin, channel, core.tick, 0);
    if (!event) return;
    event->note = r.note;
    event->line = r.line;
    event->code = kStepHandedOver;
    core.log.put();
}

}  // namespace

std::uint32_t InterruptWatch::signals_now(const Signals& signals,
                                          std::uint32_t channel) const noexcept {
    if (!inputs)
        return signals.plc((bits & kInterruptByMint ? polyturn::signals::mint
                                                    : polyturn::signals::uint)(channel)) != 0;
    std::uint32_t came = 0;
    const auto look = [&](unsigned n, PlcSignal signal) {
        if (signals.plc(signal(channel))) came |= 1u << n;
    };
    look(0, polyturn::signals::int1);
    look(1, polyturn::signals::int2);
    look(2, polyturn::signals::int3);
    look(3, polyturn::signals::int4);
    if (bits & kInterruptByWires) {
        came |= static_cast<std::uint32_t>(signals.plc(polyturn::signals::cp_uin(channel)));
        for (unsigned n = 0; n < kInterruptInputs; ++n)
            if (signals.input(n)) came |= 1u << n;
    }
    return came & inputs;
}

void ChannelRunner::watch_interrupt() noexcept {
    (void)obey_ahead();
    if (!interrupts_.on) return;
    const std::uint32_t signals_now = interrupts_.signals_now(core_.signals, number_);
    // one that stays on hides no other
    const std::uint32_t came =
        interrupts_.bits & kInterruptByLevel ? signals_now : signals_now & ~interrupts_.seen;
    interrupts_.seen = signals_now;
    if (!came || !program_.is(ChannelState::Running)) return;
    if (!interrupts_.due)
        interrupts_.input =
            interrupts_.inputs ? static_cast<unsigned>(__builtin_ctz(came)) + 1u : 0u;
    const bool first = !std::exchange(interrupts_.due, true);
    if (first && (interrupts_.bits & kInterruptAtBlockEnd) && !interrupts_.inputs &&
        !(interrupts_.bits & kInterruptByMint))
        announce_interrupt();
}

// Macro statements of the interrupt program act at once though the block is driven to its end
// (fanuc_lathe 6.14): the channel is notified as soon as it is known what follows the block.
void ChannelRunner::announce_interrupt() noexcept {
    if (path_.cursor >= path_.visible_end || outbox_.full()) return;
    const std::uint64_t running = record(path_.cursor).serial;
    // nothing runs
    if (!standing_.begun &&
        !(!path_.step.over && path_.step.s > 0 && path_.step.record == path_.cursor) &&
        running != shown_.ended_serial)
        return;
    std::uint64_t behind = path_.cursor;
    while (behind < path_.visible_end && record(behind).serial == running) ++behind;
    if (behind == path_.visible_end || record(behind).epoch != path_.epoch) return;
    interrupts_.ahead = path_.inbox.head(path_.cursor);
    tell(ChannelEventKind::Interrupt, kInterruptAhead, static_cast<double>(record(behind).serial));
    interrupts_.ahead_asked = outbox_.newest();
}

// What the channel has done ahead acts now. True: nothing of it is left, and nothing more comes.
bool ChannelRunner::obey_ahead() noexcept {
    if (interrupts_.ahead == kNoRecord) return true;
    // P1: what was pushed ahead is visible
    if (interrupts_.ahead_asked &&
        process_.segment->answered.load(std::memory_order_acquire) < interrupts_.ahead_asked)
        return process_.dead();
    interrupts_.ahead_asked = 0;
    const std::uint64_t head = path_.inbox.head(path_.cursor);
    if (interrupts_.ahead < head) {
        path_.inbox.look(path_.cursor);
        path_.inbox.take(path_.cursor, head, path_.epoch, core_, index_);
    }
    constexpr int kMostInATick = 32;
    for (int k = 0; interrupts_.ahead < head; ++interrupts_.ahead, ++k) {
        if (k == kMostInATick) return false;
        // not judged yet, or never
        if (interrupts_.ahead >= path_.inbox.taken())
            return path_.inbox.refusal().field ||
                   path_.inbox.epoch_of(interrupts_.ahead) != path_.epoch;
        const PathRecord& r = record(interrupts_.ahead);
        if (!(r.flags & kAtOnce) || r.epoch != path_.epoch) continue;
        if (writes_store(r) && !core_.store.has_room()) return false;
        hand_over_event(core_, number_, r);
        report(KernelEventKind::RecordBegin, r, 0);
        execute_instant(r, 0);
        report(KernelEventKind::RecordEnd, r, 0);
    }
    return true;
}

// The path rests: is this a place where the program may break off?
bool ChannelRunner::is_stopped_for_interrupt() noexcept {
    if (!program_.is(ChannelState::Running) || program_.holds() || program_.interrupted() ||
        process_.dead() || process_.frozen() || standing_.wait.owed || !obey_ahead())
        return false;
    const bool dwells = standing_.phase == Phase::Dwell;
    if (standing_.phase != Phase::None && !dwells)
        return false;  // a function or a wait is finished first
    if (!(interrupts_.bits & kInterruptAtBlockEnd)) return true;
    if (dwells || standing_.begun) return false;
    // braked within a block for another reason
    if (!path_.step.over && path_.step.s > 0) return false;
    if (path_.cursor >= path_.visible_end) return true;
    if (record(path_.cursor).serial != shown_.ended_serial) return true;
    // a further move of the same block, as in a cycle
    path_.planner->step_block();
    return false;
}

void ChannelRunner::break_off() noexcept {
    const bool any = path_.cursor < path_.visible_end;
    bool within = false;
    std::uint64_t serial = 0;
    if (any) {
        const PathRecord& r = record(path_.cursor);
        serial = r.serial;
        within = standing_.begun ||
                 (!path_.step.over && path_.step.s > 0 && path_.step.record == path_.cursor) ||
                 serial == shown_.ended_serial;
        if (standing_.begun || (!path_.step.over && path_.step.s > 0 && is_motion(r)))
            report(KernelEventKind::RecordEnd, r, 0);
    }
    if (standing_.phase == Phase::Dwell) standing_.dwell.broken = standing_.dwell.left;
    discard();
    interrupts_.ahead = kNoRecord;
    // none is accepted until the interrupt program is over
    interrupts_.on = interrupts_.due = false;
    tell(ChannelEventKind::Interrupt, (within ? 1u : 0u) | interrupts_.input << 1,
         static_cast<double>(serial));
}

}  // namespace polyturn::kernel
