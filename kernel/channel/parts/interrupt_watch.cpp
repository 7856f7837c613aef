#include "kernel/channel/parts/interrupt_watch.hpp"

#include "ipc/image/interrupt_inputs.hpp"
#include "kernel/tick/signals.hpp"

namespace polyturn::kernel {

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

}  // namespace polyturn::kernel
