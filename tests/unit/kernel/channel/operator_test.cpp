// What the operator asks for: hold, reset, overrides, single block, programmed stops, emergency
// stop.
#include "ipc/image/interrupt_inputs.hpp"
#include "ipc/image/program_start.hpp"
#include "tests/unit/kernel/rig.hpp"

namespace polyturn::kernel {
namespace {

TEST(Operator, HoldsAlongThePathAndGoesOn) {
    TickRig rig;
    rig.push(1, rig.line(1, {30, -60}, 50));
    rig.push(1, rig.stop(1, StopReason::M30));
    rig.start(1);
    rig.run(500);
    rig.command(CommandKind::FeedHold, 1);
    rig.run(200);
    EXPECT_EQ(rig.state(1), ChannelState::Held);
    EXPECT_EQ(rig.speed_of(2), 0);
    EXPECT_NEAR(rig.position(2), -2 * rig.position(1), 1e-9);
    const double held = rig.position(1);
    rig.run(100);
    EXPECT_EQ(rig.position(1), held);
    rig.start(1);
    rig.run_until_idle();
    EXPECT_EQ(rig.state(1), ChannelState::Ended);
    EXPECT_NEAR(rig.position(1), 30, 1e-9);
}

// #3004: the button is remembered and acts where the program allows it again; a door or a dead
// partner holds at once.
TEST(Operator, AProgramMayPutFeedHoldOff) {
    TickRig rig;
    const auto flag = [&](double value) {
        PathRecord r = rig.blank(1, RecordKind::Flag);
        r.code = kFlagControl;
        r.value = value;
        return r;
    };
    rig.push(1, flag(kControlNoHold));
    rig.push(1, rig.line(1, {10, 0}, 50));
    rig.push(1, flag(0));
    rig.push(1, rig.line(1, {10, 0}, 50));
    rig.push(1, rig.stop(1, StopReason::M30));
    rig.start(1);
    rig.run(50);
    rig.command(CommandKind::FeedHold, 1);
    rig.run_until_idle();
    EXPECT_EQ(rig.state(1), ChannelState::Held);
    EXPECT_GE(rig.position(1), 10 - 1e-9);
    EXPECT_LT(rig.position(1), 19);
    rig.start(1);
    rig.run_until_idle();
    EXPECT_EQ(rig.state(1), ChannelState::Ended);
}

// #3003: single block does not stop behind these blocks.
TEST(Operator, AProgramMayPutSingleBlockOff) {
    TickRig rig;
    const auto flag = [&](double value) {
        PathRecord r = rig.blank(1, RecordKind::Flag);
        r.code = kFlagControl;
        r.value = value;
        return r;
    };
    rig.command(CommandKind::SingleBlock, 1, 1);
    rig.push(1, flag(kControlNoSingleBlock));
    rig.push(1, rig.line(1, {5, 0}, 50));
    rig.push(1, rig.line(1, {5, 0}, 50));
    rig.push(1, flag(0));
    rig.push(1, rig.line(1, {5, 0}, 50));
    rig.push(1, rig.line(1, {5, 0}, 50));
    rig.push(1, rig.stop(1, StopReason::M30));
    rig.start(1);
    rig.run_until_idle();
    EXPECT_NEAR(rig.position(1), 15, 1e-9);
    EXPECT_EQ(rig.state(1), ChannelState::ProgramStop);
}

TEST(Operator, ResetsToAnEmptyPathAndANewEpoch) {
    TickRig rig;
    rig.push(1, rig.line(1, {30, -60}, 50));
    rig.push(1, rig.line(1, {30, -60}, 50));
    rig.start(1);
    rig.run(300);
    rig.command(CommandKind::Reset, 1);
    // the channel had not heard of it yet: belongs to the old epoch
    rig.push(1, rig.line(1, {1, 1}, 50));
    rig.run(200);
    EXPECT_EQ(rig.state(1), ChannelState::Reset);
    ASSERT_FALSE(rig.heard[0].empty());
    EXPECT_EQ(rig.heard[0].back().kind, static_cast<std::uint32_t>(ChannelEventKind::Reset));
    EXPECT_EQ(rig.channel[0]->epoch.load(), 1u);
    const double x = rig.position(1), z = rig.position(2);
    EXPECT_GT(x, 0);
    EXPECT_NEAR(z, -2 * x, 1e-9);
    rig.push(1, rig.line(1, {-x, -z}, 50));
    rig.push(1, rig.stop(1, StopReason::M30));
    rig.start(1);
    rig.run_until_idle();
    EXPECT_NEAR(rig.position(1), 0, 1e-9);
    EXPECT_EQ(rig.state(1), ChannelState::Ended);
}

// A computer that is late hands over in one tick what was pressed one after the other.
TEST(Operator, AStartBehindAResetOfTheSameTickCounts) {
    TickRig rig;
    rig.command(CommandKind::Reset, 1);
    rig.start(1);
    rig.run(1);
    EXPECT_FALSE(rig.alarmed(Alarm::NotReady));
    EXPECT_EQ(rig.state(1), ChannelState::Running);
}

TEST(Operator, AStartBehindAResetThatHasToBrakeIsRefused) {
    TickRig rig;
    rig.push(1, rig.line(1, {30, -60}, 50));
    rig.start(1);
    rig.run(200);
    rig.command(CommandKind::FeedHold, 1);
    rig.run(2);
    rig.command(CommandKind::Reset, 1);
    rig.run(1);
    ASSERT_LT(rig.speed_of(2), 0);
    rig.start(1);
    rig.run(300);
    EXPECT_EQ(rig.state(1), ChannelState::Reset);
}

TEST(Operator, StopsAfterEachBlockInSingleBlock) {
    TickRig rig;
    rig.command(CommandKind::SingleBlock, 1, 1);
    rig.push(1, rig.line(1, {5, 0}, 50));
    rig.push(1, rig.line(1, {5, 0}, 50));
    rig.push(1, rig.dwell(1, 0.1));
    rig.push(1, rig.stop(1, StopReason::M30));
    rig.start(1);
    rig.run_until_idle();
    EXPECT_NEAR(rig.position(1), 5, 1e-9);
    EXPECT_EQ(rig.state(1), ChannelState::ProgramStop);
    rig.start(1);
    rig.run_until_idle();
    EXPECT_NEAR(rig.position(1), 10, 1e-9);
    EXPECT_EQ(rig.state(1), ChannelState::ProgramStop);
    rig.start(1);
    rig.run_until_idle();
    EXPECT_EQ(rig.state(1), ChannelState::ProgramStop);  // behind the dwell
    rig.start(1);
    rig.run_until_idle();
    EXPECT_EQ(rig.state(1), ChannelState::Ended);
}

// G4 P0.1 G1 W5. M8: one block; then two moves of a cycle; then a macro statement, which is no
// block of its own.
TEST(Operator, StopsOnceABlockInSingleBlockWhateverItHolds) {
    TickRig rig;
    const auto of = [](PathRecord r, std::uint64_t serial, std::uint32_t more = 0) {
        r.serial = serial;
        r.flags |= more;
        return r;
    };
    rig.command(CommandKind::SingleBlock, 1, 1);
    rig.push(1, of(rig.dwell(1, 0.1), 1));
    rig.push(1, of(rig.line(1, {5, 0}, 50), 1));
    rig.push(1, of(rig.aux(1, 'M', 8), 1));
    rig.push(1, of(rig.line(1, {5, 0}, 50), 2));
    rig.push(1, of(rig.line(1, {5, 0}, 50), 2));
    rig.push(1, of(rig.dwell(1, 0.1), 3, kMoreBehind));
    rig.push(1, of(rig.line(1, {5, 0}, 50), 4));
    rig.push(1, of(rig.stop(1, StopReason::M30), 5));
    for (const double place : {5.0, 10.0, 15.0, 20.0}) {
        rig.start(1);
        rig.run_until_idle();
        EXPECT_NEAR(rig.position(1), place, 1e-9);
        EXPECT_EQ(rig.state(1), ChannelState::ProgramStop);
    }
    rig.start(1);
    rig.run_until_idle();
    EXPECT_EQ(rig.state(1), ChannelState::Ended);
}

TEST(Operator, SingleBlockTakenBackAndPressedAgainStandsAtTheBlockThatRunsThen) {
    TickRig rig;
    for (int n = 0; n < 3; ++n) rig.push(1, rig.line(1, {5, 0}, 50));
    rig.push(1, rig.stop(1, StopReason::M30));
    const auto until = [&](double place) {
        while (rig.position(1) < place) rig.run(1);
    };
    rig.start(1);
    until(1);
    rig.command(CommandKind::SingleBlock, 1, 1);
    until(2);
    rig.command(CommandKind::SingleBlock, 1, 0);
    until(6);
    rig.command(CommandKind::SingleBlock, 1, 1);
    rig.run_until_idle();
    EXPECT_NEAR(rig.position(1), 10, 1e-9);
    EXPECT_EQ(rig.state(1), ChannelState::ProgramStop);
}

// Pressed on the way it neither stops the axes at once nor, taken back, lets them jump to where the
// path has come.
TEST(Operator, MachineLockActsFromOneProgramToTheNext) {
    TickRig rig;
    double fastest_change = 0, before = 0;
    rig.on_tick = [&] {
        const double v = rig.speed_of(1);
        fastest_change = std::max(fastest_change, std::fabs(v - before) / 0.001);
        before = v;
    };
    rig.push(1, rig.line(1, {20, 0}, 50));
    rig.push(1, rig.stop(1, StopReason::M30));
    rig.start(1);
    rig.run(150);
    rig.command(CommandKind::MachineLock, 1, 1);
    rig.run_until_idle();
    EXPECT_NEAR(rig.position(1), 20, 1e-9);
    EXPECT_LE(fastest_change, TickRig::kAcceleration * 1.01);
    rig.push(1, rig.line(1, {20, 0}, 50));
    rig.push(1, rig.stop(1, StopReason::M30));
    rig.start(1);
    rig.run(150);
    rig.command(CommandKind::MachineLock, 1, 0);
    rig.run_until_idle();
    EXPECT_NEAR(rig.position(1), 20, 1e-9) << "this program was locked when it began";
    EXPECT_LE(fastest_change, TickRig::kAcceleration * 1.01);
}

TEST(Operator, AnswersProgrammedStopsWithStart) {
    for (const bool optional : {false, true}) {
        SCOPED_TRACE(optional);
        TickRig rig;
        if (optional) rig.command(CommandKind::OptionalStop, 1, 1);
        rig.push(1, rig.stop(1, StopReason::M01));
        PathRecord m0 = rig.stop(1, StopReason::M00);
        m0.flags |= kDrains;
        const auto at = rig.push(1, m0);
        rig.push(1, rig.line(1, {5, 0}, 50));
        rig.start(1);
        rig.run_until_idle();
        if (optional) {
            EXPECT_EQ(rig.machine->channel(0).stop_reason(), StopReason::M01);
            rig.start(1);
            rig.run_until_idle();
        }
        EXPECT_EQ(rig.state(1), ChannelState::ProgramStop);
        EXPECT_EQ(rig.machine->channel(0).stop_reason(), StopReason::M00);
        EXPECT_EQ(rig.position(1), 0);
        rig.start(1);
        rig.run_until_idle();
        EXPECT_NEAR(rig.position(1), 5, 1e-9);
        EXPECT_EQ(rig.heard[0].back().kind,
                  static_cast<std::uint32_t>(ChannelEventKind::BarrierReached));
        EXPECT_EQ(rig.heard[0].back().record, at);
    }
}

TEST(Operator, SlowsFeedAndRapidByTheirOverrides) {
    for (const bool rapid : {false, true}) {
        TickRig rig;
        rig.command(rapid ? CommandKind::RapidOverride : CommandKind::FeedOverride, 1, 0.5);
        rig.push(1, rig.line(1, {50, 0}, 80, rapid ? kRapid : 0u));
        rig.start(1);
        double fastest = 0;
        rig.on_tick = [&] { fastest = std::max(fastest, rig.speed_of(1)); };
        rig.run_until_idle();
        EXPECT_NEAR(fastest, rapid ? 0.5 * TickRig::kVelocity : 40, 0.05);
    }
}

TEST(Operator, WaitsForThePlcAndTellsTheChannelThatDrains) {
    TickRig rig;
    PathRecord m8 = rig.aux(1, 'M', 8);
    m8.flags |= kDrains;
    const auto at = rig.push(1, m8);
    rig.start(1);
    rig.run(1);
    EXPECT_EQ(rig.machine->core().signals.nc(signals::cn_mcode(1)), 8);
    EXPECT_EQ(rig.machine->core().signals.nc(signals::cn_mstr(1)), 1);
    rig.run(30);
    ASSERT_FALSE(rig.heard[0].empty());
    EXPECT_EQ(rig.heard[0].back().kind,
              static_cast<std::uint32_t>(ChannelEventKind::BarrierReached));
    EXPECT_EQ(rig.heard[0].back().record, at);
    // Inputs of cycle n out at one multiple of the PLC cycle, their answer acts at the next: never
    // sooner.
    EXPECT_NEAR(rig.when(rig.find(KernelEventKind::RecordEnd, 1, m8.note)), 10, 1e-9);
}

TEST(Operator, BrakesEverythingInEmergencyStopAndNeedsMachineOn) {
    TickRig rig;
    rig.push(1, rig.line(1, {100, 0}, 150));
    rig.start(1);
    rig.run(400);
    const double before = rig.position(1);
    rig.command(CommandKind::EmergencyStop);
    rig.run(100);
    EXPECT_EQ(rig.speed_of(1), 0);
    EXPECT_LT(rig.position(1) - before, 150.0 * 150.0 / 2 / 10'000 + 0.2);
    EXPECT_EQ(rig.state(1), ChannelState::Interrupted);
    EXPECT_EQ(rig.machine->core().state, MachineState::EmergencyStop);
    rig.start(1);
    rig.run(10);
    EXPECT_TRUE(rig.alarmed(Alarm::NotReady, 1));
    rig.command(CommandKind::MachineOn);
    rig.command(CommandKind::Reset);
    rig.run(20);
    EXPECT_EQ(rig.state(1), ChannelState::Reset);
    rig.push(1, rig.line(1, {5, 0}, 50));
    rig.start(1);
    const double from = rig.position(1);
    rig.run_until_idle();
    EXPECT_NEAR(rig.position(1), from + 5, 1e-3);
}

TEST(Operator, WatchesAndForcesSignals) {
    TickRig rig;
    rig.command(CommandKind::Watch, 0, 0, 0, signals::sp_rot(1), 1);
    rig.run(5);
    rig.command(CommandKind::SetSignal, 0, 3, 0, signals::sp_rot(1), 1);
    rig.run(30);
    const auto* changed = rig.find(KernelEventKind::Signal);
    ASSERT_TRUE(changed);
    EXPECT_EQ(changed->value, 3);
    EXPECT_EQ(changed->line, 1u);
    EXPECT_EQ(rig.machine->core().signals.plc(signals::sp_rot(1)), 3);
    rig.command(CommandKind::ReleaseSignal, 0, 0, 0, signals::sp_rot(1), 1);
    rig.run(1);
    EXPECT_EQ(rig.machine->core().signals.plc(signals::sp_rot(1)), 0);
}

TEST(Operator, MarksOfThePlcAreKeysAsLongAsTheyAreSet) {
    TickRig rig;
    const auto set = [&](PlcSignal mark, double value) {
        rig.command(CommandKind::SetSignal, 0, value, 0, mark(1), kSlotOfPlc);
        rig.run(2);
        return rig.machine->channel(0).panel().keys;
    };
    EXPECT_EQ(set(signals::blkskip2, 1), kKeyBlockSkip1 << 1);
    EXPECT_EQ(set(signals::m01stop, 1), kKeyBlockSkip1 << 1 | kKeyOptionalStop);
    EXPECT_EQ(set(signals::blkskip2, 0), std::uint32_t{kKeyOptionalStop});
    EXPECT_EQ(set(signals::m5008, 1), std::uint32_t{kKeyOptionalStop} | kKeySingleBlock);
}

// What screens show of the selected program, and of what has been chosen beside the keys.
TEST(Operator, IsToldTheLanguageAndWhatIsChosenBesideTheKeys) {
    TickRig rig([](params::Table& t, RunOptions&) {
        params::put_text(t, params::pt_language, "fanuc", 1);
    });
    const auto told = [&] {
        const auto status = std::make_unique<MachineStatus>();
        EXPECT_TRUE(rig.kernel->status.read(*status));
        return status->channels[0];
    };
    const auto speaks = [&] { return static_cast<Dialect>(told().speaks); };
    rig.run(2);
    EXPECT_EQ(speaks(), Dialect::Fanuc);
    rig.command(CommandKind::Select, 1, static_cast<double>(Dialect::Sinumerik), 0, 0, 0,
                "PART.MPF");
    rig.run(2);
    EXPECT_EQ(speaks(), Dialect::Sinumerik) << "its job says so";
    rig.command(CommandKind::Mode, 1, static_cast<double>(ChannelMode::Mdi));
    rig.run(2);
    EXPECT_EQ(speaks(), Dialect::Sinumerik) << "the selected program stays what it is";
    EXPECT_EQ(rig.machine->channel(0).speaks(), Dialect::Fanuc)
        << "a block by hand is the machine's";
    rig.command(CommandKind::Mode, 1, static_cast<double>(ChannelMode::Auto));
    rig.command(CommandKind::Select, 1, 0, 0, 0, 0, "O1.nc");
    rig.run(2);
    EXPECT_EQ(speaks(), Dialect::Fanuc);

    EXPECT_EQ(told().keys & kKeyIgnoreWaits, 0u);
    rig.command(CommandKind::IgnoreWaits, 1, 1);
    rig.run(2);
    EXPECT_NE(told().keys & kKeyIgnoreWaits, 0u);
    EXPECT_EQ(rig.machine->channel(0).panel().keys & kKeyIgnoreWaits, 0u) << "told, not pressed";
    rig.command(CommandKind::IgnoreWaits, 1, 0);
    rig.run(2);
    EXPECT_EQ(told().keys & kKeyIgnoreWaits, 0u);
    rig.command(CommandKind::SetSignal, 0, 1, 0, signals::cp_nowt(1), kSlotOfPlc);
    rig.run(2);
    EXPECT_NE(told().keys & kKeyIgnoreWaits, 0u) << "the PLC may choose it as well";
}

// INIT, START: the path comes in pieces; a program that runs goes on as it is.
TEST(Operator, AProgramStartsThatOfAnotherChannel) {
    TickRig rig;
    const std::string path = std::string(60, 'a') + "/PART2.MPF";
    for (std::size_t from = 0; from < path.size(); from += 40) {
        PathRecord piece = rig.blank(1, RecordKind::Flag);
        piece.code = kFlagProgram;
        piece.mask = 2;
        piece.value = static_cast<double>(from);
        piece.plane[0] = from + 40 >= path.size();
        copy_text(piece.text, path.substr(from, 40));
        rig.push(1, piece);
    }
    const auto start = [&] {
        PathRecord r = rig.blank(1, RecordKind::Flag);
        r.code = kFlagStart;
        r.mask = 0b10;
        rig.push(1, r);
    };
    start();
    rig.push(1, rig.dwell(1, 0.1));
    start();  // it is under way by now
    rig.push(1, rig.wait(1, WaitBoard::kProgramEnd, 0b11));
    rig.push(1, rig.stop(1, StopReason::M30));
    rig.push(2, rig.dwell(2, 0.3));
    rig.push(2, rig.stop(2, StopReason::M30));
    rig.start(1);
    rig.run_until_idle();
    EXPECT_EQ(rig.state(1), ChannelState::Ended);
    EXPECT_EQ(rig.state(2), ChannelState::Ended);
    ASSERT_EQ(rig.heard[1].size(), 2u);
    EXPECT_EQ(rig.heard[1][0].kind, static_cast<std::uint32_t>(ChannelEventKind::SelectProgram));
    EXPECT_EQ(std::string(rig.heard[1][0].text.data()), path);
    EXPECT_EQ(rig.heard[1][1].kind, static_cast<std::uint32_t>(ChannelEventKind::CycleStart));
    // it has waited for the other's end
    EXPECT_GT(rig.when(rig.find(KernelEventKind::CycleEnded, 1)),
              rig.when(rig.find(KernelEventKind::CycleEnded, 2)) - 1);
    EXPECT_TRUE(rig.log.empty() || !rig.alarmed(Alarm::NotReady));
}

// A channel whose job speaks another language than PT_LANGUAGE goes on in it.
TEST(Operator, AProgramByInitIsReadInTheLanguageOfItsChannelsJob) {
    TickRig rig;
    rig.command(CommandKind::Select, 2, static_cast<double>(Dialect::Sinumerik), 0, 0, 0,
                "LOWER.MPF");
    PathRecord whole = rig.blank(1, RecordKind::Flag);
    whole.code = kFlagProgram;
    whole.mask = 2;
    whole.plane[0] = 1;
    copy_text(whole.text, "SECOND.MPF");
    rig.push(1, whole);
    rig.push(1, rig.stop(1, StopReason::M30));
    rig.start(1);
    rig.run_until_idle();
    ASSERT_EQ(rig.heard[1].size(), 2u);
    EXPECT_EQ(std::string(rig.heard[1][1].text.data()), "SECOND.MPF");
    EXPECT_EQ(rig.heard[1][1].value, static_cast<double>(Dialect::Sinumerik));
}

}  // namespace
}  // namespace polyturn::kernel
