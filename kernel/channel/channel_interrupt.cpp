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

// The watched signals that are on: bit 0 the only one, or bit n input n + 1.
std::uint32_t ChannelRunner::interrupt_signals() noexcept {
    if (!interrupt_inputs_)
        return core_.signals.plc(
                   (interrupt_bits_ & kInterruptByMint ? signals::mint : signals::uint)(number_)) !=
               0;
    std::uint32_t on = 0;
    const auto look = [&](unsigned n, PlcSignal signal) {
        if (core_.signals.plc(signal(number_))) on |= 1u << n;
    };
    look(0, signals::int1);
    look(1, signals::int2);
    look(2, signals::int3);
    look(3, signals::int4);
    if (interrupt_bits_ & kInterruptByWires) {
        on |= static_cast<std::uint32_t>(core_.signals.plc(signals::cp_uin(number_)));
        for (unsigned n = 0; n < kInterruptInputs; ++n)
            if (core_.signals.input(n)) on |= 1u << n;
    }
    return on & interrupt_inputs_;
}

void ChannelRunner::watch_interrupt() noexcept {
    (void)obey_ahead();
    if (!interrupts_on_) return;
    const std::uint32_t signals_now = interrupt_signals();
    // one that stays on hides no other
    const std::uint32_t came =
        interrupt_bits_ & kInterruptByLevel ? signals_now : signals_now & ~interrupt_seen_;
    interrupt_seen_ = signals_now;
    if (!came || state_ != ChannelState::Running) return;
    if (!interrupt_due_)
        interrupt_input_ = interrupt_inputs_ ? static_cast<unsigned>(__builtin_ctz(came)) + 1u : 0u;
    const bool first = !std::exchange(interrupt_due_, true);
    if (first && (interrupt_bits_ & kInterruptAtBlockEnd) && !interrupt_inputs_ &&
        !(interrupt_bits_ & kInterruptByMint))
        announce_interrupt();
}

// Macro statements of the interrupt program act at once though the block is driven to its end
// (fanuc_lathe 6.14): the channel is notified as soon as it is known what follows the block.
void ChannelRunner::announce_interrupt() noexcept {
    if (cursor_ >= visible_end_ || outbox_count_ == outbox_.size()) return;
    const std::uint64_t running = record(cursor_).serial;
    // nothing runs
    if (!begun_ && !(!step_.over && step_.s > 0 && step_.record == cursor_) &&
        running != last_serial_)
        return;
    std::uint64_t behind = cursor_;
    while (behind < visible_end_ && record(behind).serial == running) ++behind;
    if (behind == visible_end_ || record(behind).epoch != epoch_) return;
    ahead_ = inbox_.head(cursor_);
    tell(ChannelEventKind::Interrupt, kInterruptAhead, static_cast<double>(record(behind).serial));
    ahead_asked_ = events_sent_ + outbox_count_;
}

// What the channel has done ahead acts now. True: nothing of it is left, and nothing more comes.
bool ChannelRunner::obey_ahead() noexcept {
    if (ahead_ == kNoRecord) return true;
    // P1: what was pushed ahead is visible
    if (ahead_asked_ && segment_->answered.load(std::memory_order_acquire) < ahead_asked_)
        return dead_;
    ahead_asked_ = 0;
    const std::uint64_t head = inbox_.head(cursor_);
    if (ahead_ < head) {
        inbox_.look(cursor_);
        inbox_.take(cursor_, head, epoch_, core_, index_);
    }
    constexpr int kMostInATick = 32;
    for (int k = 0; ahead_ < head; ++ahead_, ++k) {
        if (k == kMostInATick) return false;
        // not judged yet, or never
        if (ahead_ >= inbox_.taken())
            return inbox_.refusal().field || inbox_.epoch_of(ahead_) != epoch_;
        const PathRecord& r = record(ahead_);
        if (!(r.flags & kAtOnce) || r.epoch != epoch_) continue;
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
    if (state_ != ChannelState::Running || hold_ || interrupted_ || dead_ || stopped_ ||
        owes_rendezvous_ || !obey_ahead())
        return false;
    const bool dwells = phase_ == Phase::Dwell;
    if (phase_ != Phase::None && !dwells) return false;  // a function or a wait is finished first
    if (!(interrupt_bits_ & kInterruptAtBlockEnd)) return true;
    if (dwells || begun_) return false;
    // braked within a block for another reason
    if (!step_.over && step_.s > 0) return false;
    if (cursor_ >= visible_end_) return true;
    if (record(cursor_).serial != last_serial_) return true;
    // a further move of the same block, as in a cycle
    planner_->step_block();
    return false;
}

void ChannelRunner::break_off() noexcept {
    const bool any = cursor_ < visible_end_;
    bool within = false;
    std::uint64_t serial = 0;
    if (any) {
        const PathRecord& r = record(cursor_);
        serial = r.serial;
        within = begun_ || (!step_.over && step_.s > 0 && step_.record == cursor_) ||
                 serial == last_serial_;
        if (begun_ || (!step_.over && step_.s > 0 && is_motion(r)))
            report(KernelEventKind::RecordEnd, r, 0);
    }
    if (phase_ == Phase::Dwell) dwell_broken_ = dwell_left_;
    discard();
    ahead_ = kNoRecord;
    // none is accepted until the interrupt program is over
    interrupts_on_ = interrupt_due_ = false;
    tell(ChannelEventKind::Interrupt, (within ? 1u : 0u) | interrupt_input_ << 1,
         static_cast<double>(serial));
}

}  // namespace polyturn::kernel
