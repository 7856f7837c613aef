// The position loop of one axis: from the command of a tick to the speed command of the drive, with
// filters, feed-forward, backlash and stiction compensation; and the monitoring of the following
// error (nct_parameters_part1 7.2, 7.6 to 7.8).
//
//   cmd --mean (N0421 JRK)----> c
//   c --LP T1--> p1 --LP T2, delay TD--> pe --(-)--> e --K, threshold--> + --> speed
//                  |                        act -'                         |
//                  '--- A (dp1/dt + 2d/w d2p1/dt2) ------------------------'   + reversal and
//                                                                                start boosts
//
// The encoder is read at a tick's beginning and used in the next tick, together with the command of
// the same moment: a reading that is a tick late leaves no error behind. 2d/w is the lag of the
// drive: with A = 1 an ideal drive follows without error, with A = 0 it lags by v / K.
//
// Backlash (N0523) is added to the motor's command when the direction changes, and taken out of its
// reading, so that both stay the slide's. Positions in mm or degrees; nothing here knows a machine
// coordinate but as a number that can be shifted.
#pragma once
#include <array>
#include <cstdint>

#include "kernel/config/servo_config.hpp"

namespace polyturn::kernel {

class PositionLoop {
public:
    void configure(const ServoConfig& config, double tick_s) noexcept;
    // Command and measurement are the same from here on; no lag remains.
    void reset(double position) noexcept;
    void shift(double by) noexcept;

    // The speed for the tick in which the command goes to `target`. rapid: feed-forward in rapid is
    // a choice of its own.
    [[nodiscard]] double speed(double target, bool rapid) noexcept;
    // Rigid tapping: the loop lags as the spindle's does, with the gain that both have then
    // (N1532), and with feed-forward only where N1503 RFF leaves it; 0: as the axis' own parameters
    // say. Changed at rest (nct_parameters_part1 16.1, 16.4).
    void tap_with(double gain, bool feedforward) noexcept {
        tap_gain_ = gain;
        tap_feedforward_ = feedforward;
    }
    void tap_like(const PositionLoop& other) noexcept {
        tap_gain_ = other.tap_gain_;
        tap_feedforward_ = other.tap_feedforward_;
    }
    // how much longer it lags
    double lag_scale() const noexcept {
        return tap_gain_ > 0 && config_.gain > 0 ? config_.gain / tap_gain_ : 1.0;
    }
    // What was measured at the beginning of this tick: at the motor or, with a scale of its own, at
    // the slide.
    void measured(double motor) noexcept;
    void measured_direct(double motor, double slide) noexcept;  // dual loop (7.9)

    double position() const noexcept { return slide_; }  // measured, backlash taken out
    // the part of the command not yet output (N0421 JRK)
    double owed() const noexcept { return lag_; }
    // of the command and measurement of the same moment
    double error() const noexcept { return error_; }
    double model_error() const noexcept { return slide_ - model_; }
    bool standing() const noexcept { return still_ticks_ > standing_ticks_; }
    bool moving() const noexcept { return still_ticks_ == 0; }
    bool dual_differs() const noexcept { return dual_differs_; }

private:
    // An extra speed that ends by time, travel or event and then fades as A / n.
    struct Boost {
        double speed = 0;
        std::int64_t ticks = 0;  // since it began; fading: since it ended
        double from = 0;
        bool on = false, fading = false;
        void end(double fade) noexcept {
            on = false;
            fading = fade > 0;
            ticks = 0;
        }
    };
    double boosts(double target, double ordinary) noexcept;
    double faded(Boost& boost) noexcept;
    double compensated(double position) noexcept;
    double smoothed(double target) noexcept;

    ServoConfig config_;
    double tick_s_ = 0.001, lag_s_ = 0;
    double command_ = 0;  // of the beginning of this tick
    double p1_ = 0, v1_ = 0, p2_ = 0, pe_ = 0;
    std::array<double, 128> delay_{};  // p2 of the last ticks
    std::uint32_t delay_at_ = 0;
    std::array<double, 64> past_{};  // commands of the last ticks, for their mean
    std::uint32_t past_at_ = 0, mean_of_ = 1;
    double lag_ = 0;
    double slide_ = 0, error_ = 0, filtered_ = 0, model_ = 0, drift_ = 0, correction_ = 0;
    double tap_gain_ = 0;         // 1/s; 0: not tapping
    double play_ = 0;             // present share of N0523
    std::int32_t direction_ = 0;  // of the last motion
    std::int64_t still_ticks_ = 2, standing_ticks_ = 200;
    Boost reversal_, start_;
    bool fed_forward_ = false, dual_differs_ = false, tap_feedforward_ = false;
};

}  // namespace polyturn::kernel
