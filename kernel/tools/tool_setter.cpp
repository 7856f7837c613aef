// The setters on the machine: the tool setter (N3012, N3013), which a tool touches, and the
// workpiece setter (N3014, N3015), a probe in the turret that touches the part. While something is
// measured (CP_TMEAS) an axis that its key jogs, with N0319, stops by itself when one of them
// answers; which input it was says what is measured. Where that was stays to be read:
// AxisStatus::skip, ChannelStatus::touched. Away from it the axis can always be moved; further into
// it no key moves it while they touch.
#include "kernel/tick/machine.hpp"
#include "polyturn/parameter_handles.hpp"

namespace polyturn::kernel {
namespace {

// In the order of ChannelStatus::touched_at.
std::array<std::size_t, 4> inputs_of(const params::Table& t, std::uint32_t l) noexcept {
    return {
        static_cast<std::size_t>(params::get(t, params::n3012_sensor_input_of_tool_setter_s1, l)),
        static_cast<std::size_t>(params::get(t, params::n3013_sensor_input_of_tool_setter_s2, l)),
        static_cast<std::size_t>(
            params::get(t, params::n3014_sensor_input_of_workpiece_setter_s1, l)),
        static_cast<std::size_t>(
            params::get(t, params::n3015_sensor_input_of_workpiece_setter_s2, l))};
}

}  // namespace

void Machine::look_at_setters() noexcept {
    for (std::uint32_t l = 0; l < kMaxChannels; ++l) {
        Setter& setter = setters_[l];
        const bool measuring =
            core_.config.channels[l].exists && core_.signals.plc(signals::cp_tmeas(l + 1)) != 0;
        if (!measuring && !setter.touches()) continue;
        const std::array<std::size_t, 4> inputs = inputs_of(core_.table, l + 1);
        for (std::uint32_t s = 0; s < setter.on.size(); ++s) {
            const std::size_t input = inputs[s];
            const bool on = measuring && input > 0 && core_.signals.input(input),
                       came = on && !setter.on[s];
            setter.on[s] = on;
            if (!came) continue;
            for (std::uint32_t a = 0; a < core_.config.axis_count; ++a) {
                if (!jogs_[a].active() || jog_address_[a] == 0 ||
                    core_.config.axes[jog_address_[a] - 1].channel != l + 1)
                    continue;
                // The drives latch their encoders the moment the signal comes: those of the whole
                // channel, for where the tip is at right angles follows from two axes where the X
                // slide is inclined.
                for (std::uint32_t b = 0; b < core_.config.axis_count; ++b)
                    if (core_.config.axes[b].channel == l + 1)
                        core_.axes[b].skip = core_.sensors.position(
                            core_.axes[b], b, core_.sensors.risen_part(input, core_.tick));
                setter.touched = static_cast<std::int32_t>(a + 1) * (jogs_[a].sign() < 0 ? -1 : 1);
                setter.at = s + 1;
                jogs_[a].stop();
            }
        }
    }
}

bool Machine::touches_setter(std::uint32_t l, std::uint32_t a, double sign) const noexcept {
    const Setter& setter = setters_[l - 1];
    return setter.touches() &&
           setter.touched == static_cast<std::int32_t>(a + 1) * (sign < 0 ? -1 : 1);
}

}  // namespace polyturn::kernel
