// Rigid tapping: the spindle goes along with the path, turn by turn, and the path keeps the
// spindle's limits.
#include <algorithm>
#include <cmath>

#include "kernel/channel/channel_runner.hpp"

namespace polyturn::kernel {

// Rigid tapping: the spindle is one of those whose limits the path keeps (N1508, N1516, N1524,
// N0320).
void ChannelRunner::limit_tapping(const PathRecord& r, PlannedRecord& planned) const noexcept {
    const std::uint32_t s = r.axis[r.axis_count] - static_cast<std::uint32_t>(kMaxAxes);
    if (s >= kMaxSpindles || !core_.spindles[s].exists() || r.end[r.axis_count] == 0) return;
    const SpindleRange& range = core_.spindles[s].range();
    const double way = r.length / std::fabs(r.end[r.axis_count]);  // mm a revolution
    const double acceleration =
        (r.flags & kTapOut) ? range.out_acceleration : range.tap_acceleration;
    if (acceleration > 0) planned.a_max = std::min(planned.a_max, acceleration * way);
    if (range.tap_jerk > 0) planned.j_max = std::min(planned.j_max, range.tap_jerk * way);
    if (range.speed_max > 0) planned.v_max = std::min(planned.v_max, range.speed_max / 60.0 * way);
}

// 1/s that spindle and axes of a tapping move have in common (N1532); 0: it is none.
double ChannelRunner::tap_gain_of(const PathRecord& r) const noexcept {
    if (!(r.flags & kTapping)) return 0.0;
    const std::uint32_t s = r.axis[r.axis_count] - static_cast<std::uint32_t>(kMaxAxes);
    return s < kMaxSpindles ? core_.spindles[s].range().tap_gain : 0.0;
}

// The spindle's share of a tapping move; false: it has no closed loop.
bool ChannelRunner::place_spindle(const PathRecord& r, double s) noexcept {
    const std::uint32_t number = r.axis[r.axis_count] - static_cast<std::uint32_t>(kMaxAxes);
    if (number >= kMaxSpindles || !core_.spindles[number].closed()) {
        raise(Alarm::SpindleNotClosed,
              name_of('S', std::min<std::uint32_t>(number, kMaxSpindles - 1)).view());
        return false;
    }
    SpindleUnit& spindle = core_.spindles[number];
    if (axes_.tapped != axes_.record) {  // a new move begins where the last one ended
        axes_.tapped = axes_.record;
        axes_.tap_from = spindle.position();
    }
    spindle.tapping(true, r.value != 0);
    spindle.interpolate(axes_.tap_from + r.end[r.axis_count] * s / r.length);
    return true;
}

}  // namespace polyturn::kernel
