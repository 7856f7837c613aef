#include "kernel/motion/jerk_profile.hpp"

namespace polyturn::kernel {

namespace {
// Braking from (v, 0) to (w, 0): mean speed (v + w)/2 times the time of a symmetrical ramp.
double braking_length(double v, double w, double a_max, double j_max) {
    const double d = v - w;
    const double time = d <= a_max * a_max / j_max ? 2 * std::sqrt(d / j_max) : d / a_max + a_max / j_max;
    return (v + w) / 2 * time;
}

// Solves braking_length(v, w) = distance for v >= w by bisection: rises with v for a fixed w.
double top_speed_to(double distance, double w, double a_max, double j_max) {
    // With the ramp's jerk phase the length exceeds (v^2 - w^2)/(2 A): an upper bound of v.
    double low = w, high = std::sqrt(w * w + 2 * a_max * distance);
    for (int i = 0; i < 44 && high - low > 1e-12 * high; ++i) {
        const double middle = (low + high) / 2;
        (braking_length(middle, w, a_max, j_max) <= distance ? low : high) = middle;
    }
    return low;
}
}  // namespace

double top_speed(double distance, double w, double a_max, double j_max) noexcept {
    if (!(distance > 0)) return w;
    const double to_w = top_speed_to(distance, w, a_max, j_max);
    // The trap of the header: stopping first can be shorter than braking to a crawl.
    return w == 0 ? to_w : std::max(to_w, top_speed_to(distance, 0, a_max, j_max));
}

double Braking::falling_distance(double c) const noexcept {
    if (peak <= c) return 0;
    for (int i = 0; i < 3; ++i) {
        const PathState& x = at[i];
        if (at[i + 1].v > c || (i == 0 && x.a > 0 && profile.jerk[0] >= 0)) continue;
        // x.v + x.a t + j t^2/2 = c: the root at which the speed falls.
        const double j = profile.jerk[i], excess = x.v - c;
        double t;
        if (j == 0) {
            t = x.a < 0 ? excess / -x.a : 0;
        } else {
            const double root = std::sqrt(std::max(0.0, x.a * x.a - 2 * j * excess));
            t = (-x.a - root) / j;  // j > 0: the first one; j < 0: the second one
        }
        return advanced(x, j, std::clamp(t, 0.0, profile.time[i])).s;
    }
    return at[3].s;
}

}  // namespace polyturn::kernel
