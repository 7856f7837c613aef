// Axis words become the point that a block goes to.
#pragma once
#include "channels/state/core.hpp"
#include "channels/text/word_scanner.hpp"

namespace polyturn::channels::fanuc {

struct Execution;

bool axis_word(Execution& x, const Word& word, AxisValues& target, AxisSet& named);
bool read_axis_words(Execution& x, AxisValues& target, AxisSet* named = nullptr);

}  // namespace polyturn::channels::fanuc
