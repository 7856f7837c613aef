// `polyturn-channel --instance NAME --channel L`: the channel process of a running controller.
#pragma once
#include <string>

#include "ipc/diagnosis/diagnosis.hpp"

namespace polyturn::channels {

struct RunModeOptions {
    std::string instance;
    unsigned channel = 1;
    std::string language;    // empty: PT_LANGUAGE of the channel
    std::string setup;       // file; empty: none
    std::string kept;        // folder of what survives power-off; empty: nothing does
    bool variables = false;  // also describe every variable that the program writes
};

// Runs until the kernel says Quit.
Result<void> run_mode(const RunModeOptions& options);

}  // namespace polyturn::channels
