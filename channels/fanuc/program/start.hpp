// Cycle start: what holds before the first block.
#pragma once
#include "channels/program_files.hpp"

namespace polyturn::channels::fanuc {

struct Execution;

void clear_modal(Execution& x);
void start_program(Execution& x, FileId main);

}  // namespace polyturn::channels::fanuc
