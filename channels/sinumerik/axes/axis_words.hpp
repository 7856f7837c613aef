// Where the axis words of a block want their axes: modifiers, diameters, units.
#pragma once
#include "channels/state/core.hpp"

namespace polyturn::channels::sinumerik {

struct Execution;
struct Word;

// Absolute or incremental, what G90 G91 or the word's own modifier say.
bool is_incremental(const Execution& x, const Word& word);
// Is the axis counted in diameters by an absolute word (incremental: by an incremental one)?
bool counts_diameter(const Execution& x, unsigned place, bool incremental);
AxisSet display_swapped(const Execution& x);
// true mm or degrees: unit and diameter undone
double length_mm(const Execution& x, const Word& word, int place, bool incremental);
// where the axis word wants its axis
bool axis_target(Execution& x, const Word& word, AxisValues& target);
bool take_back_released_axes(Execution& x);
// it is not released
bool has_axis(Execution& x, const Word& word);
// from path.programmed
bool read_axis_words(Execution& x, AxisValues& target, AxisSet& named);
// an axis word or one of POS
bool names_moved_axis(const Word& word);
// axes with a word in this block
AxisSet axis_words(const Execution& x);

}  // namespace polyturn::channels::sinumerik
