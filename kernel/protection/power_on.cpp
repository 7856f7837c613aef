// From power-on to ready (docs/design/power-on-to-ready.md):
//
//   emergency stop --released--> off --machine on--> not referenced --reference--> ready
//         ^                       ^ power-on                                        |
//         +------- button, circuit, drive fault, following error -------------------+
//
// Machine on after an emergency stop passes through off: the drives get their fault reset there,
// for one PLC cycle, and a drive that keeps its fault, an open circuit or a PLC that does not
// answer refuses it by name.
#include <algorithm>
#include <utility>

#include "kernel/tick/machine.hpp"

namespace polyturn::kernel {

MachineStep Machine::step_now() const noexcept {
    if (core_.state == MachineState::EmergencyStop) return MachineStep::EmergencyStop;
    if (core_.state == MachineState::Off) return MachineStep::Off;
    if (core_.all_stop) return MachineStep::Stopped;
    bool referenced = true;
    for (std::uint32_t a = 0; a < core_.config.axis_count; ++a) {
        const AxisUnit& axis = core_.axes[a];
        if (!axis.exists()) continue;
        if (homing_[a].active() || to_reference_[a]) return MachineStep::Referencing;
        if (core_.must_be_referenced(a) && !axis.referenced) referenced = false;
    }
    return referenced ? MachineStep::Ready : MachineStep::NotReferenced;
}

// Once a tick: the step is reported when it has changed.
void Machine::watch_step() noexcept {
    const MachineStep now = step_now();
    core_.signals.set_nc(signals::n_ready(), now == MachineStep::Ready);
    for (unsigned l = 0; plc_.due() && l < kMaxChannels; ++l)
        if (core_.config.channels[l].exists)
            core_.signals.set_nc(signals::cn_ready(l + 1),
                                 channels_[l]->check_start_conditions() == 0);
    if (now == step_) return;
    step_ = now;
    core_.event(KernelEventKind::MachineState, 0, static_cast<std::int32_t>(now),
                static_cast<double>(core_.state));
}

// What keeps the machine from being switched on, all of it; empty: nothing.
ShortText Machine::missing_for_on() const noexcept {
    ShortText text;
    const auto add = [&](std::string_view what) {
        text << (text.view().empty() ? "" : "; ") << what;
    };
    if (core_.signals.plc(signals::plc_estop()))
        add("the emergency stop circuit is open: turn the button back");
    if (plc_.dead())
        add("the PLC is dead: wait until it runs again");
    else if (plc_late_)
        add("the PLC does not answer in time");
    bool first = true;
    for (std::uint32_t a = 0; a < core_.config.axis_count; ++a)
        if (core_.axes[a].exists() && core_.axes[a].drive_fault_stays()) {
            add(first ? "the drive keeps its fault:" : "");
            text << " " << name_of('A', a).view();
            first = false;
        }
    return text;
}

void Machine::release_stop() noexcept {
    if (core_.state != MachineState::EmergencyStop) return;
    if (core_.signals.plc(signals::plc_estop())) {
        core_.alarm(Alarm::MachineOnRefused, 0,
                    "the emergency stop circuit is open: turn the button back");
        return;
    }
    // Without power an axis that still brakes would stop at once: the release waits for its
    // standstill.
    release_waits_ = std::any_of(core_.axes.begin(), core_.axes.end(), [](const AxisUnit& axis) {
        return axis.exists() && axis.moving();
    });
    if (release_waits_) return;
    for (AxisUnit& axis : core_.axes) axis.clear_fault();
    for (SpindleUnit& spindle : core_.spindles) spindle.clear_fault();
    set_state(MachineState::Off);
}

void Machine::press_machine_on() noexcept {
    if (core_.on()) {  // as ever: it also takes back what has stopped everything
        core_.all_stop = plc_.dead() || plc_late_;
        return;
    }
    const bool from_stop = core_.state == MachineState::EmergencyStop;
    if (from_stop) {
        release_stop();
        on_waits_ = release_waits_;
        if (core_.state == MachineState::EmergencyStop) return;  // refused, and said why; or later
    }
    bool fault = from_stop;
    for (const AxisUnit& axis : core_.axes)
        fault = fault || (axis.exists() && axis.drive_fault_stays());
    switch_on_at_ = core_.tick + (fault ? core_.config.plc_cycle_ticks : 0);
    switch_on();
}

// Off, and machine on was pressed: on as soon as the drives have had their fault reset.
void Machine::switch_on() noexcept {
    if (switch_on_at_ < 0 || core_.tick < switch_on_at_) return;
    switch_on_at_ = -1;
    if (core_.state != MachineState::Off) return;
    if (const ShortText missing = missing_for_on(); !missing.view().empty()) {
        core_.alarm(Alarm::MachineOnRefused, 0, missing.view());
        return;
    }
    for (AxisUnit& axis : core_.axes) axis.clear_fault();
    for (SpindleUnit& spindle : core_.spindles) spindle.clear_fault();
    core_.all_stop = false;
    set_state(MachineState::On);
}

// The emergency stop circuit as the PLC sees it (its relays act by themselves; the control
// follows).
void Machine::watch_stop_circuit() noexcept {
    if (core_.signals.plc(signals::plc_estop()) && core_.state != MachineState::EmergencyStop)
        emergency_stop(Alarm::EmergencyStop, 0, {}, 0);
    if (std::exchange(release_waits_, false)) {
        const bool on = std::exchange(on_waits_, false);
        if (on)
            press_machine_on();
        else
            release_stop();
    }
    switch_on();
}

}  // namespace polyturn::kernel
