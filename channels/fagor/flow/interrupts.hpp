// INT1 to INT4: an input interrupts the program by a subroutine (fagor_8037t part 2, 12.6).
//
// The kernel stops the path, drops what was pushed and reports the first block that is not
// executed. Interpretation goes back there and the subroutine is called as if it were before that
// block; it keeps the local parameters. Behind RET the block in which the program was left is
// driven to its end, from wherever the subroutine (or its REPOS) has left the axes.
#pragma once
#include <cstdint>

namespace polyturn::channels::fagor {

struct Execution;

// The kernel watches the inputs that have a subroutine.
void arm_interrupts(Execution& x);
// See Language::interrupt.
bool enter_interrupt(Execution& x, std::uint64_t serial, bool within, unsigned input);
// For the block that is read again behind RET.
void stay_where_left(Execution& x);
bool return_from_interrupt(Execution& x);

}  // namespace polyturn::channels::fagor
