// EGDEF, EGON, EGOF: an axis that follows several others by ratios.
#pragma once
namespace polyturn::channels::sinumerik {

struct Call;
struct Execution;

bool p_gear_define(Execution& x, Call& c);
bool p_gear_on(Execution& x, Call& c);
bool p_gear_off(Execution& x, Call& c);

}  // namespace polyturn::channels::sinumerik
