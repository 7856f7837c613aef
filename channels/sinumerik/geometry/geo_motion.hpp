// Straight lines, and what every move of a contour has in common.
#pragma once
#include <array>
#include <cstddef>
#include <functional>

#include "channels/state/core.hpp"

namespace polyturn::channels::sinumerik {

struct Execution;
struct GCode;
struct Word;

// geometry (geo_*.cpp)
std::array<std::size_t, 2> plane_places(Execution& x);
bool needs_plane(Execution& x);
bool driven(Execution& x, const std::function<bool()>& drive);
bool corner_words(Execution& x, bool contour);
bool go_line(Execution& x, const AxisValues& wanted, bool rapid);
void note_tangent(Execution& x, const AxisValues& from, const AxisValues& to);
bool polar_ahead(const Execution& x);
bool polar_target(Execution& x, AxisValues& target);
bool geo_pole(Execution& x, const GCode& code);
bool geo_motion(Execution& x, const GCode& code);
bool a_geometry(Execution& x, const Word& word);

}  // namespace polyturn::channels::sinumerik
