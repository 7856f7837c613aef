#include "ipc/path/path_geometry.hpp"

#include <algorithm>

namespace polyturn {
namespace {

// Value and three derivatives of a polynomial of degree 5 (c[0] + c[1] x + ...).
struct Jet {
    double v0, v1, v2, v3;
};
Jet jet(const double* c, double x) noexcept {
    return {c[0] + x * (c[1] + x * (c[2] + x * (c[3] + x * (c[4] + x * c[5])))),
            c[1] + x * (2 * c[2] + x * (3 * c[3] + x * (4 * c[4] + x * 5 * c[5]))),
            2 * c[2] + x * (6 * c[3] + x * (12 * c[4] + x * 20 * c[5])),
            6 * c[3] + x * (24 * c[4] + x * 60 * c[5])};
}
double value(const double* c, double x) noexcept {
    return c[0] + x * (c[1] + x * (c[2] + x * (c[3] + x * (c[4] + x * c[5]))));
}

// Fraction of the sweep at s. A spiral (radius at the end differs) carries a polynomial, because
// its speed over the angle is not constant; a true arc does not need it.
bool has_parameter(const PathRecord& r) noexcept {
    return r.shape[curve_shape::kParameter + 1] != 0;
}
Jet fraction(const PathRecord& r, double s) noexcept {
    if (has_parameter(r)) return jet(&r.shape[curve_shape::kParameter], s);
    return {s / r.length, 1 / r.length, 0, 0};
}

void copy_slots(const PathRecord& r, const double* from, SlotVector& to) noexcept {
    for (std::size_t i = 0; i < r.axis_count; ++i) to[i] = from[i];
}

double end_radius(const PathRecord& r) noexcept {
    const double radius = r.shape[arc_shape::kRadiusEnd];
    return radius > 0 ? radius : r.shape[arc_shape::kRadius];  // 0: a true circle
}

}  // namespace

void position_at(const PathRecord& r, double s, SlotVector& position) noexcept {
    // The ends are exact, so that records meet without a step. !(s > 0) takes NaN and records
    // without length to the start.
    if (!(s > 0)) return copy_slots(r, &r.start[0], position);
    if (s >= r.length) return copy_slots(r, &r.end[0], position);
    switch (static_cast<RecordKind>(r.kind)) {
        case RecordKind::Line: {
            const double f = s / r.length;
            for (std::size_t i = 0; i < r.axis_count; ++i)
                position[i] = r.start[i] + (r.end[i] - r.start[i]) * f;
            return;
        }
        case RecordKind::Arc: {
            const double f = fraction(r, s).v0;
            for (std::size_t i = 0; i < r.axis_count; ++i)
                position[i] = r.start[i] + (r.end[i] - r.start[i]) * f;
            const double radius =
                r.shape[arc_shape::kRadius] + (end_radius(r) - r.shape[arc_shape::kRadius]) * f;
            const double angle = r.shape[arc_shape::kStartAngle] + r.shape[arc_shape::kSweep] * f;
            position[r.plane[0]] = r.shape[arc_shape::kCentreP] + radius * std::cos(angle);
            position[r.plane[1]] = r.shape[arc_shape::kCentreQ] + radius * std::sin(angle);
            return;
        }
        case RecordKind::Curve: {
            const double u = value(&r.shape[curve_shape::kParameter], s);
            const std::size_t count = std::min<std::size_t>(r.axis_count, kMaxCurveAxes);
            for (std::size_t i = 0; i < count; ++i)
                position[i] = value(&r.shape[curve_shape::kCoefficients + 6 * i], u);
            return;
        }
        default:
            return copy_slots(r, &r.start[0], position);
    }
}

void derivatives_at(const PathRecord& r, double s, PathDerivatives& out) noexcept {
    for (std::size_t i = 0; i < r.axis_count; ++i) out.first[i] = out.second[i] = out.third[i] = 0;
    if (!(r.length > 0)) return;
    s = std::clamp(s, 0.0, r.length);
    switch (static_cast<RecordKind>(r.kind)) {
        case RecordKind::Line:
            for (std::size_t i = 0; i < r.axis_count; ++i)
                out.first[i] = (r.end[i] - r.start[i]) / r.length;
            return;
        case RecordKind::Arc: {
            const Jet f = fraction(r, s);
            for (std::size_t i = 0; i < r.axis_count; ++i) {
                const double d = r.end[i] - r.start[i];
                out.first[i] = d * f.v1;
                out.second[i] = d * f.v2;
                out.third[i] = d * f.v3;
            }
            // With f the fraction: r = R + D f, angle = A + W f; P(f) = r cos, Q(f) = r sin; dP/df
            // = D cos - r W sin, ...
            const double w = r.shape[arc_shape::kSweep];
            const double d = end_radius(r) - r.shape[arc_shape::kRadius];
            const double radius = r.shape[arc_shape::kRadius] + d * f.v0;
            const double angle = r.shape[arc_shape::kStartAngle] + w * f.v0;
            const double c = std::cos(angle), n = std::sin(angle);
            const double p1 = d * c - radius * w * n, q1 = d * n + radius * w * c;
            const double p2 = -2 * d * w * n - radius * w * w * c,
                         q2 = 2 * d * w * c - radius * w * w * n;
            const double p3 = -3 * d * w * w * c + radius * w * w * w * n,
                         q3 = -3 * d * w * w * n - radius * w * w * w * c;
            const std::size_t p = r.plane[0], q = r.plane[1];
            out.first[p] = p1 * f.v1;
            out.first[q] = q1 * f.v1;
            out.second[p] = p2 * f.v1 * f.v1 + p1 * f.v2;
            out.second[q] = q2 * f.v1 * f.v1 + q1 * f.v2;
            out.third[p] = p3 * f.v1 * f.v1 * f.v1 + 3 * p2 * f.v1 * f.v2 + p1 * f.v3;
            out.third[q] = q3 * f.v1 * f.v1 * f.v1 + 3 * q2 * f.v1 * f.v2 + q1 * f.v3;
            return;
        }
        case RecordKind::Curve: {
            const Jet u = jet(&r.shape[curve_shape::kParameter], s);
            const std::size_t count = std::min<std::size_t>(r.axis_count, kMaxCurveAxes);
            for (std::size_t i = 0; i < count; ++i) {
                const Jet p = jet(&r.shape[curve_shape::kCoefficients + 6 * i], u.v0);
                out.first[i] = p.v1 * u.v1;
                out.second[i] = p.v2 * u.v1 * u.v1 + p.v1 * u.v2;
                out.third[i] = p.v3 * u.v1 * u.v1 * u.v1 + 3 * p.v2 * u.v1 * u.v2 + p.v1 * u.v3;
            }
            return;
        }
        default:
            return;
    }
}

}  // namespace polyturn
