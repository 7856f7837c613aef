// Axis signals to and from the PLC, except those for motion: ends of the stroke, position switches,
// index positions, lubrication, detaching (nct_parameters_part1 2.1, 3.7, 11.3, 12, 13).
#include <algorithm>
#include <cmath>

#include "kernel/tick/machine.hpp"

namespace polyturn::kernel {
namespace {
constexpr double kStrokeTolerance = 1e-6;  // mm: a move to the limit itself is allowed
}  // namespace

// Records and jogs end at the limits by themselves. This is the last defence, for limits that fall
// while an axis moves: at v it needs at least v^2/2a to stop.
void Machine::guard_stroke(std::uint32_t a) noexcept {
    AxisUnit& axis = core_.axes[a];
    axis.stroke_side = axis.referenced && !axis.detached ? core_.stroke.closed_sides(core_, a) : 0u;
    core_.signals.set_nc(signals::an_otp(a + 1), axis.stroke_side & 1u);
    core_.signals.set_nc(signals::an_otn(a + 1), axis.stroke_side >> 1 & 1u);
    const AxisZone* zone = core_.stroke.zone(core_, a);
    if (!zone || axis.target() == axis.command()) return;
    const double v = (axis.target() - axis.command()) / core_.config.tick_s;
    const double ends =
        axis.target() + (v > 0 ? v * v : -v * v) / (2.0 * core_.config.axes[a].acceleration);
    const bool out = (v > 0 && ends > zone->allowed.high + kStrokeTolerance) ||
                     (v < 0 && ends < zone->allowed.low - kStrokeTolerance);
    if (!out) return;
    const double limit = v > 0 ? zone->allowed.high : zone->allowed.low;
    if (axis.owner)
        channels_[axis.owner - 1]->fault(Alarm::StrokeLimit, name_of('A', a).view(), limit);
    jogs_[a].stop();
    stop_carrier(a);
    // its mover stops too
    for (std::uint32_t by = couplings_.master_of(a); by; by = couplings_.master_of(by - 1)) {
        if (const std::uint32_t mover = core_.axes[by - 1].owner)
            channels_[mover - 1]->fault(Alarm::StrokeLimit, name_of('A', a).view(), limit);
        jogs_[by - 1].stop();
    }
}

// AP_DETCHR: what the axis does is brought to its end, then it does not exist; coming back, it
// knows no reference point. An absolute encoder has it at once.
void Machine::attach_and_detach(std::uint32_t a) noexcept {
    AxisUnit& axis = core_.axes[a];
    const bool wanted = core_.signals.plc(signals::ap_detchr(a + 1)) != 0;
    if (wanted != axis.detached && !axis.moving() && !jogs_[a].active() && !homing_[a].active() &&
        !slides_.carrier(core_, a)) {
        axis.detached = wanted;
        if (wanted) {
            axis.referenced = false;
            axis.owner = 0;
        } else if (const ReferenceConfig& reference = core_.config.axes[a].reference;
                   reference.absolute) {
            axis.referenced = !reference.floating || core_.signals.plc(signals::ap_rpe(a + 1)) != 0;
        }
    }
    core_.signals.set_nc(signals::an_detcha(a + 1), axis.detached);
}

// Before each PLC cycle, from what the encoders say.
void Machine::position_signals() noexcept {
    if (!plc_.due()) return;
    for (std::size_t n = 0; n < core_.config.switches.size(); ++n) {
        const PositionSwitch& sw = core_.config.switches[n];
        std::int32_t on = 0, below = 0, above = 0;
        if (sw.axis >= 1 && sw.axis <= core_.config.axis_count) {
            const AxisUnit& axis = core_.axes[sw.axis - 1];
            if (axis.exists() && axis.referenced && !axis.detached) {
                const double x = axis.measured();
                below = x < sw.low;
                above = x > sw.high;
                on = !below && !above;
            }
        }
        core_.signals.set_nc(signals::n_sw(n + 1), on);
        core_.signals.set_nc(signals::n_swn(n + 1), below);
        core_.signals.set_nc(signals::n_swp(n + 1), above);
    }
    for (std::uint32_t a = 0; a < core_.config.axis_count; ++a) {
        const AxisUnit& axis = core_.axes[a];
        const AxisConfig& config = core_.config.axes[a];
        if (!axis.exists()) continue;
        const double step = config.index_step;
        const bool at_index = step > 0 && !axis.detached &&
                              std::fabs(axis.measured() - std::round(axis.measured() / step) *
                                                              step) <= config.servo.in_position;
        core_.signals.set_nc(signals::an_indp(a + 1), at_index);
        const bool due = config.lubrication > 0 && lubricated_[a] >= config.lubrication;
        if (due) lubricated_[a] = 0;
        core_.signals.set_nc(signals::an_lubr(a + 1), due);
    }
}

}  // namespace polyturn::kernel
