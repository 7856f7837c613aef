// The electronic gear box leaves the work (nct_parameters_part2 19): on CP_EGBRRQ, and on a reset
// when N1800 RCE says so. The path stops, then all axes with a distance N1804 go it together while
// the gear is still closed; with RCE it opens then.
//
// What the PLC orders is no fault: the program is held, and while the gear stays closed (RCE 0) it
// can go on once the axes have been taken back, as after a jog in a hold. When the gear opens the
// workpiece is out of phase: that ends the program like a reset.
#include <cmath>

#include "kernel/tick/machine.hpp"

namespace polyturn::kernel {

void Machine::retract_gear(std::uint32_t l) noexcept {
    if (spindle_couplings_.gear_of(l) == SpindleCouplings::kNobody ||
        gear_retract_[l - 1] != GearRetract::None)
        return;
    gear_retract_[l - 1] = GearRetract::Stopping;
}

// What a program has coupled ends with its reset; a gear stays closed, or is taken out of the work
// first.
void Machine::reset_couplings(std::uint32_t channel) noexcept {
    // N1301 CLR with N1305 C31: G51.2 stays what it is (nct part 1 14.2).
    const auto keeps = [&](std::uint32_t l) {
        return params::bit(core_.table, params::n1301_defaultg2, l, 7) &&
               params::bit(core_.table, params::n1305_clr_g_table4, l, 7);
    };
    if (channel != 0) {
        if (!keeps(channel)) spindle_couplings_.reset(channel);
    } else {
        for (std::uint32_t l = 1; l <= kMaxChannels; ++l)
            if (!keeps(l)) spindle_couplings_.reset(l);
    }
    for (std::uint32_t l = 1; l <= kMaxChannels; ++l)
        if ((channel == 0 || channel == l) && core_.config.channels[l - 1].gear_opens)
            retract_gear(l);
}

void Machine::run_gear_retracts() noexcept {
    for (std::uint32_t l = 1; l <= kMaxChannels; ++l) {
        const ChannelConfig& config = core_.config.channels[l - 1];
        if (!config.exists) continue;
        const bool asked = core_.signals.plc(signals::cp_egbrrq(l)) != 0;
        if (asked && !gear_request_[l - 1] &&
            spindle_couplings_.gear_of(l) != SpindleCouplings::kNobody) {
            if (channels_[l - 1]->program_runs()) {
                channels_[l - 1]->safe_hold();
                core_.alarm(Alarm::GearRetracted, l, "CP_EGBRRQ", 0, channels_[l - 1]->line());
            }
            retract_gear(l);
        }
        gear_request_[l - 1] = asked;
        GearRetract& phase = gear_retract_[l - 1];
        if (phase == GearRetract::None) continue;
        const std::uint32_t follower = spindle_couplings_.gear_of(l);
        const auto permit = MotionGate::ask(core_, Door::GearRetract, l);
        if (!permit || follower == SpindleCouplings::kNobody) {
            phase = GearRetract::None;
            continue;
        }
        ChannelRunner& runner = *channels_[l - 1];
        // a reset leaves nothing behind the record that runs: its axes alone are waited for
        bool rests = runner.resets() || runner.rests();
        double way2 = 0;
        for (std::uint32_t a = 0; a < core_.config.axis_count; ++a) {
            const AxisConfig& axis = core_.config.axes[a];
            if (axis.gear_retract == 0 || axis.channel != l || !core_.axes[a].exists() ||
                core_.axes[a].bound())
                continue;
            rests = rests && !core_.axes[a].moving() && !jogs_[a].active();
            way2 += axis.gear_retract * axis.gear_retract;
        }
        if (!rests) continue;
        if (phase == GearRetract::Moving || way2 == 0) {
            phase = GearRetract::None;
            if (!config.gear_opens) continue;
            spindle_couplings_.uncouple(follower);
            if (!runner.program_runs()) continue;
            runner.reset();
            reset_couplings(l);
            continue;
        }
        phase = GearRetract::Moving;
        // it may go on: the return path is stored
        const bool held = runner.program_runs() && !runner.resets();
        if (held) runner.step_aside();
        const double way = std::sqrt(way2);
        for (std::uint32_t a = 0; a < core_.config.axis_count; ++a) {
            const AxisConfig& axis = core_.config.axes[a];
            if (axis.gear_retract == 0 || axis.channel != l || !core_.axes[a].exists() ||
                core_.axes[a].bound())
                continue;
            const double share = std::fabs(axis.gear_retract) / way;
            const double speed = std::fmin(config.gear_retract_feed * share, axis.rapid);
            if (held && return_path_[l - 1].count < ReturnPath::kMost)
                return_path_[l - 1].add(a, core_.axes[a].own());
            start_jog(*permit, a, axis.gear_retract > 0 ? 1.0 : -1.0, speed,
                      std::fabs(axis.gear_retract), 0.0);
        }
    }
}

}  // namespace polyturn::kernel
