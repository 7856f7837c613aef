// A quantity with its first three derivatives along the path, as coefficients of its Taylor series:
// arithmetic on jets is the chain rule, so one formula gives position, velocity, acceleration and
// jerk (Griewank, Walther: Evaluating Derivatives, 13.2).
//
//     x(s + h) = c[0] + c[1] h + c[2] h^2 + c[3] h^3        derivative k is k! c[k]
#pragma once
#include <array>
#include <cmath>

namespace polyturn {

struct Jet {
    std::array<double, 4> c{};
    constexpr Jet() = default;
    constexpr Jet(double value)
        : c{value, 0, 0, 0} {}  // NOLINT(google-explicit-constructor): a constant is a jet
    constexpr Jet(double value, double first, double second, double third)
        : c{value, first, second / 2, third / 6} {}
    double value() const noexcept { return c[0]; }
    double first() const noexcept { return c[1]; }
    double second() const noexcept { return 2 * c[2]; }
    double third() const noexcept { return 6 * c[3]; }
};

inline double value_of(double x) noexcept { return x; }
inline double value_of(const Jet& x) noexcept { return x.c[0]; }

inline Jet operator+(Jet a, const Jet& b) noexcept {
    for (std::size_t k = 0; k < 4; ++k) a.c[k] += b.c[k];
    return a;
}
inline Jet operator-(Jet a, const Jet& b) noexcept {
    for (std::size_t k = 0; k < 4; ++k) a.c[k] -= b.c[k];
    return a;
}
inline Jet operator-(const Jet& a) noexcept { return Jet{} - a; }
inline Jet operator*(const Jet& a, const Jet& b) noexcept {
    Jet r;
    for (std::size_t k = 0; k < 4; ++k)
        for (std::size_t i = 0; i <= k; ++i) r.c[k] += a.c[i] * b.c[k - i];
    return r;
}
// r b = a, solved from the lowest coefficient up
inline Jet operator/(const Jet& a, const Jet& b) noexcept {
    Jet r;
    for (std::size_t k = 0; k < 4; ++k) {
        double rest = a.c[k];
        for (std::size_t i = 0; i < k; ++i) rest -= r.c[i] * b.c[k - i];
        r.c[k] = rest / b.c[0];
    }
    return r;
}
inline Jet sqrt(const Jet& a) noexcept {  // r r = a
    Jet r(std::sqrt(a.c[0]));
    for (std::size_t k = 1; k < 4; ++k) {
        double rest = a.c[k];
        for (std::size_t i = 1; i < k; ++i) rest -= r.c[i] * r.c[k - i];
        r.c[k] = rest / (2 * r.c[0]);
    }
    return r;
}
inline void sincos(const Jet& a, Jet& sine, Jet& cosine) noexcept {  // s' = a' c, c' = -a' s
    sine = Jet(std::sin(a.c[0]));
    cosine = Jet(std::cos(a.c[0]));
    for (std::size_t k = 1; k < 4; ++k) {
        double s = 0, c = 0;
        for (std::size_t i = 1; i <= k; ++i) {
            const double d = static_cast<double>(i) * a.c[i];
            s += d * cosine.c[k - i];
            c -= d * sine.c[k - i];
        }
        sine.c[k] = s / static_cast<double>(k);
        cosine.c[k] = c / static_cast<double>(k);
    }
}
inline void sincos(double a, double& sine, double& cosine) noexcept {
    sine = std::sin(a);
    cosine = std::cos(a);
}
// (x y' - y x') / (x^2 + y^2), integrated
inline Jet atan2(const Jet& y, const Jet& x) noexcept {
    Jet dy, dx;
    for (std::size_t k = 0; k < 3; ++k) {
        dy.c[k] = static_cast<double>(k + 1) * y.c[k + 1];
        dx.c[k] = static_cast<double>(k + 1) * x.c[k + 1];
    }
    const Jet rate = (x * dy - y * dx) / (x * x + y * y);
    Jet r(std::atan2(y.c[0], x.c[0]));
    for (std::size_t k = 1; k < 4; ++k) r.c[k] = rate.c[k - 1] / static_cast<double>(k);
    return r;
}

}  // namespace polyturn
