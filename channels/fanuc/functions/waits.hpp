// Waiting codes: which channels meet.
#pragma once
#include "channels/text/word_scanner.hpp"

namespace polyturn::channels::fanuc {

struct Execution;

bool wait_code(Execution& x, const Word& word);

}  // namespace polyturn::channels::fanuc
