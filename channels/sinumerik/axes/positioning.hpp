// POS, POSA, POSP: axes that move beside the path, with their own feed.
#pragma once
#include <cstdint>

#include "channels/state/core.hpp"

namespace polyturn::channels::sinumerik {

struct Argument;
struct Call;
struct Execution;
struct Word;

bool a_axis_feed(Execution& x, const Word& word);
bool feed_source(Execution& x, const Argument& argument, std::uint16_t& spindle);
bool p_feed_per_revolution(Execution& x, Call& c);
bool p_axis_per_revolution(Execution& x, Call& c);
bool start_positioning(Execution& x, AxisSet& wait);
bool position_in_parts(Execution& x);

}  // namespace polyturn::channels::sinumerik
