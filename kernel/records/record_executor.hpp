// Records whose turn has come: those that need standstill hold the path until they are done,
// instant ones act between two moves and cost no time. What a kind does is its row
// (record_executor.cpp).
#pragma once
#include "kernel/channel/channel.hpp"

namespace polyturn::kernel {

// Records at standstill, from the cursor on; `left`: part of the tick that is still to be used.
void execute_standing(Channel& c, double& left) noexcept;
void begin_record(Channel& c, const PathRecord& r, double offset_s) noexcept;
void end_record(Channel& c, const PathRecord& r, std::uint64_t index, double offset_s) noexcept;
// Between two moves, so many seconds behind the beginning of the tick.
void execute_instant(Channel& c, const PathRecord& r, double offset_s) noexcept;

}  // namespace polyturn::kernel
