#include "kernel/motion/jerk_profile.hpp"

namespace polyturn::kernel {

namespace {
// Halvings from an upper bound, and the relative difference that ends them: 2^-44 is 6e-14.
constexpr int kBisections = 44;
constexpr double kNear = 1e-12;

// Braking from (v, 0) to (w, 0): mean speed (v + w)/2 times the time of a symmetrical ramp.
// With `drop` v - w, that takes 2 sqrt(drop/J) where A is not reached, else drop/A + A/J.
double braking_length(double v, double w, double a_max, double j_max) {
    const double drop = v - w;
    const double time =
        drop <= a_max * a_max / j_max ? 2 * std::sqrt(drop / j_max) : drop / a_max + a_max / j_max;
    return (v + w) / 2 * time;
}

// Solves braking_length(v, w) = distance for v >= w by bisection: rises with v for a fixed w.
double top_speed_to(double distance, double w, double a_max, double j_max) {
    // With the ramp's jerk phase the length exceeds (v^2 - w^2)/(2 A): an upper bound of v.
    double low = w, high = std::sqrt(w * w + 2 * a_max * distance);
    for (int i = 0; i < kBisections && high - low > kNear * high; ++i) {
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

}  // namespace polyturn::kernel
