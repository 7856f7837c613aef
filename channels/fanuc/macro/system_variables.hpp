// System variables #1000 and beyond, as expressions read them.
#pragma once
#include <cstdint>

#include "channels/fanuc/macro/variables.hpp"

namespace polyturn::channels::fanuc {

struct Execution;

VariableStatus read_system(Execution& x, std::int64_t number, double& value);

}  // namespace polyturn::channels::fanuc
