// Changing speed under limits of acceleration and jerk, in closed form.
//
//   a |  .
//     | / \   j = -J                 (v, a) -> (w, 0) as fast as can be: a falls to -p, holds,
//     |/   \                         returns to 0; p <= A. If releasing at once (a -> 0) already
//     +-----\------------/---> t     ends below w, the mirror image: a rises to +p.
//     |      \          /
//     |       '--------'  -p
//
// It is time-optimal, and of all profiles that brake the lowest in speed at every point of the
// path, so also the shortest.
//
// Given    v, a; w; A, J. The speed at which releasing at once ends: release = v + a|a|/(2J).
// Braking  (release > w)   p^2 = J (v - w) + a^2/2, at most A^2;                            (1)
//                          hold = (v + a^2/(2J) - p^2/J - w) / p
//          a < -A at the start: jerk +J to -A first; (1) holds with that state.
// Cost     One square root.
// The trap: the distance to (w, 0) is not monotonous in w; to a crawl it can be longer than to a
//          stop. For a fixed start it rises and then falls as w grows from 0, so the least over
//          [0, w] lies at an end.
// Source   Biagiotti, Melchiorri: Trajectory Planning for Automatic Machines and Robots, 2008,
//          section 3.4.
#pragma once
#include <algorithm>
#include <cmath>

namespace polyturn::kernel {

struct PathState {
    double s = 0;  // mm
    double v = 0;  // mm/s
    double a = 0;  // mm/s2
};

// The state after time t under constant jerk j.
[[nodiscard]] inline PathState advanced(const PathState& x, double j, double t) noexcept {
    return {x.s + t * (x.v + t * (x.a / 2 + t * j / 6)), x.v + t * (x.a + t * j / 2), x.a + t * j};
}

// Three pieces of constant jerk.
struct SpeedProfile {
    double time[3] = {0, 0, 0};
    double jerk[3] = {0, 0, 0};
    [[nodiscard]] double duration() const noexcept { return time[0] + time[1] + time[2]; }
};

[[nodiscard]] inline double release_speed(double v, double a, double j) noexcept {
    return v + a * std::abs(a) / (2 * j);
}

// From (v, a) to (w, 0), time-optimal.
[[nodiscard]] inline SpeedProfile profile_to_speed(double v, double a, double w, double a_max,
                                                   double j_max) noexcept {
    SpeedProfile p;
    const double surplus = release_speed(v, a, j_max) - w;
    if (std::abs(surplus) <= 1e-11 * (std::abs(v) + std::abs(w))) {
        // Releasing is all. Rounding must not put pieces around it: what is 1e-16 of v is 1e-8 of a
        // time.
        p.time[a > 0 ? 0 : 2] = std::abs(a) / j_max;
        p.jerk[a > 0 ? 0 : 2] = a > 0 ? -j_max : j_max;
        return p;
    }
    const double sign = surplus > 0 ? 1 : -1;  // mirrored, so that it always brakes
    v *= sign;
    a *= sign;
    w *= sign;
    double first_jerk = -j_max;
    if (a < -a_max) {  // more than allowed here: back to the limit first
        p.time[0] = (-a_max - a) / j_max;
        first_jerk = j_max;
        v += (a - a_max) / 2 * p.time[0];
        p.time[1] = std::max(0.0, (v - a_max * a_max / (2 * j_max) - w) / a_max);
        p.time[2] = a_max / j_max;
    } else {
        double peak = std::sqrt(std::max(j_max * (v - w) + a * a / 2, 0.0));
        if (peak > a_max) {
            peak = a_max;
            p.time[1] = std::max(0.0, (v + (a * a / 2 - peak * peak) / j_max - w) / a_max);
        }
        p.time[0] = std::max(0.0, (a + peak) / j_max);
        p.time[2] = peak / j_max;
    }
    p.jerk[0] = sign * first_jerk;
    p.jerk[2] = sign * j_max;
    return p;
}

// Where a profile leads; t: how far along it (its whole duration, and constant in
// acceleration afterwards).
[[nodiscard]] inline PathState after_profile(PathState x, const SpeedProfile& p) noexcept {
    for (int i = 0; i < 3; ++i) x = advanced(x, p.jerk[i], p.time[i]);
    return x;
}

// One tick towards speed w, switching inside the tick where the profile does; once there, steady.
[[nodiscard]] inline PathState towards_speed(PathState x, double w, double a_max, double j_max,
                                             double dt) noexcept {
    const SpeedProfile p = profile_to_speed(x.v, x.a, w, a_max, j_max);
    double left = dt;
    for (int i = 0; i < 3; ++i) {
        const double t = std::min(left, p.time[i]);
        x = advanced(x, p.jerk[i], t);
        left -= t;
    }
    if (p.duration() <= dt * (1 + 1e-6)) {  // there: exactly, not but for rounding
        x.v = w;
        x.a = 0;
        x.s += w * left;
    } else if (x.v < 0 && x.v > -1e-9) {
        x.v = 0;
    }
    return x;
}

// Distance from (v, a) to (w, 0) by profile_to_speed.
[[nodiscard]] inline double distance_to_speed(double v, double a, double w, double a_max,
                                              double j_max) noexcept {
    return after_profile({0, v, a}, profile_to_speed(v, a, w, a_max, j_max)).s;
}
[[nodiscard]] inline double stopping_distance(double v, double a, double a_max,
                                              double j_max) noexcept {
    return distance_to_speed(v, a, 0, a_max, j_max);
}
// No speed at all takes longer to brake to than this: the stopping distance and what the trap adds
// at the most. With u = v + a^2/(2J), the speed of which (v, a) is a part of the braking: the
// longest is to u/3, by 0.0887 u sqrt(u/J), as long as A is not reached; with A reached to
// A^2/(2J), by A^3/(8 J^2).
[[nodiscard]] inline double longest_braking(double v, double a, double a_max,
                                            double j_max) noexcept {
    const double u = v + a * a / (2 * j_max);
    return stopping_distance(v, a, a_max, j_max) +
           std::min(0.09 * u * std::sqrt(u / j_max), a_max * a_max * a_max / (8 * j_max * j_max));
}
[[nodiscard]] inline double stopping_time(double v, double a, double a_max, double j_max) noexcept {
    return profile_to_speed(v, a, 0, a_max, j_max).duration();
}

// Highest speed with a = 0 from which (w, 0) or less is reached within a distance. Bisection: exact
// to rounding, from below.
[[nodiscard]] double top_speed(double distance, double w, double a_max, double j_max) noexcept;

// While acceleration is released at once (a < 0, jerk +J): distance until the speed has fallen to
// c. Given v > c >= release.
[[nodiscard]] inline double release_distance_to(double v, double a, double c,
                                                double j_max) noexcept {
    const double t = (-a - std::sqrt(std::max(a * a - 2 * j_max * (v - c), 0.0))) / j_max;
    return t * (v + t * (a / 2 + t * j_max / 6));
}

}  // namespace polyturn::kernel
