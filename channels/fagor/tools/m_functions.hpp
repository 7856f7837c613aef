// M functions: those of the table with their subroutines, those that act before or behind the
// motion, and the ends of programs (fagor_8037t part 1, 5.5).
#pragma once
#include "channels/fagor/settings.hpp"

namespace polyturn::channels::fagor {

struct Execution;

// M words that act before the motion of their block, and those that act behind it.
bool m_before(Execution& x);
bool m_after(Execution& x);
// Its row in the M table; nullptr: none.
const MEntry* m_entry(const Execution& x, double code);

}  // namespace polyturn::channels::fagor
