// The acceleration and jerk that the axes leave to the path at a speed v.
//
// With t, n the unit tangent and normal of a plane path and k its curvature, a point that moves
// along it has
//     acceleration   t a                + n k v^2
//     jerk           t (j - k^2 v^3)    + n (3 k v a + k' v^3)
// so that, with bend k, turning 3 k, along k^2 and across |k'| the largest of a record (in general:
// channels/path/record_limits.hpp),
//     a^2 + (bend v^2)^2                                      <= A^2                      (1)
//     (|j| + along v^3)^2 + (turning v |a| + across v^3)^2    <= J^2                      (2)
// keep the axes within A and J. On a line the four are 0 and A and J are all there is (`flat`).
//
// Right     Both leave the more the smaller v is: what is allowed at some speed is allowed at any
//           lower one. So a braking whose pieces are each checked at their highest speed and
//           acceleration keeps (1) and (2) all along.
// Cost      A square root or two.
#pragma once
#include <algorithm>
#include <cmath>

namespace polyturn::kernel {

struct Limits {
    double a = 0;                  // mm/s2 at standstill
    double j = 0;                  // mm/s3 at standstill
    double bend = 0, turning = 0;  // 1/mm
    double along = 0, across = 0;  // 1/mm2

    // Of the jerk, kept for changing acceleration at the largest one: without it, a braking could
    // not be ended.
    static constexpr double kChange = 0.08;

    [[nodiscard]] bool flat() const noexcept {
        return bend == 0 && turning == 0 && along == 0 && across == 0;
    }
    // Largest acceleration at v that leaves jerk to end it; 0: faster than these limits know.
    [[nodiscard]] double acceleration(double v) const noexcept {
        if (flat()) return a;
        const double v3 = v * v * v, normal = bend * v * v, tangential = along * v3 + kChange * j;
        const double left = a * a - normal * normal, jerk_left = j * j - tangential * tangential;
        if (!(left > 0) || !(jerk_left > 0)) return 0;
        const double by_a = std::sqrt(left), by_j = std::sqrt(jerk_left) - across * v3,
                     turn = turning * v;
        return by_j <= 0 ? 0 : by_a * turn <= by_j ? by_a : by_j / turn;
    }
    // Largest jerk at v as long as the acceleration is no more than p, either way.
    [[nodiscard]] double jerk(double v, double p) const noexcept {
        if (flat()) return j;
        const double v3 = v * v * v, normal = turning * v * p + across * v3;
        const double left = j * j - normal * normal;
        return left > 0 ? std::max(0.0, std::sqrt(left) - along * v3) : 0;
    }
    // What holds at v while the acceleration is at most p, as if it did not depend on them.
    [[nodiscard]] Limits at(double v, double p) const noexcept {
        if (flat()) return *this;
        const double most = acceleration(v);
        return {most, jerk(v, std::min(p, most))};
    }
    void narrow(const Limits& other) noexcept {
        a = std::min(a, other.a);
        j = std::min(j, other.j);
        bend = std::max(bend, other.bend);
        turning = std::max(turning, other.turning);
        along = std::max(along, other.along);
        across = std::max(across, other.across);
    }
    void widen(const Limits& other) noexcept {
        a = std::max(a, other.a);
        j = std::max(j, other.j);
        bend = std::min(bend, other.bend);
        turning = std::min(turning, other.turning);
        along = std::min(along, other.along);
        across = std::min(across, other.across);
    }
    [[nodiscard]] bool narrower_than(const Limits& other) const noexcept {
        return a < other.a || j < other.j || bend > other.bend || turning > other.turning ||
               along > other.along || across > other.across;
    }
};

}  // namespace polyturn::kernel
