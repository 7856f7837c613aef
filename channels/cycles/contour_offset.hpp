// The equidistant of a contour: every point of it in the same distance from the contour, on one side.
#pragma once
#include "channels/cycles/contour.hpp"

namespace polyturn::channels::cycles {

// `side` +1: left of the way, -1: right of it. Outer corners become arcs about them; what would come nearer to another part of
// the contour is left out, so nothing may be left (no elements). The contour's start (the call point) stays.
Contour equidistant(const Contour& contour, double distance, int side);
Contour translated(const Contour& contour, Point by);
// Without what lies, from the end backwards, beyond `most` (sign * X or Z); perhaps no elements are left.
Contour without_end_beyond(const Contour& contour, bool in_x, double sign, double most);
// On which side of the contour's way a point beside it lies: that of its chord, or of its first element.
int side_towards(const Contour& contour, Point point);

}  // namespace polyturn::channels::cycles
