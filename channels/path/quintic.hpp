// Quintic polynomials over 0..1: values, derivatives, the one with given ends, one half of another.
#pragma once
#include <array>

namespace polyturn::channels {

using Quintic = std::array<double, 6>;

struct QuinticEnd {
    double value, first, second;
};
inline Quintic hermite(const QuinticEnd& a, const QuinticEnd& b) {
    const double d = b.value - a.value;
    return {a.value,
            a.first,
            0.5 * a.second,
            10 * d - 6 * a.first - 4 * b.first - 1.5 * a.second + 0.5 * b.second,
            -15 * d + 8 * a.first + 7 * b.first + 1.5 * a.second - b.second,
            6 * d - 3 * (a.first + b.first) - 0.5 * (a.second - b.second)};
}
inline double at(const Quintic& c, double u) {
    return c[0] + u * (c[1] + u * (c[2] + u * (c[3] + u * (c[4] + u * c[5]))));
}
inline double slope_at(const Quintic& c, double u) {
    return c[1] + u * (2 * c[2] + u * (3 * c[3] + u * (4 * c[4] + u * 5 * c[5])));
}
inline double bend_at(const Quintic& c, double u) {
    return 2 * c[2] + u * (6 * c[3] + u * (12 * c[4] + u * 20 * c[5]));
}

// q(v) = c(from + width v)
inline Quintic part_of(const Quintic& c, double from, double width) {
    Quintic q = c;
    // Taylor shift by `from` (Horner's scheme, repeated)
    for (int i = 0; i < 5; ++i)
        for (int k = 4; k >= i; --k)
            q[static_cast<std::size_t>(k)] += from * q[static_cast<std::size_t>(k) + 1];
    double power = 1;
    for (double& x : q) {
        x *= power;
        power *= width;
    }
    return q;
}

}  // namespace polyturn::channels
