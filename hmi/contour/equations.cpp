#include "hmi/contour/equations.hpp"

#include <cmath>
#include <cstdint>

namespace polyturn::contour {
namespace {

constexpr double kRadian = M_PI / 180.0;
using Vec = Eigen::Vector2d;

Vec unit(double degrees) { return {std::cos(degrees * kRadian), std::sin(degrees * kRadian)}; }
double cross(const Vec& a, const Vec& b) { return a.x() * b.y() - a.y() * b.x(); }
// The direction of travel at `at`, as long as the radius.
Vec along(Kind kind, const Vec& centre, const Vec& at) {
    const Vec r = at - centre;
    return kind == Kind::ArcCcw ? Vec(-r.y(), r.x()) : Vec(r.y(), -r.x());
}
bool same_way(const Vec& a, const Vec& b) { return a.dot(b) > 0; }

constexpr double kPointMm = 1e-6;

}  // namespace

double norm360(double degrees) {
    const double out = std::fmod(degrees, 360.0);
    return out < 0 ? out + 360.0 : out;
}

Group::Group(const Contour& contour, std::size_t first, std::size_t last, Point from,
             std::optional<double> before)
    : contour_(&contour), first_(first), last_(last), from_(from), before_(before) {
    count();
}

void Group::count() {
    const auto look = [&](const std::optional<double>& value, double from) {
        if (value) size_ = std::fmax(size_, std::fabs(*value - from));
    };
    for (std::size_t i = first_; i <= last_; ++i) {
        const Element& e = contour_->elements[i];
        const bool line = e.kind == Kind::Line;
        unknowns_ += line ? 2 : 4;
        for (const auto& one : {e.z, e.x, e.dz, e.dx, e.angle}) equations_ += one.has_value();
        if (line)
            equations_ += e.length.has_value();
        else {
            equations_ += e.sweep ? 2 : 1;
            for (const auto& one : {e.radius, e.centre_z, e.centre_x, e.end_angle})
                equations_ += one.has_value();
        }
        equations_ += told_tangent(i);
        look(e.z, from_.z);
        look(e.x, from_.x);
        look(e.centre_z, from_.z);
        look(e.centre_x, from_.x);
        for (const auto& one : {e.dz, e.dx, e.length, e.radius}) look(one, 0.0);
    }
}

// A direction that is given as well does not count twice: it may be rounded, or follow badly from
// what lies before.
bool Group::told_tangent(std::size_t i) const {
    const Element& e = contour_->elements[i];
    if (!e.tangent || (i == first_ && !before_)) return false;
    return i > first_ || !e.angle || std::fabs(std::remainder(*e.angle - *before_, 360.0)) > 0.5;
}

Eigen::VectorXd Group::residuals(const Eigen::VectorXd& u) const {
    Eigen::VectorXd out(equations_);
    int n = 0, k = 0;
    const auto put = [&](double value) { out[n++] = value; };
    Vec start(from_.z, from_.x), way = before_ ? unit(*before_) : Vec(0, 0);
    for (std::size_t i = first_; i <= last_; ++i) {
        const Element& e = contour_->elements[i];
        const Vec end(u[k], u[k + 1]);
        if (e.z) put(end.x() - *e.z);
        if (e.x) put(end.y() - *e.x);
        if (e.dz) put(end.x() - start.x() - *e.dz);
        if (e.dx) put(end.y() - start.y() - *e.dx);
        const bool tangent = told_tangent(i);
        if (e.kind == Kind::Line) {
            const Vec d = end - start;
            if (e.angle) put(cross(unit(*e.angle), d));
            if (e.length) put(d.norm() - *e.length);
            if (tangent) put(cross(way, d));
            way = d.norm() > kPointMm ? Vec(d.normalized()) : way;
            k += 2;
        } else {
            const Vec centre(u[k + 2], u[k + 3]), a = start - centre, b = end - centre;
            if (e.sweep) {
                const double turn = (e.kind == Kind::ArcCcw ? 1 : -1) * *e.sweep * kRadian;
                const Vec there(a.x() * std::cos(turn) - a.y() * std::sin(turn),
                                a.x() * std::sin(turn) + a.y() * std::cos(turn));
                put(there.x() - b.x());
                put(there.y() - b.y());
            } else {
                put(a.norm() - b.norm());
            }
            if (e.radius) put(a.norm() - *e.radius);
            if (e.centre_z) put(centre.x() - *e.centre_z);
            if (e.centre_x) put(centre.y() - *e.centre_x);
            if (e.angle) put(cross(unit(*e.angle), along(e.kind, centre, start)));
            if (e.end_angle) put(cross(unit(*e.end_angle), along(e.kind, centre, end)));
            if (tangent) put(cross(way, along(e.kind, centre, start)));
            const Vec t = along(e.kind, centre, end);
            way = t.norm() > kPointMm ? Vec(t.normalized()) : way;
            k += 4;
        }
        start = end;
    }
    return out;
}

bool Group::fits(const Eigen::VectorXd& u) const {
    int k = 0;
    Vec start(from_.z, from_.x), way = before_ ? unit(*before_) : Vec(0, 0);
    for (std::size_t i = first_; i <= last_; ++i) {
        const Element& e = contour_->elements[i];
        const Vec end(u[k], u[k + 1]);
        if ((end - start).norm() < 1e-4) return false;
        const bool tangent = told_tangent(i), line = e.kind == Kind::Line;
        const Vec centre = line ? Vec(0, 0) : Vec(u[k + 2], u[k + 3]);
        if (!line && (start - centre).norm() < 1e-4) return false;
        const Vec in = line ? Vec(end - start) : along(e.kind, centre, start),
                  last = line ? in : along(e.kind, centre, end);
        if (e.angle && !same_way(unit(*e.angle), in)) return false;
        if (tangent && !same_way(way, in)) return false;
        if (!line && e.end_angle && !same_way(unit(*e.end_angle), last)) return false;
        way = last.normalized();
        k += line ? 2 : 4;
        start = end;
    }
    return true;
}

std::vector<Piece> Group::pieces(const Eigen::VectorXd& u) const {
    std::vector<Piece> out;
    int k = 0;
    Point start = from_;
    for (std::size_t i = first_; i <= last_; ++i) {
        Piece piece;
        piece.kind = contour_->elements[i].kind;
        piece.element = i;
        piece.from = start;
        piece.to = {u[k], u[k + 1]};
        if (piece.kind == Kind::Line) {
            k += 2;
        } else {
            piece.centre = {u[k + 2], u[k + 3]};
            piece.radius = std::hypot(piece.from.z - piece.centre.z, piece.from.x - piece.centre.x);
            const double a = std::atan2(piece.from.x - piece.centre.x,
                                        piece.from.z - piece.centre.z),
                         b = std::atan2(piece.to.x - piece.centre.x, piece.to.z - piece.centre.z);
            piece.sweep = norm360((piece.kind == Kind::ArcCcw ? b - a : a - b) / kRadian);
            k += 4;
        }
        start = piece.to;
        out.push_back(piece);
    }
    return out;
}

// As given where it is given; elsewhere anywhere within reach. Half of the beginnings follow the
// directions that are given or tangential.
Eigen::VectorXd Group::begin(unsigned seed) const {
    std::uint32_t state = seed * 2654435761u + 12345u;
    const auto chance = [&] {  // -1 to 1
        state ^= state << 13;
        state ^= state >> 17;
        state ^= state << 5;
        return state / 2147483648.0 - 1.0;
    };
    const double reach = size_ * (seed % 3 == 0 ? 3.0 : seed % 3 == 1 ? 1.5 : 0.5);
    const bool follows = seed % 2 == 1;
    Eigen::VectorXd u(unknowns_);
    int k = 0;
    Vec start(from_.z, from_.x);
    std::optional<double> way = before_;
    for (std::size_t i = first_; i <= last_; ++i) {
        const Element& e = contour_->elements[i];
        const std::optional<double> in = e.angle                ? e.angle
                                         : follows && e.tangent ? way
                                                                : std::nullopt;
        const double heads = in ? *in : 180 * chance();
        Vec end = start + unit(heads) * std::fabs(reach * chance());
        if (e.kind == Kind::Line && e.length) end = start + unit(heads) * *e.length;
        Vec centre(0, 0);
        const int side = e.kind == Kind::ArcCcw ? 1 : -1;
        if (e.kind != Kind::Line) {
            centre = start +
                     unit(heads + side * 90) * (e.radius ? *e.radius : std::fabs(reach * chance()));
            const double sweep = e.sweep                  ? *e.sweep
                                 : follows && e.end_angle ? norm360(side * (*e.end_angle - heads))
                                                          : 180 * (1 + chance());
            const Vec a = start - centre;
            const double t = side * sweep * kRadian;
            end = centre + Vec(a.x() * std::cos(t) - a.y() * std::sin(t),
                               a.x() * std::sin(t) + a.y() * std::cos(t));
        }
        if (e.dz) end.x() = start.x() + *e.dz;
        if (e.dx) end.y() = start.y() + *e.dx;
        if (e.z) end.x() = *e.z;
        if (e.x) end.y() = *e.x;
        u[k] = end.x();
        u[k + 1] = end.y();
        if (e.kind != Kind::Line) {
            if (e.centre_z) centre.x() = *e.centre_z;
            if (e.centre_x) centre.y() = *e.centre_x;
            u[k + 2] = centre.x();
            u[k + 3] = centre.y();
        }
        const Vec last = e.kind == Kind::Line ? Vec(end - start) : along(e.kind, centre, end);
        way = e.kind != Kind::Line && e.end_angle ? *e.end_angle
                                                  : std::atan2(last.y(), last.x()) / kRadian;
        k += e.kind == Kind::Line ? 2 : 4;
        start = end;
    }
    return u;
}

}  // namespace polyturn::contour
