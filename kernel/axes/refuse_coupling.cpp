// A request to couple axes that cannot be granted (couplings.hpp): the channel of the axis gets the
// alarm, and the movers of both axes stop, so that everything is at rest and unchanged.
#include "kernel/tick/machine.hpp"

namespace polyturn::kernel {

void Machine::refuse_coupling() noexcept {
    const Couplings::Refusal& refused = couplings_.refusal();
    if (!refused.axis) return;
    ChannelSet stops = 0;
    if (const std::uint32_t l = core_.config.axes[refused.axis - 1].channel)
        stops |= ChannelSet{1} << (l - 1);
    for (const std::uint32_t number : {refused.axis, refused.other}) {
        const AxisUnit& axis = core_.axes[number - 1];
        if (axis.exists() && axis.owner && axis.target() != axis.command())
            stops |= ChannelSet{1} << (axis.owner - 1);
        if (jogs_[number - 1].active()) {
            jogs_[number - 1].stop();
            handwheel_left_[number - 1] = 0;
        }
        if (homing_[number - 1].active()) homing_[number - 1].stop();
        stop_carrier(number - 1);
    }
    ChannelSet told = 0;
    for (std::uint32_t l = 0; l < kMaxChannels; ++l)
        if ((stops >> l & 1u) && channels_[l]->program_runs()) {
            channels_[l]->fault(refused.number, refused.detail.view(), refused.value);
            told |= ChannelSet{1} << l;
        }
    couplings_.refusal_shown(told);
    if (!told)
        core_.alarm(refused.number, core_.config.axes[refused.axis - 1].channel,
                    refused.detail.view(), refused.value);
}

}  // namespace polyturn::kernel
