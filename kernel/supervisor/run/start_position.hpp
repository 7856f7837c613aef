// Where the axes stand at the start of a private run: machine coordinates from the setup (cli.md
// 2).
#pragma once
#include "kernel/supervisor/check/job_plan.hpp"
#include "polyturn/image_structs.hpp"

namespace polyturn::supervisor {

// Fills start_known and start_position (true units: X as a radius).
// Where the kernel finds the files next to the parameter file: its path without the extension.
void set_machine_files(const std::string& params_file, RunOptions& options);
void set_start_positions(const JobPlan& plan, RunOptions& options);

}  // namespace polyturn::supervisor
