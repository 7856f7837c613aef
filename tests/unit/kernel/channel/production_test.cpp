// Parts wanted, first part, warm-up, the rapid key, jog and measuring feeds.
#include "tests/unit/kernel/rig.hpp"

namespace polyturn::kernel {
namespace {

// One round of a program that repeats itself: a move, the part, the barrier at which M99 goes on.
void part(TickRig& rig, unsigned l = 1) {
    rig.push(l, rig.line(l, {0, -1}, 50));
    rig.push(l, rig.blank(l, RecordKind::Part));
    PathRecord barrier = rig.blank(l, RecordKind::Barrier);
    barrier.flags |= kDrains;
    rig.push(l, barrier);
}

TEST(Production, EndsWithThePartThatMakesTheWantedNumber) {
    TickRig rig([](params::Table& t, RunOptions&) {
        params::put(t, params::n2307_no_of_machined_parts, 3, 1);
        params::put(t, params::n2308_no_of_parts_reqrd, 5, 1);
    });
    for (int i = 0; i < 4; ++i) part(rig);
    rig.start(1);
    rig.run_until_idle();
    EXPECT_EQ(rig.state(1), ChannelState::Ended);
    EXPECT_NEAR(rig.position(2), -2, 1e-9);
    EXPECT_TRUE(rig.alarmed(Alarm::PartsDone, 1));
    EXPECT_EQ(rig.machine->core().signals.nc(signals::cn_parts(1)), 1);
}

TEST(Production, OnlyReportsTheWantedNumberWhenItIsToldSo) {
    TickRig rig([](params::Table& t, RunOptions&) {
        params::put(t, params::n2308_no_of_parts_reqrd, 1, 1);
        params::put(t, params::pt_parts_stop, 0, 1);
    });
    for (int i = 0; i < 3; ++i) part(rig);
    rig.start(1);
    rig.run_until_idle();
    EXPECT_NEAR(rig.position(2), -3, 1e-9);
    EXPECT_TRUE(rig.alarmed(Alarm::PartsDone, 1));
}

TEST(Production, AWarmUpEndsWithItsRoundWhenItsTimeIsOver) {
    TickRig rig;
    rig.command(CommandKind::WarmUp, 1, 1.0);
    for (int i = 0; i < 100; ++i) part(rig);
    rig.start(1);
    rig.run_until_idle();
    EXPECT_EQ(rig.state(1), ChannelState::Ended);
    EXPECT_TRUE(rig.alarmed(Alarm::WarmUpOver, 1));
    const double rounds = -rig.position(2);
    EXPECT_GT(rounds, 3);
    EXPECT_LT(rounds, 60);
    EXPECT_NEAR(rounds, std::round(rounds), 1e-9);
}

TEST(RapidKey, MultipliesTheFeedByN0313WhileItIsHeld) {
    TickRig rig(
        [](params::Table& t, RunOptions&) { params::put(t, params::n0313_feed_mult, 3, 1); });
    rig.push(1, rig.line(1, {0, -100}, 20));
    rig.start(1);
    rig.run(500);
    EXPECT_NEAR(std::fabs(rig.speed_of(2)), 20, 1e-6);
    rig.command(CommandKind::RapidKey, 1, 1);
    rig.run(500);
    EXPECT_NEAR(std::fabs(rig.speed_of(2)), 60, 1e-6);
    rig.command(CommandKind::RapidKey, 1, 0);
    rig.run(500);
    EXPECT_NEAR(std::fabs(rig.speed_of(2)), 20, 1e-6);
}

// 5.5: step 0 of the jog register is no motion; 13 is 500 mm/min.
TEST(JogFeed, OfTheRegisterIsThatOfItsTable) {
    struct Row {
        int step;
        double mm_min;
    };
    for (const auto& [step, mm_min] :
         {Row{0, 0}, Row{1, 2}, Row{8, 50}, Row{13, 500}, Row{15, 1260}, Row{16, 2000}}) {
        SCOPED_TRACE(step);
        TickRig rig;
        rig.command(CommandKind::SetSignal, 0, step, 0, signals::cp_jogfd(1), 1);
        rig.command(CommandKind::Jog, 0, 5, 0, 2);
        rig.run(1500);
        EXPECT_NEAR(rig.speed_of(2) * 60, mm_min, 1e-6);
    }
}

TEST(JogFeed, TowardsTheToolSetterIsN0319) {
    TickRig rig(
        [](params::Table& t, RunOptions&) { params::put(t, params::n0319_t_meas_feed, 120, 1); });
    rig.command(CommandKind::SetSignal, 0, 13, 0, signals::cp_jogfd(1), 1);
    rig.command(CommandKind::SetSignal, 0, 1, 0, signals::cp_tmeas(1), 1);
    rig.command(CommandKind::Jog, 0, 5, 0, 2);
    rig.run(1500);
    EXPECT_NEAR(rig.speed_of(2) * 60, 120, 1e-6);
}

}  // namespace
}  // namespace polyturn::kernel
