// Statements in round brackets: which one it is, assignments, conditions, messages (fagor_8037t
// part 2, 12.1 to 12.4).
#pragma once
#include "channels/language.hpp"

namespace polyturn::channels::fagor {

struct Execution;

Step statement_block(Execution& x);

}  // namespace polyturn::channels::fagor
