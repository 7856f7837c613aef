// Travel to a fixed stop: an axis whose drive may give only the torque AP_TORQ meets an obstacle.
// It is at the stop when the drive is at its limit, the slide is at rest, and the command is
// PT_STOP_ERROR ahead: AN_FIXED. What moves it stops (a jog here, a record with kFixedStop by
// itself: channel/path/skip_move), and it presses until the limit is taken away; then the command
// goes back to where the slide is.
#include <cmath>

#include "kernel/tick/machine.hpp"

namespace polyturn::kernel {
namespace {
constexpr double kRestingMmS = 0.5;  // measured
}

void Machine::watch_fixed_stop(std::uint32_t a) noexcept {
    AxisUnit& axis = core_.axes[a];
    const ServoConfig& servo = core_.config.axes[a].servo;
    const double speed = (axis.measured() - last_measured_[a]) / core_.config.tick_s;
    last_measured_[a] = axis.measured();
    const bool limited =
        (axis.leaves_stop ? core_.move_torque[a] : axis.requests.torque_limit) != 0 &&
        axis.closed();
    if (!axis.pressing) {
        if (limited && axis.torque_limited() && std::fabs(speed) < kRestingMmS &&
            std::fabs(axis.error()) >= servo.stop_error) {
            axis.pressing = true;
            axis.pressed_at = axis.measured();
            // From now on: the move that ends here takes its limit away; one that program or PLC
            // have set as well stays, and it presses on.
            axis.leaves_stop = core_.move_torque[a] != 0 && core_.program_torque[a] == 0 &&
                               core_.signals.plc(signals::ap_torq(a + 1)) == 0;
            jogs_[a].stop();
            stop_carrier(a);
        }
    } else if (!limited) {
        if (axis.moving()) return;  // its path still brakes
        axis.pressing = false;
        const double back = axis.measured() - axis.own();
        if (const auto permit = MotionGate::ask(core_, Door::StopRelease, 0); permit && back != 0)
            start_jog(*permit, a, back > 0 ? 1.0 : -1.0, by_hand(a), std::fabs(back), 0.0);
        // no path moves it before it is there
        if (jogs_[a].active()) axis.beside = axis.leaves_stop = coming_back_[a] = true;
    } else if (std::fabs(axis.measured() - axis.pressed_at) >
               (core_.program_window[a] > 0 ? core_.program_window[a] : servo.stop_window)) {
        axis.pressing = false;
        core_.alarm(Alarm::FixedStopLost, core_.config.axes[a].channel, name_of('A', a).view(),
                    std::fabs(axis.measured() - axis.pressed_at));
        if (const std::uint32_t l = core_.config.axes[a].channel;
            l && channels_[l - 1]->program_runs())
            channels_[l - 1]->feed_hold();
    }
    if (axis.leaves_stop && !axis.pressing && !jogs_[a].active() && !axis.moving())
        axis.leaves_stop = false;
    if (coming_back_[a] && !jogs_[a].active() && !axis.moving())
        axis.beside = coming_back_[a] = false;
    core_.signals.set_nc(signals::an_fixed(a + 1), axis.pressing);
}

}  // namespace polyturn::kernel
