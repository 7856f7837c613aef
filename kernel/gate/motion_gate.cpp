#include "kernel/gate/motion_gate.hpp"

#include "kernel/gate/start_conditions.hpp"

namespace polyturn::kernel {

std::uint8_t MotionGate::missing(const Core& core, Door door, std::uint32_t channel) noexcept {
    std::uint8_t out = 0;
    if (!core.on()) out |= kMachineOn;
    if (core.all_stop) out |= kNoStop;
    if (channel >= 1 && channel <= kMaxChannels && core.door_open(channel)) out |= kDoorClosed;
    return static_cast<std::uint8_t>((out | kStartRows) & row_of(door).grounds);
}

std::optional<Permit> MotionGate::ask(const Core& core, Door door, std::uint32_t channel) noexcept {
    if (missing(core, door, channel) != 0) return std::nullopt;
    return Permit(door);
}

std::optional<StartPermit> MotionGate::ask(const Core& core, Door door,
                                           const StartView& view) noexcept {
    if (!(row_of(door).grounds & kStartRows) || rows_missing_for_start(core, view) != 0)
        return std::nullopt;
    return StartPermit(door);
}

}  // namespace polyturn::kernel
