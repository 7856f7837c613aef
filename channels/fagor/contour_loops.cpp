#include "channels/fagor/contour_loops.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace polyturn::channels::fagor {
namespace {

using cycles::Element;
using cycles::Point;

constexpr double kClose = 1e-4;   // mm
constexpr int kSamples = 9;       // points of an element at which the nose is looked at

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
    const Point d = is_arc(e) ? (e.sweep > 0 ? 1.0 : -1.0) * Point{-(at_share(e, share) - e.centre).x, (at_share(e, share) - e.centre).z} : e.to - e.from;
    const double l = length(d);
    return l > 0 ? (1.0 / l) * d : Point{};
}

double distance_to(const Element& e, Point p) {
    if (!is_arc(e)) {
        const Point d = e.to - e.from;
        const double square = dot(d, d), share = square > 0 ? std::clamp(dot(p - e.from, d) / square, 0.0, 1.0) : 0.0;
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

// The nose on its way along k would cut into an element of the window, wherever on k it stands.
bool collides(const std::vector<Element>& all, std::size_t k, double nose, int side, std::size_t window) {
    const Element& e = all[k];
    if (is_arc(e) && (e.sweep > 0 ? 1 : -1) == side && e.radius < nose - kClose) return true;   // the nose lies inside of an arc that it does not fit
    const std::size_t first = k > window ? k - window : 0, last = std::min(all.size() - 1, k + window);
    for (int s = 0; s < kSamples; ++s) {
        const double share = (s + 0.5) / kSamples;
        const Point d = direction(e, share), centre = at_share(e, share) + nose * static_cast<double>(side) * Point{-d.x, d.z};
        bool free = true;
        for (std::size_t m = first; free && m <= last; ++m)
            if (m + 1 < k || m > k + 1) free = distance_to(all[m], centre) >= nose - kClose;
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
    Point base, along;   // the line, or the line through the two meetings of two circles
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
        const bool forward = is_arc(a) || dot(p - a.from, a.to - a.from) > 0, onward = is_arc(b) || dot(b.to - p, b.to - b.from) > 0;
        if (forward && onward && (!best || length(p - a.to) < length(*best - a.to))) best = p;
    }
    return best;
}

std::optional<Point> crossing(const Element& a, const Element& b) {
    for (const Point p : meetings(a, b)) {
        const bool on_both = distance_to(a, p) < kClose && distance_to(b, p) < kClose;
        const bool at_end = length(p - a.from) < kClose || length(p - b.to) < kClose || (length(p - a.to) < kClose && length(p - b.from) < kClose);
        if (on_both && !at_end) return p;
    }
    return std::nullopt;
}

}  // namespace

std::vector<ContourLoop> find_loops(const std::vector<Element>& all, double nose, int side, std::size_t window) {
    std::vector<ContourLoop> loops;
    if (nose <= 0 || side == 0 || all.size() < 3) return loops;
    std::vector<bool> bad(all.size());
    for (std::size_t k = 0; k < all.size(); ++k) bad[k] = collides(all, k, nose, side, window);
    for (std::size_t i = 0; i + 2 < all.size(); ++i) {
        if (bad[i]) continue;
        const std::size_t last = std::min(all.size() - 1, i + window);
        std::optional<ContourLoop> loop;
        for (std::size_t j = last; !loop && j >= i + 2; --j)
            if (const auto p = crossing(all[i], all[j])) loop = ContourLoop{i, j, p};
        if (!loop && bad[i + 1]) {
            std::size_t j = i + 1;
            while (j <= last && bad[j]) ++j;
            if (j <= last) loop = ContourLoop{i, j, meeting(all[i], all[j])};
        }
        if (!loop) continue;
        loops.push_back(*loop);
        i = loop->after - 1;
    }
    return loops;
}

}  // namespace polyturn::channels::fagor
