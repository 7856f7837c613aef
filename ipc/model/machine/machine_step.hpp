// The sequence from power-on to ready, step by step, and the same sequence back after a fault:
// what each step is called, what the operator reads, what he does next. Kernel events and `polyturn
// status` say it with these words.
#pragma once
#include <array>
#include <string_view>

#include "ipc/image/enums.hpp"

namespace polyturn {

struct MachineStepText {
    MachineStep step;
    std::string_view name, text, next;
};

inline constexpr std::array<MachineStepText, 6> kMachineSteps{{
    {MachineStep::EmergencyStop, "emergency_stop", "the emergency stop is active",
     "turn the button back, then press machine on"},
    {MachineStep::Off, "off", "the machine is off", "press machine on"},
    {MachineStep::NotReferenced, "not_referenced", "not all axes are referenced",
     "press reference all"},
    {MachineStep::Referencing, "referencing", "axes are on their way to their reference points",
     "wait"},
    {MachineStep::Ready, "ready", "the machine is ready", ""},
    {MachineStep::Stopped, "stopped", "an alarm has stopped everything",
     "remove its cause, then press reset"},
}};

constexpr const MachineStepText& machine_step_text(std::uint32_t step) noexcept {
    return kMachineSteps[step < kMachineSteps.size() ? step : 1];
}

}  // namespace polyturn
