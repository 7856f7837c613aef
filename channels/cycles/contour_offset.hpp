// The equidistant of a contour: every point of it in the same distance from the contour, on one
// side.
#pragma once
#include "channels/cycles/contour.hpp"

namespace polyturn::channels::cycles {

// `side` +1: left of the way, -1: right of it. Outer corners become arcs about them; what would
// come nearer to another part of the contour is left out, so nothing may be left (no elements). The
// contour's start (the call point) stays.
Contour equidistant(const Contour& contour, double distance, int side);
Contour translated(const Contour& contour, Point by);
// Without what lies, from the end backwards, beyond `most` (sign * X or Z); perhaps no elements are
// left.
Contour without_end_beyond(const Contour& contour, bool in_x, double sign, double most);
// On which side of the contour's way the tool works that comes from a point: the infeed is along X
// (else along Z), and the contour's direction across it distinguishes left from right; a point that
// is far aside says nothing about its own side of the chord.
int side_towards(const Contour& contour, Point point, bool infeed_in_x);

}  // namespace polyturn::channels::cycles
