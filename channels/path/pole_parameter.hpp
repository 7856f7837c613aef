// A line that passes near the pole of a polar plane: its parameter counts both travel and the turn
// of the rotary axis.
//
// With x the distance from the foot of the perpendicular (length b) from the pole, the rotary axis
// is at C = atan(x / b). Counted along x alone, C' and its derivatives grow beyond all bounds
// at the foot, and limits that bound each term by itself let the path creep there, for before
// and behind it v and C'' would work against each other. So the record's s is
//
//     s = x + lambda * (integral of w dC)        ds/dx = q = 1 + lambda w C' >= 1
//
//      C |        .-------
//        |       |
//        |       |
//        |_______'
//         ------------- x
//
// Near the foot s counts the turn: C is driven evenly, by its own limits. Far away s counts travel,
// as that of any other record. In the plane of x and lambda C the path has two corners, as wide as
// sqrt(lambda b); the speed falls to what they allow. w is 1 in the middle, and 0 with its first
// two derivatives where the window ends, so that the neighbouring records meet without a step of
// speed or acceleration.
//
// lambda   linear axis' limits over the rotary one's (mm/rad): then both directions of that plane
//          are alike.
// Window   as far as C limits the programmed feed at all, so that elsewhere the feed is what it is;
//          never beyond the line.
// Right    Points of the line stay points of the line: only the parameter of x changes. x(s) is a
//          quintic in each piece that has the true dx/ds and d2x/ds2 at both ends; the limits are
//          taken from the quintic (record_limits_behind), not from this formula. dx/ds <= 1, and a
//          piece's feed is raised by no more than its largest dx/ds allows: the programmed feed is
//          never exceeded.
#pragma once
#include "channels/path/path_limits.hpp"
#include "ipc/kinematics/polar.hpp"

namespace polyturn::channels {

class PoleParameter {
public:
    // Of this line (path coordinates of kinematics k). Not active: it stays what it is.
    static PoleParameter of(const PathRecord& line, const Kinematics& k, const PathLimits& drives);
    bool active() const { return active_; }
    // Of a piece from `from` to `to` of the line: makes it a curve with that parameter, where it
    // lies within the window.
    void apply(double from, double to, PathRecord& piece) const;

private:
    double window(double x) const;
    double window_slope(double x) const;
    double q(double x) const { return 1 + lambda_ * window(x) * b_ / (x * x + b_ * b_); }
    double q_slope(double x) const {
        const double r2 = x * x + b_ * b_;
        return lambda_ * b_ * (window_slope(x) - window(x) * 2 * x / r2) / r2;
    }

    bool active_ = false;
    double foot_ = 0, b_ = 0, lambda_ = 0;
    double before_ = 0, behind_ = 0;  // how far the window reaches to both sides of the foot
};

}  // namespace polyturn::channels
