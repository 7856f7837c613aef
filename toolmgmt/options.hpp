// The command line of polyturn-toolmgmt.
#pragma once

#include <string>

#include "ipc/machine/load_machine.hpp"

namespace polyturn::toolmgmt {

struct Options {
    std::string instance;
    std::string store;           // folder; empty with --memory
    bool memory = false;         // nothing is kept
    MachineSource machine;
    std::string setup;           // file; empty: none
    int exit_status = -1;        // 0 or 2: help was printed or the usage was wrong
};

Options read_options(int argc, char** argv);

}  // namespace polyturn::toolmgmt
