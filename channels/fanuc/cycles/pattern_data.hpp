// G65 H90 to H94: pattern menu and pattern data.
#pragma once
#include <cstdint>

namespace polyturn::channels::fanuc {

struct Execution;

bool g_pattern_data(Execution& x, std::int64_t kind);
bool ends_program(const Execution& x);
bool pattern_dialogue(Execution& x, bool& done);

}  // namespace polyturn::channels::fanuc
