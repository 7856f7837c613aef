// Arcs and helices: G2, G3, CIP, CT.
#pragma once
#include "channels/state/core.hpp"

namespace polyturn::channels::sinumerik {

struct Execution;
struct GCode;

bool centre_words(Execution& x, ArcCall& call, bool& any);
bool fit_centre(Execution& x, const AxisValues& target, ArcCall& call);
bool centre_by_radius(Execution& x, const AxisValues& target, double radius, ArcCall& call);
bool geo_arc(Execution& x, const GCode& code);
bool geo_cip(Execution& x, const GCode&);
bool geo_ct(Execution& x, const GCode&);

}  // namespace polyturn::channels::sinumerik
