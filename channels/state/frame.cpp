#include "channels/state/frame.hpp"

#include <cmath>
#include <numbers>

namespace polyturn::channels {
namespace {

constexpr double kSingular = 1e-12;

// Quarter turns are exact: a contour turned by 90 degrees stays on integers.
void sine_cosine(double degrees, double& sine, double& cosine) {
    const double quarters = std::nearbyint(degrees / 90.0);
    const double rest = (degrees - quarters * 90.0) * std::numbers::pi / 180.0;
    const double s = std::sin(rest), c = std::cos(rest);
    switch (static_cast<int>(std::fmod(quarters, 4.0) + 4.0) % 4) {
        case 0:
            sine = s;
            cosine = c;
            return;
        case 1:
            sine = c;
            cosine = -s;
            return;
        case 2:
            sine = -s;
            cosine = -c;
            return;
        default:
            sine = -c;
            cosine = s;
            return;
    }
}

}  // namespace

Frame Frame::translation(const Point3& by) {
    Frame f;
    f.shift = by;
    return f;
}

Frame Frame::translation(unsigned place, double by) {
    Frame f;
    f.offset[place] = by;
    return f;
}

Frame Frame::rotation(GeoAxis about, double degrees) {
    // from i towards j
    const auto k = static_cast<std::size_t>(about), i = (k + 1) % 3, j = (k + 2) % 3;
    double s = 0, c = 1;
    sine_cosine(degrees, s, c);
    Frame f;
    f.linear[i][i] = c;
    f.linear[i][j] = -s;
    f.linear[j][i] = s;
    f.linear[j][j] = c;
    return f;
}

Frame Frame::scaling(const Point3& factors) {
    Frame f;
    for (std::size_t i = 0; i < 3; ++i) f.linear[i][i] = factors[i];
    return f;
}

Frame Frame::scaling(unsigned place, double factor) {
    Frame f;
    f.scale[place] = factor;
    return f;
}

Frame Frame::mirror(bool x, bool y, bool z) {
    return scaling({x ? -1.0 : 1.0, y ? -1.0 : 1.0, z ? -1.0 : 1.0});
}

Point3 Frame::direction(const Point3& v) const {
    Point3 out{};
    for (std::size_t i = 0; i < 3; ++i)
        out[i] = linear[i][0] * v[0] + linear[i][1] * v[1] + linear[i][2] * v[2];
    return out;
}

Point3 Frame::map(const Point3& point) const {
    Point3 out = direction(point);
    for (std::size_t i = 0; i < 3; ++i) out[i] += shift[i];
    return out;
}

Point3 Frame::axis(GeoAxis of) const {
    const auto k = static_cast<std::size_t>(of);
    return {linear[0][k], linear[1][k], linear[2][k]};
}

Frame Frame::operator*(const Frame& inner) const {
    Frame f;
    for (std::size_t i = 0; i < 3; ++i)
        for (std::size_t j = 0; j < 3; ++j)
            f.linear[i][j] = linear[i][0] * inner.linear[0][j] + linear[i][1] * inner.linear[1][j] +
                             linear[i][2] * inner.linear[2][j];
    f.shift = map(inner.shift);
    for (std::size_t i = 0; i < scale.size(); ++i) {
        f.scale[i] = scale[i] * inner.scale[i];
        f.offset[i] = scale[i] * inner.offset[i] + offset[i];
    }
    return f;
}

double Frame::determinant() const {
    const auto& m = linear;
    return m[0][0] * (m[1][1] * m[2][2] - m[1][2] * m[2][1]) -
           m[0][1] * (m[1][0] * m[2][2] - m[1][2] * m[2][0]) +
           m[0][2] * (m[1][0] * m[2][1] - m[1][1] * m[2][0]);
}

bool Frame::invertible() const {
    for (const double s : scale)
        if (std::fabs(s) < kSingular) return false;
    return std::fabs(determinant()) > kSingular;
}

Frame Frame::inverse() const {
    Frame f;
    const double d = determinant();
    for (std::size_t i = 0; i < 3; ++i)
        for (std::size_t j = 0; j < 3; ++j) {
            const std::size_t a = (j + 1) % 3, b = (j + 2) % 3, p = (i + 1) % 3, q = (i + 2) % 3;
            f.linear[i][j] = (linear[a][p] * linear[b][q] - linear[a][q] * linear[b][p]) / d;
        }
    f.shift = f.direction({-shift[0], -shift[1], -shift[2]});
    for (std::size_t i = 0; i < scale.size(); ++i) {
        f.scale[i] = 1.0 / scale[i];
        f.offset[i] = -offset[i] / scale[i];
    }
    return f;
}

bool Frame::is_identity() const {
    const Frame none;
    return linear == none.linear && shift == none.shift && scale == none.scale &&
           offset == none.offset;
}

}  // namespace polyturn::channels
