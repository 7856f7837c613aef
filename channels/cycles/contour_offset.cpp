#include "channels/cycles/contour_offset.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "channels/compensation/element.hpp"

namespace polyturn::channels::cycles {
namespace {

namespace comp = compensation;
using comp::Vec;

constexpr double kShortest = 1e-6;  // mm: shorter is nothing
// mm: what is nearer to the contour than the distance by more than this is cut off
constexpr double kNearer = 1e-3;
constexpr double kGap = 0.05;  // mm: ends of arcs may miss each other by the arc tolerance

Vec vec(Point p) { return {p.z, p.x}; }
Point point(Vec v) { return {v.p, v.q}; }

comp::Element element_of(const Element& e, double distance, int side) {
    comp::Element out = e.form == Element::Form::Line
                            ? comp::line(vec(e.from), vec(e.to))
                            : comp::arc(vec(e.from), vec(e.to), vec(e.centre), e.sweep);
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
    if (e.sweep > 0 && sweep < -1e-9) sweep += 2 * std::numbers::pi;
    if (e.sweep < 0 && sweep > 1e-9) sweep -= 2 * std::numbers::pi;
    out.sweep = sweep;
    return out;
}

Element about_corner(const comp::Element& a, const comp::Element& b, double distance,
                     const BlockContext& at) {
    Element arc;
    arc.at = at;
    const Vec u = distance * a.normal_at_end(), w = distance * b.normal_at_start();
    arc.from = point(a.end + u);
    arc.to = point(b.start + w);
    arc.centre = point(a.end);
    arc.radius = distance;
    arc.first_angle = std::atan2(u.q, u.p);
    arc.sweep = std::atan2(comp::cross(u, w), comp::dot(u, w));
    arc.form = arc.sweep > 0 ? Element::Form::ArcCcw : Element::Form::ArcCw;
    return arc;
}

double length_of(const Element& e) {
    return e.form == Element::Form::Line ? comp::length(vec(e.to) - vec(e.from))
                                         : std::fabs(e.sweep) * e.radius;
}

Vec at_way(const Element& e, double way) {  // mm along it
    if (e.form == Element::Form::Line)
        return vec(e.from) + way * comp::unit(vec(e.to) - vec(e.from));
    const double angle = (e.sweep < 0 ? -way : way) / e.radius, c = std::cos(angle),
                 s = std::sin(angle);
    const Vec r = vec(e.from) - vec(e.centre);
    return vec(e.centre) + Vec{r.p * c - r.q * s, r.p * s + r.q * c};
}

double distance_to(const Element& e, Vec p) {
    const double ends = std::fmin(comp::length(p - vec(e.from)), comp::length(p - vec(e.to)));
    const comp::Element c = element_of(e, 0.0, 1);
    const double way = comp::way_to(c, p);
    if (!c.arc)
        return way > 0 && way < comp::length(c.end - c.start)
                   ? std::fabs(comp::cross(c.start_dir, p - c.start))
                   : ends;
    return way > 0 && way < std::fabs(e.sweep)
               ? std::fmin(ends, std::fabs(comp::length(p - c.centre) - e.radius))
               : ends;
}

// Every element in the distance for itself, arcs about outer corners; where neighbours meet at an
// inner one, they end there.
std::vector<Element> raw_pieces(const Contour& contour, double distance, int side) {
    std::vector<Element> out;
    const Element* before = nullptr;
    std::optional<comp::Element> a;
    bool a_kept = false;
    for (const Element& e : contour.elements) {
        const comp::Element b = element_of(e, distance, side);
        if (!b.arc && comp::length(b.end - b.start) <= kShortest) continue;
        const bool kept = !b.arc || b.nose_path_radius(e.radius) > kShortest;
        Vec from = b.start + distance * b.normal_at_start();
        if (a) {
            const double turn = comp::cross(a->end_dir, b.start_dir);
            const bool straight = std::fabs(turn) < 1e-9 && comp::dot(a->end_dir, b.start_dir) > 0;
            if (!straight && turn * side > 0 && a_kept && kept) {
                const auto meeting = comp::meeting_point(*a, b);
                if (const Vec corner = a->end + meeting.value_or(Vec{});
                    meeting && comp::on_nose_path(*a, corner) && comp::on_nose_path(b, corner)) {
                    // Between two inner corners that need more length than it has, the element is
                    // turned round: it disappears.
                    if (comp::way_to(*a, corner) >
                        comp::way_to(*a, vec(out.back().from)) + kShortest)
                        out.back() = moved(*before, *a, vec(out.back().from), corner);
                    else
                        out.pop_back();
                    from = corner;
                }
            } else if (!straight && turn * side <= 0) {
                out.push_back(about_corner(*a, b, distance, e.at));
            }
        }
        if (kept) out.push_back(moved(e, b, from, b.end + distance * b.normal_at_end()));
        a = b;
        before = &e;
        a_kept = kept;
    }
    return out;
}

// Ways (mm) at which the pieces cross others, or come nearer to one of the ends of the contour than
// the distance.
std::vector<std::vector<double>> crossings_of(const std::vector<Element>& pieces, Vec first,
                                              Vec last, double distance) {
    std::vector<std::vector<double>> cuts(pieces.size());
    std::vector<comp::Element> plain;
    plain.reserve(pieces.size());
    for (const Element& e : pieces) plain.push_back(element_of(e, 0.0, 1));
    const auto way = [&](std::size_t i, Vec p) {
        return comp::way_to(plain[i], p) * (plain[i].arc ? pieces[i].radius : 1.0);
    };
    for (std::size_t i = 0; i < pieces.size(); ++i) {
        for (std::size_t j = i + 1; j < pieces.size(); ++j) {
            const comp::Crossings found = comp::crossings(plain[i], plain[j]);
            for (int k = 0; k < found.count; ++k) {
                const double u = way(i, found.at[k]), v = way(j, found.at[k]);
                if (u < 0 || u > length_of(pieces[i]) || v < 0 || v > length_of(pieces[j]))
                    continue;
                cuts[i].push_back(u);
                cuts[j].push_back(v);
            }
        }
    }
    for (const Vec end : {first, last}) {
        const Vec begin = end + Vec{distance, 0.0};
        const comp::Element around = comp::arc(begin, begin, end, 2 * std::numbers::pi);
        for (std::size_t i = 0; i < pieces.size(); ++i) {
            const comp::Crossings found = comp::crossings(plain[i], around);
            for (int k = 0; k < found.count; ++k)
                if (const double u = way(i, found.at[k]); u >= 0 && u <= length_of(pieces[i]))
                    cuts[i].push_back(u);
        }
    }
    for (auto& list : cuts) std::ranges::sort(list);
    return cuts;
}

Element between(const Element& e, double from, double to) {
    Element out = e;
    if (from > 0) out.from = point(at_way(e, from));
    if (to < length_of(e)) out.to = point(at_way(e, to));
    if (e.form != Element::Form::Line) {
        const Vec a = vec(out.from) - vec(e.centre);
        out.first_angle = std::atan2(a.q, a.p);
        out.sweep = std::copysign((to - from) / e.radius, e.sweep);
    }
    return out;
}

}  // namespace

// The pieces in the distance, without what is nearer to another part of the contour: a step or an
// inner arc that is smaller than the distance disappears, and its neighbours end where they meet.
Contour equidistant(const Contour& contour, double distance, int side) {
    Contour out = contour;
    out.elements.clear();
    const std::vector<Element> pieces = raw_pieces(contour, distance, side);
    const auto cuts = crossings_of(pieces, vec(contour.first), vec(contour.end()), distance);
    for (std::size_t i = 0; i < pieces.size(); ++i) {
        const double whole = length_of(pieces[i]);
        double from = 0.0;
        for (std::size_t k = 0; k <= cuts[i].size(); ++k) {
            const double to = k == cuts[i].size() ? whole : cuts[i][k];
            if (to - from <= kShortest) continue;
            const Vec middle = at_way(pieces[i], (from + to) / 2);
            const bool clear = std::ranges::all_of(contour.elements, [&](const Element& e) {
                return distance_to(e, middle) > distance - kNearer;
            });
            const Element part = between(pieces[i], from, to);
            from = to;
            if (!clear) continue;
            if (!out.elements.empty()) {
                Element& last = out.elements.back();
                // an island beyond a narrow place
                if (comp::length(vec(part.from) - vec(last.to)) > kGap) continue;
                if (k > 0 && last.at.line == part.at.line && last.form == part.form &&
                    last.centre.z == part.centre.z && last.centre.x == part.centre.x &&
                    comp::length(vec(part.from) - vec(last.to)) <= kShortest &&
                    (last.form != Element::Form::Line ||
                     std::fabs(comp::cross(comp::unit(vec(last.to) - vec(last.from)),
                                           vec(part.to) - vec(part.from))) < kShortest)) {
                    // the same piece goes on behind a crossing that does not count
                    last.to = part.to;
                    last.sweep += part.sweep;
                    continue;
                }
            }
            out.elements.push_back(part);
        }
    }
    if (!out.elements.empty()) out.first = out.elements.front().from;
    return out;
}

Contour translated(const Contour& contour, Point by) {
    Contour out = contour;
    const auto shift = [by](Point& p) {
        p.z += by.z;
        p.x += by.x;
    };
    shift(out.first);
    for (Element& e : out.elements) {
        shift(e.from);
        shift(e.to);
        shift(e.centre);
    }
    return out;
}

Contour without_end_beyond(const Contour& contour, bool in_x, double sign, double most) {
    Contour out = contour;
    const auto over = [&](Point p) { return sign * (in_x ? p.x : p.z) - most; };
    const auto beyond = [&](Point p) { return over(p) > kShortest; };
    while (!out.elements.empty() && beyond(out.elements.back().to)) {
        const Element last = out.elements.back();
        out.elements.pop_back();
        if (beyond(last.from)) continue;
        double low = 0.0, high = length_of(last);  // the travel at which it reaches the limit
        for (int k = 0; k < 60; ++k) {
            const double middle = (low + high) / 2;
            (over(point(at_way(last, middle))) > 0 ? high : low) = middle;
        }
        if (low > kShortest) out.elements.push_back(between(last, 0.0, low));
        break;
    }
    return out;
}

int side_towards(const Contour& contour, Point p, bool infeed_in_x) {
    const Point first = contour.first, end = contour.end();
    // left of +Z is +X, left of -X is +Z
    const double way = infeed_in_x ? end.z - first.z : first.x - end.x;
    const bool above = infeed_in_x ? p.x >= first.x : p.z >= first.z;
    if (std::fabs(way) > kShortest) return (way > 0) == above ? 1 : -1;
    const auto cross = [p](Point a, Point b) {
        return (b.z - a.z) * (p.x - a.x) - (b.x - a.x) * (p.z - a.z);
    };
    double sum = cross(first, end);
    if (std::fabs(sum) < 1e-7 && !contour.elements.empty())
        sum = cross(contour.elements.front().from, contour.elements.front().to);
    return sum > 0 ? 1 : -1;
}

}  // namespace polyturn::channels::cycles
