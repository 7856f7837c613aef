// F: feed, or lead of a thread.
#pragma once
#include "channels/text/word_scanner.hpp"

namespace polyturn::channels::fanuc {

struct Execution;
struct GCode;

// E of the series 15 format, a lead, is within its range.
bool lead_in_range(Execution& x);

bool set_feed(Execution& x, const Word& word);
bool g_feed_mode(Execution& x, const GCode& row);

}  // namespace polyturn::channels::fanuc
