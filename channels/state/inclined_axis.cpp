#include "channels/state/inclined_axis.hpp"

#include <cmath>
#include <numbers>

namespace polyturn::channels {
namespace {

constexpr double kTolerance = 0.0005;    // mm between arc and chord
constexpr double kSame = 1e-9;

}  // namespace

void InclinedAxis::configure(unsigned inclined, unsigned orthogonal, double degrees, double origin) {
    x_ = inclined;
    z_ = orthogonal;
    cosine_ = std::cos(degrees * std::numbers::pi / 180.0);
    tangent_ = std::tan(degrees * std::numbers::pi / 180.0);
    origin_ = origin;
}

void InclinedAxis::to_real(AxisValues& v) const {
    const double x = v[x_] - origin_;
    v[x_] = x / cosine_ + origin_;
    v[z_] -= x * tangent_;
}

void InclinedAxis::to_cartesian(AxisValues& v) const {
    const double x = (v[x_] - origin_) * cosine_;
    v[x_] = x + origin_;
    v[z_] += x * tangent_;
}

void InclinedAxis::pass(Move m, const BlockContext& at) {
    if (failed_) return;
    to_real(m.machine_start);
    to_real(m.machine);
    for (const unsigned i : {x_, z_}) {
        m.moved &= ~(1u << i);
        if (std::fabs(m.machine[i] - m.machine_start[i]) > kSame) m.moved |= 1u << i;
        else m.machine[i] = m.machine_start[i];
        const ChannelAxis& axis = view_->axes[i];
        if (!axis.limited || (m.machine[i] <= axis.limit_max + 1e-6 && m.machine[i] >= axis.limit_min - 1e-6)) continue;
        failed_ = true;
        failed_axis_ = i;
        failed_at_ = m.machine[i];
        return;
    }
    next_->move(m, at);
}

void InclinedAxis::move(const Move& m, const BlockContext& at) {
    if (!active_) {
        next_->move(m, at);
        return;
    }
    if (m.kind != MoveKind::ArcCw && m.kind != MoveKind::ArcCcw) {
        pass(m, at);
        return;
    }
    // sagitta r (1 - cos(step / 2)) <= tolerance, of the longer axis of the ellipse
    const double radius = m.radius / std::fabs(cosine_);
    const double step = radius > kTolerance ? 2.0 * std::acos(1.0 - kTolerance / radius) : 1.0;
    const int steps = 1 + static_cast<int>(std::fabs(m.sweep) / step);
    const std::size_t p = m.plane_p, q = m.plane_q;
    const double start = std::atan2(m.machine_start[q] - m.centre_q, m.machine_start[p] - m.centre_p);
    Move chord = m;
    chord.kind = MoveKind::Linear;
    chord.sweep = 0.0;
    chord.turns = 0;
    chord.moved |= 1u << p | 1u << q;
    if (m.feed_mode == FeedMode::InverseTime) chord.feed *= steps;
    for (int k = 1; k <= steps; ++k) {
        const double share = static_cast<double>(k) / steps, angle = start + share * m.sweep, r = m.radius + share * (m.radius_end - m.radius);
        for (std::size_t i = 0; i < chord.machine.size(); ++i) {
            chord.machine[i] = m.machine_start[i] + share * (m.machine[i] - m.machine_start[i]);
            chord.pos[i] = m.pos[i] - (1 - share) * (m.machine[i] - m.machine_start[i]);
        }
        if (k < steps) {
            chord.pos[p] = m.pos[p] + m.centre_p + r * std::cos(angle) - m.machine[p];
            chord.pos[q] = m.pos[q] + m.centre_q + r * std::sin(angle) - m.machine[q];
            chord.machine[p] = m.centre_p + r * std::cos(angle);
            chord.machine[q] = m.centre_q + r * std::sin(angle);
        }
        pass(chord, at);
        chord.machine_start = chord.machine;
    }
}

}  // namespace polyturn::channels
