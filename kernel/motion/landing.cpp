#include "kernel/motion/landing.hpp"

namespace polyturn::kernel {

bool Landing::aim(double v, double a, double distance, double a_max, double j_least,
                  double j_most) noexcept {
    if (!(v > 0)) return false;
    double low = std::max(j_least, a < 0 ? a * a / (2 * v) : 0.0), high = j_most;
    // The softer the jerk, the longer the distance.
    if (low > high || stopping_distance(v, a, a_max, high) > distance ||
        stopping_distance(v, a, a_max, low) < distance * (1 - 1e-8))
        return false;
    for (int i = 0; i < 60; ++i) {
        const double middle = (low + high) / 2;
        (stopping_distance(v, a, a_max, middle) <= distance ? high : low) = middle;
    }
    jerk_ = high;
    profile_ = profile_to_speed(v, a, 0, a_max, high);
    start_ = {0, v, a};
    time_ = moved_ = 0;
    landed_ = false;
    distance_ = distance;
    return true;
}

PathState Landing::step(double dt) noexcept {
    time_ += dt;
    const double left = profile_.duration() - time_;
    PathState next{distance_, 0, 0};
    if (left > 1e-9 * dt) {
        if (left < profile_.time[2]) {
            const double j = profile_.jerk[2];
            next = {distance_ - j * left * left * left / 6, j * left * left / 2, -j * left};
        } else {
            next = start_;
            double time = time_;
            for (int i = 0; i < 3; ++i) {
                const double t = std::min(time, profile_.time[i]);
                next = advanced(next, profile_.jerk[i], t);
                time -= t;
            }
        }
    }
    landed_ = left <= 1e-9 * dt;
    const double before = moved_;
    moved_ = next.s;
    next.s -= before;
    return next;
}

void Landing::at_once(double distance) noexcept {
    distance_ = moved_ = distance;
    profile_ = {};
    time_ = 0;
    landed_ = true;
}

}  // namespace polyturn::kernel
