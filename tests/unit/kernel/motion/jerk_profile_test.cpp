// The closed forms against fine numerical integration of the rule they solve: another way to the
// same numbers.
#include "kernel/motion/jerk_profile.hpp"

#include <gtest/gtest.h>

#include <random>

#include "kernel/motion/landing.hpp"
#include "tests/seeds.hpp"

namespace polyturn::kernel {
namespace {

struct Case {
    double v, a, w, a_max, j_max;
};

Case random_case(std::mt19937_64& random) {
    const auto between = [&](double low, double high) {
        return std::uniform_real_distribution<>(low, high)(random);
    };
    const auto log_between = [&](double low, double high) {
        return std::exp(between(std::log(low), std::log(high)));
    };
    Case c{};
    c.a_max = log_between(50, 20'000);
    c.j_max = log_between(500, 1'000'000);
    c.v = random() % 8 == 0 ? 0 : log_between(0.001, 1000);
    c.w = random() % 4 == 0 ? 0 : log_between(0.001, 1000);
    c.a = between(-1, 1) * c.a_max;
    // else it could not but reverse
    if (c.a < 0) c.a = -std::min(-c.a, std::sqrt(2 * c.j_max * c.v));
    return c;
}

// Feedback instead of formula: jerk is full towards the acceleration from which releasing ends at
// w. Euler in small steps.
PathState by_feedback(const Case& c, double time, int steps) {
    PathState x{0, c.v, c.a};
    const double h = time / steps;
    for (int i = 0; i < steps; ++i) {
        const double surplus = release_speed(x.v, x.a, c.j_max) - c.w;
        double j = surplus > 0 ? -c.j_max : c.j_max;
        j = std::clamp(j, (-c.a_max - x.a) / h, (c.a_max - x.a) / h);
        x = advanced(x, j, h);
    }
    return x;
}

TEST(JerkProfile, LeadsWhereItSaysWithinItsLimits) {
    std::mt19937_64 random(test_seed(1));
    for (int i = 0; i < 300'000; ++i) {
        const Case c = random_case(random);
        const SpeedProfile p = profile_to_speed(c.v, c.a, c.w, c.a_max, c.j_max);
        const PathState end = after_profile({0, c.v, c.a}, p);
        const double size = c.v + c.w + c.a * c.a / c.j_max;
        ASSERT_NEAR(end.v, c.w, 1e-9 * size + 1e-12);
        ASSERT_NEAR(end.a, 0, 1e-6 * c.a_max);
        PathState x{0, c.v, c.a};
        for (int k = 0; k < 3; ++k) {
            ASSERT_GE(p.time[k], 0);
            ASSERT_LE(std::abs(p.jerk[k]), c.j_max);
            x = advanced(x, p.jerk[k], p.time[k]);
            ASSERT_LE(std::abs(x.a), c.a_max * (1 + 1e-9));
        }
    }
}

TEST(JerkProfile, IsAsFastAsAFeedbackThatKnowsNoFormula) {
    std::mt19937_64 random(test_seed(2));
    for (int i = 0; i < 400; ++i) {
        const Case c = random_case(random);
        const SpeedProfile p = profile_to_speed(c.v, c.a, c.w, c.a_max, c.j_max);
        const double time = p.duration();
        if (time < 1e-6) continue;
        const PathState end = by_feedback(c, time, 20'000), exact = after_profile({0, c.v, c.a}, p);
        const double dv = c.a_max * time + c.v + c.w;
        ASSERT_NEAR(end.v, exact.v, 2e-3 * dv)
            << c.v << ' ' << c.a << ' ' << c.w << ' ' << c.a_max << ' ' << c.j_max;
        ASSERT_NEAR(end.s, exact.s, 2e-3 * dv * time);
    }
}

TEST(JerkProfile, TicksAddUpToTheWholeProfile) {
    std::mt19937_64 random(test_seed(3));
    for (int i = 0; i < 3'000; ++i) {
        const Case c = random_case(random);
        const SpeedProfile p = profile_to_speed(c.v, c.a, c.w, c.a_max, c.j_max);
        const int ticks = 7;
        PathState x{0, c.v, c.a};
        for (int k = 0; k < ticks; ++k)
            x = towards_speed(x, c.w, c.a_max, c.j_max, p.duration() / ticks);
        const PathState exact = after_profile({0, c.v, c.a}, p);
        ASSERT_NEAR(x.s, exact.s, 1e-6 * (std::abs(exact.s) + 1e-3));
        ASSERT_NEAR(x.v, c.w, 1e-6 * (c.v + c.w + 1));
    }
}

TEST(JerkProfile, BrakingToACrawlCanTakeLongerThanToAStop) {
    EXPECT_GT(distance_to_speed(100, 0, 10, 1000, 5000), stopping_distance(100, 0, 1000, 5000));
    std::mt19937_64 random(test_seed(4));
    for (int i = 0; i < 100'000; ++i) {
        Case c = random_case(random);
        c.w = std::uniform_real_distribution<>(
            0, std::max(0.0, release_speed(c.v, c.a, c.j_max)))(random);
        ASSERT_LE(distance_to_speed(c.v, c.a, c.w, c.a_max, c.j_max),
                  longest_braking(c.v, c.a, c.a_max, c.j_max) * (1 + 1e-9) + 1e-12);
    }
}

TEST(JerkProfile, TopSpeedIsTheGreatestFromWhichTheSpeedCanBeReached) {
    std::mt19937_64 random(test_seed(5));
    for (int i = 0; i < 20'000; ++i) {
        const Case c = random_case(random);
        const double distance =
            std::exp(std::uniform_real_distribution<>(std::log(1e-4), std::log(500))(random));
        const double v = top_speed(distance, c.w, c.a_max, c.j_max);
        const auto fits = [&](double u) {
            return distance_to_speed(u, 0, c.w, c.a_max, c.j_max) <= distance ||
                   stopping_distance(u, 0, c.a_max, c.j_max) <= distance;
        };
        ASSERT_GE(v, c.w);
        if (v - c.w < 1e-6 * v) continue;  // too near to be told apart
        ASSERT_TRUE(fits(c.w + (v - c.w) * (1 - 1e-6)));
        ASSERT_FALSE(fits(v + (v - c.w) * 1e-6 + 1e-9));
    }
}

TEST(Landing, EndsExactlyWhereItAimed) {
    std::mt19937_64 random(test_seed(7));
    int aimed = 0;
    for (int i = 0; i < 20'000; ++i) {
        const Case c = random_case(random);
        const double distance = stopping_distance(c.v, c.a, c.a_max, c.j_max) *
                                std::uniform_real_distribution<>(1, 1.2)(random);
        Landing landing;
        if (!landing.aim(c.v, c.a, distance, c.a_max, c.j_max / 100, c.j_max)) continue;
        ++aimed;
        PathState x{0, c.v, c.a};
        const double dt = 0.001;
        for (int tick = 0; tick < 100'000 && !landing.landed(); ++tick) {
            const PathState next = landing.step(dt);
            ASSERT_GE(next.s, -1e-12 * distance);
            ASSERT_LE(std::abs(next.a), c.a_max * (1 + 1e-9));
            ASSERT_LE(std::abs(next.a - x.a), c.j_max * dt * (1 + 1e-6));
            x = {x.s + next.s, next.v, next.a};
        }
        ASSERT_TRUE(landing.landed());
        ASSERT_NEAR(x.s, distance, 1e-12 * distance);
        ASSERT_EQ(x.v, 0);
        ASSERT_EQ(x.a, 0);
    }
    EXPECT_GT(aimed, 10'000);
}

}  // namespace
}  // namespace polyturn::kernel
