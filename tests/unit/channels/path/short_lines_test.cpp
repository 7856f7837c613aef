#include <gtest/gtest.h>

#include <algorithm>

#include "path_rig.hpp"

namespace polyturn::channels {
namespace {

using namespace rig;

double rounded(double value, double to) { return to > 0 ? std::round(value / to) * to : value; }

// Lines of `length` around a circle of `radius`, end points rounded as a program would have them.
struct Circle {
    double radius, length, rounding;
    int lines;
    std::vector<Point> corners{};
    std::vector<PathRecord> records{};

    void make(const PathLimits& limits) {
        Collected out;
        Program program(out, limits);
        program.at = {rounded(radius, rounding), 0};
        corners.push_back(program.at);
        for (int n = 1; n <= lines; ++n) {
            const double angle = n * length / radius;
            program.line({rounded(radius * std::cos(angle), rounding),
                          rounded(radius * std::sin(angle), rounding)});
            corners.push_back(program.at);
        }
        program.maker.flush();
        records = std::move(out.records);
    }
    // The least speed limit away from the ends.
    double slowest() const {
        double v = 1e9;
        for (std::size_t n = records.size() / 4; n < records.size() * 3 / 4; ++n)
            v = std::min(v, records[n].v_max);
        return v;
    }
};

double to_polyline(Point p, const std::vector<Point>& corners, std::size_t near) {
    double off = 1e9;
    for (std::size_t n = near > 30 ? near - 30 : 0; n + 1 < std::min(corners.size(), near + 30);
         ++n) {
        const Point a = corners[n], b = corners[n + 1];
        const double dx = b.x - a.x, dz = b.z - a.z, l2 = dx * dx + dz * dz;
        const double f =
            l2 > 0 ? std::clamp(((p.x - a.x) * dx + (p.z - a.z) * dz) / l2, 0.0, 1.0) : 0;
        off = std::min(off, std::hypot(p.x - a.x - f * dx, p.z - a.z - f * dz));
    }
    return off;
}

TEST(ShortLines, OfACircleReachNearlyTheSpeedOfTheCircle) {
    // The axes allow sqrt(0.9 * 2000 * R) on the circle itself, at most 166 mm/s (max feed).
    struct Row {
        double radius, length, rounding, share;
    };
    const Row rows[] = {
        {50, 0.1, 0, 0.95},     {10, 0.1, 0, 0.9},      {2, 0.1, 0, 0.7},
        {50, 0.1, 0.001, 0.95}, {10, 0.1, 0.001, 0.45}, {50, 0.01, 0.001, 0.5},
        {50, 1.0, 0.001, 0.4},
    };
    for (const Row& row : rows) {
        SCOPED_TRACE(testing::Message()
                     << "R " << row.radius << " L " << row.length << " rounding " << row.rounding);
        Circle circle{row.radius, row.length, row.rounding, 400};
        circle.make(easy_limits());
        const double ideal = std::min(166.0, std::sqrt(0.9 * 2000 * row.radius));
        EXPECT_GE(circle.slowest(), row.share * ideal) << "ideal " << ideal;
    }
}

TEST(ShortLines, StayWithinToleranceAndNameEveryBlock) {
    for (const double rounding : {0.0, 0.001}) {
        for (const double length : {0.005, 0.05, 0.4}) {
            Circle circle{10, length, rounding, 500};
            circle.make(easy_limits());
            std::int64_t block = 0;
            for (const auto& r : circle.records) {
                if (r.flags & kBlockBegin) ++block;
                EXPECT_EQ(r.block, block);
                for (double f = 0; f <= 1; f += 0.25) {
                    const Point p{axis_state(r, f * r.length, 0).p,
                                  axis_state(r, f * r.length, 1).p};
                    ASSERT_LE(to_polyline(p, circle.corners, static_cast<std::size_t>(r.block)),
                              0.005 + 1e-9)
                        << "rounding " << rounding << " length " << length;
                }
            }
            EXPECT_GE(block, 300) << "equal rounded points vanish, the others do not";
        }
    }
}

// Oracle in the other direction: no programmed corner is farther than the tolerance from the path.
TEST(ShortLines, LeaveNoCornerOut) {
    Circle circle{3, 0.05, 0.001, 300};
    circle.make(easy_limits());
    std::vector<Point> path;
    for (const auto& r : circle.records)
        for (double f = 0; f <= 1; f += 0.125)
            path.push_back({axis_state(r, f * r.length, 0).p, axis_state(r, f * r.length, 1).p});
    for (const Point& corner : circle.corners) {
        double off = 1e9;
        for (std::size_t n = 0; n + 1 < path.size(); ++n)
            off = std::min(off, to_polyline(corner, {path[n], path[n + 1]}, 0));
        EXPECT_LE(off, 0.005 + 1e-9);
    }
}

TEST(ShortLines, BlocksThatMoveOneAxisOnlyStayInTheRun) {
    Collected out;
    const PathLimits limits = easy_limits();
    Program program(out, limits);
    for (int n = 1; n <= 60; ++n) {
        PathRecord& r = program.begin(RecordKind::Line);
        if (n % 3 == 0) {  // Z alone
            r.axis_count = 1;
            r.axis = {1};
            r.start = {program.at.z};
            r.end = {program.at.z += 0.1};
        } else {
            r.end = {program.at.x += 0.00001 * (n % 3), program.at.z += 0.1};
        }
        program.maker.add_move();
    }
    program.maker.flush();
    std::size_t curves = 0;
    for (const auto& r : out.records) curves += kind_of(r) == RecordKind::Curve;
    EXPECT_GE(curves, 55u);
}

TEST(ShortLines, EventsStayBehindTheirBlocks) {
    Collected out;
    const PathLimits limits = easy_limits();
    Program program(out, limits);
    for (int n = 1; n <= 200; ++n) {
        program.line({50 * std::cos(n * 0.002), 50 * std::sin(n * 0.002)});
        PathRecord event;
        event.kind = static_cast<std::uint8_t>(RecordKind::Message);
        event.block = n;
        program.maker.add_event(event, false);
    }
    program.maker.flush();
    std::int64_t block = 0;
    for (const auto& r : out.records) {
        if (kind_of(r) == RecordKind::Message) {
            EXPECT_EQ(r.block, block);
        } else {
            block = r.block;
        }
    }
    EXPECT_EQ(block, 200);
}

// Lines along one axis within a run get the other one too: it has what the nose had added to it
// before.
TEST(ShortLines, WhatTheNoseAddsStaysWithItsAxis) {
    Collected out;
    PathLimits limits = easy_limits();
    Program program(out, limits);
    program.at = {10, 0};
    double x_nose = 0, z_nose = 0;
    std::vector<Point> noses{{0, 0}};
    for (int n = 0; n < 12; ++n) {
        PathRecord& r = program.begin(RecordKind::Line);
        if (n % 3 == 0) {  // Z alone
            r.axis_count = 1;
            r.axis = {1};
            r.start = {program.at.z};
            r.end = {program.at.z -= 0.2};
            r.nose = {z_nose = 10.0 + n};
        } else {
            program.at = {program.at.x + (n % 3 == 1 ? 0.002 : -0.002), program.at.z - 0.2};
            r.end = {program.at.x, program.at.z};
            r.nose = {x_nose = 20.0 + n, z_nose = 10.0 + n};
        }
        noses.push_back({x_nose, z_nose});
        program.maker.add_move();
    }
    program.maker.flush();
    bool curved = false;
    for (const PathRecord& r : out.records) {
        curved = curved || kind_of(r) == RecordKind::Curve;
        for (std::size_t k = 0; k < r.axis_count; ++k) {
            const Point& wanted = noses[static_cast<std::size_t>(r.block)];
            EXPECT_EQ(r.nose[k], r.axis[k] == 0 ? wanted.x : wanted.z)
                << "block " << r.block << " axis " << int(r.axis[k]);
        }
    }
    EXPECT_TRUE(curved);
}

}  // namespace
}  // namespace polyturn::channels
