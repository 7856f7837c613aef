// The tool setter on the machine (N3012, N3013): while a tool is measured (CP_TMEAS) an axis that its key jogs towards the setter,
// with N0319, stops by itself when the tool touches it. Where that was stays to be read: AxisStatus::skip, ChannelStatus::touched.
// Away from the setter the tool can always be moved; further into it no key moves the axis while they touch.
#include "kernel/cyclic/machine.hpp"
#include "polyturn/parameter_handles.hpp"

namespace polyturn::kernel {

void Machine::look_at_setters() noexcept {
    for (std::uint32_t l = 0; l < kMaxChannels; ++l) {
        Setter& setter = setters_[l];
        const bool measuring = core_.config.channels[l].exists && core_.signals.plc(signals::cp_tmeas(l + 1)) != 0;
        if (!measuring && !setter.on[0] && !setter.on[1]) continue;
        for (std::uint32_t s = 0; s < 2; ++s) {
            const auto input = static_cast<std::size_t>(s ? params::get(core_.table, params::n3013_sensor_input_of_tool_setter_s2, l + 1) : params::get(core_.table, params::n3012_sensor_input_of_tool_setter_s1, l + 1));
            const bool on = measuring && input > 0 && core_.signals.input(input), came = on && !setter.on[s];
            setter.on[s] = on;
            if (!came) continue;
            for (std::uint32_t a = 0; a < core_.config.axis_count; ++a) {
                if (!jogs_[a].active() || jog_address_[a] == 0 || core_.config.axes[jog_address_[a] - 1].channel != l + 1) continue;
                // The drives latch their encoders the moment the signal comes.
                core_.axes[a].skip = core_.sensors.position(core_.axes[a], a, core_.sensors.risen_part(input, core_.tick));
                setter.touched = static_cast<std::int32_t>(a + 1) * (jogs_[a].sign() < 0 ? -1 : 1);
                setter.at = s + 1;
                jogs_[a].stop();
            }
        }
    }
}

bool Machine::touches_setter(std::uint32_t l, std::uint32_t a, double sign) const noexcept {
    const Setter& setter = setters_[l - 1];
    return (setter.on[0] || setter.on[1]) && setter.touched == static_cast<std::int32_t>(a + 1) * (sign < 0 ? -1 : 1);
}

}  // namespace polyturn::kernel
