// Rotary heads and tables (nct part 2 33, N3200 to N3224): path coordinates are those of the tool's
// tip on the workpiece as it lies with both rotary axes at 0; the linear axes make good what the
// rotary ones move.
//
//   table    x -> c + R(angle) (x - c)     turns the workpiece
//   head     tip = pivot + R(angle) arm    turns the tool about its pivot
//   M = T1 T2 p - (H1(arm1 + H2 arm2) - (arm1 + arm2))
// The first table carries the second one, the first head the second head. With both at 0 the
// coordinates of path and axes are the same: tool length and zeros stay where they are.
#pragma once
#include "ipc/kinematics/kinematics.hpp"

namespace polyturn::five_axis {

// Layout of Kinematics::value.
// unit vectors; 0 0 0: that axis does not exist
inline constexpr std::size_t kFirstDirection = 0, kSecondDirection = 3;
// table: a point on the rotary axis, machine coordinates; head: the arm that it turns (from its
// pivot on), mm
inline constexpr std::size_t kFirstPoint = 6, kSecondPoint = 9;
inline constexpr std::size_t kFirstIsHead = 12, kSecondIsHead = 13;  // 1 head, 0 table

template <class T>
using Vector = std::array<T, 3>;

// Rodrigues: turns x about the unit vector n by the angle (degrees).
template <class T>
Vector<T> turned(const double* n, const T& degrees, const Vector<T>& x) noexcept {
    constexpr double kRad = 0.017453292519943295;
    T s, c;
    sincos(degrees * T(kRad), s, c);
    const T along = (T(n[0]) * x[0] + T(n[1]) * x[1] + T(n[2]) * x[2]) * (T(1.0) - c);
    const Vector<T> cross{T(n[1]) * x[2] - T(n[2]) * x[1], T(n[2]) * x[0] - T(n[0]) * x[2],
                          T(n[0]) * x[1] - T(n[1]) * x[0]};
    Vector<T> r;
    for (std::size_t i = 0; i < 3; ++i) r[i] = c * x[i] + s * cross[i] + along * T(n[i]);
    return r;
}

inline bool exists(const Kinematics& k, std::size_t direction) noexcept {
    return k.value[direction] != 0 || k.value[direction + 1] != 0 || k.value[direction + 2] != 0;
}

// How the tip moves against its place with all heads at 0.
template <class T>
Vector<T> head_shift(const Kinematics& k, const T& first, const T& second) noexcept {
    Vector<T> tip{T(0.0), T(0.0), T(0.0)}, rest = tip;
    const auto add = [&](std::size_t point) {
        for (std::size_t i = 0; i < 3; ++i) {
            tip[i] = tip[i] + T(k.value[point + i]);
            rest[i] = rest[i] + T(k.value[point + i]);
        }
    };
    if (k.value[kSecondIsHead] != 0 && exists(k, kSecondDirection)) {
        add(kSecondPoint);
        tip = turned(&k.value[kSecondDirection], second, tip);
    }
    if (k.value[kFirstIsHead] != 0 && exists(k, kFirstDirection)) {
        add(kFirstPoint);
        tip = turned(&k.value[kFirstDirection], first, tip);
    }
    for (std::size_t i = 0; i < 3; ++i) tip[i] = tip[i] - rest[i];
    return tip;
}

template <class T>
Vector<T> about(const Kinematics& k, std::size_t point, std::size_t direction, const T& degrees,
                Vector<T> x) noexcept {
    for (std::size_t i = 0; i < 3; ++i) x[i] = x[i] - T(k.value[point + i]);
    x = turned(&k.value[direction], degrees, x);
    for (std::size_t i = 0; i < 3; ++i) x[i] = x[i] + T(k.value[point + i]);
    return x;
}

template <class T>
Vector<T> linear_axes(const Kinematics& k, Vector<T> x, const T& first, const T& second) noexcept {
    if (k.value[kSecondIsHead] == 0 && exists(k, kSecondDirection))
        x = about(k, kSecondPoint, kSecondDirection, second, x);
    if (k.value[kFirstIsHead] == 0 && exists(k, kFirstDirection))
        x = about(k, kFirstPoint, kFirstDirection, first, x);
    const Vector<T> shift = head_shift(k, first, second);
    for (std::size_t i = 0; i < 3; ++i) x[i] = x[i] - shift[i];
    return x;
}

inline Vector<double> tip(const Kinematics& k, Vector<double> x, double first,
                          double second) noexcept {
    const Vector<double> shift = head_shift(k, first, second);
    for (std::size_t i = 0; i < 3; ++i) x[i] += shift[i];
    if (k.value[kFirstIsHead] == 0 && exists(k, kFirstDirection))
        x = about(k, kFirstPoint, kFirstDirection, -first, x);
    if (k.value[kSecondIsHead] == 0 && exists(k, kSecondDirection))
        x = about(k, kSecondPoint, kSecondDirection, -second, x);
    return x;
}

}  // namespace polyturn::five_axis
