// One step of a program: the next line, its words, and the ends of texts.
#pragma once
#include "channels/language.hpp"
#include "channels/state/core.hpp"

namespace polyturn::channels::fanuc {

struct Execution;

void end_program(Execution& x, StopReason reason);
Step read_block(Execution& x);
Step step(Execution& x);

}  // namespace polyturn::channels::fanuc
