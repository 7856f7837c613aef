// DISC (sinumerik_part2 11.3): the way round an outer corner between the arc and the intersection.
#include "channels/compensation/conic.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>
#include <random>

#include "tests/seeds.hpp"

namespace polyturn::channels::compensation {
namespace {

constexpr double kRadius = 3.0;

struct Corner {
    double phi_deg;  // contour angle, on the workpiece's side
    Vec corner, from, to, top;
};

// The bisector points along +p, turned by `spin`.
Corner corner_of(double phi_deg, double spin, Vec at) {
    const double half = (180.0 - phi_deg) / 2 * std::numbers::pi / 180.0;
    const auto on = [&](double angle, double r) {
        return at + Vec{r * std::cos(spin + angle), r * std::sin(spin + angle)};
    };
    return {phi_deg, at, on(-half, kRadius), on(half, kRadius), on(0, kRadius / std::cos(half))};
}

double off_line(Vec a, Vec b, Vec p) { return cross(b - a, p - a) / length(b - a); }

// A conic that touches CA in A and CB in B satisfies CA(x) CB(x) = k AB(x)^2 with one k: no formula
// of conic.cpp is used here.
TEST(ConicAboutACorner, TouchesBothEquidistantsAndIsOneConic) {
    std::mt19937 random(test_seed(7));
    std::uniform_real_distribution<double> angle(20, 160), turn(0, 6.28), share(0.0, 0.98);
    for (int round = 0; round < 400; ++round) {
        const Corner c = corner_of(angle(random), turn(random), {share(random) * 50, -20});
        const double over = share(random);
        const auto points = conic_about(c.from, c.to, c.corner, over);
        ASSERT_FALSE(points.empty());
        double k = 0;
        for (const Vec p : points) {
            const double ratio = off_line(c.top, c.from, p) * off_line(c.top, c.to, p) /
                                 std::pow(off_line(c.from, c.to, p), 2);
            if (k == 0) k = ratio;
            ASSERT_NEAR(ratio / k, 1.0, 1e-4) << c.phi_deg << ' ' << over;
        }
        const Vec middle = points[points.size() / 2];  // an odd number of points: the top
        // Overshoot at DISC 100: S / R = 1 / sin(phi / 2) - 1.
        const double full = 1.0 / std::sin(c.phi_deg / 2 * std::numbers::pi / 180.0) - 1.0;
        EXPECT_NEAR(length(middle - c.corner) / kRadius - 1.0, over * full, 1e-9);
    }
}

TEST(ConicAboutACorner, IsTheArcWithoutOvershoot) {
    for (const double phi : {30.0, 90.0, 150.0})
        for (const Vec p :
             conic_about(corner_of(phi, 1, {4, 5}).from, corner_of(phi, 1, {4, 5}).to, {4, 5}, 0.0))
            EXPECT_NEAR(length(p - Vec{4, 5}), kRadius, 1e-9);
}

// How far the middle of a chord is off: f / |grad f| of f(x) = CA(x) CB(x) - k AB(x)^2.
TEST(ConicAboutACorner, ItsChordsKeepNearIt) {
    for (const double over : {0.0, 0.3, 0.9, 0.98}) {
        const Corner c = corner_of(40, 0.3, {});
        auto points = conic_about(c.from, c.to, c.corner, over);
        const auto touch = [&](Vec p) {
            return off_line(c.top, c.from, p) * off_line(c.top, c.to, p);
        };
        const double k =
            touch(points.front()) / std::pow(off_line(c.from, c.to, points.front()), 2);
        const auto f = [&](Vec p) { return touch(p) - k * std::pow(off_line(c.from, c.to, p), 2); };
        points.insert(points.begin(), c.from);
        points.push_back(c.to);
        for (std::size_t i = 1; i < points.size(); ++i) {
            const Vec m = 0.5 * (points[i - 1] + points[i]);
            constexpr double kStep = 1e-6;
            const Vec gradient{(f(m + Vec{kStep, 0}) - f(m - Vec{kStep, 0})) / (2 * kStep),
                               (f(m + Vec{0, kStep}) - f(m - Vec{0, kStep})) / (2 * kStep)};
            EXPECT_LT(std::fabs(f(m)) / length(gradient), 1e-3) << over;
            EXPECT_GE(length(points[i]), kRadius - 1e-9);
        }
    }
}

}  // namespace
}  // namespace polyturn::channels::compensation
