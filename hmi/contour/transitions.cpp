// Chamfers and roundings between two elements that are known: the elements end earlier, a line or
// an arc lies between them.
//
//   rounding: its centre is r away from both, on the side to which the contour turns; of the places
//   that are, the one nearest to the corner. chamfer: it begins and ends so far from the corner.
#include <cmath>
#include <limits>

#include "hmi/contour/contour.hpp"

namespace polyturn::contour {
namespace {

constexpr double kRadian = M_PI / 180.0;
constexpr double kOnMm = 1e-6;

double distance(Point a, Point b) { return std::hypot(a.z - b.z, a.x - b.x); }
Point unit(double degrees) { return {std::cos(degrees * kRadian), std::sin(degrees * kRadian)}; }
bool is_arc(const Piece& p) { return p.kind != Kind::Line; }

// Degrees from the beginning of an arc to a point of its circle.
double turned(const Piece& p, Point at) {
    const double a = std::atan2(p.from.x - p.centre.x, p.from.z - p.centre.z),
                 b = std::atan2(at.x - p.centre.x, at.z - p.centre.z);
    return norm360((p.kind == Kind::ArcCcw ? b - a : a - b) / kRadian);
}

bool lies_on(const Piece& p, Point at) {
    if (!is_arc(p)) {
        const double l = distance(p.from, p.to), t = ((at.z - p.from.z) * (p.to.z - p.from.z) +
                                                      (at.x - p.from.x) * (p.to.x - p.from.x)) /
                                                     l;
        return t > -kOnMm && t < l + kOnMm;
    }
    const double t = turned(p, at);
    return t < p.sweep + 1e-6 || t > 360 - 1e-6;
}

// A straight line or a circle.
struct Curve {
    bool round = false;
    Point at, way;      // line
    double radius = 0;  // circle about `at`
};

// Away from the piece by r to its left (side 1) or right (-1). False: the circle would be gone.
bool beside(const Piece& p, double r, int side, Curve& out) {
    if (!is_arc(p)) {
        const Point way = unit(direction_at_start(p));
        out = {false, {p.from.z - side * r * way.x, p.from.x + side * r * way.z}, way, 0};
        return true;
    }
    const int inwards = p.kind == Kind::ArcCcw ? 1 : -1;  // the centre of a ccw arc is at its left
    out = {true, p.centre, {}, p.radius - inwards * side * r};
    return out.radius > kOnMm;
}

int meet(const Curve& a, const Curve& b, Point out[2]) {
    if (a.round && !b.round) return meet(b, a, out);
    if (!a.round && !b.round) {
        const double det = a.way.z * b.way.x - a.way.x * b.way.z;
        if (std::fabs(det) < 1e-12) return 0;
        const double t = ((b.at.z - a.at.z) * b.way.x - (b.at.x - a.at.x) * b.way.z) / det;
        out[0] = {a.at.z + t * a.way.z, a.at.x + t * a.way.x};
        return 1;
    }
    if (!a.round) {
        const double t = (b.at.z - a.at.z) * a.way.z + (b.at.x - a.at.x) * a.way.x;
        const Point foot{a.at.z + t * a.way.z, a.at.x + t * a.way.x};
        const double h2 = b.radius * b.radius - std::pow(distance(foot, b.at), 2);
        if (h2 < -kOnMm) return 0;
        const double h = std::sqrt(std::fmax(0.0, h2));
        out[0] = {foot.z + h * a.way.z, foot.x + h * a.way.x};
        out[1] = {foot.z - h * a.way.z, foot.x - h * a.way.x};
        return 2;
    }
    const double d = distance(a.at, b.at);
    if (d < kOnMm) return 0;
    const double m = (d * d + a.radius * a.radius - b.radius * b.radius) / (2 * d),
                 h2 = a.radius * a.radius - m * m;
    if (h2 < -kOnMm) return 0;
    const double h = std::sqrt(std::fmax(0.0, h2));
    const Point u{(b.at.z - a.at.z) / d, (b.at.x - a.at.x) / d};
    out[0] = {a.at.z + m * u.z - h * u.x, a.at.x + m * u.x + h * u.z};
    out[1] = {a.at.z + m * u.z + h * u.x, a.at.x + m * u.x - h * u.z};
    return 2;
}

Point touch(const Piece& p, Point centre) {
    if (!is_arc(p)) {
        const Point way = unit(direction_at_start(p));
        const double t = (centre.z - p.from.z) * way.z + (centre.x - p.from.x) * way.x;
        return {p.from.z + t * way.z, p.from.x + t * way.x};
    }
    const double d = distance(p.centre, centre);
    return {p.centre.z + (centre.z - p.centre.z) * p.radius / d,
            p.centre.x + (centre.x - p.centre.x) * p.radius / d};
}

void cut(Piece& p, Point from, Point to) {
    if (is_arc(p)) {
        const double a = turned(p, from), b = turned(p, to);
        p.sweep = norm360(b - (a > 360 - 1e-6 ? 0 : a));
    }
    p.from = from;
    p.to = to;
}

bool round_corner(Piece& a, Piece& b, double r, Piece& between) {
    const Point corner = a.to;
    double best = std::numeric_limits<double>::max();
    for (const int side : {1, -1}) {
        Curve ca, cb;
        if (!beside(a, r, side, ca) || !beside(b, r, side, cb)) continue;
        Point centres[2];
        const int many = meet(ca, cb, centres);
        for (int k = 0; k < many; ++k) {
            const Point ta = touch(a, centres[k]), tb = touch(b, centres[k]);
            if (!lies_on(a, ta) || !lies_on(b, tb)) continue;
            const double away = distance(ta, corner) + distance(tb, corner);
            if (away >= best || distance(ta, tb) < kOnMm) continue;
            best = away;
            between.role = Piece::Role::Round;
            between.kind = side > 0 ? Kind::ArcCcw : Kind::ArcCw;
            between.from = ta;
            between.to = tb;
            between.centre = centres[k];
            between.radius = r;
            between.sweep = turned(between, tb);
        }
    }
    if (best == std::numeric_limits<double>::max()) return false;
    cut(a, a.from, between.from);
    cut(b, between.to, b.to);
    return true;
}

bool chamfer_corner(Piece& a, Piece& b, double c, Piece& between) {
    const Point corner = a.to;
    const auto place = [&](const Piece& p, bool end, Point& out) {
        if (!is_arc(p)) {
            const Point way = unit(direction_at_start(p));
            const double s = end ? -c : c;
            out = {corner.z + s * way.z, corner.x + s * way.x};
            return distance(p.from, p.to) > c - kOnMm;
        }
        Point points[2];
        const int many = meet({true, corner, {}, c}, {true, p.centre, {}, p.radius}, points);
        for (int k = 0; k < many; ++k)
            if (lies_on(p, points[k])) {
                out = points[k];
                return true;
            }
        return false;
    };
    Point from, to;
    if (!place(a, true, from) || !place(b, false, to)) return false;
    between.role = Piece::Role::Chamfer;
    between.kind = Kind::Line;
    between.from = from;
    between.to = to;
    cut(a, a.from, from);
    cut(b, to, b.to);
    return true;
}

}  // namespace

// `pieces`: one for each known element, in order; afterwards with what lies between them.
bool add_transitions(const Contour& contour, std::vector<Piece>& pieces,
                     std::vector<State>& states) {
    std::vector<Piece> out;
    bool good = true;
    for (std::size_t i = 0; i < pieces.size(); ++i) {
        const Element& e = contour.elements[pieces[i].element];
        out.push_back(pieces[i]);
        if (i + 1 >= pieces.size() || (e.chamfer <= 0 && e.round <= 0)) continue;
        Piece between;
        between.element = pieces[i].element;
        const bool done = e.round > 0
                              ? round_corner(out.back(), pieces[i + 1], e.round, between)
                              : chamfer_corner(out.back(), pieces[i + 1], e.chamfer, between);
        if (done)
            out.push_back(between);
        else {
            states[pieces[i].element] = State::NoRoom;
            good = false;
        }
    }
    pieces = std::move(out);
    return good;
}

}  // namespace polyturn::contour
