// Blocks that run in place of the program: the next MDI line, or the block of a key whose label is
// a start. A start takes the lines entered before it, in single block one each, as does each start
// in a hold.
#pragma once
#include "kernel/channel/channel.hpp"
#include "kernel/gate/motion_gate.hpp"

namespace polyturn::kernel {

// The program is held where a block by hand may run in its place.
bool may_leave_for_block(const Channel& c) noexcept;
// A start takes a line, and not the program.
bool line_is_next(const Channel& c) noexcept;
void begin_line(Channel& c, StartPermit permit) noexcept;
void begin_in_hold(Channel& c, StartPermit permit, HandBlock::Of what) noexcept;
// The start that asked has been taken back by a hold, a reset, an emptied list; or something is
// missing by now.
void answered_for_block(Channel& c, bool goes_back) noexcept;
// Without another start, as soon as its channel has heard that the line before is over.
void next_line(Channel& c) noexcept;

}  // namespace polyturn::kernel
