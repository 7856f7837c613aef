// The spindles' part of a tick: what the PLC and the channels ask of them, what is told about them, and their faults.
#include "kernel/cyclic/machine.hpp"

namespace polyturn::kernel {

void Machine::open_spindle(unsigned index) {
    const SpindleConfig& config = core_.config.spindles[index];
    if (!config.exists) return;
    void* drive = SpindleUnit::open_drive(index + 1, config, core_.config.tick_s);
    core_.spindles[index].open(config, core_.config.tick_s, simulated_drive_api(), drive, static_cast<SimulatedDrive*>(drive));
}

void Machine::run_spindles() noexcept {
    SpindleInput in;
    in.tick_s = core_.config.tick_s;
    in.powered = core_.on();
    in.stop = core_.all_stop;
    for (std::uint32_t s = 0; s < core_.config.spindle_count; ++s) {
        SpindleUnit& spindle = core_.spindles[s];
        if (!spindle.exists()) continue;
        const auto plc = [&](PlcSignal signal) { return core_.signals.plc(signal(s + 1)); };
        const auto tell = [&](NcSignal signal, std::int32_t value) { core_.signals.set_nc(signal(s + 1), value); };
        const bool detached = plc(signals::sp_sdetchr) != 0 && spindle.loop() == SpindleUnit::Loop::Turning && spindle.standing();
        in.rotation = plc(signals::sp_rot);
        in.range = static_cast<std::uint32_t>(plc(signals::sp_range));
        in.creep = plc(signals::sp_par) != 0;
        in.close_loop = plc(signals::sp_oreq) != 0;
        in.orient_switch = plc(signals::sp_osw) != 0;
        in.muted = plc(signals::sp_sdetchr) != 0;
        in.override_factor = spindle.override_locked && !spindle.config().override_in_thread ? 1.0 : spindle.override_factor;
        in.axis_position = core_.axes[spindle.surface_axis()].target();
        const bool fluctuated = spindle.fluctuates(), could_orient = !spindle.cannot_orient();
        const SpindleUnit::Fault fault = spindle.fault();
        spindle.step(in);
        core_.spindle_rev_s[s] = spindle.speed() / 60.0;
        tell(signals::sn_ns, spindle.reached());
        tell(signals::sn_n0, spindle.has_encoder() && spindle.standing());
        tell(signals::sn_flu, spindle.fluctuates());
        tell(signals::sn_inpos, spindle.in_position());
        tell(signals::sn_sindp, spindle.at_index());
        tell(signals::sn_sdetcha, detached);
        tell(signals::sn_range, static_cast<std::int32_t>(spindle.range_number()));
        if (spindle.fluctuates() && !fluctuated) core_.alarm(Alarm::SpindleFluctuates, spindle.owner, name_of('S', s).view(), spindle.speed());
        if (spindle.cannot_orient() && could_orient) core_.alarm(Alarm::SpindleCannotClose, spindle.owner, name_of('S', s).view());
        if (spindle.fault() != fault && spindle.fault() != SpindleUnit::Fault::None) spindle_fault(s);
    }
}

// A spindle that does not follow its loop, or whose drive has failed, stops the machine; one that does not come into
// position only stops the program that waits for it.
void Machine::spindle_fault(std::uint32_t s) noexcept {
    const SpindleUnit& spindle = core_.spindles[s];
    const ShortText name = name_of('S', s);
    const double degrees = spindle.error() * 360.0;
    switch (spindle.fault()) {
        case SpindleUnit::Fault::Drive: return emergency_stop(Alarm::DriveFault, spindle.owner, name.view(), 0);
        case SpindleUnit::Fault::Standstill: return emergency_stop(Alarm::StandstillError, spindle.owner, name.view(), degrees);
        case SpindleUnit::Fault::Moving:
        case SpindleUnit::Fault::Absolute: return emergency_stop(Alarm::FollowingError, spindle.owner, name.view(), degrees);
        case SpindleUnit::Fault::NotOriented:
        case SpindleUnit::Fault::NotInPosition: {
            const Alarm reason = spindle.fault() == SpindleUnit::Fault::NotOriented ? Alarm::SpindleNotOriented : Alarm::SpindleNotInPosition;
            if (spindle.owner) channels_[spindle.owner - 1]->fault(reason, name.view(), degrees);
            else core_.alarm(reason, 0, name.view(), degrees);
            return;
        }
        default: return;
    }
}

}  // namespace polyturn::kernel
