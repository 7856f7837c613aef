// Curves that are no arcs in a plane of the machine.
#pragma once
#include <cstdint>

#include "channels/state/core.hpp"
#include "channels/state/frame.hpp"

namespace polyturn::channels::sinumerik {

struct Execution;
struct GCode;

bool geo_involute(Execution& x, const GCode& code);
bool frame_keeps_circles(const Execution& x);
bool arc_lies_inclined(const Execution& x);
bool drawn_arc(Execution& x, const AxisValues& target, const ArcCall& call);
bool oblique_circle(Execution& x, const Point3& a, const Point3& b, const Point3& c,
                    const AxisValues& target, std::int32_t turns);

}  // namespace polyturn::channels::sinumerik
