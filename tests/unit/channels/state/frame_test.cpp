// Frames: the rule itself, and what Core makes of it.
#include <gtest/gtest.h>

#include "core_rig.hpp"
#include "tests/property.hpp"

namespace polyturn::channels {
namespace {

using testing::CoreRig;

double within(double low, double high) {
    return low + (high - low) * *rc::gen::inRange(0, 100'001) / 100'000.0;
}

Frame any_frame() {
    Frame f = Frame::translation({within(-50, 50), within(-50, 50), within(-50, 50)});
    f = f * Frame::rotation(static_cast<GeoAxis>(*rc::gen::inRange(0, 3)), within(-360, 360));
    f = f * Frame::scaling({within(0.2, 3), within(0.2, 3), within(0.2, 3)});
    return f * Frame::mirror(*rc::gen::arbitrary<bool>(), *rc::gen::arbitrary<bool>(),
                             *rc::gen::arbitrary<bool>());
}

PROPERTY(Frames, TheInverseTakesAnyPointBack, ()) {
    const Frame f = any_frame() * any_frame();
    RC_ASSERT(f.invertible());
    const Point3 p{within(-100, 100), within(-100, 100), within(-100, 100)};
    const Point3 back = f.inverse().map(f.map(p));
    for (std::size_t i = 0; i < 3; ++i) RC_ASSERT(std::fabs(back[i] - p[i]) < 1e-8);
}

PROPERTY(Frames, AChainIsOneFrame, ()) {
    const Frame a = any_frame(), b = any_frame();
    const Point3 p{within(-100, 100), within(-100, 100), within(-100, 100)};
    const Point3 one = (a * b).map(p), two = a.map(b.map(p));
    for (std::size_t i = 0; i < 3; ++i) RC_ASSERT(std::fabs(one[i] - two[i]) < 1e-8);
}

TEST(Frames, QuarterTurnsAreExactAndRightHanded) {
    EXPECT_EQ(Frame::rotation(GeoAxis::Z, 90).map({1, 0, 0}), (Point3{0, 1, 0}));
    EXPECT_EQ(Frame::rotation(GeoAxis::Y, 90).map({0, 0, 1}), (Point3{1, 0, 0}));
    EXPECT_EQ(Frame::rotation(GeoAxis::X, -270).map({0, 1, 0}), (Point3{0, 0, 1}));
    EXPECT_FALSE(Frame::scaling({1, 0, 1}).invertible());
    EXPECT_TRUE(Frame{}.is_identity());
}

// Two spindles: TRANS Z100, AMIRROR Z, ATRANS Z10 puts z at 100 - (10 + z).
TEST(CoreFrame, AMirroredSystemOfTheCounterSpindle) {
    CoreRig rig;
    rig.core->set_frame(Frame::translation({0, 0, 100}) * Frame::mirror(false, false, true) *
                        Frame::translation({0, 0, 10}));
    ASSERT_TRUE(rig.line(20, 5));
    EXPECT_NEAR(rig.core->path.machine[rig.z], 85, 1e-12);
    EXPECT_NEAR(rig.sink.moves().back().move.pos[rig.z], 85, 1e-12);
    EXPECT_NEAR(rig.core->path.programmed[rig.z], 5, 1e-12);
}

TEST(CoreFrame, AChangeMovesNothingAndRenumbersTheProgrammedPoint) {
    CoreRig rig;
    ASSERT_TRUE(rig.line(20, 5));
    const auto moves = rig.core->moves();
    rig.core->set_frame(Frame::translation({1, 0, 2}) * Frame::rotation(GeoAxis::Y, 90));
    EXPECT_EQ(rig.core->moves(), moves);
    EXPECT_EQ(rig.core->path.machine[rig.x], 20);
    // (x, z) - (1, 2) = (19, 3); turned back by 90 degrees about Y: x outside = z inside, z outside
    // = -x inside
    EXPECT_NEAR(rig.core->path.programmed[rig.z], 19, 1e-12);
    EXPECT_NEAR(rig.core->path.programmed[rig.x], -3, 1e-12);
    rig.core->set_frame({});
    EXPECT_EQ(rig.core->path.programmed[rig.z], 5);
}

TEST(CoreFrame, AnArcKeepsItsShapeAndTurnsItsSenseUnderAMirror) {
    CoreRig rig;
    ASSERT_TRUE(rig.line(40, 12));
    rig.core->set_frame(Frame::scaling({2, 2, 2}) * Frame::mirror(false, false, true));
    ASSERT_TRUE(rig.line(20, 6));  // outside: 40, -12
    // radius 5, ccw; outside radius 10 about 50, -12, cw
    ASSERT_TRUE(rig.arc(25, 1, 25, 6, false));
    const Move& m = rig.sink.moves().back().move;
    EXPECT_EQ(m.kind, MoveKind::ArcCw);
    EXPECT_NEAR(m.radius, 10, 1e-9);
    EXPECT_NEAR(m.machine[rig.x], 50, 1e-9);
    EXPECT_NEAR(m.machine[rig.z], -2, 1e-9);
    EXPECT_NEAR(m.pos_centre_q, 50, 1e-9);
    EXPECT_NEAR(m.pos_centre_p, -12, 1e-9);
}

TEST(CoreFrame, UnequalFactorsDoNotMakeAnArc) {
    CoreRig rig;
    ASSERT_TRUE(rig.line(20, 5));
    rig.core->set_frame(Frame::scaling({2, 1, 1}));
    EXPECT_FALSE(rig.arc(15, 10, 15, 5, true));
    EXPECT_EQ(rig.core->fault().alarm, Alarm::FrameArcDistorted);
}

TEST(CoreFrame, ARotationOutOfTheLathesPlaneNeedsY) {
    CoreRig rig;
    rig.core->set_frame(Frame::rotation(GeoAxis::Z, 30));
    EXPECT_FALSE(rig.line(20, 5));
    EXPECT_EQ(rig.core->fault().alarm, Alarm::FrameAxisMissing);
    CoreRig with(true);
    with.core->set_frame(Frame::rotation(GeoAxis::Z, 30));
    ASSERT_TRUE(with.line(20, 5));
    EXPECT_NEAR(with.core->path.machine[with.y], 10, 1e-9);
}

TEST(CoreFrame, AQuarterTurnPutsAnArcIntoAnotherPlane) {
    CoreRig rig(true);
    rig.core->path.plane = Plane::XY;
    rig.core->set_frame(Frame::rotation(GeoAxis::X, 90));  // y inside = z outside
    AxisValues t{};
    t[rig.x] = 10;
    ASSERT_TRUE(rig.core->linear(t));
    t[rig.x] = 0;
    t[rig.y] = 10;
    ArcCall call;
    call.clockwise = false;
    ASSERT_TRUE(rig.core->arc(t, call));
    const Move& m = rig.sink.moves().back().move;
    EXPECT_EQ(m.plane_p, rig.z);
    EXPECT_EQ(m.plane_q, rig.x);
    EXPECT_EQ(m.kind, MoveKind::ArcCw);  // from X to Z is against the sense of the plane Z X
    EXPECT_NEAR(m.machine[rig.z], 10, 1e-9);
    rig.core->set_frame(Frame::rotation(GeoAxis::X, 30));
    EXPECT_FALSE(rig.core->arc(t, call));
    EXPECT_EQ(rig.core->fault().alarm, Alarm::FrameArcInclined);
}

// I1 after any frame, zero, shift and move.
PROPERTY(CoreFrame, TheEquationHolds, ()) {
    CoreRig rig(true);
    Core& core = *rig.core;
    for (int n = 0; n < 20; ++n) {
        switch (*rc::gen::inRange(0, 4)) {
            case 0:
                core.set_frame(any_frame());
                break;
            case 1:
                core.local_zero(rig.z, within(-20, 20));
                break;
            case 2: {
                AxisValues shift{};
                shift[rig.x] = within(-20, 20);
                shift[rig.y] = within(-5, 5);
                core.set_shift(shift);
                break;
            }
            default: {
                AxisValues t{};
                for (const unsigned i : {rig.x, rig.y, rig.z}) t[i] = within(-50, 50);
                RC_ASSERT(core.linear(t));
                for (const unsigned i : {rig.x, rig.y, rig.z})
                    RC_ASSERT(std::fabs(core.path.programmed[i] - t[i]) < 1e-12);
            }
        }
        const AxisValues point = core.framed(core.path.programmed);
        for (const unsigned i : {rig.x, rig.y, rig.z})
            RC_ASSERT(std::fabs(core.path.machine[i] - point[i] - core.path.zero[i] -
                                core.path.shift[i] - core.path.vector[i]) < 1e-7);
    }
}

TEST(CoreFrame, AMirrorPutsTheNoseOnTheOtherSide) {
    CoreRig rig;
    rig.core->path.tool.nose_radius = 1.0;
    rig.core->path.tool.geometry = 1;
    rig.core->set_frame(Frame::mirror(true, false, false));
    ASSERT_TRUE(rig.line(20, 0));
    ASSERT_TRUE(rig.core->compensation(CompSide::Left));
    EXPECT_EQ(rig.core->at.comp, CompSide::Right);
    ASSERT_TRUE(rig.line(20, 10));
    ASSERT_TRUE(rig.core->end_compensated_block(true, false, false));
    ASSERT_TRUE(rig.line(20, 30));
    ASSERT_TRUE(rig.core->end_compensated_block(true, false, false));
    ASSERT_TRUE(rig.line(20, 40));
    ASSERT_TRUE(rig.core->end_compensated_block(true, false, false));
    // Outside the path runs at X-20 in +Z; left of it in the program is X21, so X-21 outside.
    EXPECT_NEAR(rig.sink.moves().back().move.machine[rig.x], -21, 1e-9);
}

}  // namespace
}  // namespace polyturn::channels
