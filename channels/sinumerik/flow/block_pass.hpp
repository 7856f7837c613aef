// What one pass over a block keeps beside its words: how far it has come, what it waits for, and
// what holds for this block only. What must survive a barrier is engine::BlockRun.
#pragma once
#include <cstdint>
#include <memory>

#include "channels/sinumerik/modal.hpp"

namespace polyturn::channels::sinumerik {

struct BlockPass {
    bool reads = false;             // words are being computed, nothing has acted
    bool needs_barrier = false;     // a live value is missing: the block is read again behind one
    std::uint64_t ways_before = 0;  // Core::ways() when it began
    std::shared_ptr<const HolePattern> at_hole;  // MCALL calls a program at each hole
    double feed = 0.0;                           // FB
};

}  // namespace polyturn::channels::sinumerik
