// What the program takes out of the operator's hands: single block, stop, feed hold, spindle
// override (ESBLK DSBLK, DSTOP ESTOP, DFHOLD EFHOLD, PRGSSO).
#pragma once
#include <string_view>

#include "channels/fagor/statements/statement_text.hpp"

namespace polyturn::channels::fagor {

struct Execution;

// In path order (12.3). `group_ends`: what ESBLK has begun is over.
void tell_control(Execution& x, bool group_ends);
Flow control_statement(Execution& x, std::string_view word, const char*&, const char*);

}  // namespace polyturn::channels::fagor
