// What a program leaves to the next one in its channel.
#pragma once
#include <any>

namespace polyturn::channels::fanuc {

struct Execution;

std::any inheritance(const Execution& x);
void inherit(Execution& x, const std::any& before, bool after_reset);
// What was saved over power-off.
void recall_kept(Execution& x);

}  // namespace polyturn::channels::fanuc
