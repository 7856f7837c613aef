#include "tests/unit/kernel/rig.hpp"

namespace polyturn::kernel {
namespace {

TEST(Jog, StepsExactlyTheDistanceWithinTheLimits) {
    for (const double distance : {0.001, 0.01, 1.0, 60.0}) {
        SCOPED_TRACE(distance);
        TickRig rig([](params::Table& t, RunOptions&) { params::put(t, params::n0314_manual_rapid, 6000, 3); });
        double v = 0, a = 0, worst_v = 0, worst_a = 0, worst_j = 0, before = 0;
        rig.on_tick = [&] {
            const double now = rig.position(3), nv = (now - before) / 0.001, na = (nv - v) / 0.001;
            worst_v = std::max(worst_v, std::fabs(nv));
            worst_a = std::max(worst_a, std::fabs(na));
            worst_j = std::max(worst_j, std::fabs(na - a) / 0.001);
            before = now, v = nv, a = na;
        };
        rig.run(3);
        rig.command(CommandKind::Step, 0, -distance, 0, 3);
        rig.run_until_idle();
        EXPECT_NEAR(rig.position(3), -distance, 1e-12);
        EXPECT_LE(worst_v, 100 * 1.001);
        EXPECT_LE(worst_a, TickRig::kAcceleration * 1.01);
        EXPECT_LE(worst_j, TickRig::kJerk * 1.01);
    }
}

TEST(Jog, RunsForItsTimeAndStopsBeforeTheEndOfTheStroke) {
    TickRig rig([](params::Table& t, RunOptions&) {
        params::put(t, params::n1000_range_enable, 1, 1);
        params::put(t, params::n1002_range1a_positive, 12, 1);
        params::put(t, params::n1003_range1a_negative, -100, 1);
        params::put(t, params::n0315_jog_max_feed, 3000, 1);
    });
    rig.run(25);   // the PLC has set the jog feed
    rig.command(CommandKind::Jog, 0, 0.1, 0, 1);
    rig.run_until_idle();
    const double first = rig.position(1);
    EXPECT_GT(first, 1);
    EXPECT_LT(first, 12);
    rig.command(CommandKind::Jog, 0, 5, 0, 1);
    rig.run_until_idle();
    EXPECT_NEAR(rig.position(1), 12, 1e-9);
    EXPECT_FALSE(rig.alarmed(Alarm::StrokeLimit));
}

TEST(Jog, IsRefusedWhileAProgramRuns) {
    TickRig rig;
    rig.push(1, rig.line(1, {0, -20}, 50));
    rig.start(1);
    rig.run(20);
    rig.command(CommandKind::Step, 0, 5, 0, 1);
    rig.run_until_idle();
    EXPECT_EQ(rig.position(1), 0);
    EXPECT_TRUE(rig.alarmed(Alarm::NotReady, 1));
}

}  // namespace
}  // namespace polyturn::kernel
