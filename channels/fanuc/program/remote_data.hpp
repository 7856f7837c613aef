// G5 and M198: data and programs that somebody else sends.
#pragma once
#include <cstdint>

#include "channels/language.hpp"

namespace polyturn::channels::fanuc {

struct Execution;
struct GCode;

bool g_binary_input(Execution& x, const GCode&);
Step binary_step(Execution& x);
bool external_call(Execution& x, std::int64_t number, std::int64_t repeats);
Step external_step(Execution& x);

}  // namespace polyturn::channels::fanuc
