// Might a program stop at M0 or M1, or start those of other channels? Looked for in the text: too
// often yes costs a little speed, never correctness.
#pragma once
#include <string>
#include <string_view>
#include <vector>

namespace polyturn::supervisor {

bool text_holds_program_stop(std::string_view text);
// These files and all others in their folders, where subprograms are found. Yes for what cannot be
// looked through.
bool may_hold_program_stop(const std::vector<std::string>& files);

bool text_starts_programs(std::string_view text);  // START(...) of sinumerik
bool may_start_programs(const std::vector<std::string>& files);

}  // namespace polyturn::supervisor
