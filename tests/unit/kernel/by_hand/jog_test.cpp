#include "tests/unit/kernel/rig.hpp"

namespace polyturn::kernel {
namespace {

TEST(Jog, StepsExactlyTheDistanceWithinTheLimits) {
    for (const double distance : {0.001, 0.01, 1.0, 60.0}) {
        SCOPED_TRACE(distance);
        TickRig rig([](params::Table& t, RunOptions&) {
            params::put(t, params::n0314_manual_rapid, 6000, 3);
        });
        double v = 0, a = 0, worst_v = 0, worst_a = 0, worst_j = 0, before = 0;
        rig.on_tick = [&] {
            const double now = rig.position(3), nv = (now - before) / 0.001, na = (nv - v) / 0.001;
            worst_v = std::max(worst_v, std::fabs(nv));
            worst_a = std::max(worst_a, std::fabs(na));
            worst_j = std::max(worst_j, std::fabs(na - a) / 0.001);
            before = now;
            v = nv;
            a = na;
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
    rig.run(25);  // the PLC has set the jog feed
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

TEST(Jog, GoesOnWhileThePanelTellsThatTheKeyIsHeldAndStopsWhenItTellsNothing) {
    TickRig rig(
        [](params::Table& t, RunOptions&) { params::put(t, params::n0315_jog_max_feed, 3000, 1); });
    rig.run(25);
    // each for 0.3 s, told anew every 0.2 s: one motion without a stop between
    for (int told = 0; told < 5; ++told) {
        rig.command(CommandKind::Jog, 0, 0.3, 0, 1);
        const double before = rig.position(1);
        rig.run(200);
        EXPECT_GT(rig.position(1), before + 5) << told;
    }
    EXPECT_FALSE(rig.alarmed(Alarm::NotReady, 1)) << "to hold a key is nothing to complain of";
    rig.command(CommandKind::Jog, 0, -5.0, 0, 1);  // the other direction does not keep it
    const double last = rig.position(1);
    rig.run_until_idle();
    // what was left of the 0.3 s, and the way to brake
    EXPECT_LT(rig.position(1) - last, 50 * 0.1 + 5);
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

// The PLC's first outputs come some ticks after the start: a key pressed before waits for them, and
// says so when they never come.
TEST(Jog, WaitsForTheFeedThatThePlcSaysAndTellsWhenThereIsNone) {
    for (const bool comes : {true, false}) {
        TickRig rig;
        rig.plc_program = [comes](const PlcInputs& in, PlcOutputs& out) {
            TickRig::lathe(in, out);
            if (!comes) out.signal[signals::cp_jogfd(1)] = 0;
        };
        rig.command(CommandKind::Jog, 0, 0.3, 0, 1);
        rig.run(1000);
        EXPECT_EQ(rig.position(1) > 1, comes);
        EXPECT_EQ(rig.alarmed(Alarm::JogNoFeed, 1), !comes);
    }
}

TEST(Jog, FollowsTheFeedSwitchWhileTheKeyIsHeld) {
    TickRig rig;
    int step = 15;
    rig.plc_program = [&step](const PlcInputs& in, PlcOutputs& out) {
        TickRig::lathe(in, out);
        out.signal[signals::cp_jogfd(1)] = step;
    };
    rig.run(50);
    rig.command(CommandKind::Jog, 0, 2, 0, 1);
    rig.run(500);
    EXPECT_NEAR(rig.speed_of(1), 1260.0 / 60, 0.01);
    step = 10;
    rig.run(300);
    EXPECT_NEAR(rig.speed_of(1), 126.0 / 60, 0.01);
}

// An operator sets up a channel whose process has not come yet, or has died: the keys are the
// machine's.
TEST(Jog, TheRapidKeyActsWhereNoProcessOfTheChannelIsThere) {
    TickRig rig([](params::Table& t, RunOptions&) {
        params::put(t, params::n0000_machine_group, 1, 4);
        params::put(t, params::n0002_axis_assign, 4, 4);
        params::put(t, params::n0314_manual_rapid, 6000, 4);
        params::put(t, params::n0315_jog_max_feed, 600, 4);
    });
    rig.plc_program = [](const PlcInputs& in, PlcOutputs& out) {
        TickRig::lathe(in, out);
        out.signal[signals::cp_jogfd(4)] = 20;
    };
    rig.run(50);
    ASSERT_FALSE(rig.machine->channel(3).attached());
    rig.command(CommandKind::Jog, 0, 2, 0, 4);
    rig.run(300);
    EXPECT_NEAR(rig.speed_of(4), 10, 0.01);
    rig.command(CommandKind::RapidKey, 4, 1);
    rig.run(300);
    EXPECT_NEAR(rig.speed_of(4), 100, 0.01);
    rig.command(CommandKind::RapidKey, 4, 0);
    rig.run(300);
    EXPECT_NEAR(rig.speed_of(4), 10, 0.01);
}

TEST(Jog, TheAddressOfAnExchangedAxisMovesTheDriveItHas) {
    TickRig rig([](params::Table& t, RunOptions&) {
        params::put(t, params::n2104_composit_axis, 3, 1);
        params::put(t, params::n2105_composit_config, 1, 1);  // the two count against each other
        params::put(t, params::n2105_composit_config, 1, 3);
    });
    rig.run(50);
    rig.command(CommandKind::SetSignal, 0, 1, 0, signals::ap_mixr(1), 1);
    rig.run(100);
    ASSERT_EQ(rig.machine->core().signals.nc(signals::an_mixa(1)), 1);
    rig.command(CommandKind::Step, 0, 4, 0, 1);
    rig.run(500);
    EXPECT_NEAR(rig.position(3), -4, 1e-9);
    EXPECT_EQ(rig.position(1), 0);
}

TEST(Jog, AClickIsAnIncrementOfTheChannelAsOftenAsTheSwitchSays) {
    TickRig rig([](params::Table& t, RunOptions&) {
        params::put(t, params::n0105_increment_system, 1, 1);
    });
    rig.run(50);
    rig.command(CommandKind::Handwheel, 0, 3, 0, 1, 1);
    rig.run(300);
    EXPECT_NEAR(rig.position(1), 0.03, 1e-9);
    rig.command(CommandKind::SetSignal, 0, 10, 0, signals::cp_hwmul(1), 1);
    rig.command(CommandKind::Handwheel, 0, -1, 0, 1, 2);
    rig.run(300);
    EXPECT_NEAR(rig.position(1), -0.07, 1e-9);
}

}  // namespace
}  // namespace polyturn::kernel
