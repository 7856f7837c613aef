#include "kernel/motion/spindle_observer.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <functional>
#include <random>

#include "tests/seeds.hpp"

namespace polyturn::kernel {
namespace {

constexpr double kDt = 0.001;

// Greatest error in degrees after `settle` ticks; angle: true degrees at a time.
double worst_error(const std::function<double(double)>& angle, int settle, int ticks) {
    SpindleObserver observer;
    observer.configure(kDt, 4096, kDt);
    double worst = 0;
    for (int tick = 0; tick < ticks; ++tick) {
        const double latched = tick * kDt;
        observer.update(static_cast<std::int64_t>(std::floor(angle(latched) * 4096 / 360)));
        if (tick >= settle)
            worst = std::max(worst, std::abs(observer.angle() - angle(latched + kDt)));
    }
    return worst;
}

TEST(SpindleObserver, IsWithinTwoHundredthsOfADegreeAtSteadySpeed) {
    std::mt19937_64 random(test_seed(7));
    for (double rpm : {300.0, 333.0, 400.0, 500.0, 600.0, 700.0, 800.0, 900.0, 1000.0, 1100.0,
                       1200.0, 1350.0, 1500.0}) {
        SCOPED_TRACE(rpm);
        for (int i = 0; i < 20; ++i) {
            const double begin = std::uniform_real_distribution<>(0, 360)(random);
            EXPECT_LT(worst_error([&](double t) { return begin + rpm * 6 * t; }, 1500, 4000), 0.02);
        }
    }
}

TEST(SpindleObserver, IsNeverFurtherThanACountOffAtAnySteadySpeed) {
    std::mt19937_64 random(test_seed(8));
    for (int i = 0; i < 300; ++i) {
        const double rpm = std::uniform_real_distribution<>(-1500, 1500)(random);
        SCOPED_TRACE(rpm);
        EXPECT_LT(worst_error([&](double t) { return 12.3 + rpm * 6 * t; }, 1000, 3000), 0.06);
    }
}

TEST(SpindleObserver, FollowsASwingOfTwentyPercentAtOneHertzWithinATenthOfADegree) {
    for (double rpm : {300.0, 600.0, 1000.0, 1500.0}) {
        SCOPED_TRACE(rpm);
        const auto angle = [&](double t) {
            return rpm * 6 * (t + 0.2 * (1 - std::cos(2 * M_PI * t)) / (2 * M_PI));
        };
        EXPECT_LT(worst_error(angle, 1000, 5000), 0.1);
    }
}

}  // namespace
}  // namespace polyturn::kernel
