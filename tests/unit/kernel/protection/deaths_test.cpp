// Processes that die or fall silent: axes come to rest on the path, and everybody is told why.
#include "tests/unit/kernel/rig.hpp"

namespace polyturn::kernel {
namespace {

TEST(Death, OfAChannelBrakesAlongItsPathAndTheOtherGoesOn) {
    TickRig rig;
    rig.push(1, rig.line(1, {50, -100}, 60));
    rig.push(2, rig.line(2, {50, -100}, 60));
    rig.push(2, rig.stop(2, StopReason::M30));
    rig.start(1);
    rig.start(2);
    rig.run(500);
    rig.command(CommandKind::ProcessDied, 0, 0, 0, static_cast<std::uint32_t>(kProcessChannel));
    const double before = rig.position(1);
    rig.run_until_idle();
    EXPECT_EQ(rig.state(1), ChannelState::Dead);
    EXPECT_TRUE(rig.alarmed(Alarm::ChannelDied, 1));
    EXPECT_NEAR(rig.position(2), -2 * rig.position(1), 1e-9);
    EXPECT_LT(rig.position(1) - before, 5.0);
    EXPECT_EQ(rig.state(2), ChannelState::Ended);
    EXPECT_NEAR(rig.position(3), 50, 1e-9);
}

TEST(Death, HoldsOrResetsThePartnersAsTheGroupSays) {
    for (const int policy : {1, 2}) {
        TickRig rig([&](params::Table& t, RunOptions&) {
            params::put(t, params::pt_partner_death, policy, 1);
        });
        rig.push(2, rig.line(2, {50, 0}, 20));
        rig.start(2);
        rig.run(300);
        rig.command(CommandKind::ProcessDied, 0, 0, 0, static_cast<std::uint32_t>(kProcessChannel));
        rig.run_until_idle();
        EXPECT_EQ(rig.state(2), policy == 1 ? ChannelState::Held : ChannelState::Reset);
    }
}

// The operator's switch of a spindle that goes on turning acts again: its program cannot put it on
// any more (PRGSSO, fagor part 2, 11.2.10).
TEST(Death, GivesTheOverrideOfATurningSpindleBackToTheOperator) {
    TickRig rig([](params::Table& t, RunOptions&) {
        params::put_text(t, params::pt_language, "fagor", 1);
    });
    PathRecord own = rig.blank(1, RecordKind::Flag);
    own.code = kFlagControl;
    own.value = kControlOwnSpindleOverride;
    rig.push(1, own);
    rig.push(1, rig.spindle(1, 1000));
    rig.push(1, rig.aux(1, 'M', 3));
    rig.push(1, rig.dwell(1, 100));
    rig.start(1);
    rig.run(1500);
    rig.machine->core().spindles[0].override_factor = 0.6;
    rig.run(1000);
    ASSERT_NEAR(rig.machine->core().spindles[0].command(), 1000, 1);
    rig.command(CommandKind::ProcessDied, 0, 0, 0, static_cast<std::uint32_t>(kProcessChannel));
    rig.run(1000);
    EXPECT_EQ(rig.state(1), ChannelState::Dead);
    EXPECT_NEAR(rig.machine->core().spindles[0].command(), 600, 1);
}

TEST(Death, RecordsBeyondTheHorizonDoNotExist) {
    TickRig rig([](params::Table& t, RunOptions&) { params::put(t, params::pt_horizon, 16); });
    for (int i = 0; i < 100; ++i) rig.push(1, rig.line(1, {0.001, 0}, 60));
    rig.start(1);
    rig.run(3);
    const double before = rig.position(1);
    rig.command(CommandKind::ProcessDied, 0, 0, 0, static_cast<std::uint32_t>(kProcessChannel));
    rig.run_until_idle();
    EXPECT_LE(rig.position(1), before + 0.017);
}

TEST(Death, SilenceOfAChannelIsItsDeathAfterTheTimeout) {
    TickRig rig(
        [](params::Table& t, RunOptions&) { params::put(t, params::pt_channel_timeout, 0.2); });
    rig.push(1, rig.line(1, {5, 0}, 60));
    rig.start(1);
    rig.run(10);
    rig.command(CommandKind::ProcessStopped, 0, 0, 0, static_cast<std::uint32_t>(kProcessChannel));
    rig.run(185);
    EXPECT_FALSE(rig.alarmed(Alarm::ChannelSilent));
    EXPECT_NEAR(rig.position(1), 5, 1e-9);  // what had been promised is still driven
    rig.run(60);
    EXPECT_TRUE(rig.alarmed(Alarm::ChannelSilent, 1));
    EXPECT_EQ(rig.state(1), ChannelState::Dead);
}

TEST(Death, OfThePlcStopsAxesAndSpindles) {
    TickRig rig;
    rig.push(1, rig.spindle(1, 1000));
    rig.push(1, rig.aux(1, 'M', 3));
    rig.push(1, rig.line(1, {0, -500}, 50));
    rig.start(1);
    rig.run(2500);
    EXPECT_NEAR(rig.machine->core().spindles[0].speed(), 1000, 5);
    rig.command(CommandKind::ProcessDied, 0, 0, 0, static_cast<std::uint32_t>(kProcessPlc));
    rig.run(200);
    EXPECT_TRUE(rig.alarmed(Alarm::PlcDied));
    EXPECT_EQ(rig.speed_of(2), 0);
    EXPECT_EQ(rig.state(1), ChannelState::Interrupted);
    rig.run(2000);
    EXPECT_NEAR(rig.machine->core().spindles[0].speed(), 0, 1);
}

TEST(Death, AnOverrunOfThePlcIsOne) {
    TickRig rig;
    rig.push(1, rig.line(1, {0, -100}, 20));
    rig.start(1);
    rig.run(25);
    rig.plc_answers = false;
    rig.run(100);
    EXPECT_TRUE(rig.alarmed(Alarm::PlcLate));
    EXPECT_EQ(rig.speed_of(2), 0);
    rig.command(CommandKind::Reset);
    rig.run(30);
    EXPECT_TRUE(rig.machine->core().all_stop);  // it still does not answer
    rig.plc_answers = true;
    rig.run(20);
    rig.command(CommandKind::Reset);
    rig.run(10);
    EXPECT_FALSE(rig.machine->core().all_stop);
}

}  // namespace
}  // namespace polyturn::kernel
