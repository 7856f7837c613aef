// DELDTG: the way of a block ends where the condition of a synchronized action begins to hold.
#pragma once
#include <cstddef>

#include "channels/sinumerik/grammar/cursor.hpp"
#include "channels/state/core.hpp"

namespace polyturn::channels::sinumerik {

struct Execution;

bool asks_positions_only(Execution& x, Cursor condition, std::size_t end);
bool deletes_travel(const Execution& x);
bool limited_travel(Execution& x, AxisValues& target);

}  // namespace polyturn::channels::sinumerik
