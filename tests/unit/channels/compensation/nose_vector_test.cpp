// Each move tells what compensation has added to its programmed end, for screens that show
// programmed positions (F3104 DAC).
#include <gtest/gtest.h>

#include <vector>

#include "channels/compensation/compensator.hpp"
#include "tests/unit/channels/quiet_sink.hpp"

namespace polyturn::channels::compensation {
namespace {

struct Recorder final : testing::QuietSink {
    std::vector<Move> moves;
    void move(const Move& m, const BlockContext&) override { moves.push_back(m); }
};

class NoseVector : public ::testing::Test {
protected:
    NoseVector() {
        Options options;
        options.entry = Entry::Direct;
        nose.open(out, 0, 1, options);
    }
    void to(double p, double q) {
        Move m;
        m.kind = MoveKind::Linear;
        m.machine_start = m.pos = here;
        here[0] = p;
        here[1] = q;
        m.machine = m.pos = here;
        m.moved = 3;
        send(m);
    }
    void third(double r) {
        Move m;
        m.kind = MoveKind::Linear;
        m.machine_start = here;
        here[2] = r;
        m.machine = m.pos = here;
        m.moved = 4;
        send(m);
    }
    void send(const Move& m) {
        nose.nose(1, tip, true);
        nose.move(m, {});
        nose.block_done(true);
    }
    Recorder out;
    Compensator nose;
    Vec tip;
    AxisValues here{-10, 5};  // where the tool stands
};

//                     (20,20)        left of the contour, radius 1:
//                        ^             way in    to (0,0) + (0,1)
//    in  ....            |             1st line  to the inner corner (20,0) + (-1,1)
//        (0,0)--------(20,0)           2nd line  to (20,20) + (-1,0), then to the programmed point
TEST_F(NoseVector, IsWhatStandsBetweenTheProgrammedEndAndTheNose) {
    nose.select(1);
    to(0, 0);
    to(20, 0);
    to(20, 20);
    third(5);
    nose.cancel();
    to(40, 40);
    ASSERT_EQ(out.moves.size(), 5u);
    const Vec wanted[] = {{0, 1}, {-1, 1}, {-1, 0}, {-1, 0}, {0, 0}};
    for (std::size_t i = 0; i < 5; ++i) {
        SCOPED_TRACE(i);
        EXPECT_NEAR(out.moves[i].nose[0], wanted[i].p, 1e-12);
        EXPECT_NEAR(out.moves[i].nose[1], wanted[i].q, 1e-12);
        EXPECT_EQ(out.moves[i].nose[2], 0);
    }
}

// Around an outer corner every piece tells its own: the corner itself is the programmed point of
// the pieces between.
TEST_F(NoseVector, OfAPieceAroundACornerCountsFromTheCorner) {
    nose.select(-1);  // right of the path: the corner at (20,0) is outer
    to(0, 0);
    to(20, 0);
    to(0, 10);  // turns by more than 90 degrees: both lines are lengthened by the radius
    nose.cancel();
    to(0, 40);
    ASSERT_EQ(out.moves.size(), 5u);
    EXPECT_NEAR(out.moves[1].nose[0], 1, 1e-12);  // 20 + 1, 0 - 1
    EXPECT_NEAR(out.moves[1].nose[1], -1, 1e-12);
    for (std::size_t i = 0; i < 5; ++i) {
        const Move& m = out.moves[i];
        const double p = m.machine[0] - m.nose[0], q = m.machine[1] - m.nose[1];
        SCOPED_TRACE(i);
        const Vec programmed[] = {{0, 0}, {20, 0}, {20, 0}, {0, 10}, {0, 40}};
        EXPECT_NEAR(p, programmed[i].p, 1e-12);
        EXPECT_NEAR(q, programmed[i].q, 1e-12);
    }
}

// With an imaginary tip the tip's way to the centre is a part of it (fanuc_lathe 2.1: programmed
// end + V + r*e).
TEST_F(NoseVector, ContainsTheWayFromTheCentreToTheTip) {
    tip = {-1, -1};  // tip 3, radius 1
    nose.select(-1);
    to(-5, 0);
    to(20, 0);
    nose.cancel();
    to(40, 40);
    ASSERT_EQ(out.moves.size(), 3u);
    EXPECT_NEAR(out.moves[0].nose[0], -1, 1e-12);
    EXPECT_NEAR(out.moves[0].nose[1], -2, 1e-12);  // right normal (0,-1) and the tip
}

}  // namespace
}  // namespace polyturn::channels::compensation
