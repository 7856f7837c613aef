// The transition at an outer corner between the arc and the intersection (sinumerik_part2 11.3,
// DISC).
//
//          C               P  corner, |P A| = |P B| = r      A, B  normals at the corner
//        .' '.             C  intersection of the equidistants, which touch the conic in A and B
//      A.  S  .B           M  middle of A B, h half the angle between the normals
//        '.M.'             S  the conic's top on P C, where the arc has |P S| = r
//          P
//
// Overshoot o in [0, 1):  |P S| = r + o (|P C| - r)        |P M| = r cos h   |P C| = r / cos h
// A conic that touches C A and C B has its top at S = M + q (C - M) with q = w / (1 + w), w the
// weight of C in
//     X(t) = ((1-t)^2 A + 2 w t (1-t) C + t^2 B) / ((1-t)^2 + 2 w t (1-t) + t^2)
// o = 0 gives w = cos h, the arc; q < 1/2 is an ellipse, 1/2 a parabola, beyond it a hyperbola. At
// o = 1 it would be A C B. The specification fixes both ends and the kind of curve; that the
// overshoot grows evenly with DISC is our reading.
#pragma once
#include <vector>

#include "channels/compensation/element.hpp"

namespace polyturn::channels::compensation {

// Points of the conic between `from` and `to`, without them: chords leave it by less than 0.5 um.
std::vector<Vec> conic_about(Vec from, Vec to, Vec corner, double overshoot);

}  // namespace polyturn::channels::compensation
