// Positions of the machine, dwell, limits of the working area: G4, G74, G75, G25, G26.
#pragma once
namespace polyturn::channels::sinumerik {

struct Execution;
struct GCode;

bool geo_dwell(Execution& x, const GCode&);
bool geo_reference(Execution& x, const GCode&);
bool geo_fixed_point(Execution& x, const GCode&);
bool geo_limits(Execution& x, const GCode& code);

}  // namespace polyturn::channels::sinumerik
