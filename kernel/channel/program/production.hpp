// Making parts: how many are wanted and made, the end after this one, and the warm-up.
#pragma once
#include "kernel/channel/channel.hpp"

namespace polyturn::kernel {

// A Part record is executed: the counters go on (N2306, N2307), and the program may be at its end
// with it.
void part_made(Channel& c) noexcept;
void end_lap(Channel& c) noexcept;
// #3901 and #3902 are N2307 and N2308 (nct_parameters_part2 24): a program that writes them sets
// the counters. True: it was one.
bool part_counter(Channel& c, std::string_view variable, double value) noexcept;
// Once a tick.
void watch_production(Channel& c) noexcept;

}  // namespace polyturn::kernel
