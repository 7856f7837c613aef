// What the spindles may turn at: G25 S, G26 S, LIMS.
#pragma once
#include <cstddef>

#include "ipc/params/registry.hpp"

namespace polyturn::channels::sinumerik {

struct Execution;
struct Word;

// SD43210, SD43220, SD43230
bool limits_spindle_speed(const params::Row& row);
void tell_speed_limit(Execution& x, const params::Row& row, std::size_t slot, double value);
double limited_speed(const Execution& x, double rpm);
bool ask_speed(Execution& x, double rpm);
bool refresh_speed_limit(Execution& x, bool said = false);
bool refresh_speed(Execution& x, bool said = false);
bool a_limit(Execution& x, const Word& word);
bool limit_speed(Execution& x, const Word& word, bool high);

}  // namespace polyturn::channels::sinumerik
