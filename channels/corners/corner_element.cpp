#include "channels/corners/corner_element.hpp"

#include "channels/angles.hpp"

namespace polyturn::channels::corners {
namespace {

using namespace compensation;

constexpr double kFit = 1e-6;     // mm: so much beyond the end is rounding
constexpr double kSmooth = 1e-7;  // sine of the angle below which a corner is none
constexpr int kHalvings = 60;     // of a size: far below a nanometre

Vec turned(Vec v, double angle) {
    const double c = std::cos(angle), s = std::sin(angle);
    return {c * v.p - s * v.q, s * v.p + c * v.q};
}

bool fits(const Element& a, const Element& b, const Corner& corner) {
    return corner.cut_a > -kFit && corner.cut_b > -kFit && corner.cut_a < path_length(a) + kFit &&
           corner.cut_b < path_length(b) + kFit;
}

Fit chamfer_by_leg(const Element& a, const Element& b, double leg, Corner& corner) {
    corner = {point_before_end(a, leg), point_behind_start(b, leg), false, {}, 0.0, leg, leg};
    return fits(a, b, corner) ? Fit::Made : Fit::TooLarge;
}

Fit chamfer_by_length(const Element& a, const Element& b, double size, Corner& corner) {
    const double turn =
        std::fabs(std::atan2(cross(a.end_dir, b.start_dir), dot(a.end_dir, b.start_dir)));
    if (!a.arc && !b.arc) return chamfer_by_leg(a, b, size / (2.0 * std::cos(turn / 2)), corner);
    double low = 0.0, high = std::fmin(path_length(a), path_length(b));
    const auto length_at = [&](double leg) {
        return length(point_behind_start(b, leg) - point_before_end(a, leg));
    };
    if (length_at(high) < size - kFit) return Fit::TooLarge;
    for (int n = 0; n < kHalvings; ++n) {
        const double middle = (low + high) / 2;
        (length_at(middle) < size ? low : high) = middle;
    }
    return chamfer_by_leg(a, b, high, corner);
}

// Where the circle about m touches e, and how far that is from the corner along e.
void touch(const Element& e, Vec m, bool at_end, Vec& point, double& cut) {
    if (!e.arc) {
        const Vec corner = at_end ? e.end : e.start;
        const double along = dot(m - corner, e.end_dir);
        point = corner + along * e.end_dir;
        cut = at_end ? -along : along;
        return;
    }
    const double radius = at_end ? e.end_radius : e.start_radius;
    const Vec to_corner = (at_end ? e.end : e.start) - e.centre, to_touch = unit(m - e.centre);
    point = e.centre + radius * to_touch;
    // from the corner to the touch
    double angle = std::atan2(cross(to_corner, to_touch), dot(to_corner, to_touch));
    if ((e.sweep > 0) == at_end) angle = -angle;
    // behind the corner only: in the longer direction
    if (angle < 0 && angle * radius < -kFit) angle += kTurn;
    cut = angle * radius;
}

Fit rounding(Element a, Element b, double radius, Corner& corner) {
    const int side = cross(a.end_dir, b.start_dir) > 0 ? 1 : -1;
    a.nose = b.nose = radius;
    a.side = b.side = side;
    const auto meeting = meeting_point(a, b);
    if (!meeting) return Fit::TooLarge;
    corner.arc = true;
    corner.centre = a.end + *meeting;
    if (a.arc && length(corner.centre - a.centre) < kFit) return Fit::TooLarge;
    if (b.arc && length(corner.centre - b.centre) < kFit) return Fit::TooLarge;
    touch(a, corner.centre, true, corner.from, corner.cut_a);
    touch(b, corner.centre, false, corner.to, corner.cut_b);
    const Vec from = corner.from - corner.centre, to = corner.to - corner.centre;
    corner.sweep = std::atan2(cross(from, to), dot(from, to));
    if (corner.sweep * side < 0) corner.sweep += side * kTurn;
    return fits(a, b, corner) ? Fit::Made : Fit::TooLarge;
}

// From `far` tangentially onto the circle that touches direction d in `corner`; forward: towards
// it, else away from it.
Fit tangential(Vec far, Vec corner_point, Vec d, double radius, bool forward, Corner& corner) {
    const double way = length(far - corner_point);
    const double aside = cross(d, far - corner_point);
    if (way < 2 * radius - kFit) return Fit::TooLarge;
    // on the tangent itself: no circle leads there
    if (std::fabs(aside) < kFit * way) return Fit::TooLarge;
    const double left = aside > 0 ? 1.0 : -1.0;  // the circle turns in that direction
    corner.arc = true;
    corner.centre = corner_point + (left * radius) * left_of(d);
    const Vec out = far - corner.centre;
    const double distance = length(out);
    if (distance <= radius) return Fit::TooLarge;
    const double opening = std::acos(radius / distance) * (forward ? left : -left);
    const Vec touch = corner.centre + radius * turned(unit(out), opening);
    corner.from = forward ? touch : corner_point;
    corner.to = forward ? corner_point : touch;
    const Vec from = corner.from - corner.centre, to = corner.to - corner.centre;
    corner.sweep = std::atan2(cross(from, to), dot(from, to));
    if (corner.sweep * left < 0) corner.sweep += left * kTurn;
    return Fit::Made;
}

}  // namespace

double path_length(const Element& e) {
    return e.arc ? std::fabs(e.sweep) * (e.start_radius + e.end_radius) / 2
                 : length(e.end - e.start);
}

Vec point_before_end(const Element& e, double distance) {
    if (!e.arc) return e.end - distance * e.end_dir;
    return e.centre + turned(e.end - e.centre, (e.sweep > 0 ? -distance : distance) / e.end_radius);
}

Vec point_behind_start(const Element& e, double distance) {
    if (!e.arc) return e.start + distance * e.start_dir;
    return e.centre +
           turned(e.start - e.centre, (e.sweep > 0 ? distance : -distance) / e.start_radius);
}

Fit make_corner(const Element& a, const Element& b, Shape shape, double size, Corner& corner) {
    corner = {};
    if (shape == Shape::Entry)
        return a.arc ? Fit::NotStraight
                     : tangential(a.start, a.end, b.start_dir, size, true, corner);
    if (shape == Shape::Exit)
        return b.arc ? Fit::NotStraight : tangential(b.end, a.end, a.end_dir, size, false, corner);
    if (std::fabs(cross(a.end_dir, b.start_dir)) < kSmooth) return Fit::Smooth;
    switch (shape) {
        case Shape::Rounding:
            return rounding(a, b, size, corner);
        case Shape::ChamferLeg:
            return chamfer_by_leg(a, b, size, corner);
        case Shape::ChamferLength:
            return chamfer_by_length(a, b, size, corner);
        default:
            break;
    }
    return Fit::Smooth;
}

Fit make_largest_corner(const Element& a, const Element& b, Shape shape, double size,
                        Corner& corner) {
    const Fit fit = make_corner(a, b, shape, size, corner);
    if (fit != Fit::TooLarge) return fit;
    double low = 0.0, high = size;
    for (int n = 0; n < kHalvings; ++n) {
        const double middle = (low + high) / 2;
        (make_corner(a, b, shape, middle, corner) == Fit::Made ? low : high) = middle;
    }
    return low > kFit ? make_corner(a, b, shape, low, corner) : Fit::TooLarge;
}

}  // namespace polyturn::channels::corners
