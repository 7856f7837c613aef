// A superposed handwheel: while a channel has it switched on, it adds its travel to an axis that a
// program moves. The added travel stays (AxisStatus::overlay) until the channel's next reset, when
// it becomes part of the axis' own position.
//
// Both motions together keep the axis' limits: a path that is planned while the handwheel is
// superposed leaves kOverlayShare of velocity, acceleration and jerk to it (supply_path),
// and the handwheel acts only once such a path is driven.
#include <cmath>
#include <utility>

#include "kernel/tick/machine.hpp"

namespace polyturn::kernel {

void Machine::superpose(std::uint32_t a, double way) noexcept {
    const std::uint32_t l = core_.config.axes[a].channel;
    if (core_.axes[a].bound() || core_.axes[a].detached || core_.axes[a].beside) {
        core_.alarm(Alarm::SlaveCommanded, l, name_of('A', a).view());
        return;
    }
    if (const std::uint8_t missing = MotionGate::missing(core_, Door::Superpose, l)) {
        core_.alarm(Alarm::NotReady, l,
                    missing & kDoorClosed ? "the door is open: close it, or switch to setup mode"
                                          : "axes are moved by hand only while the machine is on");
        return;
    }
    overlays_[a].left += way;
}

void Machine::run_overlays() noexcept {
    for (std::uint32_t a = 0; a < core_.config.axis_count; ++a) {
        Overlay& overlay = overlays_[a];
        AxisUnit& axis = core_.axes[a];
        const AxisConfig& config = core_.config.axes[a];
        if (!axis.exists() || config.channel == 0) continue;
        ChannelRunner& runner = *channels_[config.channel - 1];
        if (!overlay.jog.active() && overlay.left != 0) {
            const auto permit = MotionGate::ask(core_, Door::Superpose, config.channel);
            if (!permit || !runner.program_runs())
                overlay.left = 0;
            else if (runner.leaves_room()) {
                const double left = std::exchange(overlay.left, 0.0), sign = left > 0 ? 1.0 : -1.0;
                const double most = config.manual_rapid > 0
                                        ? std::fmin(config.manual_rapid, config.rapid)
                                        : config.rapid;
                const double room = std::fmax(0.0, core_.stroke.room(core_, a, sign));
                overlay.jog.start(axis.overlay(), sign,
                                  {std::fmin(most, ChannelRunner::kOverlayShare * config.rapid),
                                   ChannelRunner::kOverlayShare * config.acceleration,
                                   ChannelRunner::kOverlayShare * config.jerk},
                                  0, std::fabs(left), room, core_.config.tick_s);
            }
        }
        if (overlay.jog.active()) {
            if (core_.state == MachineState::EmergencyStop || core_.all_stop) {
                overlay.jog.stop();
                overlay.left = 0;
            }
            if (axis.closed())
                axis.overlay(overlay.jog.step(core_.config.tick_s));
            else
                overlay = {};
        }
        runner.overlay_moves(a, overlay.jog.active());
        if (axis.overlay() != 0 && !overlay.jog.active() && !axis.moving() && runner.idle())
            axis.take_overlay();
    }
}

}  // namespace polyturn::kernel
