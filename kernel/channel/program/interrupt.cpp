#include "kernel/channel/program/interrupt.hpp"

#include <utility>

#include "ipc/image/interrupt_inputs.hpp"
#include "ipc/image/positioning_step.hpp"
#include "kernel/channel/program/hold.hpp"
#include "kernel/records/record_executor.hpp"
#include "kernel/records/record_kinds.hpp"

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

// Macro statements of the interrupt program act at once though the block is driven to its end
// (fanuc_lathe 6.14): the channel is notified as soon as it is known what follows the block.
void announce_interrupt(Channel& c) noexcept {
    if (c.path.cursor >= c.path.visible_end || c.outbox.full()) return;
    const std::uint64_t running = c.path.here().serial;
    // nothing runs
    if (!c.standing.begun && !c.path.within() && running != c.shown.ended_serial) return;
    std::uint64_t behind = c.path.cursor;
    while (behind < c.path.visible_end && c.record(behind).serial == running) ++behind;
    if (behind == c.path.visible_end || c.record(behind).epoch != c.path.epoch) return;
    c.interrupts.ahead = c.path.inbox.head(c.path.cursor);
    c.tell(ChannelEventKind::Interrupt, kInterruptAhead,
           static_cast<double>(c.record(behind).serial));
    c.interrupts.ahead_asked = c.outbox.newest();
}

}  // namespace

void watch_interrupt(Channel& c) noexcept {
    (void)obey_ahead(c);
    if (!c.interrupts.on) return;
    const std::uint32_t signals_now = c.interrupts.signals_now(c.core.signals, c.number);
    // one that stays on hides no other
    const std::uint32_t came =
        c.interrupts.bits & kInterruptByLevel ? signals_now : signals_now & ~c.interrupts.seen;
    c.interrupts.seen = signals_now;
    if (!came || !c.program.is(ChannelState::Running)) return;
    if (!c.interrupts.due)
        c.interrupts.input =
            c.interrupts.inputs ? static_cast<unsigned>(__builtin_ctz(came)) + 1u : 0u;
    const bool first = !std::exchange(c.interrupts.due, true);
    if (first && (c.interrupts.bits & kInterruptAtBlockEnd) && !c.interrupts.inputs &&
        !(c.interrupts.bits & kInterruptByMint))
        announce_interrupt(c);
}

bool obey_ahead(Channel& c) noexcept {
    if (c.interrupts.ahead == kNoRecord) return true;
    // P1: what was pushed ahead is visible
    if (c.interrupts.ahead_asked &&
        c.process.segment->answered.load(std::memory_order_acquire) < c.interrupts.ahead_asked)
        return c.process.dead();
    c.interrupts.ahead_asked = 0;
    const std::uint64_t head = c.path.inbox.head(c.path.cursor);
    if (c.interrupts.ahead < head) {
        c.path.inbox.look(c.path.cursor);
        c.path.inbox.take(c.path.cursor, head, c.path.epoch, c.core, c.index);
    }
    constexpr int kMostInATick = 32;
    for (int k = 0; c.interrupts.ahead < head; ++c.interrupts.ahead, ++k) {
        if (k == kMostInATick) return false;
        // not judged yet, or never
        if (c.interrupts.ahead >= c.path.inbox.taken())
            return c.path.inbox.refusal().field ||
                   c.path.inbox.epoch_of(c.interrupts.ahead) != c.path.epoch;
        const PathRecord& r = c.record(c.interrupts.ahead);
        if (!(r.flags & kAtOnce) || r.epoch != c.path.epoch) continue;
        if (writes_store(r) && !c.core.store.has_room()) return false;
        hand_over_event(c.core, c.number, r);
        c.report(KernelEventKind::RecordBegin, r, 0);
        execute_instant(c, r, 0);
        c.report(KernelEventKind::RecordEnd, r, 0);
    }
    return true;
}

bool is_stopped_for_interrupt(Channel& c) noexcept {
    if (!c.program.is(ChannelState::Running) || c.program.holds() || c.program.interrupted() ||
        c.process.dead() || c.process.frozen() || c.standing.wait.owed || !obey_ahead(c))
        return false;
    const bool dwells = c.standing.phase == RecordPhase::Dwell;
    if (c.standing.phase != RecordPhase::None && !dwells)
        return false;  // a function or a wait is finished first
    if (!(c.interrupts.bits & kInterruptAtBlockEnd)) return true;
    if (dwells || c.standing.begun) return false;
    // braked within a block for another reason
    if (!c.path.step.over && c.path.step.s > 0) return false;
    if (c.path.cursor >= c.path.visible_end) return true;
    if (c.path.here().serial != c.shown.ended_serial) return true;
    // a further move of the same block, as in a cycle
    c.path.planner->step_block();
    return false;
}

void break_off(Channel& c) noexcept {
    const bool any = c.path.cursor < c.path.visible_end;
    bool within = false;
    std::uint64_t serial = 0;
    if (any) {
        const PathRecord& r = c.path.here();
        serial = r.serial;
        within = c.standing.begun || c.path.within() || serial == c.shown.ended_serial;
        if (c.standing.begun || (!c.path.step.over && c.path.step.s > 0 && is_motion(r)))
            c.report(KernelEventKind::RecordEnd, r, 0);
    }
    if (c.standing.phase == RecordPhase::Dwell) c.standing.dwell.broken = c.standing.dwell.left;
    discard_ahead(c);
    c.interrupts.ahead = kNoRecord;
    // none is accepted until the interrupt program is over
    c.interrupts.on = c.interrupts.due = false;
    c.tell(ChannelEventKind::Interrupt, (within ? 1u : 0u) | c.interrupts.input << 1,
           static_cast<double>(serial));
}

}  // namespace polyturn::kernel
