#include <gtest/gtest.h>

#include "process_rig.hpp"

namespace polyturn::channels {
namespace {

using namespace rig;

RecordKind kind_of(const PathRecord& r) { return static_cast<RecordKind>(r.kind); }

struct ChannelProcessTest : testing::Test {
    ProcessRig rig;
    AxisValues at{};
    BlockContext block;
    ScriptedRun::Line line(double x, double z) {
        return [this, x, z](Sink& sink, const MachineView& view, Port&) {
            ++block.line;
            sink.move(line_to(view, at, x, z), block);
            sink.block_end(block);
            return Step::Continue;
        };
    }
    ScriptedRun::Line stop(StopReason reason) {
        return [this, reason](Sink& sink, const MachineView&, Port&) {
            ++block.line;
            sink.stop({reason}, block);
            sink.block_end(block);
            return reason == StopReason::M00 ? Step::AtBarrier : Step::Ended;
        };
    }
};

TEST_F(ChannelProcessTest, PushesAProgramFromCycleStartToItsEnd) {
    rig.program = {line(10, 0), line(10, 10), stop(StopReason::M30)};
    rig.run_until_quiet();
    EXPECT_EQ(rig.channel->path.head.load(), 0u);
    rig.tell(ChannelEventKind::CycleStart);
    rig.run_until_quiet();
    rig.take_all();
    ASSERT_GE(rig.taken.size(), 3u);
    EXPECT_EQ(kind_of(rig.taken.front()), RecordKind::Line);
    EXPECT_EQ(rig.taken.front().feed, 10);
    EXPECT_TRUE(rig.taken[rig.taken.size() - 2].flags & kExactStop);
    EXPECT_EQ(kind_of(rig.taken.back()), RecordKind::Stop);
    EXPECT_EQ(rig.taken.back().code, static_cast<std::int32_t>(StopReason::M30));
    ProgramNames names;
    ASSERT_TRUE(rig.channel->programs.read(names));
    EXPECT_STREQ(names.name.data(), "O0001.nc");
}

// 30 mm: the first 2 after one inner corner and the last 5 before another at half the feed; one
// note, told once.
TEST_F(ChannelProcessTest, InnerCornersAreCutWithTheirShareOfTheFeed) {
    const ScriptedRun::Line cut = [this](Sink& sink, const MachineView& view, Port&) {
        Move move = line_to(view, at, 0, 30);
        move.slow_head = 2;
        move.slow_tail = 5;
        move.slow_share = 0.5;
        ++block.line;
        sink.move(move, block);
        sink.block_end(block);
        return Step::Continue;
    };
    rig.program = {cut, stop(StopReason::M30)};
    rig.tell(ChannelEventKind::CycleStart);
    rig.run_until_quiet();
    rig.take_all();
    double slow = 0, fast = 0;
    unsigned noted = 0;
    for (const PathRecord& r : rig.taken) {
        if (kind_of(r) == RecordKind::Stop) continue;
        if (r.feed == 5) slow += r.length;
        if (r.feed == 10) fast += r.length;
        noted += (r.flags & kBlockBegin) != 0;
    }
    EXPECT_NEAR(slow, 7, 0.05) << "blends round nothing: the pieces are in line";
    EXPECT_NEAR(fast, 23, 0.05);
    EXPECT_EQ(noted, 1u);
}

TEST_F(ChannelProcessTest, StandsAtABarrierUntilTheKernelHasAnswered) {
    rig.program = {line(10, 0), stop(StopReason::M00), line(0, 0)};
    rig.tell(ChannelEventKind::CycleStart);
    rig.run_until_quiet();
    const auto pushed = rig.channel->path.head.load();
    EXPECT_EQ(pushed, 2u);
    EXPECT_EQ(rig.take_all(), 1u);
    rig.run_until_quiet();
    EXPECT_EQ(rig.channel->path.head.load(), pushed + 2) << "the move and the end";
}

// A restart that searches its block tells nothing of the codes that drain: two of them one after
// the other.
TEST_F(ChannelProcessTest, StandsAtASecondBarrierThoughNothingLiesBetween) {
    for (int n = 0; n < 2; ++n)
        rig.program.push_back([](Sink&, const MachineView&, Port&) { return Step::AtBarrier; });
    rig.tell(ChannelEventKind::CycleStart);
    for (int n = 0; n < 2; ++n) {
        rig.run_until_quiet();
        EXPECT_EQ(rig.take_all(), 1u) << n;
    }
    rig.run_until_quiet();
    rig.take_all();
    EXPECT_EQ(static_cast<RecordKind>(rig.taken.back().kind), RecordKind::Stop);
}

TEST_F(ChannelProcessTest, WaitsForRoomAndLosesNothing) {
    for (int n = 1; n <= 6000; ++n) rig.program.push_back(line(n % 2 ? 10 : 0, n));
    rig.tell(ChannelEventKind::CycleStart);
    std::thread kernel([&] {
        for (int n = 0; n < 20'000 && !rig.quiet(); ++n) {
            rig.take_all();
            rig.kernel->channel_bell[0].ring();
            sleep_ms(1);
        }
    });
    rig.run_until_quiet();
    kernel.join();
    rig.take_all();
    std::uint32_t blocks = 0;
    for (const auto& r : rig.taken)
        blocks += (r.flags & kBlockEnd) && kind_of(r) != RecordKind::Stop;
    EXPECT_EQ(blocks, 6000u);
}

TEST_F(ChannelProcessTest, AResetEndsInterpretationAndRaisesTheEpoch) {
    for (int n = 1; n <= 100; ++n) rig.program.push_back(line(n, 0));
    rig.tell(ChannelEventKind::CycleStart);
    for (int n = 0; n < 2; ++n) rig.process->turn(false);  // in the middle of it
    rig.tell(ChannelEventKind::Reset, 0, 0, 2);
    rig.run_until_quiet();
    EXPECT_EQ(rig.channel->epoch.load(), 2u);
    rig.take_all();
    EXPECT_LT(rig.taken.size(), 100u);
    rig.taken.clear();
    at = {};
    rig.tell(ChannelEventKind::CycleStart);
    rig.run_until_quiet();
    rig.take_all();
    ASSERT_FALSE(rig.taken.empty());
    for (const auto& r : rig.taken) EXPECT_EQ(r.epoch, 2u);
}

TEST_F(ChannelProcessTest, AResetIsHeardWhileTheRingIsFull) {
    for (int n = 1; n <= 6000; ++n) rig.program.push_back(line(n % 2 ? 10 : 0, n));
    rig.tell(ChannelEventKind::CycleStart);
    std::thread operator_thread([&] {
        for (int n = 0; n < 2000 && rig.channel->path.head.load() < kPathRing; ++n) sleep_ms(1);
        sleep_ms(30);
        rig.tell(ChannelEventKind::Reset, 0, 0, 2);
        rig.kernel->channel_bell[0].ring();
    });
    for (int n = 0; n < 100'000 && rig.channel->quiet.load() < 2; ++n) rig.process->turn(false);
    operator_thread.join();
    EXPECT_TRUE(rig.quiet());
}

TEST_F(ChannelProcessTest, AnAlarmStopsInPathOrder) {
    rig.program = {line(10, 0), [this](Sink& sink, const MachineView&, Port&) {
                       Diagnosis d;
                       d.alarm = Alarm::TextSyntax;
                       d.detail = "no such word";
                       sink.alarm(d, block);
                       return Step::Failed;
                   }};
    rig.tell(ChannelEventKind::CycleStart);
    rig.run_until_quiet();
    rig.take_all();
    ASSERT_EQ(rig.taken.size(), 2u);
    EXPECT_TRUE(rig.taken[0].flags & kExactStop);
    EXPECT_EQ(rig.taken[1].code, static_cast<std::int32_t>(StopReason::Alarm));
}

TEST_F(ChannelProcessTest, MakesAsManyPartsAsWereOrdered) {
    rig.program = {line(10, 0), line(0, 0), stop(StopReason::M30)};
    rig.tell(ChannelEventKind::CycleStart, 0, 3);
    for (int part = 0; part < 3; ++part) {
        rig.run_until_quiet();
        at = {};
        rig.take_all();
    }
    rig.run_until_quiet();
    int ends = 0, stops = 0;
    for (const auto& r : rig.taken) {
        ends += kind_of(r) == RecordKind::Barrier;
        stops += kind_of(r) == RecordKind::Stop;
    }
    EXPECT_EQ(ends, 2);
    EXPECT_EQ(stops, 1);
}

TEST_F(ChannelProcessTest, ASuccessorStartsInResetAndHearsOnlyWhatComesAfterIt) {
    rig.program = {line(10, 0), line(0, 0), stop(StopReason::M30)};
    rig.tell(ChannelEventKind::CycleStart);
    rig.run_until_quiet();
    rig.take_all();
    rig.taken.clear();
    rig.start_process();  // the first one is gone, with records in its ring that nobody takes
    at = {};
    rig.run_until_quiet();
    EXPECT_EQ(rig.channel->path.head.load(), 0u);
    rig.tell(ChannelEventKind::CycleStart);
    rig.run_until_quiet();
    rig.take_all();
    EXPECT_GE(rig.taken.size(), 3u);
    EXPECT_EQ(rig.taken.back().code, static_cast<std::int32_t>(StopReason::M30));
}

TEST_F(ChannelProcessTest, TheHeartbeatGrowsWhileItRests) {
    const auto before = rig.channel->heartbeat.load();
    for (int n = 0; n < 3; ++n) rig.process->turn(true);
    EXPECT_GE(rig.channel->heartbeat.load(), before + 3);
}

}  // namespace
}  // namespace polyturn::channels
