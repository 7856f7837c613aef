// The beginning of a program: the state it starts with.
#pragma once
#include "channels/program_files.hpp"
#include "channels/sink.hpp"

namespace polyturn::channels::fagor {

struct Execution;

// What the machine parameters say holds at the start of a program (fagor_8037t part 1, 9.1).
void clear_modal(Execution& x);
void start_program(Execution& x, FileId main);

}  // namespace polyturn::channels::fagor
