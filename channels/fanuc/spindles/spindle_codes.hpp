// Spindles in their closed loop.
#pragma once
#include "channels/fanuc/settings.hpp"

namespace polyturn::channels::fanuc {

struct Execution;

unsigned spindle_of_codes(const Execution& x);
const Settings::Indexing* indexing_of(const Execution& x, double code);
void note_loop(Execution& x, double code);
bool can_orient(Execution& x, unsigned spindle);
bool turn_spindle(Execution& x, unsigned spindle, double degrees, bool incremental, bool closed,
                  double rpm = 0);

}  // namespace polyturn::channels::fanuc
