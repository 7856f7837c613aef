#include "kernel/cyclic/plc_link.hpp"

#include <cstring>

namespace polyturn::kernel {

PlcLink::Take PlcLink::take_outputs() noexcept {
    const PlcSegment* plc = core_.plc_segment.load(std::memory_order_acquire);
    if (!plc || dead_ || sent_ == 0 || !due()) return Take::Nothing;
    // A stopped process may or may not have answered before: that must not decide anything.
    if (stopped_ || plc->cycle.load(std::memory_order_acquire) < sent_ || !plc->outputs.read(outputs_)) {
        // In virtual time it was waited for: it cannot answer. In real time the computer may have been busy: some cycles.
        return core_.virtual_time || ++late_in_a_row_ >= core_.config.late_max_ticks ? Take::Late : Take::Nothing;
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

void PlcLink::send_inputs() noexcept {
    if (!due() || !present()) return;
    PlcInputs& inputs = core_.image.plc_inputs.draft();
    core_.signals.fill(inputs);
    inputs.cycle = ++sent_;
    inputs.tick = core_.tick;
    if (inputs.signal != last_inputs_.signal || inputs.input != last_inputs_.input) {
        last_inputs_ = inputs;
        touched();
    }
    core_.image.plc_inputs.publish();
    core_.image.plc_bell.ring();
}

}  // namespace polyturn::kernel
