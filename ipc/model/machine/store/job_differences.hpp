// What a job (cli.md 6) brings besides its programs, against what the controller has: its zeros,
// the offsets of its setup file, its machine. Selecting a job loads programs; zeros and offsets
// that are entered stand, because somebody has measured them where the part is
// (kernel/supervisor/check/job_plan.cpp decides the same for --like). So a difference is told to
// the operator, who enters the job's values or keeps his own.
#pragma once
#include <functional>
#include <string>
#include <string_view>
#include <vector>

#include "ipc/model/machine/machine_config.hpp"
#include "ipc/model/files/job.hpp"
#include "ipc/model/files/setup.hpp"
#include "polyturn/image_structs.hpp"

namespace polyturn {

struct JobZero {
    unsigned channel = 0;
    std::string system, axis;  // as the job names them
    // as the table shows them; entered NaN: the machine has no such zero
    double wanted = 0, entered = 0;
    bool same() const;
};
using StoreOf = std::function<const ChannelStore*(unsigned channel)>;  // nullptr: not known
// All zeros of the job and of its setup file, by channel and name; where both have one, the setup
// file's, as in `run`.
std::vector<JobZero> job_zeros(const text::Job& job, const text::Setup& setup,
                               const MachineConfig& machine, const StoreOf& store);

// One offset of the job's setup file: the values that it names, in the order of the table.
struct JobOffset {
    struct Value {
        std::string_view name;  // "X" ... "R", "T": the tip's direction
        bool wear = false;
        double wanted = 0, entered = 0;  // entered NaN: the machine has no such offset
        bool same() const;
    };
    unsigned channel = 0;
    int number = 0;
    std::vector<Value> values;
    bool same() const;
};
std::vector<JobOffset> job_offsets(const text::Setup& setup, const MachineConfig& machine,
                                   const StoreOf& store);

// The machine that the job names is not the one with the tables at `base`
// (RunOptions::machine_folder): other files, and other values in them. Reads both files.
bool for_another_machine(const text::Job& job, const std::string& base);

}  // namespace polyturn
