// Changes of values that can be put back.
#pragma once
#include <functional>

namespace polyturn::channels::sinumerik {

struct Execution;

void undo(Execution& x, std::function<void()> back);

}  // namespace polyturn::channels::sinumerik
