// Sorts the words of a block: rows of G codes by group, M codes, axis words.
#pragma once
#include <cstdint>

namespace polyturn::channels::fanuc {

struct Execution;
struct GCode;

std::uint32_t drilling_name(const Execution& x, std::uint32_t tenths);
bool classify(Execution& x);
const GCode* g_row(const Execution& x, unsigned k);
bool is_macro_call(const Execution& x);

}  // namespace polyturn::channels::fanuc
