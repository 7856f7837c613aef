// Where the axes stand at the start of a private run: machine coordinates from the setup (cli.md 2).
#pragma once
#include "kernel/supervisor/job_plan.hpp"
#include "polyturn/image_structs.hpp"

namespace polyturn::supervisor {

// Fills start_known and start_position (true units: X as a radius).
void set_start_positions(const JobPlan& plan, RunOptions& options);

}  // namespace polyturn::supervisor
