// The kernel's side of the PLC cycle: inputs n go out, the answer to them acts exactly one PLC
// cycle later, however soon it came. So the machine does the same whatever the load of the
// computer.
//
//   tick    0        10       20       30        PT_PLC_CYCLE = 10 ticks
//           inputs 1 inputs 2 inputs 3
//                    outputs 1 act    outputs 2 act ...
//
// A PLC may have a fast task besides (Int0): it is asked at the end of every tick, with the few
// values of its plan, and what it answers acts at the next one. In real time an answer that comes
// later acts when it is there.
#pragma once
#include "kernel/tick/core.hpp"

namespace polyturn::kernel {

class PlcLink {
public:
    explicit PlcLink(Core& core) : core_(core) {}
    // At this tick outputs act and new inputs go out.
    bool due() const noexcept { return core_.tick % core_.config.plc_cycle_ticks == 0; }
    // The answer that acts now has come (virtual time waits for it).
    bool answered() const noexcept {
        // P1: the segment, and the outputs that the counts announce
        const PlcSegment* plc = core_.plc_segment.load(std::memory_order_acquire);
        if (!plc || dead_ || stopped_) return true;
        if (plan_.writes != 0 && plc->fast_count.load(std::memory_order_acquire) < fast_sent_)
            return false;
        // P1: the outputs of that cycle are published
        return !due() || sent_ == 0 || plc->cycle.load(std::memory_order_acquire) >= sent_;
    }
    // Virtual time waits for an answer at this tick.
    bool asked() const noexcept { return present() && (due() || plan_.writes != 0); }
    bool present() const noexcept {
        // P3: only whether there is one (the order is stronger than needed)
        return core_.plc_segment.load(std::memory_order_acquire) != nullptr && !dead_;
    }

    enum class Take : std::uint8_t { Nothing, Taken, Late };
    Take take_outputs() noexcept;
    Take take_fast() noexcept;    // Late: no answer of the fast task for a whole PLC cycle
    void send_inputs() noexcept;  // at the end of a tick; rings

    void died() noexcept { dead_ = true; }
    void started() noexcept;
    void stopped(bool now) noexcept { stopped_ = now; }
    bool dead() const noexcept { return dead_; }
    // For how long inputs and outputs have been the same, in ticks.
    std::int64_t quiet_ticks() const noexcept { return core_.tick - changed_; }
    void touched() noexcept { changed_ = core_.tick; }

private:
    bool send_fast() noexcept;
    bool send_cycle() noexcept;

    Core& core_;
    std::uint64_t sent_ = 0;  // cycle of the newest inputs
    PlcFastPlan plan_{};      // of the fast task, as its segment has it
    // sets of its inputs, counted; 0: none was sent
    std::uint64_t fast_sent_ = 0, fast_taken_ = 0;
    std::int64_t fast_late_ = 0;  // ticks without a new answer
    PlcFastOutputs fast_{};
    std::int64_t changed_ = 0;
    bool dead_ = false, stopped_ = false;
    std::int64_t late_in_a_row_ = 0;
    PlcOutputs outputs_{}, last_outputs_{};
    PlcInputs last_inputs_{};
};

}  // namespace polyturn::kernel
