// CALL, PCALL, EXTCALL, MCALL: subprograms that are not called by their bare name.
#pragma once
#include <string>
#include <string_view>

namespace polyturn::channels::sinumerik {

struct Execution;

std::string program_of_path(std::string_view path);
bool st_call(Execution& x);
bool st_pcall(Execution& x);
bool st_extcall(Execution& x);
bool st_mcall(Execution& x);

}  // namespace polyturn::channels::sinumerik
