// An inclined X slide by hand, worked out from fanuc_lathe 10.5: X at right angles by d is d /
// cos(a) of the slide and -d tan(a) of Z.
#include "tests/unit/kernel/rig.hpp"

namespace polyturn::kernel {
namespace {

using params::Table;
// 30 degrees
constexpr double kCosine = 0.86602540378443865, kSine = 0.5, kTangent = 0.57735026918962576;

struct Slant {
    explicit Slant(const std::function<void(Table&)>& more = {})
        : rig([&](Table& t, RunOptions& options) {
              params::put(t, params::n0100_axis_name1, 'X', 1);
              params::put(t, params::n0100_axis_name1, 'Z', 2);
              params::put(t, params::n0103_axis_to_plane, 1, 1);
              params::put(t, params::n0103_axis_to_plane, 3, 2);
              params::put(t, params::f8200, 1, 1);
              params::put(t, params::f8210, 30, 1);
              for (unsigned a = 1; a <= 2; ++a) {
                  params::put(t, params::n0314_manual_rapid, 6000, a);
                  params::put(t, params::n0315_jog_max_feed, 3000, a);
              }
              options.start_known[0] = options.start_known[1] = 1;
              options.start_position[0] = 40;
              options.start_position[1] = 7;
              if (more) more(t);
          }) {
        rig.run(25);
    }
    void step(unsigned axis, double by) { rig.command(CommandKind::Step, 0, by, 0, axis); }
    void jog(unsigned axis, double seconds) { rig.command(CommandKind::Jog, 0, seconds, 0, axis); }
    double x() const { return rig.position(1); }
    double z() const { return rig.position(2); }
    TickRig rig;
};

TEST(InclinedSlide, AStepOfXIsAtRightAnglesAndComesBackToWhereItWas) {
    Slant s;
    double v = 0, a = 0, worst_v = 0, worst_a = 0, before = s.z();
    s.rig.on_tick = [&] {
        // at every moment, not at the end only
        EXPECT_NEAR(s.z(), 7 - (s.x() - 40) * kSine, 1e-9);
        const double now = s.z(), nv = (now - before) / 0.001;
        a = (nv - v) / 0.001;
        v = nv;
        before = now;
        worst_v = std::max(worst_v, std::fabs(v));
        worst_a = std::max(worst_a, std::fabs(a));
    };
    s.step(1, 20);
    s.rig.run_until_idle();
    EXPECT_NEAR(s.x(), 40 + 20 / kCosine, 1e-9);
    EXPECT_NEAR(s.z(), 7 - 20 * kTangent, 1e-9);
    EXPECT_NEAR(worst_v, 100 * kTangent, 0.1);  // N0314 is the speed of X at right angles
    s.step(1, -20);
    s.rig.run_until_idle();
    EXPECT_NEAR(s.x(), 40, 1e-9);
    EXPECT_NEAR(s.z(), 7, 1e-9);
    s.rig.on_tick = {};
    s.step(2, 3);  // Z is Z
    s.rig.run_until_idle();
    EXPECT_NEAR(s.x(), 40, 1e-9);
    EXPECT_NEAR(s.z(), 10, 1e-9);
}

TEST(InclinedSlide, IsNoFasterThanTheAxisThatComesAlong) {
    Slant s([](Table& t) {
        params::put(t, params::n0304_rapid, 1200, 2);  // 20 mm/s, which X passes on at 40
        params::put(t, params::n0400_acceleration, 100, 2);
    });
    double before = s.z(), v = 0, worst_v = 0, worst_a = 0;
    s.rig.on_tick = [&] {
        const double now = s.z(), nv = (now - before) / 0.001;
        worst_v = std::max(worst_v, std::fabs(nv));
        worst_a = std::max(worst_a, std::fabs(nv - v) / 0.001);
        v = nv;
        before = now;
    };
    s.step(1, 30);
    s.rig.run_until_idle();
    EXPECT_NEAR(worst_v, 20, 0.01);
    EXPECT_LE(worst_a, 100 * 1.01);
}

TEST(InclinedSlide, NozagcMovesTheSlideAlone) {
    Slant s;
    s.rig.command(CommandKind::SetSignal, 0, 1, 0, signals::nozagc(1), 1);
    s.rig.run(25);
    s.step(1, 20);
    s.rig.run_until_idle();
    EXPECT_NEAR(s.x(), 40 + 20 / kCosine, 1e-9);
    EXPECT_NEAR(s.z(), 7, 1e-12);
}

TEST(InclinedSlide, StopsBeforeTheStrokeOfEitherAxis) {
    Slant s([](Table& t) {
        params::put(t, params::n1000_range_enable, 1, 2);
        params::put(t, params::n1002_range1a_positive, 100, 2);
        params::put(t, params::n1003_range1a_negative, 2, 2);
    });
    s.jog(1, 5);
    s.rig.run_until_idle();
    EXPECT_NEAR(s.z(), 2, 1e-6);
    EXPECT_NEAR(s.x(), 40 + 5 / kSine, 1e-6);
    EXPECT_FALSE(s.rig.alarmed(Alarm::StrokeLimit));
}

TEST(InclinedSlide, OnlyOneOfTheTwoIsMovedAtATime) {
    Slant s;
    s.jog(1, 0.5);
    s.rig.run(100);
    s.step(2, 5);
    s.rig.run(1);
    EXPECT_TRUE(s.rig.alarmed(Alarm::NotReady, 1));
    s.rig.run_until_idle();
    EXPECT_NEAR(s.z(), 7 - (s.x() - 40) * kSine, 1e-9);
    const double x = s.x();
    s.rig.log.clear();
    s.jog(2, 0.5);
    s.rig.run(100);
    s.step(1, 5);
    s.rig.run(1);
    EXPECT_TRUE(s.rig.alarmed(Alarm::NotReady, 1));
    s.rig.run_until_idle();
    EXPECT_NEAR(s.x(), x, 1e-9);
}

// Setup mode, door open: PT_SETUP_FEED is the most of each axis, not of X at right angles.
TEST(InclinedSlide, SetupModeHoldsForEachDrive) {
    Slant s([](Table& t) {
        params::put(t, params::f8210, 60, 1);
        for (unsigned a = 1; a <= 2; ++a) params::put(t, params::pt_setup_feed, 1200, a);
    });
    s.rig.command(CommandKind::SetSignal, 0, 1, 0, signals::cp_setup(1), 1);
    s.rig.run(25);
    double slide = 0, square = 0;
    s.rig.on_tick = [&] {
        slide = std::max(slide, std::fabs(s.rig.speed_of(1)));
        square = std::max(square, std::fabs(s.rig.speed_of(2)));
    };
    s.jog(1, 1);
    s.rig.run_until_idle();
    EXPECT_NEAR(slide, 20, 0.01);
    EXPECT_LE(square, 20 * 1.0001);
    s.step(1, -5);
    s.rig.run_until_idle();
    EXPECT_LE(slide, 20 * 1.0001);
}

// A key held while the feed switch is at 0: nothing moves, but Z is spoken for.
TEST(InclinedSlide, NobodyElseCommandsTheAxisThatComesAlong) {
    Slant s([](Table& t) {
        params::put(t, params::n0900_reference_type, 0x02, 2);
        params::put(t, params::n0303_ref_feed, 240, 2);
        params::put(t, params::n0904_zerodis, 10, 2);
    });
    s.rig.command(CommandKind::SetSignal, 0, 0, 0, signals::cp_jogfd(1), 1);
    s.rig.run(25);
    s.jog(1, 5);
    s.rig.run(50);
    EXPECT_EQ(s.rig.speed_of(1), 0);
    s.rig.command(CommandKind::Reference, 0, 1, 0, 2);
    s.rig.run(50);
    EXPECT_TRUE(s.rig.alarmed(Alarm::ReferenceRefused, 1));
    s.rig.command(CommandKind::SetSignal, 0, 20, 0, signals::cp_jogfd(1), 1);
    s.rig.run_until_idle();
    EXPECT_GT(s.x(), 41);
    EXPECT_NEAR(s.z(), 7 - (s.x() - 40) * kSine, 1e-9);
}

TEST(InclinedSlide, BothBrakeInAnEmergencyStop) {
    Slant s;
    s.jog(1, 5);
    s.rig.run(300);
    const double before = s.z(), v = s.rig.speed_of(2);
    EXPECT_LT(v, -20);
    double last = before, last_v = v, worst = 0;
    s.rig.on_tick = [&] {
        const double now = s.z(), nv = (now - last) / 0.001;
        worst = std::max(worst, std::fabs(nv - last_v) / 0.001);
        last = now;
        last_v = nv;
    };
    s.rig.command(CommandKind::EmergencyStop);
    s.rig.run(1000);
    EXPECT_EQ(s.rig.speed_of(1), 0);
    EXPECT_EQ(s.rig.speed_of(2), 0);
    EXPECT_LE(worst, s.rig.machine->core().config.axes[1].estop_deceleration * 1.01);
    EXPECT_LT(last, before);
}

TEST(InclinedSlide, AReferenceTakesZAlongUnlessAzrSaysNo) {
    for (const bool azr : {false, true}) {
        SCOPED_TRACE(azr);
        Slant s([azr](Table& t) {
            params::put(t, params::f8200, azr ? 5 : 1, 1);
            params::put(t, params::n0900_reference_type, 0x02, 1);  // by the zero pulse alone
            params::put(t, params::n0302_ref_rapid, 3000, 1);
            params::put(t, params::n0303_ref_feed, 240, 1);
            params::put(t, params::n0904_zerodis, 10, 1);
            params::put(t, params::n0906_reference_shift, -3, 1);
            params::put(t, params::n0200_reference_position1, 12, 1);
        });
        double driven = 0;  // of the slide: its numbers change on the way
        s.rig.on_tick = [&] { driven += s.rig.speed_of(1) * 0.001; };
        s.rig.command(CommandKind::Reference, 0, 1, 0, 1);
        s.rig.run_until_idle();
        ASSERT_TRUE(s.rig.machine->core().axes[0].referenced);
        EXPECT_NEAR(s.x(), 12, 1e-9);
        EXPECT_GT(std::fabs(driven), 1);
        EXPECT_NEAR(s.z(), azr ? 7 : 7 - driven * kSine, 1e-9);
    }
}

}  // namespace
}  // namespace polyturn::kernel
