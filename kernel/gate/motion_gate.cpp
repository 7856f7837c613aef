#include "kernel/gate/motion_gate.hpp"

#include "kernel/tick/core.hpp"

namespace polyturn::kernel {

std::uint8_t MotionGate::missing(const Core& core, Door door, std::uint32_t channel) noexcept {
    std::uint8_t out = 0;
    if (!core.on()) out |= kMachineOn;
    if (core.all_stop) out |= kNoStop;
    if (channel >= 1 && channel <= kMaxChannels && core.door_open(channel)) out |= kDoorClosed;
    return out & row_of(door).grounds;
}

std::optional<Permit> MotionGate::ask(const Core& core, Door door, std::uint32_t channel) noexcept {
    if (missing(core, door, channel) != 0) return std::nullopt;
    return Permit(door);
}

}  // namespace polyturn::kernel
