// Simulated touch and limit signals (setup, cli.md 2): an input that comes when an axis, travelling
// in the sensor's direction, passes the sensor's position, and goes when the axis has come back.
// Evaluated after the drives of a tick, seen by the channels at the next tick. The moment of the
// crossing within the tick is stored, because a probe input latches the encoders at once and not at
// a tick.
#pragma once
#include <array>
#include <cstdint>

#include "kernel/axes/axis_unit.hpp"
#include "kernel/spindles/spindle_unit.hpp"
#include "kernel/tick/signals.hpp"

namespace polyturn::kernel {

struct Sensor {
    // from 0; from kMaxAxes on spindles: a switch that the turning spindle passes, on for kCamDeg
    // from its angle on
    std::uint32_t axis = 0;
    std::uint32_t input = 0;
    int direction = 0;     // of travel in which it answers: -1, 1; 0 both
    double at = 0;         // machine coordinate, mm or degrees
    bool touches = false;  // it has answered and is still beyond
};

class Sensors {
public:
    static constexpr std::size_t kMost = 256;
    void add(const Sensor& sensor) noexcept {
        if (count_ < kMost) sensors_[count_++] = sensor;
    }
    static constexpr double kCamDeg = 10.0;
    void look(const std::array<AxisUnit, kMaxAxes>& axes,
              const std::array<SpindleUnit, kMaxSpindles>& spindles, Signals& signals,
              std::uint32_t axis_count, std::int64_t tick) noexcept;
    // For the tick after: part of the last tick (0 to 1) at which the input came; 1 when no sensor
    // knows better.
    double risen_part(std::size_t input, std::int64_t tick) const noexcept {
        return count_ && risen_tick_[input] == tick - 1 ? risen_part_[input] : 1.0;
    }
    double position(const AxisUnit& axis, std::size_t a, double part) const noexcept {
        return count_ ? before_[a] + part * (now_[a] - before_[a]) : axis.measured();
    }

private:
    std::array<Sensor, kMost> sensors_{};
    std::size_t count_ = 0;
    bool looked_ = false;
    std::array<double, kMaxAxes> before_{}, now_{};
    std::array<std::int8_t, kMaxAxes> way_{};  // of the last travel; 0: none yet
    std::array<std::int64_t, kInputs> risen_tick_{};
    std::array<double, kInputs> risen_part_{};
    std::bitset<kInputs> on_;
};

}  // namespace polyturn::kernel
