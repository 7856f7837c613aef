// Which records of the ring the path may use in this tick, and with which limits they are planned:
// at most the horizon (PT_HORIZON), none of an epoch that is over, and no further than the travel
// limits.
#pragma once
#include "kernel/channel/channel.hpp"

namespace polyturn::kernel {

// Shows the planner what it may use.
void supply_path(Channel& c) noexcept;
// Marks of the PLC that are keys of the operator (Fagor: BLKSKIP1 to BLKSKIP3, M01STOP, M5008).
void take_keys(Channel& c) noexcept;
// Whether single block stops behind a record. What follows of its block belongs to it (M3 S500 G1
// Z-1. is one block), except the next move: a cycle is driven move by move. A macro statement is no
// block (fanuc_lathe 6.7), nor is a statement outside the path, such as the one that suppresses
// single block.
bool block_ends_at(const Channel& c, std::uint64_t index) noexcept;
// After a reset the ring still holds what the channel pushed before it heard of it. Nothing of that
// is executed.
void drop_old_epochs(Channel& c, std::uint64_t most) noexcept;
void stop_at_limit(Channel& c) noexcept;
// N1301 MBM 0: of what is prepared the path knows the running block and the next one, three with
// nose-radius compensation. A thread counts as one block: it starts when all of it is known.
std::uint64_t end_of_few_blocks(const Channel& c, std::uint64_t most) noexcept;

}  // namespace polyturn::kernel
