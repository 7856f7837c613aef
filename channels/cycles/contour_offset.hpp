// The equidistant of a contour: every point of it in the same distance from the contour, on one side.
#pragma once
#include "channels/cycles/contour.hpp"

namespace polyturn::channels::cycles {

// `side` +1: left of the way, -1: right of it. Outer corners become arcs about them; an inner arc that is smaller than the
// distance is left out. The contour's start (the call point) stays.
Contour equidistant(const Contour& contour, double distance, int side);
Contour translated(const Contour& contour, Point by);
// On which side of the contour's way a point beside it lies: that of its chord, or of its first element.
int side_towards(const Contour& contour, Point point);

}  // namespace polyturn::channels::cycles
