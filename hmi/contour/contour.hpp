// A contour of lines and arcs that is described as a drawing describes it: each element by any data
// that suffice, alone or together with the elements behind it. What is not given is computed.
//
//   start Z0 X10 | line, angle 180 | arc cw, tangential, R 5, end Z-30 | line, angle 135, X 30
//                  '-- open alone --'--------- solved together ----------'
//
// All lengths are mm, X is a radius here, angles are degrees from +Z towards +X. No Qt. Source of
// the equations: plane geometry; the solver is in solve.cpp, chamfers and roundings in
// transitions.cpp.
#pragma once
#include <optional>
#include <string>
#include <vector>

namespace polyturn::contour {

struct Point {
    double z = 0.0, x = 0.0;
};

enum class Kind : unsigned char { Line, ArcCw, ArcCcw };

struct Element {
    Kind kind = Kind::Line;
    std::optional<double> z, x;    // end point
    std::optional<double> dz, dx;  // end point from the start of the element
    std::optional<double> length;  // lines
    std::optional<double> angle;   // direction at the start
    // arcs: end_angle is the direction at the end, sweep the angle it turns through
    std::optional<double> radius, centre_z, centre_x, end_angle, sweep;
    bool tangent = false;               // to the element before
    double chamfer = 0.0, round = 0.0;  // between it and the next one; at most one of them
    int solution = 0;                   // which of several
};

struct Contour {
    Point start;
    std::vector<Element> elements;
};

// What an element is in the end.
struct Piece {
    enum class Role : unsigned char { Element, Chamfer, Round } role = Role::Element;
    Kind kind = Kind::Line;
    Point from, to, centre;
    double radius = 0.0, sweep = 0.0;  // arcs; sweep in degrees, 0 to 360
    std::size_t element = 0;           // whose it is; of a transition: that before it
};

enum class State : unsigned char {
    Known,
    Open,           // data are missing
    Contradiction,  // its data exclude each other, or nothing fits
    NoRoom,         // chamfer or rounding does not fit
    NothingBefore,  // tangential, but nothing lies before it
};

struct Solved {
    std::vector<State> states;  // one for each element
    // data that it (with those before it that are open) still needs
    std::vector<int> missing;
    std::vector<Piece> pieces;  // with transitions, as far as it is known
    // Of the elements that were solved together: the last one's index has all solutions, each the
    // pieces of the group.
    struct Choice {
        std::size_t first = 0, last = 0;
        std::vector<std::vector<Piece>> solutions;
        std::size_t chosen = 0;
    };
    std::vector<Choice> choices;  // only where there are several
    bool complete() const;
};

Solved solve(const Contour& contour);

// The direction of a piece, degrees.
double direction_at_start(const Piece& piece);
double direction_at_end(const Piece& piece);

// --- used by the parts of the solver
double norm360(double degrees);  // 0 up to, not including, 360
bool add_transitions(const Contour& contour, std::vector<Piece>& pieces,
                     std::vector<State>& states);

}  // namespace polyturn::contour
