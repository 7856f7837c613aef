// System variables #1000 and beyond, as statements write them.
#pragma once
#include <cstdint>

#include "channels/fanuc/macro/variables.hpp"

namespace polyturn::channels::fanuc {

struct Execution;

VariableStatus write_system(Execution& x, std::int64_t number, double value);

}  // namespace polyturn::channels::fanuc
