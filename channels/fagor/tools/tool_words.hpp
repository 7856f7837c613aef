// T and D: the tool and its offset.
#pragma once
#include <cstdint>

namespace polyturn::channels::fagor {

struct Execution;

bool tool_words(Execution& x);
bool change_tool(Execution& x, std::int64_t tool, std::int64_t offset);
// Lengths and wear of the offset in use; the next move brings the new tip to where the old one was.
void load_tool(Execution& x);

}  // namespace polyturn::channels::fagor
