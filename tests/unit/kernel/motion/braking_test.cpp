#include "kernel/motion/braking.hpp"

#include <gtest/gtest.h>

#include <memory>
#include <random>
#include <vector>

#include "tests/seeds.hpp"

namespace polyturn::kernel {
namespace {

// A road that is known from the beginning.
class Given final : public Road {
public:
    explicit Given(const std::vector<Stretch>& stretches, double ends) {
        clear();
        for (const Stretch& s : stretches)
            EXPECT_TRUE(begin_stretch(s.begin, s.speed_limit, s.limits));
        close(ends);
    }

private:
    void more() noexcept override {}
};

double between(std::mt19937_64& random, double low, double high) {
    return std::uniform_real_distribution<>(low, high)(random);
}
double log_between(std::mt19937_64& random, double low, double high) {
    return std::exp(between(random, std::log(low), std::log(high)));
}

Limits random_limits(std::mt19937_64& random, double v, bool bends) {
    Limits l;
    l.a = 2000 * log_between(random, 0.5, 2);
    l.j = 50'000 * log_between(random, 0.5, 2);
    if (bends) {
        l.bend = l.a / std::pow(v * log_between(random, 1.03, 10), 2);
        l.turning = 3 * l.bend;
        l.along = l.bend * l.bend;
        l.across = random() % 2 == 0 ? 0 : l.j / std::pow(v * log_between(random, 1.03, 10), 3);
    }
    return l;
}

// Drives it in small steps and judges each by the limits of where it is.
TEST(Braking, StandsAtItsEndAndKeepsTheLimitsOnTheWay) {
    std::mt19937_64 random(test_seed(1));
    auto braking = std::make_unique<Braking>();
    int possible = 0;
    for (int i = 0; i < 20'000; ++i) {
        SCOPED_TRACE(i);
        const double v = log_between(random, 0.1, 600);
        std::vector<Stretch> stretches;
        double at = 0;
        for (int n = 0; n < 8; ++n) {
            stretches.push_back(
                {at, v * between(random, 1.0, 3.0), random_limits(random, v, random() % 3 != 0)});
            at += log_between(random, 0.01, 20);
        }
        Given road(stretches, at + 1e6);
        PathState x{0, v, between(random, -1, 1) * stretches[0].limits.acceleration(v)};
        braking->along(road, x);
        if (!braking->possible()) continue;
        ++possible;
        constexpr int kSteps = 400;
        const double h = braking->duration() / kSteps;
        for (int k = 0; k < kSteps; ++k) {
            const PathState moved = braking->follow(k * h, h);
            const PathState next{x.s + moved.s, moved.v, moved.a};
            Limits most = {0, 0, 1e9, 1e9, 1e9, 1e9};  // of what the step touches
            double speed_limit = 0;
            for (std::size_t n = 0; n < stretches.size(); ++n) {
                if (stretches[n].begin > next.s ||
                    (n + 1 < stretches.size() && stretches[n + 1].begin < x.s))
                    continue;
                most.widen(stretches[n].limits);
                speed_limit = std::max(speed_limit, stretches[n].speed_limit);
            }
            const double j = (next.a - x.a) / h, u = (next.v + x.v) / 2, a = (next.a + x.a) / 2,
                         u3 = u * u * u;
            ASSERT_LE(std::hypot(a, most.bend * u * u), 1.008 * most.a) << k;
            ASSERT_LE(std::hypot(std::abs(j) + most.along * u3,
                                 most.turning * u * std::abs(a) + most.across * u3),
                      1.01 * most.j)
                << k;
            ASSERT_LE(next.v, speed_limit * 1.001);
            x = next;
        }
        ASSERT_NEAR(x.v, 0, 1e-6 * v);
        ASSERT_NEAR(x.a, 0, 1e-3);
        ASSERT_NEAR(x.s, braking->end(), 1e-6 * (x.s + 1e-9));
    }
    EXPECT_GT(possible, 5'000);
}

// Without bends the closed form is the shortest. With faint ones it is hardly longer.
TEST(Braking, IsTheShortest) {
    std::mt19937_64 random(test_seed(2));
    auto braking = std::make_unique<Braking>();
    for (int i = 0; i < 5'000; ++i) {
        const double v = log_between(random, 0.1, 600);
        Limits limits = random_limits(random, v, false);
        double a = between(random, -1, 1) * limits.a;
        if (release_speed(v, a, limits.j) < 0) continue;
        const double least = stopping_distance(v, a, limits.a, limits.j);
        Given straight({{0, 1e9, limits}}, 1e9);
        braking->along(straight, {0, v, a});
        ASSERT_TRUE(braking->possible());
        ASSERT_LE(braking->distance(), 1.001 * least + 1e-9);
        limits.bend = limits.turning = 1e-9;
        Given faint({{0, 1e9, limits}}, 1e9);
        braking->along(faint, {0, v, a});
        ASSERT_TRUE(braking->possible()) << i;
        ASSERT_LE(braking->distance(), 1.09 * least + 1e-9);
    }
}

TEST(Braking, ArrivesWhereAProfileToThatSpeedDoes) {
    std::mt19937_64 random(test_seed(3));
    auto braking = std::make_unique<Braking>();
    for (int i = 0; i < 5'000; ++i) {
        const double v = log_between(random, 0.1, 600);
        const Limits limits = random_limits(random, v, false);
        const double a = between(random, -1, 1) * limits.a, c = v * between(random, 0, 1);
        if (release_speed(v, a, limits.j) <= c) continue;
        const double way = distance_to_speed(v, a, c, limits.a, limits.j);
        Given road({{0, 1e9, limits}}, 1e9);
        braking->along(road, {0, v, a});
        ASSERT_TRUE(braking->possible());
        EXPECT_TRUE(braking->arrives(c, way * 1.001 + 1e-6));
        EXPECT_FALSE(braking->arrives(c, way * 0.999 - 1e-6));
    }
}

TEST(Braking, KnowsWhatItMayNot) {
    auto braking = std::make_unique<Braking>();
    const Limits limits{2000, 50'000};
    const double need = stopping_distance(100, 0, 2000, 50'000);
    Given just({{0, 100, limits}}, need * 1.001), short_of({{0, 100, limits}}, need * 0.999);
    braking->along(just, {0, 100, 0});
    EXPECT_TRUE(braking->possible());
    braking->along(short_of, {0, 100, 0});
    EXPECT_FALSE(braking->possible());
    Given slow({{0, 100, limits}, {1, 60, limits}}, 1e9);
    braking->along(slow, {0, 100, 0});
    EXPECT_FALSE(braking->possible()) << "above the speed limit of the second stretch";
    braking->along(slow, {0, 100, 0}, false);
    EXPECT_TRUE(braking->possible()) << "speed limits do not count";
    Given soft({{0, 100, limits}, {1, 100, {300, 50'000}}}, 1e9);
    braking->along(soft, {0, 100, -1900});
    EXPECT_FALSE(braking->possible()) << "cannot release so much in 1 mm";
    braking->along(soft, {0, 100, -600});
    EXPECT_TRUE(braking->possible());
}

}  // namespace
}  // namespace polyturn::kernel
