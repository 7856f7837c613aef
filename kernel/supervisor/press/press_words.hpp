// What an operator can do, in words (cli.md 5): one grammar for scenario and command line. Words
// become commands whose tick is still 0; who sends them sets it.
#pragma once
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "ipc/diagnosis/diagnosis.hpp"
#include "ipc/model/machine/machine_config.hpp"
#include "ipc/model/files/job.hpp"
#include "polyturn/image_structs.hpp"

namespace polyturn::supervisor {

// "feed_hold L2", "mode L1=mdi", "jog A3+ 0.5s" ... Programs are named relative to `folder`.
Result<std::vector<Command>> parse_press(std::string_view words, const MachineConfig& machine,
                                         const std::string& folder = {});
// The file that `select` names, job or program; empty: the words are of something else.
std::string selected_file(std::string_view words, const std::string& folder);
// The job that `select JOB` names; nothing for everything else, and for a job that cannot be read.
std::optional<text::Job> selected_job(std::string_view words, const std::string& folder = {});
// What else selecting it enters: parameter lines with the parts that it wants (N2308 of its
// channels).
std::vector<std::string> parts_wanted(const text::Job& job);
// "AP_SYNCR A3=1", "drive A3=fault", "input 5=1", "offset L1 3 wear X=0.05", "zero L1 G54 Z=-150",
// a parameter line.
Result<std::vector<Command>> parse_set(std::string_view words, const MachineConfig& machine);
// "AP_SYNCR A3", "input 5".
Result<std::vector<Command>> parse_release(std::string_view words, const MachineConfig& machine);

// The first words of everything that can be pressed, for tests and help.
std::vector<std::string_view> press_names();

// Copies a text into a fixed field; false when it is too long.
bool put_text(Command& command, std::string_view words);

}  // namespace polyturn::supervisor
