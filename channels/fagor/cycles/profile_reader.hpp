// The blocks of a profile are read as geometry (fagor_8037t part 2, 9.1.2).
#pragma once
#include "channels/cycles/contour.hpp"

namespace polyturn::channels::fagor {

struct Execution;

// Reads the blocks from S to E of the cycle's words into `part`; a blank that the profile gives
// too goes into `blank`.
bool read_profile(Execution& x, cycles::Contour& part, cycles::Contour& blank, bool& has_blank);

}  // namespace polyturn::channels::fagor
