// Chamfers, corners R and lines by their angle.
#pragma once
#include "channels/state/core.hpp"
#include "channels/text/word_scanner.hpp"

namespace polyturn::channels::fanuc {

struct Execution;

bool corner_word(Execution& x, const Word& word);
bool lathe_corner(Execution& x, AxisSet named);
bool follows_corner(Execution& x, const AxisValues& target, bool line);
const Word* angle_word(const Execution& x);
bool angle_line(Execution& x, AxisSet named);

}  // namespace polyturn::channels::fanuc
