// Forward and back, derivatives against finite differences, the pole; random transformations.
#include "ipc/kinematics/kinematics.hpp"

#include <gtest/gtest.h>

#include <array>
#include <functional>
#include <numbers>
#include <random>

#include "ipc/kinematics/five_axis.hpp"
#include "ipc/kinematics/polar.hpp"
#include "tests/seeds.hpp"

namespace polyturn {
namespace {

constexpr double kPi = std::numbers::pi;

struct Dice {
    std::mt19937_64 engine{test_seed(20260117)};
    double between(double low, double high) {
        return std::uniform_real_distribution<double>(low, high)(engine);
    }
};

Kinematics plain(KinematicsKind kind) {
    Kinematics k{};
    k.kind = static_cast<std::uint32_t>(kind);
    k.sign.fill(1.0);
    for (std::uint8_t i = 0; i < 8; ++i) k.axis[i] = i;
    return k;
}

Kinematics random_one(KinematicsKind kind, Dice& dice) {
    Kinematics k = plain(kind);
    for (std::size_t i = 0; i < kMaxRoles; ++i) k.centre[i] = dice.between(-50, 50);
    switch (kind) {
        case KinematicsKind::Polar:
            k.value[0] = dice.between(-2, 2);
            k.value[1] = dice.between(-1, 1) < 0 ? -1 : 1;
            break;
        case KinematicsKind::Cylinder:
            k.value[0] = dice.between(1, 100);
            break;
        case KinematicsKind::Inclined:
            k.value[0] = dice.between(-1, 1);
            break;
        case KinematicsKind::FiveAxis:
            for (const std::size_t at : {five_axis::kFirstDirection, five_axis::kSecondDirection}) {
                double length = 0;
                for (std::size_t i = 0; i < 3; ++i) {
                    k.value[at + i] = dice.between(-1, 1);
                    length += k.value[at + i] * k.value[at + i];
                }
                for (std::size_t i = 0; i < 3; ++i) k.value[at + i] /= std::sqrt(length);
            }
            for (std::size_t i = five_axis::kFirstPoint; i < five_axis::kFirstIsHead; ++i)
                k.value[i] = dice.between(-100, 100);
            k.value[five_axis::kFirstIsHead] = dice.between(0, 1) < 0.5;
            k.value[five_axis::kSecondIsHead] = dice.between(0, 1) < 0.5;
            break;
        case KinematicsKind::None:
            break;
    }
    return k;
}

constexpr KinematicsKind kKinds[] = {KinematicsKind::Polar, KinematicsKind::Cylinder,
                                     KinematicsKind::Inclined, KinematicsKind::FiveAxis};

TEST(Kinematics, LeadsBackToWhereItCameFrom) {
    Dice dice;
    for (int n = 0; n < 20000; ++n) {
        const Kinematics k = random_one(kKinds[n % 4], dice);
        RoleValues axes{}, path{}, again{};
        for (double& a : axes) a = dice.between(-400, 400);
        to_path(k, axes, path);
        const Branch branch{axes[1],
                            axes[0] < k.centre[0] ? SideOfPole::Negative : SideOfPole::Positive};
        ASSERT_TRUE(to_axes(k, branch, path, again));
        for (std::size_t i = 0; i < role_count(kind_of(k)); ++i)
            ASSERT_NEAR(again[i], axes[i], 1e-7) << n << " role " << i;
    }
}

// Derivatives 1 to 3 at h = 0 by central differences of step h.
std::array<double, 3> differences(const std::function<double(double)>& f, double h) {
    const double a0 = f(-2 * h), a1 = f(-h), a2 = f(0), a3 = f(h), a4 = f(2 * h);
    return {(a3 - a1) / (2 * h), (a1 - 2 * a2 + a3) / (h * h),
            (a4 - 2 * a3 + 2 * a1 - a0) / (2 * h * h * h)};
}

// The error of a central difference is a series in h^2: halving the step shows how large it is, and
// Richardson's extrapolation takes its first term away. So near a pole, where the derivatives grow,
// the judgement is as wide as the differences are uncertain there, and tight everywhere else.
TEST(Kinematics, DerivativesAreThoseOfFiniteDifferences) {
    constexpr double kStep = 0.01;                             // of the parameter of the path
    constexpr std::array<double, 3> kRounding{1e-7, 1e-5, 1e-3};  // relative, at half that step
    Dice dice;
    for (int n = 0; n < 4000; ++n) {
        const Kinematics k = random_one(kKinds[n % 4], dice);
        RoleJets path, axes;
        for (std::size_t i = 0; i < kMaxRoles; ++i)
            path[i] = Jet(dice.between(-80, 80), dice.between(-1, 1), dice.between(-0.1, 0.1),
                          dice.between(-0.02, 0.02));
        RoleValues here;
        for (std::size_t i = 0; i < kMaxRoles; ++i) here[i] = path[i].value();
        if (reach(k, here) < 5) continue;
        const auto at = [&](double h) {
            RoleValues p, a{};
            for (std::size_t i = 0; i < kMaxRoles; ++i)
                p[i] = path[i].c[0] + h * (path[i].c[1] + h * (path[i].c[2] + h * path[i].c[3]));
            EXPECT_TRUE(to_axes(k, {path[1].value(), SideOfPole::Positive}, p, a));
            return a;
        };
        ASSERT_TRUE(to_axes(k, {path[1].value(), SideOfPole::Positive}, path, axes));
        for (std::size_t i = 0; i < role_count(kind_of(k)); ++i) {
            const auto role = [&](double h) { return at(h)[i]; };
            ASSERT_NEAR(axes[i].value(), role(0), 1e-9);
            const auto coarse = differences(role, kStep), fine = differences(role, kStep / 2);
            const std::array<double, 3> ours{axes[i].first(), axes[i].second(), axes[i].third()};
            for (std::size_t d = 0; d < ours.size(); ++d)
                ASSERT_NEAR(ours[d], (4 * fine[d] - coarse[d]) / 3,
                            kRounding[d] * (1 + std::abs(ours[d])) + std::abs(coarse[d] - fine[d]))
                    << n << " role " << i << " derivative " << d + 1;
        }
    }
}

// nct part 1, 4.4: linear = sqrt(u^2 + v^2 - d^2), angle = atan2(v, u) - asin(d / sqrt(u^2 + v^2)).
TEST(PolarPlane, IsTheFormulaOfN0217) {
    Kinematics k = plain(KinematicsKind::Polar);
    k.value[0] = 3.0;
    RoleValues axes{};
    ASSERT_TRUE(to_axes(k, {}, {12.0, 16.0, 0, 0, 0}, axes));
    EXPECT_NEAR(axes[0], std::sqrt(391.0), 1e-12);
    EXPECT_NEAR(axes[1], (std::atan2(16, 12) - std::asin(3.0 / 20)) * 180 / kPi, 1e-12);
    EXPECT_FALSE(to_axes(k, {}, {2.0, 2.0, 0, 0, 0}, axes));
}

TEST(PolarPlane, GoesThroughThePoleWithTheRotaryAxisAtRest) {
    const Kinematics k = plain(KinematicsKind::Polar);
    PathRecord r{};
    r.kind = static_cast<std::uint8_t>(RecordKind::Line);
    r.axis_count = 2;
    r.axis = {0, 1};
    r.start = {3, 4};
    r.end = {-3, -4};
    r.length = 10;
    r.transform = 1;
    r.side = static_cast<std::uint8_t>(SideOfPole::Through);
    r.turn = std::atan2(4, 3) * 180 / kPi + 720;
    SlotVector drives;
    for (const double s : {0.0, 2.5, 5.0, 7.5, 10.0}) {
        ASSERT_TRUE(drives_at(r, &k, s, drives));
        EXPECT_NEAR(drives[0], 5 - s, 1e-9);
        EXPECT_EQ(drives[1], r.turn);
    }
}

TEST(PolarPlane, CountsTurnsOfAnArcAboutThePole) {
    Dice dice;
    for (int n = 0; n < 1000; ++n) {
        const PlanePoint c{dice.between(-10, 10), dice.between(-10, 10)};
        const double radius = dice.between(0.1, 20), start = dice.between(-kPi, kPi),
                     sweep = dice.between(-20, 20);
        const double clear = arc_to_pole(c, radius, start, sweep);
        double least = 1e9, turned = 0, before = 0;
        constexpr int kSteps = 4000;
        for (int i = 0; i <= kSteps; ++i) {
            const double a = start + sweep * i / kSteps, u = c.u + radius * std::cos(a),
                         v = c.v + radius * std::sin(a);
            const double now = std::atan2(v, u);
            least = std::min(least, std::hypot(u, v));
            if (i > 0) turned += std::remainder(now - before, 2 * kPi);
            before = now;
        }
        ASSERT_NEAR(clear, least, 0.1);
        if (clear < 0.1) continue;
        ASSERT_NEAR(turned_about_pole(c, radius, radius, start, sweep), turned, 1e-6) << n;
    }
}

TEST(Route, StandsBehindTheTransformation) {
    Kinematics k = plain(KinematicsKind::Cylinder);
    // a millimetre is a degree
    k.value[0] = 180 / kPi;
    k.sign[0] = -1;
    k.shift[0] = 30;
    PathRecord r{};
    r.kind = static_cast<std::uint8_t>(RecordKind::Line);
    r.axis_count = 1;
    r.start = {0};
    r.end = {10};
    r.length = 10;
    r.transform = 1;
    SlotVector drives;
    PathDerivatives d;
    ASSERT_TRUE(drives_at(r, &k, 4, drives) && drive_derivatives_at(r, &k, 4, d));
    EXPECT_NEAR(drives[0], 26, 1e-12);
    EXPECT_NEAR(d.first[0], -1, 1e-12);
    EXPECT_NEAR(unrouted(k, 0, drives[0]), 4, 1e-12);
}

// A table about Z at the origin: with C at 90 degrees the workpiece's X points along the machine's
// Y.
TEST(FiveAxis, KeepsTheTipOnTheTurnedWorkpiece) {
    Kinematics k = plain(KinematicsKind::FiveAxis);
    k.value[five_axis::kSecondDirection + 2] = 1;
    RoleValues axes{};
    ASSERT_TRUE(to_axes(k, {}, {10, 0, 5, 0, 90}, axes));
    EXPECT_NEAR(axes[0], 0, 1e-12);
    EXPECT_NEAR(axes[1], 10, 1e-12);
    EXPECT_NEAR(axes[2], 5, 1e-12);
    // A head about Y with 100 mm from pivot to tip: at 90 degrees the tip lies beside the pivot, so
    // the axes go the other way.
    k = plain(KinematicsKind::FiveAxis);
    k.value[five_axis::kFirstDirection + 1] = 1;
    k.value[five_axis::kFirstIsHead] = 1;
    k.value[five_axis::kFirstPoint + 2] = -100;
    ASSERT_TRUE(to_axes(k, {}, {0, 0, 0, 90, 0}, axes));
    EXPECT_NEAR(axes[0], 100, 1e-9);
    EXPECT_NEAR(axes[2], -100, 1e-9);
}

}  // namespace
}  // namespace polyturn
