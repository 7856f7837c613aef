// The arguments of functions, procedures and programs.
#pragma once
#include <string>
#include <vector>

#include "channels/sinumerik/grammar/tables.hpp"

namespace polyturn::channels::sinumerik {

struct Execution;

bool read_program_arguments(Execution& x, const std::string&, std::vector<Argument>& arguments);
bool read_arguments(Execution& x, const Command& command, Call& call);

}  // namespace polyturn::channels::sinumerik
