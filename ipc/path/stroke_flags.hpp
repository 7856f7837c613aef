// What the PLC selects and switches off of the stroke ranges (part 1, 11), read from its signals by
// whoever has them: the channel, the kernel, the screens. A header of its own, for stroke_zones.hpp
// knows no signals.
#pragma once
#include "ipc/path/stroke_zones.hpp"
#include "polyturn/image_structs.hpp"

namespace polyturn {

// on(slot): a signal of the PLC is on. Channel and axis from 1.
template <class On>
[[nodiscard]] StrokeFlags stroke_flags(On&& on, unsigned channel, unsigned axis) noexcept {
    namespace s = signals;
    return {on(s::cp_limsel(channel)),  on(s::ap_limselp(axis)),    on(s::ap_limseln(axis)),
            on(s::cp_lim1dis(channel)), on(s::cp_lim2dis(channel)), on(s::cp_lim3dis(channel))};
}

}  // namespace polyturn
