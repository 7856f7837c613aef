// T: the tool, and how its offsets act.
#pragma once

namespace polyturn::channels::fanuc {

struct Execution;

bool tool_word(Execution& x);
bool apply_tool_offsets(Execution& x);
void load_nose(Execution& x);

}  // namespace polyturn::channels::fanuc
