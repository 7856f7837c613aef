#include "channels/path/record_limits.hpp"

#include <algorithm>
#include <limits>
#include <numbers>

namespace polyturn::channels {
namespace {

constexpr double kInfinity = std::numeric_limits<double>::infinity();
constexpr double kFlat = 1e-12;                   // an axis' share below this does not move
constexpr double kFastest = 1e6, kHardest = 1e9;  // where no axis limits: keeps arithmetic finite
// Points of an arc that are sampled: so many and so many a radian, at the most ... (every 0.1 rad
// its tangent has turned by 6 degrees, what lies between is in kSampling), and its quarters.
constexpr std::size_t kArcSamples = 4, kMostArcSamples = 64;
constexpr double kArcSamplesPerRad = 10;
constexpr std::size_t kMostSamples = 80;
// Of a curve's record, a quintic, and of a record behind a transformation, which bends it more.
constexpr std::size_t kCurveSteps = 8, kTransformedSteps = 12;
// Threads: of the jerk that the bend leaves, for changing acceleration through it. The other half
// remains for the jerk along the path.
constexpr double kThreadTurning = 0.5;
// d3/dt3 of a path at speed v with acceleration a has the term 3 k v a: limits.hpp.
constexpr double kTurning = 3;

struct Samples {
    std::size_t count = 0;
    std::array<PathDerivatives, kMostSamples> at;
};

RecordLimits finite(RecordLimits c) {
    c.v = std::min(c.v, kFastest);
    c.a = std::min(c.a, kHardest);
    return c;
}

RecordLimits of_line(const PathRecord& r, const PathLimits& limits, bool rapid) {
    RecordLimits c{kInfinity, kInfinity, kInfinity};
    for (std::size_t i = 0; i < r.axis_count; ++i) {
        const double t = std::abs(r.end[i] - r.start[i]) / r.length;
        if (t < kFlat) continue;
        const PathAxis& axis = limits.axis[r.axis[i]];
        c.v = std::min(c.v, (rapid ? axis.rapid : axis.feed) / t);
        c.a = std::min(c.a, axis.accel / t);
        c.j = std::min(c.j, axis.jerk / t);
    }
    if (rapid && r.feed > 0) c.v = std::min(c.v, r.feed);  // a programmed share of rapid
    return finite(c);
}

// At one speed: see record_limits.hpp, threads.
RecordLimits of_thread(const PathRecord& r, const PathLimits& limits, bool rapid,
                       const Samples& samples) {
    RecordLimits c{kInfinity, kInfinity, kInfinity};
    double bend = 0, twist = 0;  // largest of v^-2 and v^-3 seen; roots are taken once
    for (std::size_t n = 0; n < samples.count; ++n)
        for (std::size_t i = 0; i < r.axis_count; ++i) {
            const PathAxis& axis = limits.axis[r.axis[i]];
            const PathDerivatives& at = samples.at[n];
            const double t = std::abs(at.first[i]), k = std::abs(at.second[i]),
                         p = std::abs(at.third[i]);
            if (t > kFlat) c.v = std::min(c.v, (rapid ? axis.rapid : axis.feed) / t);
            bend = std::max(bend, k / std::min(kThreadBend * axis.accel, axis.normal));
            twist = std::max(twist, p / (kThreadTwist * axis.jerk));
        }
    if (bend > 0) c.v = std::min(c.v, std::sqrt(1 / bend));
    if (twist > 0) c.v = std::min(c.v, std::cbrt(1 / twist));
    c.v = std::min(c.v * kSampling, kFastest);
    // a share of rapid, or what its spindle asks for
    if (r.feed > 0 && (rapid || static_cast<FeedMode>(r.feed_mode) == FeedMode::Thread))
        c.v = std::min(c.v, r.feed);
    const double v2 = c.v * c.v, v3 = v2 * c.v;
    const auto each = [&](auto&& use) {
        for (std::size_t n = 0; n < samples.count; ++n)
            for (std::size_t i = 0; i < r.axis_count; ++i)
                use(limits.axis[r.axis[i]], std::abs(samples.at[n].first[i]),
                    std::abs(samples.at[n].second[i]), std::abs(samples.at[n].third[i]));
    };
    each([&](const PathAxis& axis, double t, double k, double p) {
        if (t > kFlat) c.a = std::min(c.a, (axis.accel - k * v2) / t);
        if (k * c.v > kFlat)
            c.a = std::min(c.a, kThreadTurning * (axis.jerk - p * v3) / (kTurning * k * c.v));
    });
    c.a = std::min(c.a * kSampling, kHardest);
    each([&](const PathAxis& axis, double t, double k, double p) {
        if (t > kFlat) c.j = std::min(c.j, (axis.jerk - p * v3 - kTurning * k * c.v * c.a) / t);
    });
    c.j *= kSampling;
    return c;
}

// t, k, p as vectors of what the axes do, each divided by its limit: lengths of the longest, and
// the largest product of t and k.
struct Shares {
    double t = 0, k = 0, tk = 0;
    double along = 0, across = 0;  // p along t and the rest of it
    void add(const PathDerivatives& at, const PathRecord& r, const PathLimits& limits,
             double PathAxis::*limit) {
        double t2 = 0, k2 = 0, p2 = 0, t_k = 0, t_p = 0;
        for (std::size_t i = 0; i < r.axis_count; ++i) {
            const double most = limits.axis[r.axis[i]].*limit;
            if (!std::isfinite(most)) continue;
            const double x = at.first[i] / most, y = at.second[i] / most, z = at.third[i] / most;
            t2 += x * x;
            k2 += y * y;
            p2 += z * z;
            t_k += x * y;
            t_p += x * z;
        }
        t = std::max(t, std::sqrt(t2));
        k = std::max(k, std::sqrt(k2));
        tk = std::max(tk, std::abs(t_k));
        const double part = t2 > 0 ? t_p / t2 : 0;
        along = std::max(along, std::abs(part) * std::sqrt(t2));
        across = std::max(across, std::sqrt(std::max(0.0, p2 - part * t_p)));
    }
    // Square root of 1 + c.
    double skew() const { return t * k > 0 ? std::sqrt(1 + std::min(1.0, tk / (t * k))) : 1; }
};

// `least`: what the bend alone must not lower the speed below (N0310); it may take more than N0400
// then, never more than N0402 and the jerk.
RecordLimits of_samples(const PathRecord& r, const PathLimits& limits, bool rapid,
                        const Samples& samples, double least = 0) {
    RecordLimits c{kInfinity, kInfinity, kInfinity};
    Shares of_a, of_j;
    for (std::size_t n = 0; n < samples.count; ++n) {
        const PathDerivatives& at = samples.at[n];
        for (std::size_t i = 0; i < r.axis_count; ++i) {
            const PathAxis& axis = limits.axis[r.axis[i]];
            const double t = std::abs(at.first[i]), k = std::abs(at.second[i]);
            if (t > kFlat) c.v = std::min(c.v, (rapid ? axis.rapid : axis.feed) / t);
            if (k > kFlat && (axis.normal < axis.accel || least > 0))
                c.v = std::min(c.v, std::sqrt(axis.normal / k));
        }
        of_a.add(at, r, limits, &PathAxis::accel);
        of_j.add(at, r, limits, &PathAxis::jerk);
    }
    const double a_skew = of_a.skew(), j_skew = of_j.skew();
    // (2) for j_max = 1
    const double j_along = j_skew * of_j.along, j_across = j_skew * of_j.across;
    c.a = std::min(kSampling / std::max(a_skew * of_a.t, kFlat), kHardest);
    c.bend = c.a * a_skew * of_a.k;
    if (of_j.t > 0) {
        c.j = kSampling / (j_skew * of_j.t);
        c.turning = c.j * kTurning * j_skew * of_j.k;
        c.along = c.j * j_along;
        c.across = c.j * j_across;
    }
    double by_bend = kInfinity;
    if (c.bend > 0) by_bend = std::sqrt(kBendShare * c.a / c.bend);
    if (const double lift = least / (by_bend * kSampling); lift > 1) {  // (1) goes with v^2
        by_bend *= lift;
        c.bend /= lift * lift;
    }
    // (2) with kAlongLeft and kAcrossLeft of j_max to spare: a quadratic equation in v^3.
    const double square = j_along * j_along + j_across * j_across;
    if (square > 0) {
        const double half = kAlongLeft * j_along + kAcrossLeft * j_across;
        const double rest =
            kSampling * kSampling - kAlongLeft * kAlongLeft - kAcrossLeft * kAcrossLeft;
        by_bend =
            std::min(by_bend, std::cbrt((std::sqrt(half * half + square * rest) - half) / square));
    }
    c.v = std::min(std::min(c.v, by_bend) * kSampling, kFastest);
    if (rapid && r.feed > 0) c.v = std::min(c.v, r.feed);
    return c;
}

// Evenly, and where a plane axis turns back (there its curvature or its speed is largest).
void sample_arc(const PathRecord& r, Samples& samples) {
    const double sweep = r.shape[arc_shape::kSweep], start = r.shape[arc_shape::kStartAngle];
    const double seen = std::min(std::abs(sweep), 2 * std::numbers::pi);
    const std::size_t steps = std::min<std::size_t>(
        kMostArcSamples, kArcSamples + static_cast<std::size_t>(seen * kArcSamplesPerRad));
    for (std::size_t n = 0; n <= steps; ++n)
        derivatives_at(r,
                       r.length * (seen / std::abs(sweep)) * static_cast<double>(n) /
                           static_cast<double>(steps),
                       samples.at[samples.count++]);
    const double quarter = std::numbers::pi / 2, low = std::min(start, start + sweep),
                 high = low + seen;
    for (double angle = std::ceil(low / quarter) * quarter;
         angle <= high && samples.count < kMostSamples; angle += quarter)
        derivatives_at(r, r.length * (angle - start) / sweep, samples.at[samples.count++]);
}

}  // namespace

RecordLimits record_limits_of(const PathRecord& r, const PathLimits& limits) {
    const bool rapid = (r.flags & kRapid) != 0, thread = (r.flags & kThread) != 0;
    if (static_cast<RecordKind>(r.kind) == RecordKind::Line) return of_line(r, limits, rapid);
    Samples samples;
    if (static_cast<RecordKind>(r.kind) == RecordKind::Arc) {
        sample_arc(r, samples);
        RecordLimits c =
            thread ? of_thread(r, limits, rapid, samples)
                   : of_samples(r, limits, rapid, samples, rapid ? 0.0 : limits.arc_feed_min);
        // N0310: sqrt(a r) of the softest axis, but never below Circ F Min (nct_parameters_part1
        // 5.4).
        double softest = kInfinity;
        for (std::size_t i = 0; i < r.axis_count; ++i)
            softest = std::min(softest, limits.axis[r.axis[i]].accel);
        const double radius = std::abs(r.shape[arc_shape::kRadius]);
        if (!rapid) c.v = std::min(c.v, std::max(std::sqrt(softest * radius), limits.arc_feed_min));
        return c;
    }
    for (std::size_t n = 0; n <= kCurveSteps; ++n)
        derivatives_at(r, r.length * static_cast<double>(n) / kCurveSteps,
                       samples.at[samples.count++]);
    return thread ? of_thread(r, limits, rapid, samples) : of_samples(r, limits, rapid, samples);
}

bool record_limits_behind(const PathRecord& r, const Kinematics& kinematics,
                          const PathLimits& drives, RecordLimits& c) {
    Samples samples;
    for (std::size_t n = 0; n <= kTransformedSteps; ++n)
        if (!drive_derivatives_at(r, &kinematics,
                                  r.length * static_cast<double>(n) / kTransformedSteps,
                                  samples.at[samples.count++]))
            return false;
    const bool rapid = (r.flags & kRapid) != 0, thread = (r.flags & kThread) != 0;
    c = thread ? of_thread(r, drives, rapid, samples) : of_samples(r, drives, rapid, samples);
    return c.v > 0 && c.a > 0 && c.j > 0;
}

void store(const RecordLimits& c, PathRecord& r) {
    r.v_max = c.v;
    r.a_max = c.a;
    r.j_max = c.j;
    r.bend = c.bend;
    r.bend_turning = c.turning;
    r.bend_along = c.along;
    r.bend_across = c.across;
}

void apply_junction_rules(const JunctionSides& sides, double angle, const PathLimits& limits,
                          RecordLimits& c) {
    if (!limits.corner_by_axis_step && limits.corner_feed > 0 && angle > limits.corner_angle)
        c.v = std::min(c.v, limits.corner_feed);
    for (std::size_t i = 0; i < sides.count; ++i) {
        const PathAxis& axis = limits.axis[sides.axis[i]];
        const double turn = std::abs(sides.after[i] - sides.before[i]);
        const double bend = std::abs(sides.bend_after[i] - sides.bend_before[i]);
        if (limits.corner_by_axis_step && axis.speed_step > 0 && turn > kFlat)
            c.v = std::min(c.v, axis.speed_step / turn);
        if (sides.arc) {
            if (axis.accel_step_arc > 0 && bend > kFlat)
                c.v = std::min(c.v, std::sqrt(axis.accel_step_arc / bend));
            if (axis.accel_step_arc > 0 && turn > kFlat) c.soften(axis.accel_step_arc / turn);
        } else if (axis.accel_step > 0 && turn > kFlat) {
            c.soften(axis.accel_step / turn);
        }
    }
}

void apply_turn_rules(const PathRecord& r, double turn, const PathLimits& limits, RecordLimits& c) {
    if (!(turn > kFlat)) return;
    if (!limits.corner_by_axis_step && limits.corner_feed > 0 && turn > limits.corner_angle)
        c.v = std::min(c.v, limits.corner_feed);
    for (std::size_t i = 0; i < r.axis_count; ++i) {
        const PathAxis& axis = limits.axis[r.axis[i]];
        if (limits.corner_by_axis_step && axis.speed_step > 0)
            c.v = std::min(c.v, axis.speed_step / turn);
        if (axis.accel_step > 0) c.soften(axis.accel_step / turn);
    }
}

}  // namespace polyturn::channels
