#include "channels/compensation/element.hpp"

#include <numbers>

namespace polyturn::channels::compensation {
namespace {

// sine of the angle below which two lines have no useful intersection
constexpr double kParallel = 1e-9;
constexpr double kTouch = 1e-7;  // mm: equidistants that miss each other by rounding only touch

// A contour counts as closed if its ends are no farther apart than this part of the nose's radius
// and, mm, this: 1000 steps of the path. More is meant.
constexpr double kClosedOfNose = 0.1, kClosedMm = 1.0;

struct Circle {
    Vec centre;  // seen from the corner
    double radius;
};

struct Points {
    Vec at[2];
    int count = 0;
};

// Circle about c with radius r and the line through a in direction d: foot of the perpendicular,
// then to both sides.
//     foot = a + ((c - a).d) d      h = distance from c to foot      half = sqrt(r*r - h*h)
Points meet(Vec a, Vec d, const Circle& circle) {
    const Vec foot = a + dot(circle.centre - a, d) * d;
    const double h = length(circle.centre - foot);
    if (h > circle.radius + kTouch) return {};
    const double half =
        h < circle.radius ? std::sqrt((circle.radius - h) * (circle.radius + h)) : 0.0;
    return {{foot + half * d, foot - half * d}, 2};
}

// Two circles: their common chord is perpendicular to the line of centres at distance x from the
// first centre,
//     x = (D*D + r1*r1 - r2*r2) / 2D
Points meet(const Circle& a, const Circle& b) {
    const Vec between = b.centre - a.centre;
    const double distance = length(between);
    if (distance < kTouch) return {};  // concentric: nowhere or everywhere
    const Vec along = (1.0 / distance) * between;
    const double x =
        (distance * distance + (a.radius - b.radius) * (a.radius + b.radius)) / (2.0 * distance);
    if (std::fabs(x) > a.radius + kTouch) return {};
    const double rest = (a.radius - std::fabs(x)) * (a.radius + std::fabs(x));
    const double half = rest > 0 ? std::sqrt(rest) : 0.0;
    const Vec foot = a.centre + x * along;
    return {{foot + half * left_of(along), foot - half * left_of(along)}, 2};
}

}  // namespace

Element line(Vec start, Vec end) {
    Element e;
    e.start = start;
    e.end = end;
    e.start_dir = e.end_dir = unit(end - start);
    return e;
}

Element arc(Vec start, Vec end, Vec centre, double sweep) {
    Element e;
    e.arc = true;
    e.start = start;
    e.end = end;
    e.centre = centre;
    e.sweep = sweep;
    e.start_radius = length(start - centre);
    e.end_radius = length(end - centre);
    const double turn = sweep > 0 ? 1.0 : -1.0;
    e.start_dir = turn * left_of((1.0 / e.start_radius) * (start - centre));
    e.end_dir = turn * left_of((1.0 / e.end_radius) * (end - centre));
    return e;
}

std::optional<Vec> meeting_point(const Element& a, const Element& b) {
    const Vec na = a.nose * a.normal_at_end(), nb = b.nose * b.normal_at_start();
    if (!a.arc && !b.arc) {
        const double sine = cross(a.end_dir, b.start_dir);
        if (std::fabs(sine) < kParallel) return std::nullopt;
        // na + s*da lies on b's equidistant:  cross(na + s*da - nb, db) = 0
        const double s = cross(nb - na, b.start_dir) / sine;
        return na + s * a.end_dir;
    }
    Points points;
    const Circle ca{a.centre - a.end, a.nose_path_radius(a.end_radius)},
        cb{b.centre - b.start, b.nose_path_radius(b.start_radius)};
    if ((a.arc && ca.radius < 0) || (b.arc && cb.radius < 0)) return std::nullopt;
    if (a.arc && b.arc)
        points = meet(ca, cb);
    else
        points = a.arc ? meet(nb, b.start_dir, ca) : meet(na, a.end_dir, cb);
    if (points.count == 0) return std::nullopt;
    return length(points.at[0]) <= length(points.at[1]) ? points.at[0] : points.at[1];
}

Crossings crossings(const Element& a, const Element& b) {
    const Vec na = a.start + a.nose * a.normal_at_start(),
              nb = b.start + b.nose * b.normal_at_start();
    if (!a.arc && !b.arc) {
        const double sine = cross(a.start_dir, b.start_dir);
        if (std::fabs(sine) < kParallel) return {};
        return {{na + (cross(nb - na, b.start_dir) / sine) * a.start_dir, {}}, 1};
    }
    const Circle ca{a.centre, a.nose_path_radius(a.end_radius)},
        cb{b.centre, b.nose_path_radius(b.start_radius)};
    if ((a.arc && ca.radius < 0) || (b.arc && cb.radius < 0)) return {};
    const Points points = a.arc && b.arc ? meet(ca, cb)
                          : a.arc        ? meet(nb, b.start_dir, ca)
                                         : meet(na, a.start_dir, cb);
    return {{points.at[0], points.at[1]}, points.count};
}

std::optional<Vec> closed_meeting_point(const Element& a, const Element& b, bool at_start) {
    const double gap = length(b.end - a.start);
    if ((!a.arc && !b.arc) || gap >= kClosedOfNose * a.nose || gap > kClosedMm) return std::nullopt;
    const Crossings points = crossings(a, b);
    std::optional<Vec> found;
    for (int i = 0; i < points.count; ++i)
        if (on_nose_path(a, points.at[i]) && on_nose_path(b, points.at[i]) &&
            (!found || (way_to(a, points.at[i]) < way_to(a, *found)) == at_start))
            found = points.at[i];
    if (!found) return std::nullopt;
    return *found - a.end;
}

double way_to(const Element& e, Vec point) {
    if (!e.arc) return dot(point - e.start, e.start_dir);
    const Vec from = e.start - e.centre, to = point - e.centre;
    const double turned = std::atan2(cross(from, to), dot(from, to)),
                 forward = e.sweep < 0 ? -turned : turned;
    return forward < -kTouch ? forward + 2.0 * std::numbers::pi : forward;
}

bool on_nose_path(const Element& e, Vec point) {
    const double way = way_to(e, point);
    return way > -kTouch && way < (e.arc ? std::fabs(e.sweep) : length(e.end - e.start)) + kTouch;
}

}  // namespace polyturn::channels::compensation
