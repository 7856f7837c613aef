// G10 L50: parameters written by the program.
#pragma once
#include <string>

namespace polyturn::channels::fanuc {

struct Execution;

bool g10_parameter_block(Execution& x);
bool give_parameter(Execution& x, const std::string& line, char letter);

}  // namespace polyturn::channels::fanuc
