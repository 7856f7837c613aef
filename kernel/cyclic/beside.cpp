// Axes that move beside the paths (architecture 5.7): PLC axes (AP_PAXR) and positioning axes of a program (record Beside). Each
// has its own feed, several go at once; an event says when one begins and when it rests. And the watch over the contour.
//
//   AP_PAXR     ____/-----------\____     rising: to AP_PAXPOS with AP_PAXFEED; falling: it brakes
//   AN_PAXA     _____/-----\__________     while it moves
#include <cmath>

#include "kernel/cyclic/machine.hpp"

namespace polyturn::kernel {

void Machine::start_beside(std::uint32_t a, double target, double speed, std::uint32_t channel) noexcept {
    AxisUnit& axis = core_.axes[a];
    const AxisConfig& config = core_.config.axes[a];
    const bool may = axis.exists() && core_.on() && !core_.all_stop && axis.referenced && !axis.bound() && !axis.detached && !axis.moving() && !jogs_[a].active() &&
                     !homing_[a].active() && !to_reference_[a] && axis.closed();
    if (!may) {
        axis.beside = false;
        if (channel) channels_[channel - 1]->fault(Alarm::BesideRefused, name_of('A', a).view(), 0);
        else core_.alarm(Alarm::BesideRefused, config.channel, name_of('A', a).view());
        return;
    }
    const double way = target - axis.own();
    const double v = speed > 0 ? std::fmin(speed, config.rapid) : config.rapid;
    core_.event(KernelEventKind::BesideBegin, config.channel, static_cast<std::int32_t>(a + 1), target);
    axis.beside = true;
    if (way != 0) start_jog(a, way > 0 ? 1.0 : -1.0, v, std::fabs(way), 0.0);
}

void Machine::run_beside() noexcept {
    for (std::uint32_t a = 0; a < core_.config.axis_count; ++a) {
        AxisUnit& axis = core_.axes[a];
        if (!axis.exists()) continue;
        const bool asked = core_.signals.plc(signals::ap_paxr(a + 1)) != 0;
        if (axis.beside && !core_.beside[a].asked) {
            if (beside_by_plc_[a] && !asked) jogs_[a].stop();
            if (!jogs_[a].active() && !axis.moving()) {
                axis.beside = beside_by_plc_[a] = false;
                core_.event(KernelEventKind::BesideEnd, core_.config.axes[a].channel, static_cast<std::int32_t>(a + 1), axis.own());
            }
        }
        if (core_.beside[a].asked) {
            const Core::BesideWish wish = core_.beside[a];
            core_.beside[a] = {};
            start_beside(a, wish.target, wish.speed, wish.channel);
        } else if (asked && !pax_request_[a]) {
            const double unit = core_.config.axes[a].inch ? 25.4 : 1.0;
            const double place = core_.signals.plc(signals::ap_paxpos(a + 1)) / 1000.0 * unit;
            const double target = core_.signals.plc(signals::ap_paxinc(a + 1)) ? axis.own() + place : place;
            beside_by_plc_[a] = true;
            start_beside(a, target, core_.signals.plc(signals::ap_paxfeed(a + 1)) * unit / 60.0, 0);
        }
        pax_request_[a] = asked;
        core_.signals.set_nc(signals::an_paxa(a + 1), axis.beside);
    }
    watch_contours();
}

// How far the measured axes are beside the path that they are commanded to drive: what of the following errors is not along it.
void Machine::watch_contours() noexcept {
    for (std::uint32_t l = 1; l <= kMaxChannels; ++l) {
        const double tolerance = core_.config.channels[l - 1].contour_tolerance;
        if (tolerance <= 0 || !channels_[l - 1]->cuts()) continue;
        double speed2 = 0, along = 0, error2 = 0;
        for (std::uint32_t a = 0; a < core_.config.axis_count; ++a) {
            const AxisUnit& axis = core_.axes[a];
            if (!axis.exists() || axis.owner != l || core_.config.axes[a].rotary) continue;
            speed2 += axis.velocity() * axis.velocity();
            along += axis.velocity() * axis.error();
            error2 += axis.error() * axis.error();
        }
        if (speed2 == 0) continue;
        const double beside = std::sqrt(std::fmax(0.0, error2 - along * along / speed2));
        if (beside <= tolerance) continue;
        ShortText name;
        name << "L" << l;
        channels_[l - 1]->fault(Alarm::ContourDeviates, name.view(), beside);
    }
}

}  // namespace polyturn::kernel
