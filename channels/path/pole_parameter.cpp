#include "channels/path/pole_parameter.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <utility>

#include "channels/path/quintic.hpp"
#include "ipc/path/path_geometry.hpp"

namespace polyturn::channels {
namespace {

// an override of the feed does not leave the window too small
constexpr double kFeedReserve = 1.2;
constexpr double kLeast = 4.0;  // windows narrower than so many b gain nothing

double smooth(double t) { return t <= 0 ? 0 : t >= 1 ? 1 : t * t * t * (10 + t * (-15 + 6 * t)); }
double smooth_slope(double t) { return t <= 0 || t >= 1 ? 0 : 30 * t * t * (1 - t) * (1 - t); }

bool plain_cut(const PathRecord& r) {
    const auto mode = static_cast<FeedMode>(r.feed_mode);
    return static_cast<RecordKind>(r.kind) == RecordKind::Line && r.feed > 0 &&
           (mode == FeedMode::PerMinute || mode == FeedMode::PerRevolution) &&
           !(r.flags & (kRapid | kThread | kTapping)) && r.axis_count <= kMaxCurveAxes;
}

}  // namespace

PoleParameter PoleParameter::of(const PathRecord& line, const Kinematics& k,
                                const PathLimits& drives) {
    PoleParameter out;
    if (kind_of(k) != KinematicsKind::Polar || k.value[0] != 0 || !plain_cut(line)) return out;
    const auto slots = slots_of(line, k);
    if (slots[0] == kMaxPathAxes || slots[1] == kMaxPathAxes) return out;
    const PlanePoint a = plane_point(k, line.start[slots[0]], line.start[slots[1]]),
                     e = plane_point(k, line.end[slots[0]], line.end[slots[1]]);
    const NearestToPole nearest = nearest_to_pole(a, e);
    out.b_ = nearest.distance;
    out.foot_ = nearest.share * line.length;
    // of the distance in the plane: the rest would change C'
    const double share = std::hypot(e.u - a.u, e.v - a.v) / line.length;
    if (nearest.share <= 0 || nearest.share >= 1 || !(out.b_ > 0) || share < 1 - 1e-9) return out;
    constexpr double kRadian = std::numbers::pi / 180.0;
    const PathAxis &x = drives.axis[k.axis[0]], &c = drives.axis[k.axis[1]];
    const double accel = c.accel * kRadian, jerk = c.jerk * kRadian, speed = c.feed * kRadian;
    out.lambda_ = x.accel / accel;
    if (std::isfinite(x.jerk) && std::isfinite(jerk))
        out.lambda_ = std::sqrt(out.lambda_ * x.jerk / jerk);
    double feed = line.v_max;
    if (static_cast<FeedMode>(line.feed_mode) == FeedMode::PerMinute)
        feed = std::min(feed, kFeedReserve * line.feed);
    double limited =
        std::max(std::sqrt(out.b_ * feed / speed), std::cbrt(2 * out.b_ * feed * feed / accel));
    if (std::isfinite(jerk))
        limited = std::max(limited, std::sqrt(std::sqrt(6 * out.b_ * feed * feed * feed / jerk)));
    const double reach = 2 * std::max(limited, 2 * std::sqrt(out.lambda_ * out.b_));
    if (limited <= out.b_) return out;  // the feed is driven past it
    out.before_ = std::min(reach, out.foot_);
    out.behind_ = std::min(reach, line.length - out.foot_);
    out.active_ =
        std::isfinite(out.lambda_) && std::min(out.before_, out.behind_) > kLeast * out.b_;
    return out;
}

double PoleParameter::window(double x) const {
    return x < 0 ? smooth(2 * (x + before_) / before_) : smooth(2 * (behind_ - x) / behind_);
}
double PoleParameter::window_slope(double x) const {
    return x < 0 ? 2 / before_ * smooth_slope(2 * (x + before_) / before_)
                 : -2 / behind_ * smooth_slope(2 * (behind_ - x) / behind_);
}

void PoleParameter::apply(double from, double to, PathRecord& piece) const {
    const double x0 = from - foot_, x1 = to - foot_, way = x1 - x0;
    if (!active_ || x1 <= -before_ || x0 >= behind_ || !(way > 0)) return;
    // Gauss, three points in each half: q changes by some tens of per cent in a piece.
    double length = 0, least = std::min(q(x0), q(x1));
    for (int half = 0; half < 2; ++half)
        for (const auto& [at, weight] :
             {std::pair{0.11270166537925831, 5.0 / 18}, std::pair{0.5, 8.0 / 18},
              std::pair{0.88729833462074169, 5.0 / 18}}) {
            const double value = q(x0 + way * 0.5 * (half + at));
            length += 0.5 * way * weight * value;
            least = std::min(least, value);
        }
    const auto end = [&](double x, double value) {
        const double slope = 1 / q(x), bend = -q_slope(x) * slope * slope * slope;
        return QuinticEnd{value, slope * length / way, bend * length * length / way};
    };
    const Quintic u = hermite(end(x0, 0), end(x1, 1));  // share of the piece over s / length
    for (std::size_t i = 0; i < piece.axis_count; ++i) {
        double* c = &piece.shape[curve_shape::kCoefficients + 6 * i];
        std::fill(c, c + 6, 0.0);
        c[0] = piece.start[i];
        c[1] = piece.end[i] - piece.start[i];
    }
    double steepest = 0, power = 1;
    for (std::size_t n = 0; n <= 16; ++n)
        steepest = std::max(steepest, slope_at(u, static_cast<double>(n) / 16) * way / length);
    for (std::size_t n = 0; n < 6; ++n, power /= length)
        piece.shape[curve_shape::kParameter + n] = u[n] * power;
    piece.kind = static_cast<std::uint8_t>(RecordKind::Curve);
    piece.length = length;
    // What holds for the distance holds for s with the largest dx/ds.
    steepest = std::max(steepest, 1 / least) * (1 + 1e-6);
    piece.feed /= steepest;
    piece.v_max /= steepest;
    piece.a_max /= steepest;
    piece.j_max /= steepest;
}

}  // namespace polyturn::channels
