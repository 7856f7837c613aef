// The chamfer or the rounding between two elements of a contour: where each of them ends, and what
// lies between.
//
//        a  ---------F             F  end of what is left of a, cut_a before the corner C along a
//                     \            T  begin of what is left of b, cut_b behind the corner along b
//                      T
//                      |  b
//
// Rounding   its centre M is where the equidistants of a and b in distance r meet on the inner
//            side; F, T nearest to M
// Leg        cut_a = cut_b = size, measured along the elements
// Length     |FT| = size with cut_a = cut_b; two lines that turn by d: cut = size / (2 cos(d/2))
// Entry      a, a line, leaves its own way: it goes tangentially onto a circle that touches b where
//            b begins (T = C). Its centre lies on the side of a's start; at least twice the radius
//            lies between start and corner (fagor 6.7)
// Exit       the mirror image: the circle touches a where a ends (F = C), b, a line, leaves it
//            tangentially (fagor 6.8)
#pragma once
#include "channels/compensation/element.hpp"

namespace polyturn::channels::corners {

using compensation::Element;
using compensation::Vec;

enum class Shape : unsigned char { Rounding, ChamferLeg, ChamferLength, Entry, Exit };

struct Corner {
    Vec from, to;  // F, T
    bool arc = false;
    Vec centre;
    double sweep = 0.0;               // rad, > 0 left
    double cut_a = 0.0, cut_b = 0.0;  // mm along the elements
};

enum class Fit : unsigned char {
    Made,
    // the elements go over into each other, or straight back: there is no corner to work on
    Smooth,
    TooLarge,
    NotStraight,  // Entry, Exit: the block that it bends is an arc
};

double path_length(const Element& e);
Vec point_before_end(const Element& e, double distance);
Vec point_behind_start(const Element& e, double distance);

Fit make_corner(const Element& a, const Element& b, Shape shape, double size, Corner& corner);
// Likewise; a size that does not fit is made smaller until it does.
Fit make_largest_corner(const Element& a, const Element& b, Shape shape, double size,
                        Corner& corner);

}  // namespace polyturn::channels::corners
