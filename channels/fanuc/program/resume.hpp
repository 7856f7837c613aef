// Going back to a block that is not executed yet (Language::resume_at).
#pragma once
#include <cstdint>

namespace polyturn::channels::fanuc {

struct Execution;

void keep_resume_states(Execution& x, bool on);
bool is_plain_move(const Execution& x);
void note_resume_point(Execution& x);
bool go_back_to(Execution& x, std::uint64_t serial, bool within_compensation);

}  // namespace polyturn::channels::fanuc
