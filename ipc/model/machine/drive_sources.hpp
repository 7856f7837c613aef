// Which kinds of drives a machine asks for beside the simulated ones (PT_DRIVE of its axes,
// PT_SPINDLE_DRIVE of its spindles): the kernel loads drive.so, the supervisor starts the process
// of the drives.
#pragma once
#include "ipc/params/table.hpp"

namespace polyturn {

struct DriveSources {
    bool library = false, process = false;
};

DriveSources wanted_drives(const params::Table& table);

}  // namespace polyturn
