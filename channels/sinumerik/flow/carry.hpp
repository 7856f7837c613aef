// What a program leaves to the next one of its channel, and what the operator changes under it.
#pragma once
#include <any>

namespace polyturn::channels::sinumerik {

struct Execution;

std::any carry(const Execution& x);
void take_carry(Execution& x, const std::any& before, bool after_reset);
bool offsets_changed(Execution& x);

}  // namespace polyturn::channels::sinumerik
