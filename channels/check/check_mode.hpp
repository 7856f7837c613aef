// `polyturn-channel --check`: interprets one program without a machine and prints its events
// (cli.md 3).
#pragma once
#include <cstdint>
#include <cstdio>
#include <string>

#include "ipc/model/machine/load_machine.hpp"

namespace polyturn::channels {

struct CheckOptions {
    unsigned channel = 1;
    std::string language;  // empty: PT_LANGUAGE of the channel
    MachineSource machine;
    std::string setup;  // file; empty: none
    std::string program;
    bool variables = false;
    // file that holds the variables which all channels of this check share; empty: alone
    std::string shared;
    bool alone = false;  // no other program takes part
    // more are taken for a program without an end; 0: no limit (RoundWatch)
    std::uint64_t most_blocks = 10'000'000;
};

// Prints to `out`. Exit status: 0 done, 1 an alarm ended the program, 2 something could not be
// read.
int run_check(const CheckOptions& options, std::FILE* out);

}  // namespace polyturn::channels
