// The command line of polyturn-toolmgmt.
#pragma once

#include <string>

#include "ipc/model/machine/load_machine.hpp"

namespace polyturn::toolmgmt {

struct Options {
    std::string instance;
    std::string store;    // folder; empty with --memory
    bool memory = false;  // nothing is kept
    MachineSource machine;
    std::string setup;  // file; empty: none
    // a running controller whose tools this one begins with; empty: none
    std::string like;
    // a backup, or "newest": put in place of the store, then the program ends
    std::string restore;
    bool with_plc = false;  // with restore: programs of the PLC too
    // what a damaged store has lost is no longer missed, then the program ends
    bool confirm = false;
    std::string machine_folder;  // of the machine; empty when a single file was given
    int exit_status = -1;        // 0 or 2: help was printed or the usage was wrong
};

Options read_options(int argc, char** argv);

}  // namespace polyturn::toolmgmt
