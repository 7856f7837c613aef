// What a job (cli.md 6) brings beside its programs, against what the controller has: its zeros and its machine. Selecting a job loads
// programs; zeros that are entered stand, because somebody has measured them where the part is (kernel/supervisor/job_plan.cpp decides
// the same for --like). So a difference is told to the operator, who enters the job's values or keeps his own.
#pragma once
#include <functional>
#include <string>
#include <vector>

#include "ipc/machine/machine_config.hpp"
#include "ipc/text/job.hpp"
#include "polyturn/image_structs.hpp"

namespace polyturn {

struct JobZero {
    unsigned channel = 0;
    std::string system, axis;          // as the job names them
    double wanted = 0, entered = 0;    // as the table shows them; entered NaN: the machine has no such zero
    bool same() const;
};
// All zeros of the job in its order. `store`: of a channel; nullptr: not known.
std::vector<JobZero> job_zeros(const text::Job& job, const MachineConfig& machine, const std::function<const ChannelStore*(unsigned)>& store);

// The machine that the job names is not the one with the tables at `base` (RunOptions::machine_folder): other files, and other values in
// them. Reads both files.
bool for_another_machine(const text::Job& job, const std::string& base);

}  // namespace polyturn
