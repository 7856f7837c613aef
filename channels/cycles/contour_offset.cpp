#include "channels/cycles/contour_offset.hpp"

#include <cmath>

#include "channels/compensation/element.hpp"

namespace polyturn::channels::cycles {
namespace {

namespace comp = compensation;
using comp::Vec;

Vec vec(Point p) { return {p.z, p.x}; }
Point point(Vec v) { return {v.p, v.q}; }

comp::Element element_of(const Element& e, double distance, int side) {
    comp::Element out = e.form == Element::Form::Line ? comp::line(vec(e.from), vec(e.to)) : comp::arc(vec(e.from), vec(e.to), vec(e.centre), e.sweep);
    out.nose = distance;
    out.side = side;
    return out;
}

// Between `from` and `to` what the element becomes in the distance.
Element moved(const Element& e, const comp::Element& c, Vec from, Vec to) {
    Element out = e;
    out.from = point(from);
    out.to = point(to);
    if (!c.arc) return out;
    out.radius = c.nose_path_radius(e.radius);
    const Vec a = from - c.centre, b = to - c.centre;
    out.first_angle = std::atan2(a.q, a.p);
    double sweep = std::atan2(comp::cross(a, b), comp::dot(a, b));
    if (e.sweep > 0 && sweep < -1e-9) sweep += 2 * 3.14159265358979323846;
    if (e.sweep < 0 && sweep > 1e-9) sweep -= 2 * 3.14159265358979323846;
    out.sweep = sweep;
    return out;
}

}  // namespace

Contour equidistant(const Contour& contour, double distance, int side) {
    Contour out = contour;
    out.elements.clear();
    struct Kept {
        Element element;
        comp::Element c;
    };
    std::vector<Kept> kept;
    for (const Element& e : contour.elements) {
        const comp::Element c = element_of(e, distance, side);
        if (c.arc ? c.nose_path_radius(e.radius) > 1e-9 : comp::length(c.end - c.start) > 1e-9) kept.push_back({e, c});
    }
    if (kept.empty()) return contour;
    Vec from = kept.front().c.start + distance * kept.front().c.normal_at_start();
    out.first = point(from);
    for (std::size_t i = 0; i < kept.size(); ++i) {
        const auto& [e, a] = kept[i];
        const Vec end = a.end + distance * a.normal_at_end();
        if (i + 1 == kept.size()) {
            out.elements.push_back(moved(e, a, from, end));
            break;
        }
        const comp::Element& b = kept[i + 1].c;
        const double turn = comp::cross(a.end_dir, b.start_dir);
        const bool straight = std::fabs(turn) < 1e-9 && comp::dot(a.end_dir, b.start_dir) > 0;
        const Vec begin = b.start + distance * b.normal_at_start();
        const auto meeting = straight || turn * side > 0 ? comp::meeting_point(a, b) : std::nullopt;
        if (straight || meeting) {
            const Vec corner = straight ? end : a.end + *meeting;
            out.elements.push_back(moved(e, a, from, corner));
            from = corner;
            continue;
        }
        out.elements.push_back(moved(e, a, from, end));
        Element arc;   // about the corner
        arc.at = kept[i + 1].element.at;
        arc.from = point(end);
        arc.to = point(begin);
        arc.centre = point(a.end);
        arc.radius = distance;
        const Vec u = end - a.end, w = begin - a.end;
        arc.first_angle = std::atan2(u.q, u.p);
        arc.sweep = std::atan2(comp::cross(u, w), comp::dot(u, w));
        arc.form = arc.sweep > 0 ? Element::Form::ArcCcw : Element::Form::ArcCw;
        out.elements.push_back(arc);
        from = begin;
    }
    return out;
}

Contour translated(const Contour& contour, Point by) {
    Contour out = contour;
    const auto shift = [by](Point& p) { p.z += by.z, p.x += by.x; };
    shift(out.first);
    for (Element& e : out.elements) shift(e.from), shift(e.to), shift(e.centre);
    return out;
}

int side_towards(const Contour& contour, Point p) {
    const auto cross = [p](Point a, Point b) { return (b.z - a.z) * (p.x - a.x) - (b.x - a.x) * (p.z - a.z); };
    double sum = cross(contour.first, contour.end());
    if (std::fabs(sum) < 1e-7 && !contour.elements.empty()) sum = cross(contour.elements.front().from, contour.elements.front().to);
    return sum > 0 ? 1 : -1;
}

}  // namespace polyturn::channels::cycles
