// One test for each row of the table of interlocks: it alone acts as its row says, names itself,
// and nothing acts without it.
#include "kernel/protection/interlocks.hpp"

#include <map>

#include "tests/unit/kernel/rig.hpp"

namespace polyturn::kernel {
namespace {

void signal(TickRig& rig, std::uint32_t slot, int value) {
    rig.command(CommandKind::SetSignal, 0, value, 0, slot, 1);
}

// A long cut with S1 turning, and behind it the end of a part that would be repeated.
void cut(TickRig& rig) {
    rig.push(1, rig.spindle(1, 600));
    rig.push(1, rig.aux(1, 'M', 3));
    rig.push(1, rig.line(1, {0, -100}, 20));
    rig.push(1, rig.blank(1, RecordKind::Part));
    PathRecord barrier = rig.blank(1, RecordKind::Barrier);
    barrier.flags |= kDrains;
    rig.push(1, barrier);
    rig.push(1, rig.line(1, {0, 100}, 50));
    rig.start(1);
    rig.run(1000);
}

struct Break {
    std::function<void(TickRig&)> make;
    Alarm says;
};
const std::map<std::string_view, Break>& breaks() {
    const auto set = [](std::uint32_t slot) {
        return [slot](TickRig& rig) { signal(rig, slot, 1); };
    };
    static const std::map<std::string_view, Break> kBreaks{
        {"door", {set(signals::cp_dooropen(1)), Alarm::InterlockHold}},
        {"chuck", {set(signals::sp_unclamped(1)), Alarm::InterlockStop}},
        {"tailstock", {set(signals::cp_tailopen(1)), Alarm::InterlockStop}},
        {"tool", {set(signals::cp_turretopen(1)), Alarm::InterlockStop}},
        {"lubrication", {set(signals::cp_nolube(1)), Alarm::InterlockNote}},
        {"bar", {set(signals::cp_barend(1)), Alarm::InterlockNote}},
        {"store",
         {[](TickRig& rig) { rig.machine->core().store_dead = true; }, Alarm::InterlockNote}},
    };
    return kBreaks;
}

TEST(Interlocks, EachRowAloneActsAsItSaysAndNamesItself) {
    for (const Interlock& row : interlocks()) {
        SCOPED_TRACE(row.name);
        const auto fault = breaks().find(row.name);
        ASSERT_NE(fault, breaks().end()) << "a row without a test";
        TickRig rig;
        cut(rig);
        ASSERT_EQ(rig.state(1), ChannelState::Running);
        fault->second.make(rig);
        rig.run(20);
        EXPECT_TRUE(rig.alarmed(fault->second.says, 1));
        rig.run_until_idle();
        switch (row.act) {
            case Interlock::Act::Hold:
                EXPECT_EQ(rig.state(1), ChannelState::Held);
                break;
            case Interlock::Act::Stop:
                EXPECT_EQ(rig.state(1), ChannelState::Interrupted);
                break;
            case Interlock::Act::EndOfPart:
                EXPECT_EQ(rig.state(1), ChannelState::Ended);
                EXPECT_NEAR(rig.position(2), -100, 1e-9);
                break;
        }
        if (row.act != Interlock::Act::EndOfPart) { EXPECT_GT(rig.position(2), -100); }
    }
}

TEST(Interlocks, ADoorInSetupModeHoldsNothingButSpeedsAreLimited) {
    TickRig rig([](params::Table& t, RunOptions&) {
        params::put(t, params::pt_setup_feed, 600, 2);
        params::put(t, params::pt_setup_speed, 120, 1);
    });
    signal(rig, signals::cp_setup(1), 1);
    signal(rig, signals::cp_dooropen(1), 1);
    rig.run(2);
    rig.push(1, rig.spindle(1, 2000));
    rig.push(1, rig.aux(1, 'M', 3));
    rig.push(1, rig.line(1, {0, -20}, 0, kRapid));
    double fastest = 0;
    rig.on_tick = [&] { fastest = std::max(fastest, std::fabs(rig.speed_of(2))); };
    rig.start(1);
    rig.run_until_idle();
    EXPECT_NEAR(rig.position(2), -20, 1e-9);
    EXPECT_LE(fastest, 10 + 1e-6);
    EXPECT_LE(std::fabs(rig.machine->core().spindles[0].command()), 120 + 1e-6);
}

TEST(Interlocks, ASpindleDoesNotStartWithAnOpenChuckNorBehindAnOpenDoor) {
    for (const bool chuck : {true, false}) {
        TickRig rig;
        rig.push(1, rig.spindle(1, 600));
        rig.push(1, rig.dwell(1, 0.5));
        rig.push(1, rig.aux(1, 'M', 3));
        rig.push(1, rig.dwell(1, 2));
        rig.start(1);
        rig.run(100);
        signal(rig, chuck ? signals::sp_unclamped(1) : signals::cp_dooropen(1), 1);
        rig.run(20);
        rig.start(1);
        rig.run(2000);
        EXPECT_LT(std::fabs(rig.machine->core().spindles[0].speed()), 1e-6);
        if (chuck) { EXPECT_TRUE(rig.alarmed(Alarm::InterlockStop, 1)); }
    }
}

TEST(Interlocks, AChuckThatOpensStopsItsSpindleOnlyWhenTheAxesRest) {
    TickRig rig;
    cut(rig);
    signal(rig, signals::sp_unclamped(1), 1);
    bool cut_without = false;
    rig.on_tick = [&] {
        cut_without = cut_without || (std::fabs(rig.speed_of(2)) > 1 &&
                                      rig.machine->core().spindles[0].command() == 0);
    };
    rig.run_until_idle();
    EXPECT_FALSE(cut_without);
    EXPECT_EQ(rig.machine->core().spindles[0].command(), 0);
}

TEST(Interlocks, JogWithAnOpenDoorNeedsSetupMode) {
    TickRig rig;
    signal(rig, signals::cp_dooropen(1), 1);
    rig.command(CommandKind::Step, 0, 5, 0, 2);
    rig.run_until_idle();
    EXPECT_EQ(rig.position(2), 0);
    EXPECT_TRUE(rig.alarmed(Alarm::NotReady, 1));
    signal(rig, signals::cp_setup(1), 1);
    rig.command(CommandKind::Step, 0, 5, 0, 2);
    rig.run(3);
    rig.run_until_idle();
    EXPECT_NEAR(rig.position(2), 5, 1e-9);
}

}  // namespace
}  // namespace polyturn::kernel
