// Chamfers and roundings in the stream of moves: order, feeds, compensation behind them, what ends
// a held move.
#include <gtest/gtest.h>

#include "../state/core_rig.hpp"

namespace polyturn::channels {
namespace {

using corners::Shape;
using testing::CoreRig;
using testing::Kept;

struct CornerRig : CoreRig {
    using CoreRig::CoreRig;
    bool corner(Shape shape, double size, bool from_next = false, double feed = 0,
                bool reduce = false) {
        corners::Call call;
        call.shape = shape;
        call.size = size;
        call.from_next = from_next;
        call.feed = feed;
        call.reduce = reduce;
        return core->corner(call);
    }
    bool end(bool program_ends = false) {
        ++core->at.serial;
        return !core->reads_ahead() || core->end_compensated_block(true, false, program_ends);
    }
    void expect_moves(const std::vector<std::pair<double, double>>& points) {
        const auto moves = sink.moves();
        ASSERT_EQ(moves.size(), points.size());
        for (std::size_t i = 0; i < moves.size(); ++i) {
            EXPECT_NEAR(moves[i].move.machine[x], points[i].first, 1e-6) << i;
            EXPECT_NEAR(moves[i].move.machine[z], points[i].second, 1e-6) << i;
            EXPECT_NEAR(moves[i].move.pos[x], points[i].first, 1e-6) << i;
            if (i == 0) continue;
            EXPECT_NEAR(moves[i].move.machine_start[x], points[i - 1].first, 1e-6) << i;
            EXPECT_NEAR(moves[i].move.machine_start[z], points[i - 1].second, 1e-6) << i;
        }
    }
};

TEST(CornerStage, ChamferThenRoundingOnOneMove) {
    CornerRig rig;
    ASSERT_TRUE(rig.line(10, 5) && rig.end());
    ASSERT_TRUE(rig.corner(Shape::ChamferLeg, 1.5) && rig.line(10, -20) && rig.end());
    ASSERT_TRUE(rig.corner(Shape::Rounding, 2, false, 30) && rig.line(20, -20) && rig.end());
    ASSERT_TRUE(rig.line(20, -40) && rig.end());
    rig.expect_moves({{10, 5}, {10, -18.5}, {11.5, -20}, {18, -20}, {20, -22}, {20, -40}});
    const Move arc = rig.sink.moves()[4].move;
    EXPECT_EQ(arc.kind, MoveKind::ArcCcw);  // on a lathe, seen against Y: from +X to -Z
    EXPECT_NEAR(arc.radius, 2, 1e-9);
    EXPECT_EQ(arc.feed, 30);
    EXPECT_EQ(rig.sink.moves()[5].move.feed, 100);
    EXPECT_FALSE(rig.core->reads_ahead());
}

TEST(CornerStage, FunctionsBetweenKeepTheirOrder) {
    for (const bool from_next : {false, true}) {
        CornerRig rig;
        ASSERT_TRUE(rig.corner(Shape::Rounding, 2, from_next) && rig.line(0, -20) && rig.end());
        rig.core->aux('M', 8, "M8", false);
        ASSERT_TRUE(rig.end());
        rig.core->path.feed = 50;
        ASSERT_TRUE(rig.line(10, -20) && rig.end());
        std::string order;
        for (const Kept& call : rig.sink.calls) order += call.what;
        EXPECT_EQ(order, from_next ? "mamm" : "mmam");
        EXPECT_EQ(rig.sink.moves()[1].move.feed, from_next ? 50 : 100);
    }
}

TEST(CornerStage, WithoutANextMoveOfTheContourThereIsNone) {
    CornerRig rig;
    ASSERT_TRUE(rig.corner(Shape::Rounding, 2) && rig.line(0, -20) && rig.end());
    ASSERT_TRUE(rig.end(true));
    rig.expect_moves({{0, -20}});
    ASSERT_TRUE(rig.corner(Shape::Rounding, 2) && rig.line(0, -30) && rig.end());
    for (int blocks = 0; blocks < 4; ++blocks) ASSERT_TRUE(rig.end());
    EXPECT_FALSE(rig.core->reads_ahead());
    ASSERT_TRUE(rig.line(10, -30) && rig.end());
    rig.expect_moves({{0, -20}, {0, -30}, {10, -30}});
}

TEST(CornerStage, TooLargeIsAFaultOfItsOwnBlockAndNothingOfItIsDelivered) {
    CornerRig rig;
    rig.core->at.line = 7;
    ASSERT_TRUE(rig.corner(Shape::Rounding, 9) && rig.line(0, -8) && rig.end());
    rig.core->at.line = 8;
    ASSERT_TRUE(rig.line(20, -8));
    EXPECT_FALSE(rig.end());
    EXPECT_EQ(rig.core->fault().alarm, Alarm::CornerTooLarge);
    ASSERT_TRUE(rig.core->fault().block);
    EXPECT_EQ(rig.core->fault().block->line, 7u);
    EXPECT_TRUE(rig.sink.moves().empty());
}

TEST(CornerStage, TooLargeMayBeMadeSmaller) {
    CornerRig rig;
    ASSERT_TRUE(rig.corner(Shape::Rounding, 9, false, 0, true) && rig.line(0, -8) && rig.end());
    ASSERT_TRUE(rig.line(20, -8) && rig.end());
    const auto moves = rig.sink.moves();
    ASSERT_EQ(moves.size(), 2u);  // nothing is left of the first block
    EXPECT_NEAR(moves[0].move.radius, 8, 1e-5);
}

TEST(CornerStage, LineAndArc) {
    CornerRig rig;
    ASSERT_TRUE(rig.line(10, 0) && rig.end());
    ASSERT_TRUE(rig.corner(Shape::ChamferLeg, 2) && rig.line(10, -20) && rig.end());
    ASSERT_TRUE(rig.arc(20, -30, 10, -30, false) && rig.end());
    rig.expect_moves(
        {{10, 0}, {10, -18}, {10 + 10 * std::sin(0.2), -30 + 10 * std::cos(0.2)}, {20, -30}});
    EXPECT_NEAR(rig.sink.moves()[3].move.sweep, std::acos(0.0) - 0.2, 1e-9);
}

TEST(CornerStage, CompensationFollowsTheElement) {
    CornerRig rig;
    rig.core->path.tool.nose_radius = 1.0;
    rig.core->path.tool.geometry = 1;
    ASSERT_TRUE(rig.line(15, 5) && rig.end());
    ASSERT_TRUE(rig.core->compensation(CompSide::Right) && rig.line(10, 0) && rig.end());
    ASSERT_TRUE(rig.corner(Shape::Rounding, 3) && rig.line(10, -20) && rig.end());
    ASSERT_TRUE(rig.line(30, -20) && rig.end());
    ASSERT_TRUE(rig.core->compensation_off(0, 0) && rig.line(40, -10) && rig.end());
    // right of -Z at X10 is X11; the inner rounding of 3 becomes 2 about X13 Z-17
    rig.expect_moves({{15, 5}, {11, 0}, {11, -17}, {13, -19}, {30, -19}, {40, -10}});
    EXPECT_NEAR(rig.sink.moves()[3].move.radius, 2, 1e-9);
    EXPECT_FALSE(rig.core->reads_ahead());
}

TEST(CornerStage, CancelInTheBlockBehindTheCornerWaitsForIt) {
    CornerRig rig;
    rig.core->path.tool.nose_radius = 1.0;
    rig.core->path.tool.geometry = 1;
    ASSERT_TRUE(rig.core->compensation(CompSide::Left) && rig.line(0, -10) && rig.end());
    ASSERT_TRUE(rig.corner(Shape::ChamferLeg, 2) && rig.line(0, -30) && rig.end());
    ASSERT_TRUE(rig.line(20, -30) && rig.end());
    ASSERT_TRUE(rig.core->compensation_off(0, 0) && rig.line(30, -30) && rig.end());
    EXPECT_EQ(rig.sink.moves().back().move.machine[rig.x], 30);
    EXPECT_EQ(rig.sink.moves().back().move.machine[rig.z], -30);
}

TEST(CornerStage, AReservedMoveStandsBeforeWhatCameMeanwhile) {
    CornerRig rig;
    ASSERT_TRUE(rig.core->reserve_move());
    rig.core->aux('M', 8, "M8", false);
    ASSERT_TRUE(rig.end());
    EXPECT_TRUE(rig.core->move_reserved());
    bool made = false;
    rig.core->insert_reserved([&] { made = rig.corner(Shape::Rounding, 2) && rig.line(0, -20); });
    ASSERT_TRUE(made && rig.line(20, -20) && rig.end());
    std::string order;
    for (const Kept& call : rig.sink.calls) order += call.what;
    EXPECT_EQ(order, "mmam");
    EXPECT_FALSE(rig.core->reads_ahead());
}

// Without compensation too: what comes behind a program stop waits for it, and reading goes on
// behind it.
TEST(CornerStage, AStopBehindAHeldMoveHaltsTheReading) {
    CornerRig rig;
    ASSERT_TRUE(rig.corner(Shape::ChamferLeg, 1) && rig.line(0, -20) && rig.end());
    rig.core->sink().stop({StopReason::M00}, rig.core->at);
    ++rig.core->at.serial;
    ASSERT_TRUE(rig.core->end_compensated_block(true, true, false));
    EXPECT_FALSE(rig.core->halted());
    ASSERT_TRUE(rig.line(20, -20) && rig.end());
    EXPECT_TRUE(rig.core->reads_ahead() && rig.core->halted());
    rig.expect_moves({{0, -19}, {1, -20}});
    // the program has been read on: Core stands behind what follows the stop
    EXPECT_FALSE(rig.core->barrier_passed());
    rig.expect_moves({{0, -19}, {1, -20}, {20, -20}});
    ASSERT_TRUE(rig.line(30, -20) && rig.end());
    EXPECT_FALSE(rig.core->reads_ahead());
    EXPECT_EQ(rig.sink.moves().size(), 4u);
}

// The way out of compensation is read before the stop in front of it is reached: Core stands behind
// it then, not at the stop.
TEST(CornerStage, AStopBeforeTheWayOutLeavesCoreBehindTheWayOut) {
    CornerRig rig;
    rig.core->path.tool.nose_radius = 1.0;
    rig.core->path.tool.geometry = 1;
    ASSERT_TRUE(rig.core->compensation(CompSide::Left) && rig.line(0, -10) && rig.end());
    ASSERT_TRUE(rig.line(0, -30) && rig.end());
    rig.core->sink().stop({StopReason::M00}, rig.core->at);
    ++rig.core->at.serial;
    ASSERT_TRUE(rig.core->end_compensated_block(true, true, false));
    ASSERT_TRUE(rig.core->compensation_off(0, 0) && rig.line(30, -30) && rig.end());
    EXPECT_TRUE(rig.core->halted());
    EXPECT_FALSE(rig.core->barrier_passed());
    EXPECT_EQ(rig.sink.moves().back().move.machine[rig.x], 30);
}

// A move that waits for its element when another one is reserved goes on in front of it, joined to
// it.
TEST(CornerStage, AReservedMoveIsTheNextOneOfAHeldMove) {
    CornerRig rig;
    ASSERT_TRUE(rig.corner(Shape::ChamferLeg, 1) && rig.line(0, -20) && rig.end());
    rig.core->aux('M', 7, "M7", false);
    ASSERT_TRUE(rig.core->reserve_move());
    rig.core->aux('M', 8, "M8", false);
    ASSERT_TRUE(rig.end());
    bool made = false;
    rig.core->insert_reserved([&] { made = rig.line(20, -20); });
    ASSERT_TRUE(made && rig.end());
    rig.expect_moves({{0, -19}, {1, -20}, {20, -20}});
    std::string order;
    for (const Kept& call : rig.sink.calls) order += call.what;
    EXPECT_EQ(order, "mmama");
    EXPECT_FALSE(rig.core->reads_ahead());
}

TEST(CornerStage, ABarrierLetsAHeldMoveBeforeAReservedOneGo) {
    CornerRig rig;
    ASSERT_TRUE(rig.corner(Shape::ChamferLeg, 1) && rig.line(0, -20) && rig.end());
    ASSERT_TRUE(rig.core->reserve_move());
    rig.core->sink().barrier(rig.core->at);
    rig.expect_moves({{0, -20}});
}

TEST(CornerStage, ABarrierLetsTheHeldMoveGo) {
    CornerRig rig;
    ASSERT_TRUE(rig.corner(Shape::Rounding, 2) && rig.line(0, -20) && rig.end());
    EXPECT_TRUE(rig.core->holds_block());
    rig.core->sink().barrier(rig.core->at);
    EXPECT_TRUE(rig.core->halted());
    EXPECT_EQ(rig.sink.moves().size(), 1u);
    EXPECT_TRUE(rig.core->barrier_passed());
}

}  // namespace
}  // namespace polyturn::channels
