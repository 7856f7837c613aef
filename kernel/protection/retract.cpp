// Retract by a defined distance: when the process of a partner has died (PT_PARTNER_DEATH 3), or
// when power fails (PLC_POWER). The path brakes along itself first; then all axes of the channel
// that have a distance PT_RETRACT go it together, while the spindles still turn. After a power
// failure everything stops then.
#include <cmath>

#include "kernel/tick/machine.hpp"

namespace polyturn::kernel {

void Machine::retract_work(std::uint32_t l) noexcept {
    ChannelRunner& runner = *channels_[l - 1];
    if (retracts_[l - 1] != Retract::None ||
        (!runner.program_runs() && runner.state() != ChannelState::Dead))
        return;
    runner.interrupt();
    retracts_[l - 1] = Retract::Stopping;
}

void Machine::watch_power() noexcept {
    const bool out = core_.signals.plc(signals::plc_power()) != 0;
    if (out && !power_was_out_ && core_.on()) {
        core_.alarm(Alarm::PowerFailed, 0);
        power_failed_ = true;
        for (std::uint32_t l = 1; l <= kMaxChannels; ++l) {
            retract_work(l);
            channels_[l - 1]->interrupt();
        }
    }
    power_was_out_ = out;
}

void Machine::run_retracts() noexcept {
    bool any = false;
    for (std::uint32_t l = 1; l <= kMaxChannels; ++l) {
        Retract& phase = retracts_[l - 1];
        if (phase == Retract::None) continue;
        const auto takes_part = [&](std::uint32_t a) {
            const AxisConfig& config = core_.config.axes[a];
            const AxisUnit& axis = core_.axes[a];
            return config.channel == l && config.retract != 0 && axis.exists() && !axis.bound() &&
                   !axis.detached && axis.closed();
        };
        bool rests =
            !channels_[l - 1]->path_moves() && channels_[l - 1]->state() != ChannelState::Running;
        double longest = 0;
        for (std::uint32_t a = 0; a < core_.config.axis_count; ++a) {
            if (core_.config.axes[a].channel == l && core_.axes[a].exists())
                rests = rests && !core_.axes[a].moving() && !jogs_[a].active();
            if (takes_part(a))
                longest = std::fmax(
                    longest, std::fabs(core_.config.axes[a].retract) / core_.config.axes[a].rapid);
        }
        const auto permit = MotionGate::ask(core_, Door::WorkRetract, l);
        if (!permit)
            phase = Retract::None;  // braking already
        else if (!rests)
            any = true;
        else if (phase == Retract::Moving || longest == 0)
            phase = Retract::None;
        else {
            phase = Retract::Moving;
            any = true;
            for (std::uint32_t a = 0; a < core_.config.axis_count; ++a) {
                if (!takes_part(a)) continue;
                // together: each arrives when the slowest does
                const double way = core_.config.axes[a].retract;
                start_jog(*permit, a, way > 0 ? 1.0 : -1.0, std::fabs(way) / longest,
                          std::fabs(way), 0.0);
            }
        }
        core_.signals.set_nc(signals::cn_retract(l), phase != Retract::None);
    }
    if (power_failed_ && !any) {
        power_failed_ = false;
        core_.all_stop = true;
        for (auto& runner : channels_) runner->interrupt();
    }
}

}  // namespace polyturn::kernel
