// `--like NAME`: a private run begins with what a running controller has now: parameters, offsets,
// zeros, kept variables, tools.
#pragma once
#include <map>
#include <string>

#include "ipc/diagnosis/diagnosis.hpp"
#include "ipc/model/files/setup.hpp"

namespace polyturn::supervisor {

struct LikeValues {
    // its folder, or its parameter file; empty: not to be found any more
    std::string machine;
    // all of them, but no parts made yet, to be read on top of the machine
    std::string parameter_lines;
    // wins over the job's files; a setup named on the command line wins over it
    text::Setup setup;
    // With tool management, as a channel's setup names tools: those of its turret by their
    // stations, the others behind them. A run has them in its store (polyturn-toolmgmt --like), a
    // check in its setup.
    std::map<unsigned, std::map<int, text::ToolSetup>> tools;
};
Result<LikeValues> values_of_controller(const std::string& instance);

// What `base` has and `setup` does not name.
void fill_up(text::Setup& setup, const text::Setup& base);

}  // namespace polyturn::supervisor
