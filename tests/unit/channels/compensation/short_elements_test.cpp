// Elements that are too short for an inner corner (sinumerik_part2 11.4.2, 11.5): hollows of many
// short lines, in which the nose does not fit, are passed without touching any of them.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <random>
#include <vector>

#include "channels/compensation/compensator.hpp"
#include "tests/seeds.hpp"
#include "tests/unit/channels/quiet_sink.hpp"

namespace polyturn::channels::compensation {
namespace {

struct Recorder final : testing::QuietSink {
    std::vector<Move> moves;
    std::vector<std::pair<Vec, double>> functions;  // where the nose stood
    void move(const Move& m, const BlockContext&) override { moves.push_back(m); }
    void aux(const Aux& a, const BlockContext&) override {
        const Move& m = moves.back();
        functions.push_back({{m.machine[0], m.machine[1]}, a.value});
    }
};

struct Driven {
    std::vector<Vec> points;  // of the nose's centre
    std::vector<std::pair<Vec, double>> functions;
    bool failed = false;
};

// From `start` to the first point compensated on the left, along all points, and out to `end`. A
// function stands behind each block.
Driven drive(Vec start, const std::vector<Vec>& contour, Vec end, double radius,
             const Options& options) {
    Recorder out;
    Compensator nose;
    nose.open(out, 0, 1, options);
    Vec here = start;
    double number = 0;
    const auto to = [&](Vec there) {
        Move m;
        m.kind = MoveKind::Linear;
        m.machine_start[0] = here.p;
        m.machine_start[1] = here.q;
        m.machine[0] = there.p;
        m.machine[1] = there.q;
        m.moved = 3;
        nose.nose(radius, {}, true);
        nose.move(m, {});
        Aux a;
        a.value = ++number;
        nose.aux(a, {});
        nose.block_done(true);
        here = there;
    };
    nose.select(1);
    for (const Vec point : contour) to(point);
    nose.cancel();
    to(end);
    Driven driven;
    driven.failed = nose.failed();
    driven.functions = out.functions;
    for (const Move& m : out.moves) {
        EXPECT_EQ(m.kind, MoveKind::Linear);
        if (driven.points.empty())
            driven.points.push_back({m.machine_start[0], m.machine_start[1]});
        EXPECT_NEAR(m.machine_start[0], driven.points.back().p, 1e-9);
        EXPECT_NEAR(m.machine_start[1], driven.points.back().q, 1e-9);
        driven.points.push_back({m.machine[0], m.machine[1]});
    }
    return driven;
}

double distance(Vec p, Vec a, Vec b) {
    const double t = std::clamp(dot(p - a, b - a) / dot(b - a, b - a), 0.0, 1.0);
    return length(p - (a + t * (b - a)));
}

Options options_of(ShortLast how) {
    Options o;
    o.entry = Entry::Direct;
    o.corner = Corner::Arc;
    o.looks_back = true;
    o.leaves_out = 100;
    o.short_last = how;
    return o;
}

// A long line, up to eight short ones that turn left, and a long line again.
TEST(ShortElements, AHollowOfShortLinesIsNotCutInto) {
    std::mt19937 random(test_seed(11));
    std::uniform_real_distribution<double> turn(5, 40), size(0.2, 4), nose(1, 5);
    std::uniform_int_distribution<int> lines(1, 8);
    int left_out = 0;
    for (int round = 0; round < 3000; ++round) {
        std::vector<Vec> contour{{0, 0}, {60, 0}};
        double angle = 0;
        for (int k = lines(random); k > 0; --k) {
            const double by = turn(random);
            if (angle + by > 110) break;
            angle += by;
            const double w = angle * std::numbers::pi / 180, s = size(random);
            contour.push_back(contour.back() + Vec{s * std::cos(w), s * std::sin(w)});
        }
        angle += 30;
        const double w = angle * std::numbers::pi / 180;
        contour.push_back(contour.back() + Vec{80 * std::cos(w), 80 * std::sin(w)});
        const double radius = nose(random);
        const Driven driven = drive({-10, 20}, contour, contour.back() + Vec{-20, 5}, radius,
                                    options_of(ShortLast::Line));
        ASSERT_FALSE(driven.failed) << round;
        ASSERT_EQ(driven.functions.size(), contour.size() + 1) << round;  // none is lost
        left_out += driven.points.size() < contour.size() + 2;
        for (std::size_t i = 2; i + 1 < driven.points.size(); ++i)  // without the ways in and out
            for (int k = 0; k <= 20; ++k) {
                const Vec p =
                    driven.points[i - 1] + (k / 20.0) * (driven.points[i] - driven.points[i - 1]);
                for (std::size_t e = 1; e < contour.size(); ++e)
                    ASSERT_GE(distance(p, contour[e - 1], contour[e]), radius - 1e-6) << round;
            }
        for (std::size_t i = 1; i < driven.functions.size(); ++i)
            EXPECT_EQ(driven.functions[i].second, driven.functions[i - 1].second + 1);
    }
    EXPECT_GT(left_out, 1000);  // the draw has what it is about
}

// sinumerik_part2 11.5: of three blocks that are known one can be left out.
TEST(ShortElements, NotMoreThanTheOptionsSayAreLeftOut) {
    const std::vector<Vec> contour{{0, 0}, {40, 0}, {40.5, 0.3}, {40.8, 0.8}, {41, 40}};
    Options o = options_of(ShortLast::Line);
    EXPECT_FALSE(drive({-10, 5}, contour, {20, 40}, 5, o).failed);
    o.leaves_out = 1;
    EXPECT_TRUE(drive({-10, 5}, contour, {20, 40}, 5, o).failed);
}

struct LastRow {
    ShortLast how;
    double leaves_at;  // on the line of the nose's centre, 5 beside the contour's long line
};
// The way out from the square point (35, 2) of the last line to (20, 20) crosses the line q = 5 at
// p = 32.5; the circle of 5 about (40, 2) at 36; the last line's equidistant at 35. All lines but
// the first are shorter than the nose needs.
constexpr LastRow kLast[] = {
    {ShortLast::TravelOut, 32.5}, {ShortLast::Circle, 36.0}, {ShortLast::Line, 35.0}};

TEST(ShortElements, TheLastOnesAreLeftOutAsTheOptionsSay) {
    for (const LastRow& row : kLast)
        for (const std::vector<Vec>& last :
             {std::vector<Vec>{{40, 2}}, std::vector<Vec>{{40, 1}, {40, 2}},
              std::vector<Vec>{{40, 0.5}, {40, 1.2}, {40, 2}}}) {
            std::vector<Vec> contour{{0, 0}, {40, 0}};
            contour.insert(contour.end(), last.begin(), last.end());
            const Driven out = drive({-10, 0}, contour, {20, 20}, 5, options_of(row.how));
            ASSERT_FALSE(out.failed);
            ASSERT_EQ(out.points.size(), 4u);
            EXPECT_NEAR(out.points[2].p, row.leaves_at, 1e-9);
            EXPECT_NEAR(out.points[2].q, 5, 1e-9);
            // Mirrored in p and driven backwards: the way in.
            std::vector<Vec> back(contour.rbegin(), contour.rend());
            for (Vec& v : back) v.p = -v.p;
            const Driven in = drive({-20, 20}, back, {10, 0}, 5, options_of(row.how));
            ASSERT_FALSE(in.failed);
            ASSERT_EQ(in.points.size(), 4u);
            EXPECT_NEAR(in.points[1].p, -row.leaves_at, 1e-9);
            EXPECT_NEAR(in.points[1].q, 5, 1e-9);
        }
}

TEST(ShortElements, WhereNothingMeetsTheLastOneIsAnAlarm) {
    const Driven out =
        drive({-10, 0}, {{0, 0}, {2, 0}, {2, 2}}, {-20, 20}, 5, options_of(ShortLast::Circle));
    EXPECT_TRUE(out.failed);
}

}  // namespace
}  // namespace polyturn::channels::compensation
