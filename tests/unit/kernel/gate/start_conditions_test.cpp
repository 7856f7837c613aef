// One test for each row of the table of start conditions: its fault alone refuses the start, and
// the text names it.
#include "kernel/gate/start_conditions.hpp"

#include <map>

#include "tests/unit/kernel/rig.hpp"

namespace polyturn::kernel {
namespace {

struct Fault {
    std::function<void(TickRig&, StartView&)> make;
    std::string_view says;
};

const std::map<std::string_view, Fault>& faults() {
    const auto signal = [](std::uint32_t slot) {
        return [slot](TickRig& rig, StartView&) { rig.machine->core().signals.force_plc(slot, 1); };
    };
    static const std::map<std::string_view, Fault> kFaults{
        {"process", {[](TickRig&, StartView& v) { v.process_there = false; }, "process"}},
        {"emergency_stop",
         {[](TickRig& rig, StartView&) { rig.machine->core().state = MachineState::EmergencyStop; },
          "emergency stop"}},
        {"machine_on",
         {[](TickRig& rig, StartView&) { rig.machine->core().state = MachineState::Off; },
          "not switched on"}},
        {"no_stop",
         {[](TickRig& rig, StartView&) { rig.machine->core().all_stop = true; },
          "stopped by an alarm"}},
        {"store",
         {[](TickRig& rig, StartView&) { rig.machine->core().store_dead = true; }, "store"}},
        {"store_whole",
         {[](TickRig& rig, StartView&) { rig.machine->core().store_unfit = true; }, "lost data"}},
        {"reset_over", {[](TickRig&, StartView& v) { v.resting = false; }, "reset"}},
        {"by_hand", {[](TickRig& rig, StartView&) { rig.machine->core().jogging = 1; }, "by hand"}},
        {"back_on_path", {[](TickRig&, StartView& v) { v.away = true; }, "press return"}},
        {"alarm", {[](TickRig&, StartView& v) { v.alarmed = true; }, "an alarm"}},
        {"mode", {[](TickRig&, StartView& v) { v.by_hand_mode = true; }, "mode"}},
        {"bar", {signal(signals::cp_barend(1)), "bar"}},
        {"tailstock", {signal(signals::cp_tailopen(1)), "tailstock"}},
        {"tool", {signal(signals::cp_turretopen(1)), "turret"}},
        {"door", {signal(signals::cp_dooropen(1)), "door"}},
        {"lubrication", {signal(signals::cp_nolube(1)), "lubrication"}},
        {"chuck", {signal(signals::sp_unclamped(1)), "S1 the chuck"}},
        {"attached",
         {[](TickRig& rig, StartView&) {
              rig.machine->core().axes[1].detached = true;
              rig.machine->core().config.axes[1].named = true;
          },
          "A2 detached"}},
        {"program",
         {[](TickRig&, StartView& v) { v.lacks_program = true; }, "no program is selected"}},
        {"block", {[](TickRig&, StartView& v) { v.lacks_block = true; }, "no block is entered"}},
        {"restart",
         {[](TickRig&, StartView& v) { v.others_search = true; },
          "not all channels of the restart"}},
        {"referenced",
         {[](TickRig& rig, StartView&) { rig.machine->core().axes[0].referenced = false; },
          "A1 not referenced"}},
    };
    return kFaults;
}

TEST(StartConditions, AMachineThatHasEverythingMayStart) {
    TickRig rig;
    EXPECT_EQ(missing_for_start(rig.machine->core(), {1}).view(), "");
}

TEST(StartConditions, EachRowAloneRefusesTheStartAndIsNamedWithItsRemedy) {
    for (std::size_t number = 0; number < start_conditions().size(); ++number) {
        const StartCondition& row = start_conditions()[number];
        SCOPED_TRACE(row.name);
        const auto fault = faults().find(row.name);
        ASSERT_NE(fault, faults().end()) << "a row without a test";
        TickRig rig;
        StartView view{1};
        fault->second.make(rig, view);
        const std::string text(missing_for_start(rig.machine->core(), view).view());
        EXPECT_NE(text.find(fault->second.says), std::string::npos) << text;
        EXPECT_NE(text.find(kStartWords[number].remedy), std::string::npos) << text;
        EXPECT_EQ(rows_missing_for_start(rig.machine->core(), view), 1u << number);
    }
}

TEST(StartConditions, ARefusedStartListsEverythingThatIsMissing) {
    TickRig rig;
    rig.machine->core().axes[0].referenced = false;
    rig.command(CommandKind::SetSignal, 0, 1, 0, signals::cp_dooropen(1), 1);
    rig.start(1);
    rig.run(2);
    const KernelEvent* alarm = rig.find(KernelEventKind::Alarm, 1);
    ASSERT_NE(alarm, nullptr);
    const std::string text = alarm->text.data();
    EXPECT_NE(text.find("door"), std::string::npos) << text;
    EXPECT_NE(text.find("A1 not referenced"), std::string::npos) << text;
    EXPECT_EQ(rig.state(1), ChannelState::Reset);
    EXPECT_FALSE(rig.alarmed(Alarm::NotReady, 2));
}

TEST(StartConditions, ADoorThatOpensHoldsTheProgram) {
    TickRig rig;
    rig.push(1, rig.line(1, {50, 0}, 50));
    rig.start(1);
    rig.run(100);
    rig.command(CommandKind::SetSignal, 0, 1, 0, signals::cp_dooropen(1), 1);
    rig.run_until_idle();
    EXPECT_EQ(rig.state(1), ChannelState::Held);
    rig.start(1);
    rig.run(20);
    EXPECT_EQ(rig.state(1), ChannelState::Held);
    rig.command(CommandKind::ReleaseSignal, 0, 0, 0, signals::cp_dooropen(1), 1);
    rig.run(2);
    rig.start(1);
    rig.run_until_idle();
    EXPECT_NEAR(rig.position(1), 50, 1e-9);
}

// Nothing that could only be interrupted begins, whoever presses the key.
TEST(StartConditions, AChannelWithoutAProgramDoesNotBeginAndSaysWhatToDo) {
    TickRig rig;
    rig.command(CommandKind::Select, 1, 0, 0, 0, 0, "");  // what was selected is no more
    rig.start(1);
    rig.run(3);
    EXPECT_EQ(rig.state(1), ChannelState::Reset);
    const KernelEvent* alarm = rig.find(KernelEventKind::Alarm, 1);
    ASSERT_NE(alarm, nullptr);
    EXPECT_EQ(alarm->code, static_cast<int>(Alarm::NotReady));
    EXPECT_NE(std::string(alarm->text.data()).find("no program is selected (select one"),
              std::string::npos)
        << alarm->text.data();
    rig.command(CommandKind::Restart, 1, 120, 0, 0, 1);
    rig.run(3);
    EXPECT_EQ(rig.state(1), ChannelState::Reset) << "nor does it restart";
    rig.command(CommandKind::Select, 1, 0, 0, 0, 0, "O1.nc");
    rig.start(1);
    rig.run(3);
    EXPECT_EQ(rig.state(1), ChannelState::Running);
}

// All that can and should begin, in one tick; who has nothing to begin was not meant.
TEST(StartConditions, AStartOfAllPassesOverChannelsWithoutAProgram) {
    TickRig rig;
    rig.command(CommandKind::Select, 1, 0, 0, 0, 0, "O1.nc");
    rig.command(CommandKind::Select, 3, 0, 0, 0, 0, "O3.nc");
    rig.command(CommandKind::Select, 2, 0, 0, 0, 0, "");
    rig.start(0);
    rig.run(3);
    EXPECT_EQ(rig.state(1), ChannelState::Running);
    EXPECT_EQ(rig.state(2), ChannelState::Reset);
    EXPECT_EQ(rig.state(3), ChannelState::Running);
    EXPECT_EQ(rig.find(KernelEventKind::Alarm, 2), nullptr) << "passed over";
    ASSERT_NE(rig.find(KernelEventKind::CycleStarted, 3), nullptr);
    EXPECT_EQ(rig.find(KernelEventKind::CycleStarted, 1)->tick,
              rig.find(KernelEventKind::CycleStarted, 3)->tick);
}

TEST(StartConditions, AStartOfAllTellsWhatItLacksWhereAProgramIsSelected) {
    TickRig rig;
    rig.command(CommandKind::Select, 1, 0, 0, 0, 0, "O1.nc");
    rig.command(CommandKind::Select, 2, 0, 0, 0, 0, "O2.nc");
    rig.command(CommandKind::SetSignal, 0, 1, 0, signals::cp_dooropen(2), 1);
    rig.start(0);
    rig.run(3);
    EXPECT_EQ(rig.state(1), ChannelState::Running);
    EXPECT_EQ(rig.state(2), ChannelState::Reset);
    EXPECT_TRUE(rig.alarmed(Alarm::NotReady, 2));
}

TEST(StartConditions, WhereNothingCouldBeginThatIsSaidOnce) {
    TickRig rig;
    for (unsigned l = 1; l <= 3; ++l) rig.command(CommandKind::Select, l, 0, 0, 0, 0, "");
    rig.start(0);
    rig.run(3);
    int told = 0;
    for (const KernelEvent& e : rig.log)
        told += e.kind == static_cast<std::uint32_t>(KernelEventKind::Alarm);
    EXPECT_EQ(told, 1);
}

// Of the channel that it concerns, which shows it, and in the words of its mode.
TEST(StartConditions, WhereNothingCouldBeginItsChannelAndWhatItLacksAreNamed) {
    for (const bool by_hand : {false, true}) {
        TickRig rig([](params::Table& t, RunOptions&) {
            params::put(t, params::n0000_machine_group, 2, 2);
        });
        for (unsigned l = 1; l <= 3; ++l) rig.command(CommandKind::Select, l, 0, 0, 0, 0, "");
        if (by_hand) rig.command(CommandKind::Mode, 3, static_cast<double>(ChannelMode::Mdi));
        rig.command(CommandKind::CycleStart, 0, 1, 0, 1);  // the first group: L1 and L3
        rig.run(3);
        const KernelEvent* alarm = rig.find(KernelEventKind::Alarm);
        ASSERT_NE(alarm, nullptr);
        EXPECT_EQ(alarm->channel, by_hand ? 3u : 1u) << "who has chosen MDI, or the first";
        EXPECT_NE(std::string(alarm->text.data())
                      .find(by_hand ? "no block is entered" : "no program is selected"),
                  std::string::npos)
            << alarm->text.data();
    }
}

// N0000: a machine group is a machine of its own.
TEST(StartConditions, AGroupIsStartedWithoutTheOthers) {
    TickRig rig(
        [](params::Table& t, RunOptions&) { params::put(t, params::n0000_machine_group, 2, 2); });
    for (unsigned l = 1; l <= 3; ++l) rig.command(CommandKind::Select, l, 0, 0, 0, 0, "O1.nc");
    rig.command(CommandKind::CycleStart, 0, 1, 0, 2);
    rig.run(3);
    EXPECT_EQ(rig.state(1), ChannelState::Reset);
    EXPECT_EQ(rig.state(2), ChannelState::Running);
    EXPECT_EQ(rig.state(3), ChannelState::Reset);
}

// A successor has not been told what its predecessor was to do.
TEST(StartConditions, ASuccessorOfADeadProcessHasNoProgram) {
    TickRig rig;
    rig.command(CommandKind::Select, 3, 0, 0, 0, 0, "O3.nc");
    rig.run(2);
    rig.command(CommandKind::ProcessDied, 0, 1, 0, static_cast<std::uint32_t>(kProcessChannel + 2));
    rig.run(5);
    rig.channel[2] = std::make_unique<ChannelSegment>();
    rig.machine->attach_channel(2, *rig.channel[2]);
    rig.start(3);
    rig.run(3);
    EXPECT_EQ(rig.state(3), ChannelState::Reset);
}

TEST(JogInHold, GoesBackTheSameWayAndTheProgramEndsWhereItWould) {
    TickRig rig;
    rig.push(1, rig.line(1, {50, 0}, 50));
    rig.start(1);
    rig.run(300);
    rig.command(CommandKind::FeedHold, 1);
    rig.run(100);
    const double held = rig.position(1);
    rig.command(CommandKind::Step, 0, 5, 0, 1);
    rig.run(500);
    EXPECT_EQ(rig.position(1), held);  // not without jog_in_hold
    rig.command(CommandKind::JogInHold, 1);
    rig.command(CommandKind::Step, 0, 5, 0, 1);
    rig.run(500);
    EXPECT_NEAR(rig.position(1), held + 5, 1e-9);
    rig.command(CommandKind::Step, 0, 7, 0, 2);
    rig.run(500);
    rig.start(1);
    rig.run(5);
    EXPECT_EQ(rig.state(1), ChannelState::Held);  // first back
    std::vector<std::pair<double, double>> way;
    rig.command(CommandKind::Return, 1);
    rig.on_tick = [&] { way.push_back({rig.position(1), rig.position(2)}); };
    rig.run(1000);
    // Z first, as it came last
    for (const auto& [x, z] : way) EXPECT_TRUE(z < 1e-9 || x > held + 5 - 1e-9);
    EXPECT_NEAR(rig.position(1), held, 1e-9);
    EXPECT_NEAR(rig.position(2), 0, 1e-9);
    rig.start(1);
    rig.run_until_idle();
    EXPECT_NEAR(rig.position(1), 50, 1e-9);
}

TEST(JogInHold, IsNotBackBeforeItIsThereThoughAnotherChannelIsReset) {
    TickRig rig;
    rig.push(1, rig.line(1, {50, 0}, 50));
    rig.start(1);
    rig.run(300);
    rig.command(CommandKind::FeedHold, 1);
    rig.run(100);
    rig.command(CommandKind::JogInHold, 1);
    rig.command(CommandKind::Step, 0, 20, 0, 1);
    rig.run(1500);
    double longest = 0, before = rig.position(1);
    rig.on_tick = [&] {
        longest = std::max(longest, std::fabs(rig.position(1) - before));
        before = rig.position(1);
    };
    rig.command(CommandKind::Return, 1);
    rig.run(60);
    rig.command(CommandKind::Reset, 2);  // stops all that is moved by hand
    rig.run(1500);
    rig.start(1);
    rig.run_until_idle();
    EXPECT_NEAR(rig.position(1), 50, 1e-9);
    EXPECT_LE(longest, TickRig::kVelocity * 0.001 * 1.01) << "it jumped onto the path";
}

TEST(Handwheel, IsReversedAndCollectsOrLosesPulsesAsN2400Says) {
    TickRig rig([](params::Table& t, RunOptions&) {
        params::put(t, params::n2400_handle_direction, 0x02, 1);  // wheel 2 reversed
        // wheel 1 loses pulses while the axis moves
        params::put(t, params::n2400_handle_direction, 0x10, 2);
    });
    rig.command(CommandKind::Handwheel, 0, 1000, 0, 1, 2);
    rig.command(CommandKind::Handwheel, 0, 1000, 0, 1, 2);
    rig.command(CommandKind::Handwheel, 0, 1000, 0, 2, 1);
    rig.command(CommandKind::Handwheel, 0, 1000, 0, 2, 1);
    rig.run(3);
    rig.run_until_idle();
    EXPECT_NEAR(rig.position(1), -2, 1e-9);
    EXPECT_NEAR(rig.position(2), 1, 1e-9);
}

// nct_parameters_part2 25: HnM 0, the axis goes on until all pulses are used up; 1, it stops at
// once when the wheel stops.
TEST(Handwheel, StopsWithTheWheelWhereN2400SaysSo) {
    TickRig rig([](params::Table& t, RunOptions&) {
        params::put(t, params::n2400_handle_direction, 0x10, 2);
    });
    rig.command(CommandKind::Handwheel, 0, 100'000, 0, 1, 1);
    rig.command(CommandKind::Handwheel, 0, 100'000, 0, 2, 1);
    rig.run(3);
    rig.run_until_idle();
    EXPECT_NEAR(rig.position(1), 100, 1e-9);
    EXPECT_GT(rig.position(2), 1);
    EXPECT_LT(rig.position(2), 20)
        << "what it could drive while the wheel turned, and its way to brake";
    // Turned on and on, the axis does not stop between the pulses; none is kept for later, and none
    // is driven twice.
    const double from = rig.position(2);
    double slowest = 1e9;
    for (int n = 0; n < 50; ++n) {
        rig.command(CommandKind::Handwheel, 0, -500, 0, 2, 1);
        rig.run(20);
        if (n > 10) slowest = std::min(slowest, std::fabs(rig.speed_of(2)));
    }
    EXPECT_GT(slowest, 5);
    const double turned = rig.position(2);
    EXPECT_LT(turned, from - 10);  // never faster than it can stop within the last pulses
    EXPECT_GE(turned, from - 25 - 1e-9);
    rig.run_until_idle();
    EXPECT_GE(rig.position(2), turned - 1) << "not further than the last pulses say";
    // The wheel is turned back while the axis moves: that is no way to go on.
    rig.command(CommandKind::Handwheel, 0, 100'000, 0, 2, 1);
    rig.run(60);
    const double back = rig.position(2);
    rig.command(CommandKind::Handwheel, 0, -10, 0, 2, 1);
    rig.run_until_idle();
    EXPECT_LT(rig.position(2) - back, 10);
    EXPECT_EQ(rig.speed_of(2), 0.0);
}

TEST(Jog, IsNoFasterThanN0302BeforeTheAxisIsReferencedAndReferencesInItsMode) {
    TickRig rig([](params::Table& t, RunOptions& options) {
        params::put(t, params::n0302_ref_rapid, 600, 1);
        params::put(t, params::n0900_reference_type, 0x10, 1);
        options.ready = 0;
    });
    rig.command(CommandKind::MachineOn);
    rig.command(CommandKind::Step, 0, 30, 0, 1);
    rig.run(1000);
    EXPECT_NEAR(rig.speed_of(1), 10, 1e-9);
    rig.run_until_idle();
    rig.command(CommandKind::Mode, 1, static_cast<double>(ChannelMode::Reference));
    rig.command(CommandKind::Jog, 0, 1, 0, 1);
    rig.run_until_idle();
    EXPECT_TRUE(rig.machine->core().axes[0].referenced);
}

}  // namespace
}  // namespace polyturn::kernel
