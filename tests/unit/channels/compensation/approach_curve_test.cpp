// KONTT and KONTC: the way onto the contour touches it, the curved one with the curvature of the
// equidistant (sinumerik_part2 11.2).
#include <gtest/gtest.h>

#include <cmath>
#include <numbers>
#include <vector>

#include "channels/compensation/compensator.hpp"
#include "tests/unit/channels/quiet_sink.hpp"

namespace polyturn::channels::compensation {
namespace {

struct Recorder final : testing::QuietSink {
    std::vector<Move> moves;
    void move(const Move& m, const BlockContext&) override { moves.push_back(m); }
};

Move line_to(Vec from, Vec to) {
    Move m;
    m.kind = MoveKind::Linear;
    m.machine_start[0] = from.p;
    m.machine_start[1] = from.q;
    m.machine[0] = to.p;
    m.machine[1] = to.q;
    // a third axis goes along evenly
    m.machine_start[2] = 0;
    m.machine[2] = 6;
    m.moved = 7;
    return m;
}

// From the start point onto a half circle to the left about (0,10) that begins at the origin
// towards +p; then out to `end`.
std::vector<Move> drive(Entry entry, int side) {
    Options options;
    options.entry = entry;
    Recorder out;
    Compensator nose;
    nose.open(out, 0, 1, options);
    const auto step = [&](Move m) {
        nose.nose(2, {}, true);
        nose.move(m, {});
        nose.block_done(true);
    };
    nose.select(side);
    step(line_to({-30, 20}, {0, 0}));
    Move arc = line_to({0, 0}, {0, 20});
    arc.kind = MoveKind::ArcCcw;
    arc.centre_p = 0;
    arc.centre_q = 10;
    arc.radius = arc.radius_end = 10;
    arc.sweep = std::numbers::pi;
    step(arc);
    nose.cancel();
    step(line_to({0, 20}, {25, 45}));
    return out.moves;
}

Vec at(const Move& m, std::size_t k) {  // k = 0 start, last end
    const std::size_t n = m.through->size();
    const AxisValues& v = k == 0 ? m.machine_start : k > n ? m.machine : (*m.through)[k - 1];
    return {v[0], v[1]};
}

// Curvature of the circle through three neighbouring points.
double curvature(Vec a, Vec b, Vec c) {
    return 2 * cross(b - a, c - b) / (length(b - a) * length(c - b) * length(c - a));
}

TEST(ApproachByPolynomial, TouchesTheContourWhereItBeginsAndEnds) {
    for (const int side : {1, -1})
        for (const Entry entry : {Entry::Smooth, Entry::Curved}) {
            const std::vector<Move> moves = drive(entry, side);
            ASSERT_EQ(moves.size(), 3u);
            ASSERT_TRUE(moves[0].through && moves[2].through);
            EXPECT_NEAR(moves[0].machine[0], 0, 1e-9);
            EXPECT_NEAR(moves[0].machine[1], 2 * side, 1e-9);  // the point that NORM has
            EXPECT_NEAR(moves[2].machine[0], 25, 1e-9);
            EXPECT_NEAR(moves[2].machine[1], 45, 1e-9);
            const std::size_t n = moves[0].through->size();
            const Vec in = unit(at(moves[0], n + 1) - at(moves[0], n)),
                      away = unit(at(moves[2], 1) - at(moves[2], 0));
            EXPECT_NEAR(in.q, 0, 0.04) << "towards +p";
            EXPECT_GT(in.p, 0);
            EXPECT_NEAR(away.q, 0, 0.04) << "towards -p";
            EXPECT_LT(away.p, 0);
            EXPECT_NEAR((*moves[0].through)[n / 2][2],
                        6.0 * static_cast<double>(n / 2 + 1) / static_cast<double>(n + 1), 1e-9);
            if (entry != Entry::Curved) continue;
            // of the equidistant of the half circle
            const double wanted = side == 1 ? 1 / 8.0 : 1 / 12.0;
            EXPECT_NEAR(curvature(at(moves[0], n - 1), at(moves[0], n), at(moves[0], n + 1)),
                        wanted, 0.01);
            EXPECT_NEAR(curvature(at(moves[2], 0), at(moves[2], 1), at(moves[2], 2)), wanted, 0.01);
        }
}

}  // namespace
}  // namespace polyturn::channels::compensation
