// A function that begins before the rapid move in front of it has come to rest (N0421 ROL).
#pragma once
#include "kernel/channel/channel.hpp"

namespace polyturn::kernel {

// N0421 ROL (nct_parameters_part1 6.4): a block without movement behind a rapid move begins when
// that is braking to its end and each of its axes has fallen below its share of rapid (N0422).
void begin_function_early(Channel& c) noexcept;

}  // namespace polyturn::kernel
