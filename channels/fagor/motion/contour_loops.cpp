#include "channels/fagor/motion/contour_loops.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <numeric>

namespace polyturn::channels::fagor {
namespace {

using cycles::Element;
using cycles::Point;

constexpr double kClose = 1e-4;  // mm
constexpr int kSamples = 9;      // points of an element at which the nose is looked at
constexpr int kMostPasses = 50;  // over what is left of a contour; each shortens it

Point operator+(Point a, Point b) { return {a.z + b.z, a.x + b.x}; }
Point operator-(Point a, Point b) { return {a.z - b.z, a.x - b.x}; }
Point operator*(double f, Point a) { return {f * a.z, f * a.x}; }
double dot(Point a, Point b) { return a.z * b.z + a.x * b.x; }
double cross(Point a, Point b) { return a.z * b.x - a.x * b.z; }
double length(Point a) { return std::hypot(a.z, a.x); }
bool is_arc(const Element& e) { return e.form != Element::Form::Line; }

Point at_share(const Element& e, double share) {
    if (!is_arc(e)) return e.from + share * (e.to - e.from);
    const double angle = e.first_angle + share * e.sweep;
    return e.centre + e.radius * Point{std::cos(angle), std::sin(angle)};
}

Point direction(const Element& e, double share) {
    const Point d = is_arc(e)
                        ? (e.sweep > 0 ? 1.0 : -1.0) * Point{-(at_share(e, share) - e.centre).x,
                                                             (at_share(e, share) - e.centre).z}
                        : e.to - e.from;
    const double l = length(d);
    return l > 0 ? (1.0 / l) * d : Point{};
}

double distance_to(const Element& e, Point p) {
    if (!is_arc(e)) {
        const Point d = e.to - e.from;
        const double square = dot(d, d),
                     share = square > 0 ? std::clamp(dot(p - e.from, d) / square, 0.0, 1.0) : 0.0;
        return length(p - at_share(e, share));
    }
    const Point r = p - e.centre;
    double angle = std::atan2(r.x, r.z) - e.first_angle;
    constexpr double kTurn = 2 * std::numbers::pi;
    angle -= std::floor(angle / kTurn) * kTurn;
    const double along = e.sweep > 0 ? angle : angle == 0 ? 0.0 : kTurn - angle;
    if (along <= std::fabs(e.sweep)) return std::fabs(length(r) - e.radius);
    return std::min(length(p - e.from), length(p - e.to));
}

// By how much the corner between two lines shortens the way of the nose along each: an inner one
// does, an outer one may lengthen it.
double taken_by_corner(const Element& a, const Element& b, const Nose& nose) {
    if (b.rapid) return nose.radius;  // the nose stops before it (8.2.7)
    if (is_arc(a) || is_arc(b)) return 0.0;
    const Point d = direction(a, 1.0), e = direction(b, 0.0);
    const double turn = nose.side * std::atan2(cross(d, e), dot(d, e));
    // 300 degrees on the nose's side (8.2.5)
    constexpr double kStraight = 1e-6, kMostExtended = std::numbers::pi * 2 / 3 + kStraight;
    if (turn > kStraight)
        return turn < std::numbers::pi - kStraight ? nose.radius * std::tan(turn / 2) : 0.0;
    if (nose.corner == compensation::Corner::Arc || turn < -kMostExtended) return 0.0;
    const double extended = std::tan(turn / 2);
    return nose.radius *
           (nose.corner == compensation::Corner::Extended ? std::fmax(extended, -1.0) : extended);
}

// The nose moving along k would cut into an element of the window, wherever on k it is.
bool collides(const std::vector<Element>& all, std::size_t k, const Nose& tool,
              std::size_t window) {
    const Element& e = all[k];
    const double nose = tool.radius;
    const int side = tool.side;
    if (e.rapid) return false;
    // the nose lies inside of an arc that it does not fit
    if (is_arc(e) && (e.sweep > 0 ? 1 : -1) == side && e.radius < nose - kClose) return true;
    // the share of a line that the corners leave; none: the compensated line would run backwards
    double begin = 0.0, end = 1.0;
    if (const double l = length(e.to - e.from); !is_arc(e) && l > kClose) {
        if (k > 0) begin = taken_by_corner(all[k - 1], e, tool) / l;
        if (k + 1 < all.size()) end -= taken_by_corner(e, all[k + 1], tool) / l;
        if ((begin - end) * l > kClose) return true;
        // only its continuation is driven: as far as the inner corner
        if (begin > 1 || end < 0)
            begin = end = begin > 1 ? begin : end;
        else {
            begin = std::fmax(begin, 0.0);
            end = std::fmin(end, 1.0);
        }
    }
    const std::size_t first = k > window ? k - window : 0,
                      last = std::min(all.size() - 1, k + window);
    for (int s = 0; s < kSamples; ++s) {
        const double share = begin + (s + 0.5) / kSamples * (end - begin);
        const Point d = direction(e, share),
                    centre =
                        at_share(e, share) + nose * static_cast<double>(side) * Point{-d.x, d.z};
        bool free = true;
        for (std::size_t m = first; free && m <= last; ++m)
            if ((m + 1 < k || m > k + 1) && !all[m].rapid)
                free = distance_to(all[m], centre) >= nose - kClose;
        if (free) return false;
    }
    return true;
}

// Points in which the whole lines or circles of a and b meet.
std::vector<Point> meetings(const Element& a, const Element& b) {
    if (is_arc(a) && !is_arc(b)) return meetings(b, a);
    if (!is_arc(a) && !is_arc(b)) {
        const Point d = a.to - a.from, e = b.to - b.from;
        const double det = cross(d, e);
        if (std::fabs(det) < 1e-9 * length(d) * length(e)) return {};
        return {a.from + (cross(b.from - a.from, e) / det) * d};
    }
    Point base, along;  // the line, or the line through the two meetings of two circles
    double half2 = 0.0;
    if (!is_arc(a)) {
        const Point d = direction(a, 0.0);
        base = a.from + dot(b.centre - a.from, d) * d;
        along = d;
        half2 = b.radius * b.radius - dot(base - b.centre, base - b.centre);
    } else {
        const Point d = b.centre - a.centre;
        const double l = length(d);
        if (l < kClose) return {};
        const double x = (l * l + a.radius * a.radius - b.radius * b.radius) / (2 * l);
        base = a.centre + (x / l) * d;
        along = (1.0 / l) * Point{-d.x, d.z};
        half2 = a.radius * a.radius - x * x;
    }
    if (half2 < 0) return {};
    const double half = std::sqrt(half2);
    return {base + half * along, base - half * along};
}

// The one nearest to where a ends, if a leads to it and b away from it.
std::optional<Point> meeting(const Element& a, const Element& b) {
    std::optional<Point> best;
    for (const Point p : meetings(a, b)) {
        const bool forward = is_arc(a) || dot(p - a.from, a.to - a.from) > 0,
                   onward = is_arc(b) || dot(b.to - p, b.to - b.from) > 0;
        if (forward && onward && (!best || length(p - a.to) < length(*best - a.to))) best = p;
    }
    return best;
}

std::optional<Point> crossing(const Element& a, const Element& b) {
    for (const Point p : meetings(a, b)) {
        const bool on_both = distance_to(a, p) < kClose && distance_to(b, p) < kClose;
        const bool at_end = length(p - a.from) < kClose || length(p - b.to) < kClose ||
                            (length(p - a.to) < kClose && length(p - b.from) < kClose);
        if (on_both && !at_end) return p;
    }
    return std::nullopt;
}

bool in_line(const Element& a, const Element& b) {
    if (is_arc(a) || is_arc(b)) return false;
    const Point d = direction(a, 1.0);
    return std::fabs(cross(d, b.from - a.to)) < kClose &&
           std::fabs(cross(d, b.to - a.to)) < kClose && dot(d, b.to - a.to) > 0;
}

// The point lies on line k, or on another of first to last that k continues: a step may be
// programmed in pieces.
bool leads_through(const std::vector<Element>& all, std::size_t first, std::size_t last,
                   std::size_t k, Point p) {
    const Point d = direction(all[k], 0.0);
    for (std::size_t m = first; m <= last; ++m)
        if (!is_arc(all[m]) && distance_to(all[m], p) < kClose &&
            dot(d, direction(all[m], 0.0)) > 1 - 1e-9)
            return true;
    return false;
}

// Of the elements i to j two lines that meet, both long enough for the nose in the inner corner
// between them: the shoulder of a groove whose other one is lower, with the surface that follows.
std::optional<ContourLoop> inner_corner(const std::vector<Element>& all, std::size_t i,
                                        std::size_t j, const Nose& nose) {
    for (std::size_t span = j - i - 1; span >= 2; --span)
        for (std::size_t a = i; a + span <= j; ++a) {
            const std::size_t b = a + span;
            Element in = all[a], out = all[b];
            if (is_arc(in) || is_arc(out) || out.rapid) continue;
            const auto p = meeting(in, out);
            if (!p || (a != i && !leads_through(all, a, b, a, *p)) ||
                (b != j && !leads_through(all, a, b, b, *p)))
                continue;
            in.to = out.from = *p;
            const double taken = taken_by_corner(in, out, nose);
            const double before = a > 0 ? taken_by_corner(all[a - 1], in, nose) : 0.0;
            const double behind = b + 1 < all.size() ? taken_by_corner(out, all[b + 1], nose) : 0.0;
            if (taken > 0 && before + taken < length(in.to - in.from) + kClose &&
                taken + behind < length(out.to - out.from) + kClose)
                return ContourLoop{a, b, p};
        }
    return std::nullopt;
}

// How i goes on where all elements up to j collide.
std::optional<ContourLoop> around(const std::vector<Element>& all, std::size_t i, std::size_t j,
                                  const Nose& nose) {
    if (const auto p = meeting(all[i], all[j])) return ContourLoop{i, j, p};
    if (is_arc(all[i]) || is_arc(all[j]) || all[j].rapid || in_line(all[i], all[j]))
        return ContourLoop{i, j, std::nullopt};
    if (const auto corner = inner_corner(all, i, j, nose)) return corner;
    // Straight to the end of j, unless that would cut below the beginning of j.
    if (nose.side * cross(direction(all[i], 1.0), all[j].from - all[i].to) > 0) return std::nullopt;
    return ContourLoop{i, j, std::nullopt};
}

std::vector<ContourLoop> one_pass(const std::vector<Element>& all, const Nose& nose,
                                  std::size_t window) {
    std::vector<ContourLoop> loops;
    std::vector<bool> bad(all.size());
    for (std::size_t k = 0; k < all.size(); ++k) bad[k] = collides(all, k, nose, window);
    for (std::size_t i = 0; i + 2 < all.size(); ++i) {
        if (bad[i] || all[i].rapid) continue;
        const std::size_t last = std::min(all.size() - 1, i + window);
        std::optional<ContourLoop> loop;
        for (std::size_t j = last; !loop && j >= i + 2; --j)
            if (const auto p = all[j].rapid ? std::nullopt : crossing(all[i], all[j]))
                loop = ContourLoop{i, j, p};
        if (!loop && bad[i + 1]) {
            std::size_t j = i + 1;
            while (j <= last && bad[j]) ++j;
            if (j <= last) loop = around(all, i, j, nose);
        }
        if (!loop) continue;
        loops.push_back(*loop);
        i = loop->after - 1;
    }
    return loops;
}

// The element between two points of its line or circle.
void cut_to(Element& e, Point from, Point to) {
    if (is_arc(e)) {
        if (std::fabs(length(from - e.centre) - e.radius) > kClose ||
            std::fabs(length(to - e.centre) - e.radius) > kClose)
            return;
        constexpr double kTurn = 2 * std::numbers::pi;
        const double way = e.sweep > 0 ? 1.0 : -1.0;
        e.first_angle = std::atan2((from - e.centre).x, (from - e.centre).z);
        double sweep = way * (std::atan2((to - e.centre).x, (to - e.centre).z) - e.first_angle);
        if (sweep <= 0) sweep += kTurn;
        e.sweep = way * sweep;
    }
    e.from = from;
    e.to = to;
}

// The elements first to last of a contour, at most the last of them rapid. What is left of it may
// not be free either.
void loops_of(const std::vector<Element>& all, std::size_t first, std::size_t last,
              const Nose& nose, std::size_t window, std::vector<ContourLoop>& loops) {
    std::vector<Element> left(all.begin() + static_cast<std::ptrdiff_t>(first),
                              all.begin() + static_cast<std::ptrdiff_t>(last));
    std::vector<std::size_t> place(left.size());
    std::iota(place.begin(), place.end(), first);
    for (int pass = 0; pass < kMostPasses && left.size() >= 3; ++pass) {
        const auto found = one_pass(left, nose, window);
        if (found.empty()) break;
        for (auto loop = found.rbegin(); loop != found.rend(); ++loop) {
            Element &before = left[loop->before], &after = left[loop->after];
            if (loop->meeting) cut_to(before, before.from, *loop->meeting);
            cut_to(after, before.to, after.to);
            const auto from = static_cast<std::ptrdiff_t>(loop->before) + 1,
                       to = static_cast<std::ptrdiff_t>(loop->after);
            left.erase(left.begin() + from, left.begin() + to);
            place.erase(place.begin() + from, place.begin() + to);
        }
    }
    for (std::size_t k = 0; k + 1 < left.size(); ++k) {
        if (place[k + 1] == place[k] + 1) continue;
        ContourLoop loop{place[k], place[k + 1], std::nullopt};
        if (length(left[k].to - all[place[k]].to) > kClose) loop.meeting = left[k].to;
        loops.push_back(loop);
    }
}

}  // namespace

std::vector<ContourLoop> find_loops(const std::vector<Element>& all, const Nose& nose,
                                    std::size_t window) {
    std::vector<ContourLoop> loops;
    if (nose.radius <= 0 || nose.side == 0) return loops;
    for (std::size_t first = 0, last = 0; first < all.size(); first = last) {
        while (last < all.size() && !all[last].rapid) ++last;
        if (last < all.size()) ++last;
        loops_of(all, first, last, nose, window, loops);
    }
    return loops;
}

std::vector<Element> without_loops(std::vector<Element> elements,
                                   const std::vector<ContourLoop>& loops) {
    for (auto loop = loops.rbegin(); loop != loops.rend(); ++loop) {
        Element &before = elements[loop->before], &after = elements[loop->after];
        if (loop->meeting) cut_to(before, before.from, *loop->meeting);
        cut_to(after, before.to, after.to);
        elements.erase(elements.begin() + static_cast<std::ptrdiff_t>(loop->before) + 1,
                       elements.begin() + static_cast<std::ptrdiff_t>(loop->after));
    }
    return elements;
}

}  // namespace polyturn::channels::fagor
