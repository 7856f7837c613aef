// The simulated sensors of a setup as commands for the kernel.
#pragma once
#include <vector>

#include "ipc/image/commands.hpp"
#include "ipc/model/machine/machine_config.hpp"
#include "ipc/model/files/setup.hpp"
#include "kernel/supervisor/check/job_plan.hpp"

namespace polyturn::supervisor {

std::vector<Command> sensor_commands(const JobPlan& plan);
// A sensor on an axis or an input that does not exist.
void check_sensors(const text::Setup& setup, const MachineConfig& machine,
                   std::vector<Diagnosis>& diagnoses);

}  // namespace polyturn::supervisor
