// Which machine is meant by --machine: a parameter file, a folder with `machine.params`, or the
// name of one of the machines that come with Polyturn; without the option the twin-turret lathe.
#pragma once
#include <string>
#include <string_view>

#include "ipc/diagnosis/diagnosis.hpp"

namespace polyturn::text {

struct MachinePath {
    std::string params;  // the parameter file
    std::string folder;  // the machine's folder; empty when a single file was given
    // machine.toml: where axes, chucks and turrets stand; empty when there is none
    std::string room;
    std::string plc;  // plc.so: the machine builder's PLC; empty: the built-in lathe PLC
    // drives: the machine builder's process of the drives (PT_DRIVE 2); empty: the emulator
    std::string drives;
};

Result<MachinePath> resolve_machine(std::string_view option);

// Where examples and machines lie: $POLYTURN_SHARE, else found from the running program (build tree
// or installed). Empty when there are none.
std::string share_folder();

// Folder of the running program: the others of the same build lie beside it.
std::string program_folder();

}  // namespace polyturn::text
