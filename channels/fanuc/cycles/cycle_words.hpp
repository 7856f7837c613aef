// Words that the repetitive cycles G70 to G76 share.
#pragma once
#include <optional>

#include "channels/state/core.hpp"

namespace polyturn::channels::fanuc {

struct Execution;
struct GCode;

// The first of the two blocks of a cycle: it names no contour.
bool first_of_two(const Execution& x);

bool turning_cycles_available(Execution& x, const GCode& row);
void keep_length(Execution& x, std::optional<double>& kept, char letter);
double shift_word(const Execution& x, char letter, PlaneRole role);
bool series15_count(Execution& x, char letter, double& value);

}  // namespace polyturn::channels::fanuc
