#include "channels/path/ceilings.hpp"

#include <gtest/gtest.h>

#include "path_rig.hpp"

namespace polyturn::channels {
namespace {

using namespace rig;

// Oracle: the axes' velocity, acceleration and jerk as differences of position along s(t) with the state (v, a, j) at the
// middle. Steps are chosen so that neither truncation nor rounding reaches the margin of 1 %.
struct Motion {
    double velocity, acceleration, jerk;
};
Motion differences(const PathRecord& r, unsigned axis, double s, double v, double a, double j) {
    const double h = 0.02 * std::min(1e-2, r.length / v);   // a small part of the time that the record takes
    long double p[5];
    for (int n = -2; n <= 2; ++n) {
        const double t = n * h, at = s + v * t + a * t * t / 2 + j * t * t * t / 6;
        SlotVector position{};
        position_at(r, at, position);
        for (std::size_t i = 0; i < r.axis_count; ++i)
            if (r.axis[i] == axis) p[n + 2] = static_cast<long double>(position[i]);
    }
    return {static_cast<double>((p[3] - p[1]) / (2 * h)), static_cast<double>((p[3] - 2 * p[2] + p[1]) / (h * h)),
            static_cast<double>((p[4] - 2 * p[3] + 2 * p[1] - p[0]) / (2 * h * h * h))};
}

TEST(Ceilings, NoStateBelowThemTakesAnAxisOverItsLimits) {
    const PathLimits limits = easy_limits();
    std::size_t judged = 0;
    for (std::uint64_t seed = 1; seed <= 80; ++seed) {
        std::mt19937_64 random(seed);
        std::uniform_real_distribution<double> unit(0, 1);
        Collected out;
        Program program(out, limits);
        random_path(program, random, 40);
        program.maker.flush();
        for (const auto& r : out.records) {
            for (int n = 0; n < 12; ++n) {
                const auto extreme = [&] { return unit(random) < 0.6 ? (unit(random) < 0.5 ? -1.0 : 1.0) : 2 * unit(random) - 1; };
                const double v = r.v_max * (unit(random) < 0.7 ? 1.0 : unit(random)), a = r.a_max * extreme(), j = r.j_max * extreme();
                const double s = r.length * (0.1 + 0.8 * unit(random));
                // Exact derivatives, bound 1 %; differences of positions as the oracle where double has the digits for it.
                for (unsigned axis = 0; axis < 2; ++axis) {
                    PathDerivatives d{};
                    derivatives_at(r, s, d);
                    for (std::size_t i = 0; i < r.axis_count; ++i) {
                        if (r.axis[i] != axis) continue;
                        const double acc = d.first[i] * a + d.second[i] * v * v;
                        const double jerk = d.first[i] * j + 3 * d.second[i] * v * a + d.third[i] * v * v * v;
                        ASSERT_LE(std::abs(d.first[i] * v), limits.axis[axis].feed * 1.01) << "seed " << seed;
                        ASSERT_LE(std::abs(acc), limits.axis[axis].accel * 1.01) << "seed " << seed << " kind " << int(r.kind);
                        ASSERT_LE(std::abs(jerk), limits.axis[axis].jerk * 1.01) << "seed " << seed << " kind " << int(r.kind);
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

TEST(Ceilings, ARapidLineIsAsFastAsItsSlowestShare) {
    PathLimits limits = easy_limits();
    limits.axis[1].rapid = 500;
    Collected out;
    Program program(out, limits);
    program.line({30, 40}, kRapid);
    program.maker.flush();
    EXPECT_NEAR(out.records[0].v_max, std::min(333 / 0.6, 500 / 0.8), 1e-9);
}

TEST(Ceilings, AnArcUsesMostOfTheAccelerationAndNeverMoreThanTheNormalOne) {
    PathLimits limits = easy_limits();
    for (auto& axis : limits.axis) axis.jerk = std::numeric_limits<double>::infinity(), axis.feed = 1e5;
    for (const double normal : {2000.0, 500.0}) {
        for (auto& axis : limits.axis) axis.normal = normal;
        Collected out;
        Program program(out, limits);
        program.arc({-10, 0}, 6.0);
        program.maker.flush();
        const double v = out.records[0].v_max;
        EXPECT_NEAR(v * v / 10, std::min(normal, 0.9 * 2000), 0.02 * normal);
        EXPECT_TRUE(std::isinf(out.records[0].j_max));
    }
}

TEST(Ceilings, CornersObeyTheParametersOfTheMachine) {
    struct Row { const char* why; bool by_axis; double corner_feed, speed_step; double turn, expected; };
    const Row rows[] = {   // the blend alone allows about 1.3 mm/s at 90 degrees, 18 at 10; override asks for 1.0 at the most
        {"N0308 beyond N0307", false, 0.8, 0, 90, 0.8},
        {"below N0307", false, 0.8, 0, 10, 1.0},
        {"N0309", true, 0.8, 0.5, 90, 0.5},
        {"N0309 of 0 says nothing", true, 0.8, 0, 90, 1.0},
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
        program.feed = 0.5;   // slow enough that no stop is faster
        program.line({10, 0});
        program.line({10 + 10 * std::cos(turn), 10 * std::sin(turn)});
        program.maker.flush();
        EXPECT_GE(out.records.size(), 4u);
        for (const auto& r : out.records)
            if (kind_of(r) == RecordKind::Curve) { EXPECT_NEAR(r.v_max, row.expected, 1e-9); }
    }
}

// An arc of 10 mm at 50 mm/s: what 164 mm/s would take of the axes is left for braking.
TEST(Ceilings, ABendIsNotDrivenFasterThanOverrideCanAsk) {
    Collected out;
    const PathLimits limits = easy_limits();
    Program program(out, limits);
    program.feed = 50;
    program.arc({0, 10}, std::numbers::pi / 2);
    program.maker.flush();
    bool seen = false;
    for (const auto& r : out.records) {
        if (kind_of(r) != RecordKind::Arc) continue;
        seen = true;
        EXPECT_LE(r.v_max, 100.0);
        const double faster_a = [&] {
            PathRecord open = r;
            open.feed = 1e6;
            return ceilings_of(open, limits).a;
        }();
        EXPECT_GT(r.a_max, 1.3 * faster_a);
    }
    EXPECT_TRUE(seen);
}

}  // namespace
}  // namespace polyturn::channels
