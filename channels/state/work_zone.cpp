#include "channels/state/work_zone.hpp"

#include <cmath>

namespace polyturn::channels {
namespace {

constexpr double kSlack = 1e-6;   // mm: along the border is allowed
constexpr double kStep = 0.0045;  // rad of an arc that counts as straight

}  // namespace

bool WorkZone::contains(const AxisValues& point, double slack) const {
    for (AxisSet left = has_low | has_high; left; left &= left - 1) {
        const auto i = static_cast<std::size_t>(__builtin_ctz(left));
        if ((has_low >> i & 1u) && point[i] < low[i] - slack) return false;
        if ((has_high >> i & 1u) && point[i] > high[i] + slack) return false;
    }
    return true;
}

// The share of the travel that lies between each pair of borders; what is left of [0, 1] lies
// inside all of them.
bool WorkZone::crossed_by(const AxisValues& from, const AxisValues& to) const {
    double first = 0.0, last = 1.0;
    for (AxisSet left = has_low | has_high; left; left &= left - 1) {
        const auto i = static_cast<std::size_t>(__builtin_ctz(left));
        const double bottom = has_low >> i & 1u ? low[i] + kSlack : -1e12,
                     top = has_high >> i & 1u ? high[i] - kSlack : 1e12;
        const double way = to[i] - from[i];
        if (std::fabs(way) < 1e-12) {
            if (from[i] <= bottom || from[i] >= top) return false;
            continue;
        }
        const double a = (bottom - from[i]) / way, b = (top - from[i]) / way;
        first = std::fmax(first, std::fmin(a, b));
        last = std::fmin(last, std::fmax(a, b));
    }
    return first < last;
}

bool violates(const WorkZone& zone, const Move& m) {
    if (zone.guard == WorkZone::Guard::Off || !zone.limited()) return false;
    const bool arc = m.kind == MoveKind::ArcCw || m.kind == MoveKind::ArcCcw;
    const int steps = arc ? 1 + static_cast<int>(std::fabs(m.sweep) / kStep) : 1;
    const std::size_t p = m.plane_p, q = m.plane_q;
    const double start =
        arc ? std::atan2(m.machine_start[q] - m.centre_q, m.machine_start[p] - m.centre_p) : 0.0;
    AxisValues from = m.machine_start;
    for (int k = 1; k <= steps; ++k) {
        AxisValues to = m.machine;
        if (k < steps) {
            const double share = static_cast<double>(k) / steps, angle = start + share * m.sweep;
            for (std::size_t i = 0; i < to.size(); ++i)
                to[i] = m.machine_start[i] + share * (m.machine[i] - m.machine_start[i]);
            to[p] = m.centre_p + m.radius * std::cos(angle);
            to[q] = m.centre_q + m.radius * std::sin(angle);
        }
        if (zone.guard == WorkZone::Guard::NoEntry ? zone.crossed_by(from, to)
                                                   : !zone.contains(to, kSlack))
            return true;
        from = to;
    }
    return false;
}

}  // namespace polyturn::channels
