// One block of words: what it codes, and the order in which it acts.
#pragma once
#include "channels/language.hpp"

namespace polyturn::channels::fanuc {

struct Execution;

Step nc_block(Execution& x);

}  // namespace polyturn::channels::fanuc
