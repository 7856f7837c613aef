// Where a channel waits for others, and how its language writes that.
#pragma once
#include "kernel/channel/channel.hpp"

namespace polyturn::kernel {

// It executes blocks towards its target: during a block search, or a block entered by hand, it does
// not rendezvous with channels that cut.
WaitBoard::Phase wait_phase(const Channel& c) noexcept;
void stand_at_wait(Channel& c, const PathRecord& r) noexcept;
// What it waits at, as its language writes it.
void write_code(const Channel& c, ShortText& text) noexcept;
// "L2 O2001.nc:17 M502 (L1, L2)"
void describe_wait(Channel& c, ShortText& text) noexcept;

}  // namespace polyturn::kernel
