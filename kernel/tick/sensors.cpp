#include "kernel/tick/sensors.hpp"

#include <algorithm>
#include <cmath>

namespace polyturn::kernel {

void Sensors::look(const std::array<AxisUnit, kMaxAxes>& axes,
                   const std::array<SpindleUnit, kMaxSpindles>& spindles, Signals& signals,
                   std::uint32_t axis_count, std::int64_t tick) noexcept {
    if (count_ == 0) return;
    for (std::uint32_t a = 0; a < axis_count; ++a) {
        before_[a] = looked_ ? now_[a] : axes[a].measured();
        now_[a] = axes[a].measured();
        if (axes[a].velocity() != 0.0) way_[a] = axes[a].velocity() > 0 ? 1 : -1;
    }
    looked_ = true;
    std::bitset<kInputs> sensed, known;
    for (std::size_t i = 0; i < count_; ++i) {
        Sensor& one = sensors_[i];
        known[one.input] = true;
        if (one.axis >= kMaxAxes) {
            const double passed =
                std::fmod(spindles[one.axis - kMaxAxes].true_angle() - one.at + 720.0, 360.0);
            if (passed < kCamDeg) sensed[one.input] = true;
            continue;
        }
        const int way = way_[one.axis], side = one.direction != 0 ? one.direction : way;
        const double here = now_[one.axis], last = before_[one.axis];
        const bool beyond = side != 0 && (side > 0 ? here >= one.at : here <= one.at);
        one.touches = beyond && way != 0 && (way == side || one.touches);
        if (!one.touches) continue;
        sensed[one.input] = true;
        if (on_[one.input]) continue;
        const double part =
            here != last ? std::clamp((one.at - last) / (here - last), 0.0, 1.0) : 1.0;
        risen_part_[one.input] =
            risen_tick_[one.input] == tick ? std::min(risen_part_[one.input], part) : part;
        risen_tick_[one.input] = tick;
    }
    for (std::size_t n = 0; n < kInputs; ++n)
        if (known[n] && sensed[n] != on_[n]) signals.sense(n, sensed[n]);
    on_ = sensed;
}

}  // namespace polyturn::kernel
