// What holds when a program begins.
#pragma once
#include <optional>

#include "ipc/diagnosis/diagnosis.hpp"

namespace polyturn::channels::sinumerik {

struct Execution;

std::optional<Diagnosis> reset_value_fault(const Execution& x);
void reset_modal(Execution& x);

}  // namespace polyturn::channels::sinumerik
