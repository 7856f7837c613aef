// A part passed from one spindle to the other by hand: which turret says what, as the parameters of
// this machine have it. The words are those of the built-in lathe PLC
// (kernel/plc/lathe/lathe_plc.hpp); docs/builder.md, part transfer, tells the same as two programs.
#pragma once
#include <cstdint>
#include <string>
#include <vector>

#include "ipc/model/machine/machine_config.hpp"
#include "ipc/params/table.hpp"

namespace polyturn::hmi {

struct TransferStep {
    const char* title = "";  // to be translated
    unsigned channel = 0;    // that says it; of a jog, the one whose axis moves
    long code = -1;          // M code; -1: by jog
    // that plain S of the channel must mean then, for the code acts on it; 0: any
    unsigned spindle = 0;
};

// Steps in their order; none where the machine has no counter spindle. The counter spindle is the
// first one that has a master (PT_SPINDLE_MASTER), else S2 where a code of PT_M_SPINDLE or N0604
// gives it to a channel. Its turret is the channel whose slide goes against a stop (PT_M_TORQUE),
// else the one that N0604 gives the spindle, else the second one. A machine with one channel
// chooses between its spindles before each chuck: M11 opens the chuck of the chosen one.
std::vector<TransferStep> transferSteps(const MachineConfig& config, const params::Table& table,
                                        const std::vector<unsigned>& channels);

}  // namespace polyturn::hmi
