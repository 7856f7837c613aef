// The offset vectors of the nose centre between two elements: the rules of start-up, offset mode
// and cancel.
//
//   \  Q1 . . . . Q2          P  programmed corner, end of a and start of b
//    \  . n1    n2 .   \      n  normals to the nose's side, d directions of travel, r nose radius
//     \   .     .       \     inner corner    V = the intersection of both equidistants
//      \    . .     b    \    outer, obtuse   likewise
//   a   \----P---->       v   outer, acute    Q1 = r*(n1 + d1), Q2 = r*(n2 - d2):
//                                            each element lengthened by r
//
// The lengthening by exactly r makes the acute rule continuous with the intersection at 90 degrees.
// Source of all rules: the lathe control's compensation chapter, 3.2 to 3.7, 3.9.
#pragma once
#include <array>

#include "channels/compensation/element.hpp"
#include "channels/compensation/options.hpp"

namespace polyturn::channels::compensation {

// Offset vectors at one corner in the order in which the nose takes them; at[0] is where element a
// ends.
struct Vectors {
    std::array<Vec, 5> at{};
    std::array<bool, 5> by_arc{};  // reached by an arc about the corner
    // or by a conic: this share of the distance from the arc to the intersection (conic.hpp)
    std::array<double, 5> overshoot{};
    unsigned count = 0;
    unsigned of_first = 1;  // so many belong to a: a single block stop comes behind them
    void add(Vec v, bool arc = false, double over = 0.0) {
        at[count] = v;
        overshoot[count] = over;
        by_arc[count++] = arc;
    }
    static Vectors one(Vec v) {
        Vectors list;
        list.add(v);
        return list;
    }
};

enum class CornerFault : std::uint8_t { None, NoIntersection };

struct CornerResult {
    Vectors vectors;
    CornerFault fault = CornerFault::None;
};

enum class Turn : std::uint8_t { Inner, Obtuse, Acute, Reversal };
Turn classify(const Element& a, const Element& b);  // b's side counts

// a is the (uncompensated) block that begins compensation, b the first element of the contour.
CornerResult start_corner(const Element& a, const Element& b, const Options& options);
// Both compensated; a change of side is allowed.
CornerResult offset_corner(const Element& a, const Element& b, const Options& options);
// b is the block that ends it.
CornerResult cancel_corner(const Element& a, const Element& b, const Options& options);
// The contour would go on in direction `wish` (G40 with I, K).
CornerResult retract_corner(const Element& a, Vec wish);

// Leaves out vectors that are closer than `limit` on both axes to the one before. keep_last: what
// follows is half a turn or more and must begin on its own circle.
void drop_small(Vectors& list, double limit, bool keep_last);

}  // namespace polyturn::channels::compensation
