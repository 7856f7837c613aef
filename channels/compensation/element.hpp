// One programmed line or arc in the plane of compensation, and where its equidistant meets that of
// the next one.
//
// The plane has a first axis p and a second axis q (G18: Z and X), both in true millimetres, X as a
// radius. A left turn is one from p towards q. `side` is +1 when the nose is left of the path, -1
// when it is right of it.
#pragma once
#include <cmath>
#include <optional>

namespace polyturn::channels::compensation {

struct Vec {
    double p = 0.0, q = 0.0;
    friend Vec operator+(Vec a, Vec b) { return {a.p + b.p, a.q + b.q}; }
    friend Vec operator-(Vec a, Vec b) { return {a.p - b.p, a.q - b.q}; }
    friend Vec operator*(double k, Vec a) { return {k * a.p, k * a.q}; }
};
inline double dot(Vec a, Vec b) { return a.p * b.p + a.q * b.q; }
inline double cross(Vec a, Vec b) { return a.p * b.q - a.q * b.p; }  // > 0: b points left of a
inline double length(Vec a) { return std::hypot(a.p, a.q); }
inline Vec unit(Vec a) { return (1.0 / length(a)) * a; }
inline Vec left_of(Vec d) { return {-d.q, d.p}; }

struct Element {
    bool arc = false;
    Vec start, end;
    Vec start_dir, end_dir;  // unit, direction of travel
    Vec centre;              // arcs
    double start_radius = 0.0, end_radius = 0.0;
    double sweep = 0.0;  // rad, > 0 left
    // The nose that cuts it.
    double nose = 0.0;  // radius, not negative
    int side = 1;

    Vec normal_at_start() const { return static_cast<double>(side) * left_of(start_dir); }
    Vec normal_at_end() const { return static_cast<double>(side) * left_of(end_dir); }
    bool centre_on_nose_side() const { return (sweep > 0) == (side > 0); }
    // Radius of the nose centre's circle about the same centre; negative: the nose is larger than
    // the arc.
    double nose_path_radius(double radius) const {
        return centre_on_nose_side() ? radius - nose : radius + nose;
    }
};

Element line(Vec start, Vec end);
// The radii at both ends may differ a little: each end has its own circle about the centre.
Element arc(Vec start, Vec end, Vec centre, double sweep);

// Offset vector from the corner (a.end, b.start) to the point nearest to it where the nose centre's
// path along a meets that along b, both taken without ends; nothing where they do not meet.
std::optional<Vec> meeting_point(const Element& a, const Element& b);

// The end of b lies where a begins, nearly: of the two points that the paths inside have in common,
// the one that the nose comes to first (at_start) or last along a (sinumerik_part2 11.1, closed
// contours). Nothing where the contour is not such a one.
std::optional<Vec> closed_meeting_point(const Element& a, const Element& b, bool at_start);

// Where the nose centre's paths along two elements meet that need not be neighbours: points of the
// plane, both taken without ends. on_nose_path: does the nose centre really pass the point between
// the normals at both ends of the element?
struct Crossings {
    Vec at[2];
    int count = 0;
};
Crossings crossings(const Element& a, const Element& b);
bool on_nose_path(const Element& e, Vec point);
// along the nose centre's path, from the normal at the start; arcs: in rad
double way_to(const Element& e, Vec point);

}  // namespace polyturn::channels::compensation
