#include "channels/path/record_limits.hpp"

#include <gtest/gtest.h>

#include "path_rig.hpp"
#include "tests/seeds.hpp"

namespace polyturn::channels {
namespace {

using namespace rig;

// Oracle: the axes' velocity, acceleration and jerk as differences of position along s(t) with the
// state (v, a, j) at the middle. Steps are chosen so that neither truncation nor rounding reaches
// the margin of 1 %.
struct Motion {
    double velocity, acceleration, jerk;
};
Motion differences(const PathRecord& r, unsigned axis, double s, double v, double a, double j) {
    // a small part of the time that the record takes
    const double h = 0.02 * std::min(1e-2, r.length / v);
    long double p[5];
    for (int n = -2; n <= 2; ++n) {
        const double t = n * h, at = s + v * t + a * t * t / 2 + j * t * t * t / 6;
        SlotVector position{};
        position_at(r, at, position);
        for (std::size_t i = 0; i < r.axis_count; ++i)
            if (r.axis[i] == axis) p[n + 2] = static_cast<long double>(position[i]);
    }
    return {static_cast<double>((p[3] - p[1]) / (2 * h)),
            static_cast<double>((p[3] - 2 * p[2] + p[1]) / (h * h)),
            static_cast<double>((p[4] - 2 * p[3] + 2 * p[1] - p[0]) / (2 * h * h * h))};
}

TEST(RecordLimits, NoStateBelowThemTakesAnAxisOverItsLimits) {
    const PathLimits limits = easy_limits();
    std::size_t judged = 0;
    for (std::uint64_t seed = 1; seed <= 80; ++seed) {
        std::mt19937_64 random(test_seed(seed));
        std::uniform_real_distribution<double> unit(0, 1);
        Collected out;
        Program program(out, limits);
        random_path(program, random, 40);
        program.maker.flush();
        for (const auto& r : out.records) {
            for (int n = 0; n < 12; ++n) {
                const auto extreme = [&] {
                    return unit(random) < 0.6 ? (unit(random) < 0.5 ? -1.0 : 1.0)
                                              : 2 * unit(random) - 1;
                };
                // The most that the record's two inequalities leave at a speed, or some of it.
                const double v = r.v_max * (unit(random) < 0.5 ? 1.0 : unit(random)), v2 = v * v,
                             v3 = v2 * v;
                const double most_a =
                    std::sqrt(std::max(0.0, r.a_max * r.a_max - r.bend * r.bend * v2 * v2));
                const double by_j =
                    r.bend_turning > 0
                        ? (std::sqrt(std::max(
                               0.0, r.j_max * r.j_max - r.bend_along * r.bend_along * v3 * v3)) -
                           r.bend_across * v3) /
                              (r.bend_turning * v)
                        : most_a;
                ASSERT_GT(std::min(most_a, by_j), 0) << "nothing is left to slow down with";
                const double a = std::min(most_a, by_j) * extreme();
                const double normal = r.bend_turning * v * std::abs(a) + r.bend_across * v3;
                const double j = (std::sqrt(std::max(0.0, r.j_max * r.j_max - normal * normal)) -
                                  r.bend_along * v3) *
                                 extreme();
                const double s = r.length * (0.1 + 0.8 * unit(random));
                // Exact derivatives, bound 1 %; differences of positions as the oracle where double
                // has the digits for it.
                for (unsigned axis = 0; axis < 2; ++axis) {
                    PathDerivatives d{};
                    derivatives_at(r, s, d);
                    for (std::size_t i = 0; i < r.axis_count; ++i) {
                        if (r.axis[i] != axis) continue;
                        const double acc = d.first[i] * a + d.second[i] * v * v;
                        const double jerk =
                            d.first[i] * j + 3 * d.second[i] * v * a + d.third[i] * v * v * v;
                        ASSERT_LE(std::abs(d.first[i] * v), limits.axis[axis].feed * 1.01)
                            << "seed " << seed;
                        ASSERT_LE(std::abs(acc), limits.axis[axis].accel * 1.01)
                            << "seed " << seed << " kind " << int(r.kind);
                        ASSERT_LE(std::abs(jerk), limits.axis[axis].jerk * 1.01)
                            << "seed " << seed << " kind " << int(r.kind);
                        if (r.length < 0.05) continue;
                        const Motion m = differences(r, axis, s, v, a, j);
                        EXPECT_NEAR(m.velocity, d.first[i] * v, 0.02 * limits.axis[axis].feed);
                        EXPECT_NEAR(m.acceleration, acc, 0.05 * limits.axis[axis].accel);
                        ++judged;
                    }
                }
            }
        }
    }
    EXPECT_GT(judged, 10'000u);
}

TEST(RecordLimits, ARapidLineIsAsFastAsItsSlowestShare) {
    PathLimits limits = easy_limits();
    limits.axis[1].rapid = 500;
    Collected out;
    Program program(out, limits);
    program.feed = 0;  // a rapid without a share of its own
    program.line({30, 40}, kRapid);
    program.maker.flush();
    EXPECT_NEAR(out.records[0].v_max, std::min(333 / 0.6, 500 / 0.8), 1e-9);
}

TEST(RecordLimits, AnArcUsesMostOfTheAccelerationAndNeverMoreThanTheNormalOne) {
    PathLimits limits = easy_limits();
    for (auto& axis : limits.axis) {
        axis.jerk = std::numeric_limits<double>::infinity();
        axis.feed = 1e5;
    }
    for (const double normal : {2000.0, 500.0}) {
        for (auto& axis : limits.axis) axis.normal = normal;
        Collected out;
        Program program(out, limits);
        program.arc({-10, 0}, 6.0);
        program.maker.flush();
        const double v = out.records[0].v_max;
        EXPECT_NEAR(v * v / 10, std::min(normal, 0.95 * 2000), 0.02 * normal);
        EXPECT_TRUE(std::isinf(out.records[0].j_max));
    }
}

TEST(RecordLimits, CornersObeyTheParametersOfTheMachine) {
    struct Row {
        const char* why;
        bool by_axis;
        double corner_feed, speed_step;
        double turn, expected;
    };
    // the blend alone allows about 1.3 mm/s at 90 degrees, 18 at 10; 0: no rule, what its own bend
    // allows
    const Row rows[] = {
        {"N0308 beyond N0307", false, 0.8, 0, 90, 0.8},
        {"below N0307", false, 0.8, 0, 10, 0},
        {"N0309", true, 0.8, 0.5, 90, 0.5},
        {"N0309 of 0 says nothing", true, 0.8, 0, 90, 0},
    };
    for (const Row& row : rows) {
        SCOPED_TRACE(row.why);
        PathLimits limits = easy_limits();
        limits.corner_by_axis_step = row.by_axis;
        limits.corner_angle = 0.3;
        limits.corner_feed = row.corner_feed;
        for (auto& axis : limits.axis) axis.speed_step = row.speed_step;
        Collected out;
        Program program(out, limits);
        const double turn = row.turn * std::numbers::pi / 180;
        program.feed = 0.5;  // slow enough that no stop is faster
        program.line({10, 0});
        program.line({10 + 10 * std::cos(turn), 10 * std::sin(turn)});
        program.maker.flush();
        EXPECT_GE(out.records.size(), 4u);
        for (const auto& r : out.records)
            if (kind_of(r) == RecordKind::Curve) {
                EXPECT_NEAR(r.v_max,
                            row.expected > 0 ? row.expected : record_limits_of(r, limits).v, 1e-9);
            }
    }
}

// What speed does not take of an axis is there for changing it, whatever the speed limit.
TEST(RecordLimits, ASlowBendBrakesNearlyAsALine) {
    Collected out;
    const PathLimits limits = easy_limits();
    Program program(out, limits);
    program.arc({0, 10}, std::numbers::pi / 2);
    program.maker.flush();
    ASSERT_EQ(out.records.size(), 1u);
    const PathRecord& r = out.records[0];
    EXPECT_NEAR(r.a_max, 2000, 20);
    EXPECT_NEAR(r.j_max, 40'000, 400);
    EXPECT_NEAR(r.bend, 0.1, 0.001);
    EXPECT_NEAR(r.bend_turning, 0.3, 0.003);
    EXPECT_NEAR(r.bend_along, 0.01, 0.0001);
    EXPECT_LT(r.bend_across, 1e-9);
}

// Unequal axes: the inequalities are looser than the softest axis alone, and still right.
TEST(RecordLimits, AxesMayDiffer) {
    PathLimits limits = easy_limits();
    limits.axis[1].accel = limits.axis[1].normal = 5000;
    limits.axis[1].jerk = 200'000;
    Collected out;
    Program program(out, limits);
    program.arc({0, 10}, 6.0);
    program.maker.flush();
    const PathRecord& r = out.records[0];
    for (double part : {0.3, 0.8, 1.0})
        for (double angle = 0; angle < 1; angle += 0.01) {
            PathDerivatives d{};
            derivatives_at(r, angle * r.length, d);
            const double v = part * r.v_max,
                         a = std::sqrt(
                             std::max(0.0, r.a_max * r.a_max - std::pow(r.bend * v * v, 2)));
            for (std::size_t i = 0; i < 2; ++i)
                for (double sign : {-1.0, 1.0})
                    ASSERT_LE(std::abs(d.first[i] * sign * a + d.second[i] * v * v),
                              1.01 * limits.axis[i].accel);
        }
}

// nct_parameters_part1 5.4: F = min(programmed, max(sqrt(a r), Circ F Min)); 6.2: N0402 counts in
// any case.
TEST(RecordLimits, TheBendOfAnArcNeverLowersItsSpeedBelowCircFMin) {
    const auto arc = [](double least, double normal) {
        PathLimits limits = easy_limits();
        for (auto& axis : limits.axis) {
            axis.accel = 100;
            axis.normal = normal;
            axis.jerk = 2000;
        }
        limits.arc_feed_min = least;
        Collected out;
        Program program(out, limits);
        program.arc({0, 25}, std::numbers::pi);
        program.maker.flush();
        return out.records[0];
    };
    EXPECT_NEAR(arc(10, 1e6).v_max, 50, 2);  // sqrt(100 * 25), less what braking needs
    EXPECT_NEAR(arc(80, 1e6).v_max, 80, 0.5);
    EXPECT_NEAR(arc(80, 144).v_max, 60, 0.5);  // sqrt(144 * 25)
    const PathRecord r = arc(80, 1e6);
    EXPECT_NEAR(r.a_max, 100, 1);  // along the path N0400 holds
    EXPECT_LT(r.bend * r.v_max * r.v_max, r.a_max);
}

TEST(RecordLimits, AThreadKeepsWhatHoldsAtItsSpeed) {
    Collected out;
    const PathLimits limits = easy_limits();
    Program program(out, limits);
    program.arc({0, 10}, std::numbers::pi / 2, 0, kThread);
    program.maker.flush();
    for (const auto& r : out.records) {
        EXPECT_EQ(r.bend + r.bend_turning + r.bend_along + r.bend_across, 0);
        EXPECT_LT(r.a_max, 1000);
    }
}

}  // namespace
}  // namespace polyturn::channels
