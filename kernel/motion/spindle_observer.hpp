// Estimates the spindle's present angle. The encoder gives that of one tick ago, in whole counts.
//
//   angle ^          . '   now: predicted over the latch delay
//         |       _.x
//         |    _.'|  ...   counts: a staircase of 360/4096 = 0.088 degrees, one tick late
//         |  .'___|
//         +----------> t
//
// Two fading-memory polynomial filters run side by side on the middle of each count:
//   fast   cubic, memory 1/60 s      follows swings and ramps, but has half the staircase's noise
//   slow   quadratic, memory 1/10 s  at steady speed averages the staircase away
// The slow one is used while its predictions stay within kTrust counts of the measurement; once
// it does not, it begins anew from the fast one (its memory grows with its age), and only after
// kSettled ticks without a breach the result is faded over to it. So the switch makes no step, and
// a swing of 20 % at 1 Hz is followed by the fast one alone.
//
// Gains    Fading-memory polynomial of degree n, all poles at z = exp(-dt/memory). Source: N.
//          Morrison, Introduction to Sequential Smoothing and Prediction, 1969, chapter 13.
// Error    Fast: snap/pole^4 + about 0.05 degrees of noise. Slow: 0.01 degrees, see
//          spindle_observer_test.
// Weakness Where a tick is within 0.1 % of an integer count (at 1 ms and 4096 counts:
// multiples of 14.65 1/min)
//          the staircase is the same at each tick and nothing can tell where in a count the spindle
//          is: up to half a count.
#pragma once
#include <cstdint>

namespace polyturn::kernel {

class SpindleObserver {
public:
    // dt: tick, seconds. delay: from the latch to the moment asked for by angle(0), seconds (one
    // tick).
    void configure(double dt, double counts_per_rev, double delay) noexcept;
    void reset(std::int64_t counts) noexcept;  // the spindle is stopped there
    // Counts over all revolutions, as latched `delay` ago. Once a tick.
    void update(std::int64_t counts) noexcept;

    // Degrees over all revolutions, `ahead` seconds after now.
    [[nodiscard]] double angle(double ahead = 0) const noexcept;
    [[nodiscard]] double speed(double ahead = 0) const noexcept;         // degrees a second
    [[nodiscard]] double acceleration(double ahead = 0) const noexcept;  // degrees a second squared

private:
    struct Filter {
        // at the latch; angle relative to origin_
        double angle = 0, speed = 0, acceleration = 0, jerk = 0;
        [[nodiscard]] double at(double t) const noexcept {
            return angle + t * (speed + t * (acceleration / 2 + t * jerk / 6));
        }
        [[nodiscard]] double speed_at(double t) const noexcept {
            return speed + t * (acceleration + t * jerk / 2);
        }
        void predict(double t) noexcept;
    };
    double dt_ = 0.001, degrees_per_count_ = 360.0 / 4096, delay_ = 0.001;
    double fast_pole_ = 0, slow_pole_ = 0;
    std::int64_t origin_ = 0;  // counts; moved along so that doubles stay exact over days
    double turned_ = 0;        // degrees of origin_
    Filter fast_, slow_;
    double trust_ = 0;       // share of the slow filter in the result
    std::int32_t calm_ = 0;  // ticks since the slow filter began or was contradicted
    bool known_ = false;
};

}  // namespace polyturn::kernel
