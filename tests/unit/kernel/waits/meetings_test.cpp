// A channel that is not running has met nobody: what takes its half of a meeting back, whatever the
// order of keys, alarms and deaths.
#include "tests/unit/kernel/rig.hpp"

namespace polyturn::kernel {
namespace {

constexpr int kCode = 500;
constexpr std::uint32_t kBoth = 0b11;

// L1 and L2 meet at M500; behind it L1 cuts. Who goes on behind the code has moved.
struct Meeting : TickRig {
    using TickRig::TickRig;
    void arrive(unsigned l, std::uint32_t set = kBoth, int code = kCode) {
        push(l, wait(l, code, set));
        push(l, l <= 2 ? line(l, {5, 0}, 20) : dwell(l, 1));  // L3 has no axes
        start(l);
        run(10);
    }
    bool went_on(unsigned l) const { return position(2 * l - 1) != 0; }
    bool waits(unsigned l) const { return state(l) == ChannelState::Waiting; }
    std::string_view told(Alarm number, unsigned l = 0) const {
        for (const KernelEvent& e : log)
            if (e.code == static_cast<int>(number) && (l == 0 || e.channel == l))
                return {e.text.data()};
        return {};
    }
    void restart(std::initializer_list<unsigned> channels) {
        std::uint32_t set = 0;
        for (const unsigned l : channels) set |= 1u << (l - 1);
        for (const unsigned l : channels) command(CommandKind::Restart, l, 100 + l, 0, 0, set);
        run(3);
    }
    void at_block(unsigned l) {
        push(l, stop(l, StopReason::Restart));
        run(5);
    }
    void die(unsigned l) {
        command(CommandKind::ProcessDied, 0, 0, 0,
                static_cast<std::uint32_t>(kProcessChannel + l - 1));
    }
};

// --- what ends an arrival ---

TEST(Meetings, EndWithEveryReasonThatStopsTheProgramThatWaits) {
    struct Cause {
        const char* name;
        std::function<void(Meeting&)> act;
    };
    const Cause causes[] = {
        {"an alarm of the channel",
         [](Meeting& m) { m.machine->channel(1).fault(Alarm::InterlockStop, "door", 0); }},
        {"a stop of the whole machine",
         [](Meeting& m) {
             m.machine->stop_all(Alarm::PlcLate);
             m.run(2);
             m.command(CommandKind::Reset, 1);
         }},
        {"the emergency stop", [](Meeting& m) { m.command(CommandKind::EmergencyStop); }},
        {"a reset", [](Meeting& m) { m.command(CommandKind::Reset, 2); }},
        {"death", [](Meeting& m) { m.die(2); }},
    };
    for (const Cause& cause : causes) {
        SCOPED_TRACE(cause.name);
        Meeting m;
        m.arrive(2);
        ASSERT_TRUE(m.waits(2));
        cause.act(m);
        m.run(5);
        if (m.machine->core().state == MachineState::EmergencyStop) {
            m.command(CommandKind::Reset, 1);
            m.command(CommandKind::ReleaseStop);
            m.run(5);
            m.command(CommandKind::MachineOn);
            m.run(20);
        }
        EXPECT_FALSE(m.waits(2));
        m.arrive(1);
        m.run(300);
        EXPECT_FALSE(m.went_on(1));
        EXPECT_TRUE(m.waits(1) || m.state(1) == ChannelState::Reset)
            << static_cast<int>(m.state(1));
    }
}

TEST(Meetings, EndWithTheTimeOut) {
    // of the group
    Meeting m(
        [](params::Table& t, RunOptions&) { params::put(t, params::pt_wait_timeout, 0.1, 1); });
    m.arrive(2);
    m.run(150);
    ASSERT_EQ(m.state(2), ChannelState::Interrupted);
    m.arrive(1);
    m.run(50);
    EXPECT_FALSE(m.went_on(1));
    EXPECT_TRUE(m.waits(1));
}

TEST(Meetings, EndWithTheAlarmOfADeadlock) {
    Meeting m;
    m.arrive(1, kBoth, 501);
    m.arrive(2, kBoth, kCode);  // they wait for each other: the alarm is L2's
    ASSERT_TRUE(m.alarmed(Alarm::WaitDeadlock, 2));
    m.command(CommandKind::Reset, 1);
    m.run(5);
    m.arrive(1);
    m.run(300);
    EXPECT_FALSE(m.went_on(1));
}

TEST(Meetings, OfThreeOpenForNobodyWhenOneHasStopped) {
    Meeting m;
    m.arrive(1, 0b111);
    m.arrive(2, 0b111);
    m.machine->channel(1).fault(Alarm::InterlockStop, "door", 0);
    m.run(5);
    m.arrive(3, 0b111);
    m.run(300);
    EXPECT_FALSE(m.went_on(1));
    EXPECT_TRUE(m.waits(1));
    EXPECT_TRUE(m.waits(3));
}

TEST(Meetings, AreKeptByAHold) {
    Meeting m;
    m.arrive(2);
    m.command(CommandKind::FeedHold, 2);
    m.run(5);
    m.arrive(1);
    m.run(300);
    EXPECT_TRUE(m.went_on(1));
    EXPECT_FALSE(m.went_on(2));
}

TEST(Meetings, OfAProgramAndABlockEnteredByHandAreNone) {
    Meeting m;
    m.push(2, m.wait(2, kCode, kBoth));
    m.push(2, m.line(2, {5, 0}, 20));
    m.command(CommandKind::Mode, 2, static_cast<double>(ChannelMode::Mdi));
    m.command(CommandKind::Mdi, 2, 0, 0, 0, 0, "M500 P12");
    m.start(2);
    m.run(10);
    ASSERT_TRUE(m.waits(2));
    m.arrive(1);
    m.run(300);
    EXPECT_FALSE(m.went_on(1));
    EXPECT_FALSE(m.went_on(2));
    EXPECT_TRUE(m.waits(1));
    EXPECT_FALSE(m.alarmed(Alarm::WaitDeadlock));
    EXPECT_NE(m.told(Alarm::WaitPartnerAbsent, 1).find("L2"), std::string_view::npos);
}

TEST(Meetings, OfADryRunAndACutAreNoneUntilBothAreAlike) {
    Meeting m;
    m.command(CommandKind::DryRun, 2);
    m.arrive(2);
    m.arrive(1);
    m.run(300);
    EXPECT_FALSE(m.went_on(1)) << "the other one has cut nothing";
    EXPECT_FALSE(m.went_on(2));
    EXPECT_NE(m.told(Alarm::WaitPartnerAbsent, 1).find("dry run"), std::string_view::npos);
    m.command(CommandKind::DryRun, 1);
    m.run(300);
    EXPECT_TRUE(m.went_on(1));
    EXPECT_TRUE(m.went_on(2));
}

// --- the end of another program (WAITE) ---

TEST(Meetings, AtTheEndOfAProgramDoNotCountOneThatHasDied) {
    Meeting m;
    m.push(2, m.line(2, {50, 0}, 5));
    m.start(2);
    m.arrive(1, kBoth, WaitBoard::kProgramEnd);
    ASSERT_TRUE(m.waits(1));
    m.die(2);
    m.run(300);
    EXPECT_EQ(m.state(2), ChannelState::Dead);
    EXPECT_FALSE(m.went_on(1));
    EXPECT_TRUE(m.alarmed(Alarm::WaitPartnerAbsent, 1));
    auto successor = std::make_unique<ChannelSegment>();
    m.machine->attach_channel(1, *successor);  // in reset, but the program has not come to its end
    std::swap(m.channel[1], successor);
    m.run(50);
    EXPECT_FALSE(m.went_on(1));
    m.command(CommandKind::Reset, 2);  // the operator says so
    m.run(300);
    EXPECT_TRUE(m.went_on(1));
}

TEST(Meetings, AtTheEndOfAProgramDoNotCountAChannelThatIsNotThere) {
    Meeting m;
    m.arrive(1, 0b1001, WaitBoard::kProgramEnd);
    m.run(100);
    EXPECT_FALSE(m.went_on(1));
    EXPECT_TRUE(m.alarmed(Alarm::WaitPartnerAbsent, 1));
}

// --- a flying wait ---

TEST(Meetings, ThatAreFlownThroughAreWaitedForWhenThePartnerIsGone) {
    // mm in front of the code: it can, or cannot, stand in front of it any more
    for (const double before : {5.0, 0.5}) {
        SCOPED_TRACE(before);
        Meeting m;
        m.push(1, m.line(1, {20, 0}, 50));
        m.push(1, m.wait(1, kCode, kBoth, kFlying));
        m.push(1, m.line(1, {20, 0}, 50));
        m.push(2, m.wait(2, kCode, kBoth));
        m.start(2);
        m.run(5);
        m.start(1);
        bool gone = false;
        m.on_tick = [&] {
            if (gone || m.position(1) < 20 - before) return;
            gone = true;
            m.machine->channel(1).fault(Alarm::InterlockStop, "door", 0);
        };
        m.run(1500);
        EXPECT_EQ(m.state(1), ChannelState::Waiting);
        EXPECT_LT(m.position(1), 21.5) << "it stands as soon as its path allows";
        m.on_tick = {};
        m.command(CommandKind::Reset, 2);
        m.run(5);
        m.push(2, m.wait(2, kCode, kBoth));
        m.start(2);
        m.run(2000);
        EXPECT_NEAR(m.position(1), 40, 1e-9) << "and goes on when the partner has come";
    }
}

// --- restart ---

TEST(Restart, ThatIsRefusedLetsNobodyThroughAWait) {
    Meeting m;
    m.restart({1, 2});
    m.at_block(1);                     // N170, in front of N180 M502
    m.push(2, m.wait(2, 502, kBoth));  // N100 lies behind it: its search replays the wait
    m.run(10);
    EXPECT_TRUE(m.alarmed(Alarm::RestartMismatch, 2));
    EXPECT_TRUE(m.alarmed(Alarm::RestartRefused));
    EXPECT_NE(m.told(Alarm::RestartRefused).find("L2"), std::string_view::npos);
    EXPECT_EQ(m.state(1), ChannelState::Reset);
    EXPECT_EQ(m.state(2), ChannelState::Reset);
    m.push(1, m.wait(1, 502, kBoth));
    m.push(1, m.line(1, {5, 0}, 20));
    m.command(CommandKind::CycleStart);
    m.run(300);
    EXPECT_FALSE(m.went_on(1));
    int said = 0;
    for (const KernelEvent& e : m.log)
        said += e.code == static_cast<int>(Alarm::RestartRefused) &&
                e.kind == static_cast<std::uint32_t>(KernelEventKind::Alarm);
    EXPECT_EQ(said, 1);
}

// Whoever presses start then means the approach, not the program's first block.
TEST(Restart, ThatIsRefusedIsNotStartedFromTheBeginningInstead) {
    Meeting m;
    m.restart({1, 2});
    m.at_block(1);
    m.machine->channel(1).fault(Alarm::InterlockStop, "door", 0);
    m.start(1);
    m.run(10);
    m.push(1, m.line(1, {5, 0}, 20));
    m.start(1);
    m.run(300);
    EXPECT_FALSE(m.went_on(1));
    EXPECT_NE(m.told(Alarm::NotReady, 1).find("restart"), std::string_view::npos);
    m.command(CommandKind::Reset, 1);  // now it is meant
    m.run(5);
    m.push(1, m.line(1, {5, 0}, 20));
    m.start(1);
    m.run(300);
    EXPECT_TRUE(m.went_on(1));
}

TEST(Restart, MayFollowARefusedOneAtOnce) {
    Meeting m;
    m.restart({1, 2});
    m.at_block(1);
    m.machine->channel(1).fault(Alarm::InterlockStop, "door", 0);
    m.run(5);
    m.restart({1, 2});
    m.at_block(1);
    m.at_block(2);
    m.push(1, m.line(1, {5, 0}, 20));
    m.command(CommandKind::CycleStart);
    m.run(300);
    EXPECT_TRUE(m.went_on(1));
}

TEST(Restart, StartsWhenAllAreAtTheirBlocks) {
    Meeting m;
    m.restart({1, 2});
    m.at_block(1);
    m.push(1, m.line(1, {5, 0}, 20));
    m.start(1);
    m.run(50);
    EXPECT_EQ(m.state(1), ChannelState::ProgramStop);
    EXPECT_FALSE(m.went_on(1));
    EXPECT_NE(m.told(Alarm::NotReady, 1).find("restart"), std::string_view::npos);
    m.at_block(2);
    m.push(2, m.wait(2, kCode, kBoth));
    m.push(2, m.line(2, {5, 0}, 20));
    m.start(2);  // one after the other, as an operator makes the approaches
    m.run(50);
    EXPECT_TRUE(m.waits(2));
    m.start(1);
    m.run(300);
    EXPECT_TRUE(m.went_on(1));
    EXPECT_FALSE(m.alarmed(Alarm::RestartRefused));
}

TEST(Restart, EndsForAllWhenOneOfThemDoes) {
    struct Cause {
        const char* name;
        std::function<void(Meeting&)> act;
        ChannelState left = ChannelState::Reset;
    };
    const Cause causes[] = {
        {"a reset", [](Meeting& m) { m.command(CommandKind::Reset, 2); }},
        {"a reset in the tick of the other's start",
         [](Meeting& m) {
             m.at_block(2);
             m.command(CommandKind::Reset, 2);
             m.start(1);
         }},
        {"an alarm",
         [](Meeting& m) { m.machine->channel(1).fault(Alarm::InterlockStop, "door", 0); }},
        {"a program that cannot be read",
         [](Meeting& m) { m.push(2, m.stop(2, StopReason::Alarm)); }},
        {"a program that ends", [](Meeting& m) { m.push(2, m.stop(2, StopReason::M30)); }},
        {"death", [](Meeting& m) { m.die(2); }, ChannelState::Dead},
    };
    for (const Cause& cause : causes) {
        SCOPED_TRACE(cause.name);
        Meeting m;
        m.restart({1, 2});
        m.at_block(1);
        m.push(1, m.line(1, {5, 0}, 20));
        cause.act(m);
        m.run(10);
        EXPECT_EQ(m.state(2), cause.left);
        EXPECT_EQ(m.state(1), ChannelState::Reset);
        EXPECT_TRUE(m.alarmed(Alarm::RestartRefused));
        EXPECT_NE(m.told(Alarm::RestartRefused).find("L2"), std::string_view::npos)
            << m.told(Alarm::RestartRefused);
        m.run(300);
        EXPECT_FALSE(m.went_on(1));
    }
}

TEST(Restart, BeginsForNobodyWhereOneCannot) {
    for (const bool last : {false, true}) {  // the refused channel is asked first, or last
        SCOPED_TRACE(last);
        Meeting m;
        const unsigned refused = last ? 2 : 1, other = last ? 1 : 2;
        m.machine->channel(refused - 1).select("", 0);
        m.restart({1, 2});
        m.run(3);
        EXPECT_EQ(m.state(refused), ChannelState::Reset);
        EXPECT_EQ(m.state(other), ChannelState::Reset);
        EXPECT_TRUE(m.alarmed(Alarm::NotReady, refused));
        EXPECT_TRUE(m.alarmed(Alarm::RestartRefused));
    }
}

TEST(Restart, OfAChannelThatRunsLeavesItAlone) {
    Meeting m;
    m.push(2, m.line(2, {50, 0}, 5));
    m.start(2);
    m.run(10);
    m.restart({1, 2});
    m.run(100);
    EXPECT_EQ(m.state(1), ChannelState::Reset);
    EXPECT_EQ(m.state(2), ChannelState::Running);
    EXPECT_TRUE(m.alarmed(Alarm::RestartRefused));
}

TEST(Restart, OfAllThatAreResetTogetherSaysNothing) {
    Meeting m;
    m.restart({1, 2});
    m.at_block(1);
    m.command(CommandKind::Reset);
    m.run(10);
    EXPECT_EQ(m.state(1), ChannelState::Reset);
    EXPECT_EQ(m.state(2), ChannelState::Reset);
    EXPECT_FALSE(m.alarmed(Alarm::RestartRefused));
}

TEST(Restart, WhoseOtherHalfIsNeverAskedIsRefused) {
    Meeting m;
    m.command(CommandKind::Restart, 1, 170, 0, 0, kBoth);
    m.run(3);
    m.at_block(1);
    m.run(1200);
    EXPECT_EQ(m.state(1), ChannelState::Reset);
    EXPECT_TRUE(m.alarmed(Alarm::RestartRefused));
}

// A partner that really waits is not met by a search that passes the same code, nor the other way
// round.
TEST(Restart, MeetsOnlyThoseThatRestartWithIt) {
    Meeting m;
    m.arrive(3, 0b101, kCode);
    m.restart({1, 2});
    m.push(1, m.wait(1, kCode, 0b101));
    m.run(50);
    EXPECT_TRUE(m.waits(3));
    EXPECT_FALSE(m.went_on(3));
}

TEST(Restart, SetsMarkersForOthersWhenItStartsOnly) {
    Meeting m;
    PathRecord set = m.blank(1, RecordKind::Marker);
    set.code = 7;
    set.value = 1;
    m.arrive(2, kBoth, 7);
    ASSERT_TRUE(m.waits(2));
    m.restart({1});
    m.push(1, set);
    m.at_block(1);
    m.run(50);
    EXPECT_FALSE(m.went_on(2)) << "nothing was driven to the marker";
    m.push(1, m.line(1, {5, 0}, 20));
    m.start(1);
    m.run(300);
    EXPECT_TRUE(m.went_on(2));
}

TEST(Restart, IsNotStoppedBySingleBlock) {
    Meeting m;
    m.command(CommandKind::SingleBlock, 1);
    m.restart({1, 2});
    m.push(1, m.wait(1, kCode, kBoth));
    m.push(2, m.wait(2, kCode, kBoth));
    m.run(10);
    EXPECT_EQ(m.state(1), ChannelState::Running) << "it only reads";
    m.at_block(1);
    m.at_block(2);
    EXPECT_EQ(m.machine->channel(0).stop_reason(), StopReason::Restart);
}

}  // namespace
}  // namespace polyturn::kernel
