// Tool radius compensation: G40, G41, G42 and what shapes it.
#pragma once
namespace polyturn::channels::sinumerik {

struct Execution;
struct GCode;

bool update_compensation(Execution& x);
bool geo_comp_option(Execution& x, const GCode& code);
bool geo_comp_kind(Execution& x, const GCode& code);
bool geo_compensation(Execution& x, const GCode& code);

}  // namespace polyturn::channels::sinumerik
