// Turns many short lines along a smooth curve, as CAM systems write them, into one smooth curve
// within tolerance.
//
//   programmed  ----A----o-o--o-o-o--o-----B-----        o vertices of short lines
//   curve            M===c====c======c==M'               c control points of a cubic B-spline,
//                                                        M and M' on A and B
//
// Why: blends that fit into short lines have no curvature where they meet, so it swings between 0
// and twice its mean, and with 0.1 mm lines jerk allows a few percent of the speed that the curve
// itself does. A spline over several lines also averages what rounding to 0.001 mm does to their
// directions.
//
// Given    vertices P, tolerance e
// Choose   knots among the vertices, greedily: what lies between two of them leaves their chord by
//          at most kSkipShare e, and the curve leaves a knot by at most kTurnShare e (2). Knot
//          intervals h are the chord lengths, so the speed over the parameter is nearly even.
// Control  the blossom of the parabola through a knot P and its neighbours, which keeps quadratic
//          motion exact, whatever the intervals: with its slope and half its bend, q1 and q2, over
//          the chord lengths,
//              Q = P + q1 (h+ - h-)/3 - q2 h- h+ / 3                                            (1)
//          The curve then leaves P by a sixth to a third of d = q2 h- h+ / 3:
//              A d- - (A + C) d + C d+   (uniform: A = C = 1/6)                                 (2)
// Ends     M lies on the line before, M' on the line behind; a mirrored control point beyond each
//          makes the curve begin and end there exactly, tangent to the line and without curvature,
//          so what is before and behind needs no more. The first and the last vertex are knots,
//          their control points stay on the outer lines.
// Pieces   each programmed block keeps its own records: the curve is cut where the path passes its
//          end.
// Right    a cubic B-spline has continuous second derivative. The deviation is tested by dense
//          sampling, both ways, against the programmed polyline.
// Weakness knots are programmed vertices with their rounding; an optimal smoothing would average
//          all of them.
// Source   de Boor, A Practical Guide to Splines; knots and Bezier points as in Farin, Curves and
//          Surfaces, 5.4.
#pragma once
#include <array>
#include <vector>

#include "channels/path/blend.hpp"

namespace polyturn::channels {

// of the tolerance: what the curve would leave a corner by, without (1)
inline constexpr double kCornerShare = 0.8;
inline constexpr double kSkipShare = 0.5, kTurnShare = 0.3;
inline constexpr double kMostTurn = 0.25;  // rad; a sharper corner is meant as a corner
// mm: two lines of which none is shorter are not short lines
inline constexpr double kLongestShort = 5.0;
// of a length over that of its neighbour: the curve's parameter stays even
inline constexpr double kMostGrowth = 2.5;
inline constexpr std::size_t kMostSkipped = 64;  // vertices between two control points

// Whether the corner between two lines is one of a smooth curve. Slots, rates and metric must
// agree, the caller looks at flags. A run does not begin where there is no turn at all (`begins`).
bool is_short_corner(const PathRecord& before, const PathRecord& after, bool begins,
                     const PathLimits& limits, const Smoothing& smoothing = {});
// How far a run of such lines may leave them.
double run_tolerance(const PathRecord& line, const PathLimits& limits, const Smoothing& smoothing);

using SplinePoint = std::array<double, kMaxCurveAxes>;

// The curve over vertices that come one by one. Axes are those of the lines, in their order.
class SplineRun {
public:
    struct Piece {
        // number of the programmed line that it belongs to, from 0 (the one that ends at the first
        // vertex)
        std::size_t line;
        bool last_of_line;
        double turn;  // rad, the sharper of the programmed turns at the line's ends
        BlendPiece curve;
    };
    // from: M; axes: how many; measured: which of them count in the path's length.
    void begin(const SplinePoint& from, std::size_t axes,
               const std::array<bool, kMaxCurveAxes>& measured, double tolerance);
    void add_vertex(const SplinePoint& vertex);  // end of the next programmed line
    void end(const SplinePoint& to);             // M', on the line behind the last vertex
    // Pieces that are final, in order; taken by the caller.
    std::vector<Piece>& ready() { return ready_; }

private:
    using Cubic = std::array<std::array<double, 6>, kMaxCurveAxes>;
    struct Control {
        SplinePoint point;   // P
        std::size_t vertex;  // its index in path_; 0 is M
        SplinePoint used{};  // Q
        bool fixed = false;  // next to an end
    };
    double distance(const SplinePoint& a, const SplinePoint& b) const;
    double turn_at(const SplinePoint& a, const SplinePoint& b, const SplinePoint& c) const;
    bool chord_fits(std::size_t to) const;
    bool skips_well(std::size_t from, std::size_t to) const;
    void add_control(std::size_t vertex);
    double interval(std::ptrdiff_t i) const;
    SplinePoint beside(std::size_t control) const;
    void place_used(std::size_t control);
    void make_spans(bool all);
    void make_span(std::size_t span, bool last_span);
    void add_piece(const Cubic& cubic, double from, double to, Piece piece, int depth);
    const SplinePoint& path(std::size_t vertex) const { return path_[vertex - dropped_]; }

    std::size_t axes_ = 0;
    std::array<bool, kMaxCurveAxes> measured_{};
    double tolerance_ = 0;
    // M, vertices, M'; those already used up are dropped from the front
    std::vector<SplinePoint> path_;
    std::size_t dropped_ = 0;       // how many were dropped
    std::vector<Control> control_;  // with the mirrored ones
    std::vector<double> interval_;  // of control i to i + 1
    std::size_t next_span_ = 1;     // from control i to i + 1
    std::size_t next_used_ = 2;     // first control without its Q
    std::vector<Piece> ready_;
};

}  // namespace polyturn::channels
