// From the machine that --machine names, the files of --param-file and the lines of --set to one
// table of parameters, alike in the store, the channel's check mode and the command line. A
// machine's file is the whole machine: what it does not name has its default.
#pragma once

#include <memory>
#include <string>
#include <vector>

#include "ipc/diagnosis/diagnosis.hpp"
#include "ipc/params/table.hpp"

namespace polyturn {

// As the options give them.
struct MachineSource {
    // a file, a folder, a name; empty: the twin-turret lathe
    std::string machine;
    std::vector<std::string> param_files;  // each on top of what stands before it ...
    std::vector<std::string> sets;         // ... and these on top of them all
};

struct LoadedMachine {
    std::unique_ptr<params::Table> table;  // never null; defaults where lines are wrong
    std::vector<Diagnosis> diagnoses;      // of all lines of all files
    std::string params_file;               // that was read
    std::string room_file;                 // machine.toml beside it; empty when there is none
    bool ok() const;                       // no error among the diagnoses
};

// The machine alone, without --param-file and --set.
LoadedMachine load_machine_file(const std::string& machine);
// --param-file, then --set, on top of the table. A line with a fault changes nothing; the others
// act.
void apply_overrides(const MachineSource& source, params::Table& table,
                     std::vector<Diagnosis>& diagnoses);
// Both, then the contradictions of the whole (config_check.hpp) unless a line was wrong already.
LoadedMachine load_machine(const MachineSource& source);

bool any_error(const std::vector<Diagnosis>& diagnoses);

}  // namespace polyturn
