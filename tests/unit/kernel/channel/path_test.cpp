#include "tests/unit/kernel/rig.hpp"

namespace polyturn::kernel {
namespace {

TEST(Path, IsDrivenWithinTheLimitsAndReportedWithPartsOfATick) {
    TickRig rig;
    const PathRecord first = rig.line(1, {20, -40}, 50),
                     second = rig.line(1, {15, -30}, 80, kExactStop);
    rig.push(1, first);
    rig.push(1, second);
    rig.push(1, rig.stop(1, StopReason::M30));
    rig.start(1);
    double before[2] = {0, 0}, v[2] = {0, 0}, worst_v = 0, worst_a = 0;
    rig.on_tick = [&] {
        for (unsigned i = 0; i < 2; ++i) {
            const double now = rig.position(i + 1), speed = (now - before[i]) / 0.001;
            worst_v = std::max(worst_v, std::fabs(speed));
            worst_a = std::max(worst_a, std::fabs(speed - v[i]) / 0.001);
            before[i] = now;
            v[i] = speed;
        }
    };
    rig.run_until_idle();
    EXPECT_EQ(rig.state(1), ChannelState::Ended);
    EXPECT_NEAR(rig.position(1), 35, 1e-9);
    EXPECT_NEAR(rig.position(2), -70, 1e-9);
    EXPECT_LE(worst_v, TickRig::kVelocity * 1.01);
    EXPECT_LE(worst_a, TickRig::kAcceleration * 1.01);
    const auto* begin = rig.find(KernelEventKind::RecordBegin, 1, first.note);
    const auto* end = rig.find(KernelEventKind::RecordEnd, 1, first.note);
    const auto* next = rig.find(KernelEventKind::RecordBegin, 1, second.note);
    ASSERT_TRUE(begin && end && next);
    EXPECT_LT(rig.when(begin), rig.when(end));
    EXPECT_DOUBLE_EQ(rig.when(end), rig.when(next));
    ASSERT_TRUE(rig.find(KernelEventKind::CycleEnded, 1));
    EXPECT_EQ(rig.find(KernelEventKind::CycleEnded, 1)->code, static_cast<int>(StopReason::M30));
    EXPECT_EQ(rig.kernel->path_tail[0].tail.load(), 3u);
}

// Whatever a channel sends, no drive is told to be elsewhere within a tick; who sends it is out of
// work, nobody else stops.
TEST(Path, ThatDoesNotBeginWhereTheAxisStandsIsNotDriven) {
    TickRig rig;
    rig.place(1, 0, 50);  // the channel believes that X stands at 50
    rig.push(1, rig.line(1, {10, 0}, 50));
    rig.push(1, rig.stop(1, StopReason::M30));
    double worst = 0, before = 0;
    rig.on_tick = [&] {
        worst = std::max(worst, std::fabs(rig.position(1) - before));
        before = rig.position(1);
    };
    rig.start(1);
    rig.run(500);
    EXPECT_EQ(worst, 0);
    EXPECT_TRUE(rig.alarmed(Alarm::ChannelHostile, 1));
    EXPECT_EQ(rig.state(1), ChannelState::Dead);
    EXPECT_EQ(rig.machine->core().state, MachineState::On);
}

TEST(Path, IsFollowedByTheMeasuredAxis) {
    TickRig rig;
    rig.push(1, rig.line(1, {0, -100}, 100));
    rig.start(1);
    double worst = 0;
    rig.on_tick = [&] { worst = std::max(worst, std::fabs(rig.machine->core().axes[1].error())); };
    rig.run_until_idle();
    rig.run(200);
    EXPECT_LT(worst, 0.02);  // feed-forward 1 leaves only the transients of the drive
    EXPECT_TRUE(rig.machine->core().axes[1].in_position());
}

TEST(Path, DwellsForItsTime) {
    TickRig rig;
    const PathRecord dwell = rig.dwell(1, 0.25);
    rig.push(1, dwell);
    rig.start(1);
    rig.run_until_idle();
    EXPECT_NEAR(rig.when(rig.find(KernelEventKind::RecordEnd, 1, dwell.note)) -
                    rig.when(rig.find(KernelEventKind::RecordBegin, 1, dwell.note)),
                250, 1e-6);
}

TEST(Path, OfASkipMoveEndsWhereTheSignalComes) {
    TickRig rig;
    PathRecord skip = rig.line(1, {0, -50}, 20, kSkipMove | kExactStop);
    skip.code = 7;
    rig.push(1, skip);
    PathRecord barrier = rig.blank(1, RecordKind::Barrier);
    barrier.flags |= kDrains;
    const auto at = rig.push(1, barrier);
    rig.start(1);
    rig.run(1000);
    rig.command(CommandKind::SetInput, 0, 1, 0, 7);
    const double before = rig.position(2);
    rig.run_until_idle();
    EXPECT_LT(rig.position(2), before);
    EXPECT_GT(rig.position(2), before - 1.5);
    EXPECT_TRUE(rig.find(KernelEventKind::RecordEnd, 1, skip.note));
    ASSERT_FALSE(rig.heard[0].empty());
    EXPECT_EQ(rig.heard[0].back().record, at);
}

}  // namespace
}  // namespace polyturn::kernel
