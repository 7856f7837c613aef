// Labels and block numbers: jumps, CASE, REPEAT of a section.
#pragma once
#include <optional>
#include <string>

#include "channels/program_files.hpp"
#include "channels/sinumerik/flow/text_index.hpp"

namespace polyturn::channels::sinumerik {

struct Execution;

const TextIndex& index_of(Execution& x, FileId file);
std::optional<TextPosition> find_label(Execution& x, const std::string& label, int direction);
bool jump_target(Execution& x, std::string& label);
bool st_goto(Execution& x);
bool st_case(Execution& x);
bool st_repeat(Execution& x);

}  // namespace polyturn::channels::sinumerik
