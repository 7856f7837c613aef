#include "channels/path/path_maker.hpp"

#include <gtest/gtest.h>

#include "path_rig.hpp"
#include "tests/seeds.hpp"

namespace polyturn::channels {
namespace {

using namespace rig;

std::vector<PathRecord> made(const PathLimits& limits, auto&& program_text) {
    Collected out;
    Program program(out, limits);
    program_text(program);
    program.maker.flush();
    return out.records;
}

// I1: position, tangent and curvature meet, or there is a stop.
void expect_smooth(const std::vector<PathRecord>& records) {
    for (std::size_t n = 0; n + 1 < records.size(); ++n) {
        const PathRecord &a = records[n], &b = records[n + 1];
        for (unsigned axis = 0; axis < 2; ++axis) {
            const AxisState end = axis_state(a, a.length, axis), begin = axis_state(b, 0, axis);
            ASSERT_NEAR(end.p, begin.p, 1e-9) << "record " << n;
            if (a.flags & kExactStop) continue;
            ASSERT_NEAR(end.t, begin.t, 2e-6)
                << "record " << n << " kinds " << int(a.kind) << int(b.kind) << " length "
                << a.length << " " << b.length;
            const double scale = std::max({1.0, std::abs(end.k), std::abs(begin.k)});
            ASSERT_NEAR(end.k / scale, begin.k / scale, 1e-5)
                << "record " << n << " kinds " << int(a.kind) << int(b.kind) << " length "
                << a.length << " " << b.length;
        }
    }
}

double to_segment(Point p, Point a, Point b) {
    const double dx = b.x - a.x, dz = b.z - a.z, l2 = dx * dx + dz * dz;
    const double f = l2 > 0 ? std::clamp(((p.x - a.x) * dx + (p.z - a.z) * dz) / l2, 0.0, 1.0) : 0;
    return std::hypot(p.x - a.x - f * dx, p.z - a.z - f * dz);
}

Point point(const PathRecord& r, double s) {
    return {axis_state(r, s, 0).p, axis_state(r, s, 1).p};
}

TEST(PathMaker, ASingleLineIsOneRecordThatStops) {
    const auto records = made(easy_limits(), [](Program& p) { p.line({3, 4}); });
    ASSERT_EQ(records.size(), 1u);
    EXPECT_DOUBLE_EQ(records[0].length, 5);
    EXPECT_EQ(records[0].flags, kBlockBegin | kBlockEnd | kExactStop);
    EXPECT_DOUBLE_EQ(records[0].v_max, 166 / 0.8);
    EXPECT_DOUBLE_EQ(records[0].a_max, 2000 / 0.8);
    EXPECT_DOUBLE_EQ(records[0].j_max, 40000 / 0.8);
}

TEST(PathMaker, ARightAngleBecomesABlendWithinTolerance) {
    const auto records = made(easy_limits(), [](Program& p) {
        p.feed = 1;
        p.line({10, 0});
        p.line({10, 10});
    });
    ASSERT_GE(records.size(), 4u);
    expect_smooth(records);
    double nearest = 1;
    for (const auto& r : records)
        for (double f = 0; f <= 1; f += 0.05)
            nearest = std::min(nearest,
                               std::hypot(point(r, f * r.length).x - 10, point(r, f * r.length).z));
    EXPECT_LE(nearest, 0.005);
    EXPECT_GT(nearest, 0.0045) << "the tolerance is used";
    // The first half ends block 1, the second begins block 2.
    for (std::size_t n = 0; n + 1 < records.size(); ++n)
        if (records[n].block != records[n + 1].block) {
            EXPECT_TRUE(records[n].flags & kBlockEnd);
            EXPECT_TRUE(records[n + 1].flags & kBlockBegin);
            EXPECT_EQ(kind_of(records[n]), RecordKind::Curve);
            EXPECT_EQ(kind_of(records[n + 1]), RecordKind::Curve);
        }
}

TEST(PathMaker, StopsWhereItMust) {
    struct Row {
        const char* why;
        double turn;
        std::uint32_t first, second;
        double tolerance;
        bool stop;
        double feed = 1, square = 400;
    };
    const Row rows[] = {
        {"corner", 90, 0, 0, 0.1, false},
        {"exact stop asked for", 90, kExactStop, 0, 0.005, true},
        {"exact stop on a straight path", 0, kExactStop, 0, 0.005, true},
        {"tolerance 0", 90, 0, 0, 0, true},
        {"tolerance 0, straight on", 0, 0, 0, 0, false},
        {"reversal", 180, 0, 0, 0.005, true},
        {"nearly a reversal", 170, 0, 0, 0.005, true},
        {"sharp", 150, 0, 0, 0.5, false},
        {"faster by a stop", 150, 0, 0, 0.005, true, 100},
        {"square corners from 80 degrees on", 90, 0, 0, 0.1, true, 1, 80},
        {"square corners from 100 degrees on", 90, 0, 0, 0.1, false, 1, 100},
        {"rapid before", 90, kRapid, 0, 0.005, true},
        {"rapid behind", 90, 0, kRapid, 0.005, true},
        {"thread begins", 0, 0, kThread, 0.005, true},
        {"threads in a row", 10, kThread, kThread | kThreadChained, 0.005, false},
        {"threads in a row at any angle", 150, kThread, kThread | kThreadChained, 0.005, false,
         100},
        {"threads in a row, tolerance 0", 10, kThread, kThread | kThreadChained, 0, false},
        {"threads in a row, exact stop asked for", 10, kThread | kExactStop,
         kThread | kThreadChained, 0.005, true},
        {"threads in a row, a reversal", 170, kThread, kThread | kThreadChained, 0.005, true},
    };
    for (const Row& row : rows) {
        SCOPED_TRACE(row.why);
        PathLimits limits = easy_limits();
        limits.tolerance = row.tolerance;
        limits.square_turn = row.square * std::numbers::pi / 180;
        const double turn = row.turn * std::numbers::pi / 180;
        const auto records = made(limits, [&](Program& p) {
            p.feed = row.feed;
            p.line({10, 0}, row.first);
            p.line({10 + 10 * std::cos(turn), 10 * std::sin(turn)}, row.second);
        });
        std::size_t stops = 0;
        for (const auto& r : records) stops += (r.flags & kExactStop) != 0;
        EXPECT_EQ(stops, row.stop ? 2u : 1u);
        expect_smooth(records);
    }
}

// Threads of 40 mm lead 2 that turn by `angle` degrees, at `turns` revolutions a second.
std::vector<PathRecord> joined_threads(const PathLimits& limits, double angle, double turns,
                                       std::uint32_t first_flags = 0) {
    const double turn = angle * std::numbers::pi / 180;
    return made(limits, [&](Program& p) {
        const auto thread = [&](Point to, std::uint32_t flags) {
            PathRecord& r = p.begin(RecordKind::Line);
            r.feed_mode = static_cast<std::uint8_t>(FeedMode::Thread);
            r.feed = 0;
            r.lead = 2;
            r.flags = kThread | flags;
            r.end = {to.x, to.z};
            p.at = to;
            p.maker.thread_turns(turns);
            p.maker.add_move();
        };
        thread({0, -40}, first_flags);
        thread({40 * std::sin(turn), -40 - 40 * std::cos(turn)}, kThreadChained);
    });
}

// fagor_8037t part 1, 6.11: the spindle leads, so the corner is rounded as far as its speed asks
// for; what the bend leaves is there to start with.
TEST(PathMaker, JoinedThreadsGoRoundTheirCornerAtTheSpeedOfTheSpindle) {
    struct Row {
        double angle, turns, off;
    };
    for (const Row& row : {Row{18.4, 2, 0.1}, Row{18.4, 10, 0.1}, Row{18.4, 20, 0.4},
                           Row{45, 10, 0.4}, Row{90, 10, 1}, Row{150, 10, 3}})
        for (const double tolerance : {0.005, 0.0}) {
            SCOPED_TRACE(row.angle);
            SCOPED_TRACE(row.turns);
            PathLimits limits = easy_limits();
            limits.tolerance = tolerance;
            const auto records = joined_threads(limits, row.angle, row.turns);
            ASSERT_GT(records.size(), 2u);
            expect_smooth(records);
            double far = 0;
            for (std::size_t n = 0; n < records.size(); ++n) {
                const PathRecord& r = records[n];
                EXPECT_EQ((r.flags & kThreadEnd) != 0, n + 1 == records.size());
                EXPECT_EQ((r.flags & kExactStop) != 0, n + 1 == records.size());
                EXPECT_GE(r.v_max, 2 * row.turns);
                EXPECT_GT(r.a_max, 300) << "of 2000";
                const Point end{r.end[0], r.end[1]};
                const double turn = row.angle * std::numbers::pi / 180;
                far = std::max(
                    far, std::min(to_segment(end, {0, 0}, {0, -40}),
                                  to_segment(end, {0, -40},
                                             {40 * std::sin(turn), -40 - 40 * std::cos(turn)})));
            }
            EXPECT_LT(far, row.off);
        }
}

// On the line of the spindle, tick by tick: what the axes are told stays within their acceleration
// (2000) and jerk (40000) round the corner.
TEST(PathMaker, JoinedThreadsAskNoJumpOfTheAxes) {
    constexpr double kTick = 0.001, kSpeed = 20;
    for (const double angle : {14.0, 45.0, 90.0, 150.0})
        for (const double tolerance : {0.005, 0.0}) {
            SCOPED_TRACE(angle);
            PathLimits limits = easy_limits();
            limits.tolerance = tolerance;
            std::vector<Point> at;
            double s = 0;
            for (const PathRecord& r : joined_threads(limits, angle, kSpeed / 2)) {
                for (; s < r.length; s += kSpeed * kTick) at.push_back(point(r, s));
                s -= r.length;
            }
            double acceleration = 0, jerk = 0;
            for (std::size_t n = 3; n < at.size(); ++n)
                for (double Point::*axis : {&Point::x, &Point::z}) {
                    const double now = at[n].*axis - 2 * at[n - 1].*axis + at[n - 2].*axis,
                                 before = at[n - 1].*axis - 2 * at[n - 2].*axis + at[n - 3].*axis;
                    acceleration = std::max(acceleration, std::abs(now) / (kTick * kTick));
                    jerk = std::max(jerk, std::abs(now - before) / (kTick * kTick * kTick));
                }
            EXPECT_LT(acceleration, 2000);
            EXPECT_LT(jerk, 40000);
        }
}

// Where a stop is asked for they are two threads: the first one ends, the second one waits for its
// angle and has a run-in of its own.
TEST(PathMaker, ThreadsWithAStopBetweenThemAreNotJoined) {
    struct Row {
        double angle;
        std::uint32_t flags;
    };
    for (const Row& row : {Row{14, kExactStop}, Row{170, 0}}) {
        SCOPED_TRACE(row.angle);
        const auto records = joined_threads(easy_limits(), row.angle, 10, row.flags);
        ASSERT_EQ(records.size(), 2u);
        for (const PathRecord& r : records) {
            EXPECT_TRUE(r.flags & kThreadEnd);
            EXPECT_TRUE(r.flags & kExactStop);
            EXPECT_FALSE(r.flags & kThreadChained);
        }
    }
}

// N1337 PCH; must be 0 where rapid moves overlap (nct_parameters_part1 6.4, 14.4).
TEST(PathMaker, RapidMovesEndInPositionWherePchAsksForIt) {
    const auto flags = [](bool asked, bool overlaps) {
        PathLimits limits = easy_limits();
        limits.rapid_in_position = asked;
        limits.rapid_overlaps = overlaps;
        const auto records = made(limits, [](Program& p) {
            p.line({5, 0});
            p.line({10, 0}, kRapid);
        });
        EXPECT_FALSE(records.front().flags & kInPosition);
        return records.back().flags & kInPosition;
    };
    EXPECT_TRUE(flags(true, false));
    EXPECT_FALSE(flags(false, false));
    EXPECT_FALSE(flags(true, true));
}

TEST(PathMaker, ATangentialArcGetsATransitionUnlessNoAxisHasAJerkLimit) {
    const auto text = [](Program& p) {
        p.line({10, 0});
        p.arc({10, 5}, 1.5);
    };
    auto records = made(easy_limits(), text);
    EXPECT_GE(records.size(), 4u);
    expect_smooth(records);
    PathLimits unlimited = easy_limits();
    for (auto& axis : unlimited.axis) axis.jerk = std::numeric_limits<double>::infinity();
    records = made(unlimited, text);
    ASSERT_EQ(records.size(), 2u);
    EXPECT_FALSE(records[0].flags & kExactStop);
}

TEST(PathMaker, MovesOfNoLengthVanish) {
    const auto records = made(easy_limits(), [](Program& p) {
        p.line({1, 0});
        p.line({1, 0});
        p.line({2, 0});
    });
    EXPECT_EQ(records.size(), 2u);
}

TEST(PathMaker, EventsKeepTheirPlaceBetweenTheBlocks) {
    Collected out;
    const PathLimits limits = easy_limits();
    Program p(out, limits);
    p.feed = 1;
    PathRecord event;
    event.kind = static_cast<std::uint8_t>(RecordKind::SpindleSpeed);
    p.line({10, 0});
    p.maker.add_event(event, false);
    p.line({10, 10});
    event.kind = static_cast<std::uint8_t>(RecordKind::Aux);
    p.maker.add_event(event, true);
    p.line({0, 10});
    p.maker.flush();
    std::size_t speed = 0, aux = 0;
    for (std::size_t n = 0; n < out.records.size(); ++n) {
        if (kind_of(out.records[n]) == RecordKind::SpindleSpeed) speed = n;
        if (kind_of(out.records[n]) == RecordKind::Aux) aux = n;
    }
    ASSERT_GT(speed, 0u);
    EXPECT_EQ(out.records[speed - 1].block, 1);
    EXPECT_FALSE(out.records[speed - 1].flags & kExactStop);
    EXPECT_EQ(out.records[speed + 1].block, 2);
    EXPECT_TRUE(out.records[aux - 1].flags & kExactStop);
}

TEST(PathMaker, RandomPathsAreSmoothCompleteAndNamedByTheirBlocks) {
    for (std::uint64_t seed = 1; seed <= 300; ++seed) {
        SCOPED_TRACE(seed);
        std::mt19937_64 random(test_seed(seed));
        const int moves = 60;
        const auto records =
            made(easy_limits(), [&](Program& p) { random_path(p, random, moves); });
        expect_smooth(records);
        if (testing::Test::HasFatalFailure()) return;
        std::int64_t block = 0;
        bool open = false;
        for (const auto& r : records) {  // I2
            if (r.flags & kBlockBegin) {
                EXPECT_FALSE(open);
                EXPECT_EQ(r.block, ++block);
                open = true;
            }
            EXPECT_EQ(r.block, block);
            EXPECT_GT(r.length, 0);
            EXPECT_GT(r.v_max, 0);
            EXPECT_GT(r.a_max, 0);
            EXPECT_GT(r.j_max, 0);
            if (r.flags & kBlockEnd) open = false;
        }
        EXPECT_EQ(block, moves);
    }
}

TEST(PathMaker, SpeedAlongEachRecordIsOneAndItsLengthIsTrue) {
    for (std::uint64_t seed = 1; seed <= 60; ++seed) {
        std::mt19937_64 random(test_seed(seed));
        const auto records = made(easy_limits(), [&](Program& p) { random_path(p, random, 60); });
        for (const auto& r : records)
            for (double f = 0; f <= 1.0001; f += 1.0 / 32) {
                const double speed =
                    std::hypot(axis_state(r, f * r.length, 0).t, axis_state(r, f * r.length, 1).t);
                ASSERT_NEAR(speed, 1, 1.1e-4)
                    << "seed " << seed << " kind " << int(r.kind) << " f " << f;
            }
    }
}

// Oracle: distance of dense samples to the programmed polyline, and of its corners to the samples.
TEST(PathMaker, PolylinesAreFollowedWithinTolerance) {
    for (std::uint64_t seed = 1; seed <= 100; ++seed) {
        std::mt19937_64 random(test_seed(seed));
        std::uniform_real_distribution<double> unit(0, 1);
        std::vector<Point> corners{{0, 0}};
        const auto records = made(easy_limits(), [&](Program& p) {
            double heading = 0;
            for (int n = 0; n < 40; ++n) {
                heading += (unit(random) - 0.5) * 2 * std::numbers::pi;
                const double length = std::pow(10.0, -3 + 5 * unit(random));
                p.line({p.at.x + length * std::cos(heading), p.at.z + length * std::sin(heading)});
                corners.push_back(p.at);
            }
        });
        for (const auto& r : records)
            for (double f = 0; f <= 1; f += 0.1) {
                const Point at = point(r, f * r.length);
                double off = 1e9;
                for (std::size_t n = 0; n + 1 < corners.size(); ++n)
                    off = std::min(off, to_segment(at, corners[n], corners[n + 1]));
                ASSERT_LE(off, 0.005 + 1e-9) << "seed " << seed;
            }
        std::size_t block = 0;
        for (std::size_t n = 0; n + 1 < records.size(); ++n)
            if (records[n].block != records[n + 1].block) {
                const Point middle = point(records[n], records[n].length);
                ++block;
                ASSERT_LE(std::hypot(middle.x - corners[block].x, middle.z - corners[block].z),
                          0.005 + 1e-9)
                    << "seed " << seed << " corner " << block;
            }
    }
}

// What compensation has added stays with its axis, whatever slots a blend has: each half belongs to
// its move, and an axis that the move does not have stands where the one before has left it.
TEST(PathMaker, WhatTheNoseAddsGoesAlongWithItsAxis) {
    Collected out;
    const PathLimits limits = easy_limits();
    Program program(out, limits);
    program.feed = 1;  // so slow that a blend is worth it
    const auto single = [&](std::uint8_t axis, double to, double nose) {
        PathRecord& r = program.begin(RecordKind::Line);
        r.axis_count = 1;
        r.axis = {axis};
        double& at = axis == 0 ? program.at.x : program.at.z;
        r.start = {at};
        r.end = {at = to};
        r.nose = {nose};
        program.maker.add_move();
    };
    // only Z, only X, only Z: every corner joins two records that share no axis
    single(1, -20, 1);
    single(0, 20, 2);
    single(1, -40, 3);
    program.maker.flush();
    const double wanted[3][2] = {{0, 1}, {2, 1}, {2, 3}};  // behind block 1, 2, 3: X, Z
    bool blended = false;
    ASSERT_GT(out.records.size(), 3u);
    for (const PathRecord& r : out.records) {
        blended = blended || r.axis_count == 2;
        for (std::size_t k = 0; k < r.axis_count; ++k)
            EXPECT_EQ(r.nose[k], wanted[r.block - 1][r.axis[k]])
                << "block " << r.block << " axis " << int(r.axis[k]);
    }
    EXPECT_TRUE(blended);
}

}  // namespace
}  // namespace polyturn::channels
