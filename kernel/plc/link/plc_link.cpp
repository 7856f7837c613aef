#include "kernel/plc/link/plc_link.hpp"

#include <algorithm>
#include <cstring>

namespace polyturn::kernel {

PlcLink::Take PlcLink::take_outputs() noexcept {
    // P1: the segment is published
    const PlcSegment* plc = core_.plc_segment.load(std::memory_order_acquire);
    if (!plc || dead_ || sent_ == 0 || !due()) return Take::Nothing;
    // A stopped process may or may not have answered before: that must not decide anything.
    // P1: the outputs of that cycle are published
    if (stopped_ || plc->cycle.load(std::memory_order_acquire) < sent_ ||
        !plc->outputs.read(outputs_)) {
        // In virtual time it was waited for: it cannot answer. In real time the computer may have
        // been busy: some cycles.
        return core_.virtual_time || ++late_in_a_row_ >= core_.config.late_max_ticks
                   ? Take::Late
                   : Take::Nothing;
    }
    late_in_a_row_ = 0;
    core_.signals.take_plc(outputs_);
    if (outputs_.signal != last_outputs_.signal || outputs_.output != last_outputs_.output) {
        last_outputs_ = outputs_;
        touched();
    }
    core_.signals.fill(core_.image.plc_seen.draft());
    core_.image.plc_seen.draft().cycle = sent_;
    core_.image.plc_seen.draft().output = outputs_.output;
    core_.image.plc_seen.publish();
    return Take::Taken;
}

void PlcLink::started() noexcept {
    dead_ = false;
    sent_ = 0;
    // goes on counting: an answer to what its predecessor was asked is none
    fast_taken_ = fast_sent_;
    fast_late_ = 0;
    // P1: fast_plan was written before the segment was published
    plan_ = core_.plc_segment.load(std::memory_order_acquire)->fast_plan;
    // Its process maps it writable: nothing of it is believed.
    plan_.reads = std::min<std::uint32_t>(plan_.reads, kFastSignals);
    plan_.writes = std::min<std::uint32_t>(plan_.writes, kFastSignals);
    if (std::any_of(plan_.write.begin(), plan_.write.begin() + plan_.writes,
                    [](std::uint32_t slot) { return slot >= kPlcSignals; }))
        plan_.writes = 0;
    core_.signals.give_to_fast_task({plan_.write.data(), plan_.writes});
}

PlcLink::Take PlcLink::take_fast() noexcept {
    // P1: the segment, and the outputs that the count announces, are published
    const PlcSegment* plc = core_.plc_segment.load(std::memory_order_acquire);
    if (!plc || dead_ || stopped_ || plan_.writes == 0 || fast_sent_ == 0) return Take::Nothing;
    const std::uint64_t count = plc->fast_count.load(std::memory_order_acquire);
    if (count <= fast_taken_ || count > fast_sent_ || !plc->fast.read(fast_))
        return ++fast_late_ > core_.config.plc_cycle_ticks ? Take::Late : Take::Nothing;
    fast_late_ = 0;
    fast_taken_ = count;
    for (std::uint32_t i = 0; i < plan_.writes; ++i) {
        if (core_.signals.plc(core_.signals.fast_slot(i)) != fast_.value[i]) touched();
        core_.signals.take_fast(i, fast_.value[i]);
    }
    return Take::Taken;
}

// The cycle's inputs first: one that sees those of the fast task of a tick sees them too, so that
// the order in which the PLC works them off is always the same (Int0, then its cycle).
void PlcLink::send_inputs() noexcept {
    const bool cycle = send_cycle(), fast = send_fast();
    if (cycle || fast) core_.image.plc_bell.ring();
}

bool PlcLink::send_fast() noexcept {
    if (plan_.writes == 0 || !present()) return false;
    PlcFastInputs& inputs = core_.image.plc_fast.draft();
    inputs.count = ++fast_sent_;
    inputs.tick = core_.tick;
    for (std::uint32_t i = 0; i < plan_.reads; ++i) {
        const std::uint32_t what = plan_.read[i];
        inputs.value[i] = what < kNcSignals ? core_.signals.nc(what)
                          : what >= kFastInput && what - kFastInput < kInputs
                              ? core_.signals.input(what - kFastInput)
                              : 0;
    }
    core_.image.plc_fast.publish();
    return true;
}

bool PlcLink::send_cycle() noexcept {
    if (!due() || !present()) return false;
    PlcInputs& inputs = core_.image.plc_inputs.draft();
    core_.signals.fill(inputs);
    inputs.cycle = ++sent_;
    inputs.tick = core_.tick;
    if (inputs.signal != last_inputs_.signal || inputs.input != last_inputs_.input) {
        last_inputs_ = inputs;
        touched();
    }
    core_.image.plc_inputs.publish();
    return true;
}

}  // namespace polyturn::kernel
