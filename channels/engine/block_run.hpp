// What an interpreter remembers of the block under way, for all languages. A block is read, comes
// to a barrier, is read again behind it, and ends; between two blocks only `serial`, `fresh` and
// `ended` hold.
#pragma once
#include <cstdint>

namespace polyturn::channels::engine {

struct BlockRun {
    std::uint64_t serial = 0;       // counts the blocks of a run, from 1; the events carry it
    std::uint64_t tool_serial = 0;  // of the block whose T was executed before the rest of it
    bool reread = false;            // a barrier came before the block: it is read again behind it
    bool fresh = false;             // live values are those of the barrier just passed
    bool wants_barrier = false;     // the block is done; what it commanded is executed first
    bool jumped = false, called = false;  // the next block is not the next one of the text
    bool ended = false;                   // the program is over: by its end, or by a fault
    // resume states: kept at all; the one kept last does not hold any more
    bool keeps_states = false, state_changed = true;
};

}  // namespace polyturn::channels::engine
