// Records in path coordinates: what the kernel makes of them keeps every axis' limits, however near
// the pole they pass.
#include "channels/path/transformed_out.hpp"

#include <gtest/gtest.h>

#include "path_rig.hpp"

namespace polyturn::channels {
namespace {

Kinematics polar() {
    Kinematics k{};
    k.kind = static_cast<std::uint32_t>(KinematicsKind::Polar);
    k.axis.fill(0xff);
    // X, and a rotary axis of the rig
    k.axis[0] = 0;
    k.axis[1] = 4;
    k.sign.fill(1.0);
    k.value[1] = 1.0;
    return k;
}

// A line from a to b in the polar plane, as the path maker puts it out.
std::vector<PathRecord> pieces_of(double au, double av, double bu, double bv, double feed = 50) {
    static const PathLimits drives = rig::easy_limits();
    rig::Collected out;
    TransformedOut transformed(out, drives);
    const double turn = std::atan2(av, au) * 180 / std::numbers::pi;
    transformed.begin(polar(), turn, SideOfPole::Positive);
    PathMaker maker(transformed, transformed.limits());
    PathRecord& r = maker.next_move();
    r.kind = static_cast<std::uint8_t>(RecordKind::Line);
    r.feed_mode = static_cast<std::uint8_t>(FeedMode::PerMinute);
    r.feed = feed;
    r.axis_count = 2;
    r.axis = {0, 4};
    r.start = {au, av};
    r.end = {bu, bv};
    r.transform = 1;
    maker.add_move();
    maker.flush();
    return out.records;
}

struct Motion {
    double v, a, j;
};
// What the drives do at path speed v, acceleration a, jerk j.
Motion motion(const PathDerivatives& d, std::size_t slot, double v, double a, double j) {
    return {d.first[slot] * v, d.first[slot] * a + d.second[slot] * v * v,
            d.first[slot] * j + 3 * d.second[slot] * v * a + d.third[slot] * v * v * v};
}

void expect_limits_kept(const std::vector<PathRecord>& records) {
    static const PathLimits drives = rig::easy_limits();
    const Kinematics k = polar();
    for (std::size_t n = 0; n < records.size(); ++n) {
        const PathRecord& r = records[n];
        ASSERT_GT(r.v_max, 0) << n;
        ASSERT_GT(r.a_max, 0) << n;
        ASSERT_GT(r.j_max, 0) << n;
        ASSERT_GT(r.length, 0) << n;
        for (int i = 0; i <= 40; ++i) {
            PathDerivatives d;
            ASSERT_TRUE(drive_derivatives_at(r, &k, r.length * i / 40, d));
            for (std::size_t slot = 0; slot < r.axis_count; ++slot) {
                const PathAxis& axis = drives.axis[r.axis[slot]];
                const Motion fast = motion(d, slot, r.v_max, 0, 0);
                ASSERT_LE(std::abs(fast.v), axis.feed) << n;
                ASSERT_LE(std::abs(fast.a), axis.accel) << n;
                ASSERT_LE(std::abs(fast.j), axis.jerk) << n;
                const Motion still = motion(d, slot, 0, r.a_max, r.j_max);
                ASSERT_LE(std::abs(still.a), axis.accel) << n;
                ASSERT_LE(std::abs(still.j), axis.jerk) << n;
            }
        }
    }
}

TEST(TransformedOut, KeepsTheLimitsOfTheAxesHoweverNearThePole) {
    for (const double b : {40.0, 5.0, 1.0, 0.1, 0.01, 0.001, 0.0006}) {
        SCOPED_TRACE(b);
        expect_limits_kept(pieces_of(30, b, -30, b));
        expect_limits_kept(pieces_of(-b, 20, -b, -55));
    }
}

TEST(TransformedOut, LeadsTheDrivesOnWithoutAStep) {
    const Kinematics k = polar();
    for (const double b : {10.0, 0.1, 0.002, 0.0003, 0.0}) {
        SCOPED_TRACE(b);
        const auto records = pieces_of(30, b, -30, b);
        SlotVector end, begin;
        for (std::size_t n = 0; n < records.size(); ++n) {
            ASSERT_TRUE(drives_at(records[n], &k, 0, begin));
            if (n > 0) {
                ASSERT_NEAR(begin[0], end[0], 1e-7);
                ASSERT_NEAR(begin[1], end[1], 1e-7);
            }
            ASSERT_TRUE(drives_at(records[n], &k, records[n].length, end));
        }
        if (b < 0.0005) {  // through the pole: one record, the linear axis goes to the other side
            ASSERT_EQ(records.size(), 1u);
            EXPECT_NEAR(end[0], -30, 1e-6);
            EXPECT_NEAR(end[1], -b / 30 * 180 / std::numbers::pi, 1e-6);
        } else {
            EXPECT_NEAR(end[0], std::hypot(30, b), 1e-9);
            EXPECT_NEAR(end[1], std::atan2(b, -30) * 180 / std::numbers::pi, 1e-9);
        }
    }
}

// Past the pole the pieces count the turn of the rotary axis too: the points are those of the line,
// speed and acceleration go on from piece to piece and into what stands beside, and the way never
// goes faster than the feed.
TEST(TransformedOut, CountsTheTurnWithoutLeavingTheLineOrItsFeed) {
    for (const double b : {0.2, 0.02, 0.001, 0.0006}) {
        SCOPED_TRACE(b);
        const auto records = pieces_of(40, b, -25, b);
        double way = 0, length = 0;
        std::size_t curves = 0;
        for (std::size_t n = 0; n < records.size(); ++n) {
            const PathRecord& r = records[n];
            curves += r.kind == static_cast<std::uint8_t>(RecordKind::Curve);
            length += r.length;
            way += r.start[0] - r.end[0];
            for (int i = 0; i <= 20; ++i) {
                SlotVector p{};
                position_at(r, r.length * i / 20, p);
                ASSERT_NEAR(p[1], b, 1e-9);
                PathDerivatives d;
                derivatives_at(r, r.length * i / 20, d);
                ASSERT_LE(-d.first[0] * r.feed, 50 * (1 + 1e-9)) << n;  // mm/s of the way
                ASSERT_GT(-d.first[0], 0) << n;
            }
            if (n == 0) continue;
            PathDerivatives before, behind;
            derivatives_at(records[n - 1], records[n - 1].length, before);
            derivatives_at(r, 0, behind);
            ASSERT_NEAR(before.first[0], behind.first[0], 1e-7 + 1e-5 * std::abs(behind.first[0]))
                << n;
            ASSERT_NEAR(before.second[0], behind.second[0],
                        1e-6 + 1e-4 * std::abs(behind.second[0]))
                << n;
        }
        EXPECT_NEAR(way, 65, 1e-9);
        EXPECT_GT(curves, 10u);
        EXPECT_GT(length, 65.0);
    }
    // Where the rotary axis follows the feed anyway, and at the ends of a line, nothing is counted
    // differently.
    for (const PathRecord& r : pieces_of(30, 20, -30, 20))
        EXPECT_EQ(r.kind, static_cast<std::uint8_t>(RecordKind::Line));
    const auto records = pieces_of(40, 0.001, -25, 0.001);
    EXPECT_EQ(records.front().kind, static_cast<std::uint8_t>(RecordKind::Line));
    EXPECT_EQ(records.back().kind, static_cast<std::uint8_t>(RecordKind::Line));
}

TEST(TransformedOut, CutsNoMoreThanThePoleDemands) {
    EXPECT_LE(pieces_of(30, 40, -30, 40).size(), 16u);
    EXPECT_LE(pieces_of(30, 0.0006, -30, 0.0006).size(), 200u);
}

}  // namespace
}  // namespace polyturn::channels
