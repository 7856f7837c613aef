// Exchanged axes (nct part 2 22.4): where the borrowed drive goes, by the formulas of the
// specification.
#include <gtest/gtest.h>

#include <cmath>

#include "channels/forwarding_port.hpp"
#include "core_rig.hpp"

namespace polyturn::channels::testing {
namespace {

// X of L1 works with the drive of A3 (X of L2).
struct BorrowedX : CoreRig {
    explicit BorrowedX(int config, double drive_at, double zero = 0) {
        params::put(*view.parameters, params::n2105_composit_config, config, 1);
        // shown as a diameter
        view.store->zeros[static_cast<std::size_t>(kZeroG54Row) * kChannelAxes + x] = 2 * zero;
        core->load_zeros();
        std::array<std::uint8_t, kMaxAxes> route{};
        route[0] = 3;
        route[2] = 1;
        EXPECT_TRUE(take_routes(view, route));
        core->refresh_limits();
        core->take_machine(x, drive_at);
    }
};

TEST(Routes, TrueSideKeepsTheNumbers) {
    BorrowedX rig(0, -40);
    EXPECT_DOUBLE_EQ(rig.core->path.programmed[rig.x], -40);
    ASSERT_TRUE(rig.line(-15, 5));
    EXPECT_DOUBLE_EQ(rig.sink.moves().back().move.machine[rig.x], -15);
    EXPECT_EQ(rig.view.axes[rig.x].machine_axis, 2);
}

TEST(Routes, VirtualSideIsMirroredAboutTheWorkpieceZero) {
    // zero at machine 7: x_true = -x_prog
    BorrowedX rig(4, -40, 7);
    EXPECT_DOUBLE_EQ(rig.core->path.programmed[rig.x], 47);
    ASSERT_TRUE(rig.line(15, 0));
    EXPECT_DOUBLE_EQ(rig.sink.moves().back().move.machine_start[rig.x], -40);
    EXPECT_DOUBLE_EQ(rig.sink.moves().back().move.machine[rig.x], 7 - 15);
    EXPECT_DOUBLE_EQ(rig.sink.moves().back().move.pos[rig.x], 15);
}

TEST(Routes, OppositeDirectionsAreNegated) {
    BorrowedX rig(1, -40);
    EXPECT_DOUBLE_EQ(rig.core->path.programmed[rig.x], 40);
    ASSERT_TRUE(rig.line(15, 0));
    EXPECT_DOUBLE_EQ(rig.sink.moves().back().move.machine[rig.x], -15);
    // mirrored and opposite: as if nothing were
    BorrowedX both(5, -40);
    EXPECT_DOUBLE_EQ(both.core->path.programmed[both.x], -40);
}

TEST(Routes, AnArcTurnsRoundOnTheOtherSide) {
    BorrowedX rig(4, -12);
    ASSERT_TRUE(rig.line(12, -3));
    ASSERT_TRUE(rig.arc(20, -11, 12, -11, false));
    const Move arc = rig.sink.moves().back().move;
    EXPECT_EQ(arc.kind, MoveKind::ArcCcw);  // as programmed
    EXPECT_DOUBLE_EQ(arc.centre_q, -12);
    EXPECT_DOUBLE_EQ(arc.centre_p, -11);
    EXPECT_DOUBLE_EQ(arc.machine[rig.x], -20);
    // From the start, turned about the centre by the sweep, one comes to the end: p is Z, q is X.
    const double p = arc.machine_start[rig.z] - arc.centre_p,
                 q = arc.machine_start[rig.x] - arc.centre_q;
    EXPECT_NEAR(arc.centre_p + p * std::cos(arc.sweep) - q * std::sin(arc.sweep),
                arc.machine[rig.z], 1e-9);
    EXPECT_NEAR(arc.centre_q + p * std::sin(arc.sweep) + q * std::cos(arc.sweep),
                arc.machine[rig.x], 1e-9);
}

TEST(Routes, AnotherZeroMovesNothing) {
    BorrowedX rig(4, -40);
    rig.core->local_zero(rig.x, 10);
    // true side: -40 is 50 behind the zero at 10
    EXPECT_DOUBLE_EQ(rig.core->path.programmed[rig.x], 50);
    ASSERT_TRUE(rig.line(50, 1));
    EXPECT_DOUBLE_EQ(rig.sink.moves().back().move.machine[rig.x], -40);
}

TEST(Routes, LimitsAreThoseOfTheBorrowedDrive) {
    BorrowedX rig(4, -40);
    ChannelAxis& axis = rig.view.axes[rig.x];
    axis.stroke.range1 = true;
    axis.stroke.a = {-60, 0};
    rig.view.stroke.before_move = true;
    rig.core->refresh_limits();
    EXPECT_TRUE(rig.line(59, 0));
    EXPECT_FALSE(rig.line(61, 0));
    EXPECT_EQ(rig.core->fault().alarm, Alarm::StrokeExceeded);
}

// nct part 2 22.5: limits are checked on the machine position with what the master has added: here
// Z is 100 further on.
TEST(Superimposed, TheLimitCountsFromWhereTheMasterHasBroughtTheAxis) {
    struct Added final : ForwardingPort {
        Added(Port& next, unsigned axis) : ForwardingPort(next), axis_(axis) {}
        double axis_added(unsigned machine_axis) override {
            return machine_axis == axis_ ? 100.0 : 0.0;
        }
        unsigned axis_;
    };
    CoreRig rig;
    Added port(rig.port, rig.view.axes[rig.z].machine_axis);
    Core core(rig.view, rig.sink, port);
    core.start_at_machine({});
    core.path.feed = 100.0;
    ChannelAxis& axis = rig.view.axes[rig.z];
    axis.stroke.range1 = true;
    axis.stroke.a = {-60, 150};
    rig.view.stroke.before_move = true;
    core.refresh_limits();
    AxisValues target = core.path.programmed;
    target[rig.z] = -150;
    EXPECT_TRUE(core.linear(target));
    target[rig.z] = 51;
    EXPECT_FALSE(core.linear(target));
    EXPECT_EQ(core.fault().alarm, Alarm::StrokeExceeded);
    EXPECT_DOUBLE_EQ(core.fault().value0, 151);
}

TEST(Routes, GoingHomeEndsAllOfIt) {
    BorrowedX rig(4, -40);
    std::array<std::uint8_t, kMaxAxes> home{};
    EXPECT_TRUE(take_routes(rig.view, home));
    rig.core->refresh_limits();
    rig.core->take_machine(rig.x, 30);
    EXPECT_DOUBLE_EQ(rig.core->path.programmed[rig.x], 30);
    ASSERT_TRUE(rig.line(31, 0));
    EXPECT_DOUBLE_EQ(rig.sink.moves().back().move.machine[rig.x], 31);
    EXPECT_FALSE(take_routes(rig.view, home));
}

}  // namespace
}  // namespace polyturn::channels::testing
