// From block to block: reading, barriers, the end of a block and of a text.
#pragma once
#include <cstdint>

#include "channels/language.hpp"

namespace polyturn::channels::fagor {

struct Execution;

Step step(Execution& x);
void live_value_barrier(Execution& x);
// Behind words and statements. `counts`: it is a block for compensation; `ways_before`:
// Core::ways() at its beginning, for modal calls.
Step end_block(Execution& x, bool counts, std::uint64_t ways_before);

}  // namespace polyturn::channels::fagor
