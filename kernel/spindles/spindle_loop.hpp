// The position loop of a spindle (nct_parameters_part1 9, structure as 7.2; revolutions):
//
//   command -> LP T1 -> p1 -+-> LP T2 -> delay TD -> pe -> (-) <- measured
//                           '-> d/dt x A -----------------> (+) <- K x error -> speed
//
// T1 N0710, T2 N0718, TD N0726, K N0701, A N0734.
// Watched: |measured - LP(command, T3)| against N0761 at rest and N0769 in motion, |error| against
// N0777.
#pragma once
#include <array>
#include <cstdint>

#include "kernel/config/spindle_config.hpp"

namespace polyturn::kernel {

class SpindleLoop {
public:
    enum class Fault : std::uint8_t { None, Standstill, Moving, Absolute };

    // Closes on a spindle at `measured` that turns with `speed` (rev/s): the command starts so far
    // ahead that the output goes on without a step. Returns that command.
    double close(double measured, double speed, const SpindleRange& range, double gain,
                 double feedforward) noexcept;
    // Command of the end of the tick: the speed to give out over it, rev/s.
    double output(double command, double dt, const SpindleRange& range, double gain,
                  double feedforward) noexcept;
    // What was measured at the tick's start. `scale`: how much longer than with N0701 the loop lags
    // under the gain of now.
    // `lag`: of the model; 0 with full feed-forward, which leaves none.
    Fault observe(double measured, double dt, bool moving, const SpindleRange& range, double scale,
                  double lag) noexcept;
    double error() const noexcept { return error_; }

private:
    static constexpr std::size_t kDelay = 16;  // ticks of dead time at the most
    double command_ = 0, filtered_ = 0, equalised_ = 0, reference_ = 0, model_ = 0, error_ = 0,
           drift_ = 0;
    std::array<double, kDelay> delayed_{};
    std::size_t delay_at_ = 0;
};

}  // namespace polyturn::kernel
