// Retrace and the handwheel as time of the programs: the path driven backwards and forwards again.
#include "tests/unit/kernel/rig.hpp"

namespace polyturn::kernel {
namespace {

struct Path {
    TickRig& rig;
    std::vector<std::array<double, 2>> points;  // of L1, one a tick
    explicit Path(TickRig& r) : rig(r) {
        rig.on_tick = [this] { points.push_back({rig.position(1), rig.position(2)}); };
    }
};

// Distance from the polyline (0,0) (10,0) (10,-20) (30,-20).
double off_path(const std::array<double, 2>& p) {
    const double a = std::hypot(std::fmax(0.0, std::fmax(-p[0], p[0] - 10)), p[1]);
    const double b = std::hypot(p[0] - 10, std::fmax(0.0, std::fmax(p[1], -20 - p[1])));
    const double c = std::hypot(std::fmax(0.0, std::fmax(10 - p[0], p[0] - 30)), p[1] + 20);
    return std::fmin(a, std::fmin(b, c));
}

void push_path(TickRig& rig) {
    rig.push(1, rig.line(1, {10, 0}, 50, kExactStop));
    rig.push(1, rig.line(1, {0, -20}, 50, kExactStop));
    rig.push(1, rig.line(1, {20, 0}, 50, kExactStop));
    rig.push(1, rig.stop(1, StopReason::M30));
}

TEST(Retrace, DrivesBackToTheBeginningAndForwardToTheEnd) {
    TickRig rig;
    push_path(rig);
    rig.start(1);
    rig.run(900);
    rig.command(CommandKind::FeedHold, 1);
    rig.run(200);
    ASSERT_EQ(rig.state(1), ChannelState::Held);
    const double x = rig.position(1), z = rig.position(2);
    ASSERT_NEAR(z, -20, 1e-9);
    ASSERT_GT(x, 10);
    Path path(rig);
    const auto chosen = [&] {
        const auto status = std::make_unique<MachineStatus>();
        return rig.kernel->status.read(*status) && (status->channels[0].keys & kKeyRetrace);
    };
    EXPECT_FALSE(chosen());
    rig.command(CommandKind::Retrace, 1, 1);
    rig.run(2);
    EXPECT_TRUE(chosen()) << "the next start drives backwards: screens say so before it does";
    rig.start(1);
    rig.run_until_idle();
    EXPECT_FALSE(chosen()) << "no further back";
    EXPECT_EQ(rig.state(1), ChannelState::Held);
    EXPECT_NEAR(rig.position(1), 0, 1e-9);
    EXPECT_NEAR(rig.position(2), 0, 1e-9);
    EXPECT_TRUE(rig.alarmed(Alarm::RetraceEnds, 1));
    rig.command(CommandKind::Retrace, 1, 0);
    rig.start(1);
    rig.run_until_idle();
    EXPECT_EQ(rig.state(1), ChannelState::Ended);
    EXPECT_NEAR(rig.position(1), 30, 1e-9);
    EXPECT_NEAR(rig.position(2), -20, 1e-9);
    double worst = 0;
    for (const auto& p : path.points) worst = std::fmax(worst, off_path(p));
    EXPECT_LT(worst, 1e-6);
}

TEST(Retrace, IsHeldAndTurnedRoundAnywhere) {
    TickRig rig;
    push_path(rig);
    rig.start(1);
    rig.run(900);
    rig.command(CommandKind::FeedHold, 1);
    rig.run(200);
    const double x = rig.position(1);
    Path path(rig);
    rig.command(CommandKind::Retrace, 1, 1);
    rig.start(1);
    rig.run(250);
    rig.command(CommandKind::FeedHold, 1);
    rig.run(100);
    EXPECT_EQ(rig.state(1), ChannelState::Held);
    EXPECT_EQ(rig.speed_of(1), 0);
    EXPECT_LT(rig.position(1), x);
    rig.command(CommandKind::Retrace, 1, 0);
    rig.start(1);
    rig.run_until_idle();
    EXPECT_EQ(rig.state(1), ChannelState::Ended);
    EXPECT_NEAR(rig.position(1), 30, 1e-9);
    for (const auto& p : path.points) ASSERT_LT(off_path(p), 1e-6);
}

TEST(Retrace, EndsAtAFunction) {
    TickRig rig;
    rig.push(1, rig.line(1, {10, 0}, 50, kExactStop));
    rig.push(1, rig.aux(1, 'M', 8));
    rig.push(1, rig.line(1, {10, 0}, 50, kExactStop));
    rig.push(1, rig.stop(1, StopReason::M30));
    rig.start(1);
    rig.run(400);
    rig.command(CommandKind::FeedHold, 1);
    rig.run(100);
    ASSERT_GT(rig.position(1), 10);
    rig.command(CommandKind::Retrace, 1, 1);
    rig.start(1);
    rig.run_until_idle();
    EXPECT_NEAR(rig.position(1), 10, 1e-9);
    EXPECT_EQ(rig.state(1), ChannelState::Held);
    rig.start(1);  // forwards again
    rig.run_until_idle();
    EXPECT_EQ(rig.state(1), ChannelState::Ended);
    EXPECT_NEAR(rig.position(1), 20, 1e-9);
}

// M01: a wall where the machine has stood, also when the key is switched off meanwhile, and where
// the program was read anew behind it; one that was merely driven over leaves nothing.
TEST(Retrace, EndsAtAnOptionalStopThatCounted) {
    struct Row {
        const char* why;
        bool key;
        std::uint32_t flags;
        double back_to;
    };
    for (const Row& row :
         {Row{"stood there, key off since", true, 0, 10}, Row{"passed", false, 0, 0},
          Row{"passed, a barrier", false, kDrains, 10}}) {
        SCOPED_TRACE(row.why);
        TickRig rig;
        if (row.key) rig.command(CommandKind::OptionalStop, 1, 1);
        rig.push(1, rig.line(1, {10, 0}, 50, kExactStop));
        PathRecord m1 = rig.stop(1, StopReason::M01);
        m1.flags |= row.flags;
        rig.push(1, m1);
        rig.push(1, rig.line(1, {10, 0}, 50, kExactStop));
        rig.push(1, rig.stop(1, StopReason::M30));
        rig.start(1);
        if (row.key) {
            rig.run_until_idle();
            ASSERT_EQ(rig.state(1), ChannelState::ProgramStop);
            rig.command(CommandKind::OptionalStop, 1, 0);
            rig.start(1);
            rig.run(100);
        } else {
            rig.run(400);
        }
        rig.command(CommandKind::FeedHold, 1);
        rig.run(100);
        ASSERT_EQ(rig.state(1), ChannelState::Held);
        ASSERT_GT(rig.position(1), 10);
        EXPECT_EQ(rig.find(KernelEventKind::RecordBegin, 1, m1.note) != nullptr, row.key);
        EXPECT_EQ(rig.find(KernelEventKind::RecordEnd, 1, m1.note) != nullptr, row.key);
        rig.command(CommandKind::Retrace, 1, 1);
        rig.start(1);
        rig.run_until_idle();
        EXPECT_NEAR(rig.position(1), row.back_to, 1e-9);
    }
}

// At the stop behind a block that block is over: it lies on the way back once, not once more as the
// part that was driven.
TEST(Retrace, ABlockThatSingleBlockHasEndedIsDrivenBackOnce) {
    TickRig rig;
    push_path(rig);
    rig.command(CommandKind::SingleBlock, 1, 1);
    rig.start(1);
    rig.run_until_idle();
    rig.start(1);
    rig.run_until_idle();
    ASSERT_EQ(rig.state(1), ChannelState::ProgramStop);
    ASSERT_NEAR(rig.position(2), -20, 1e-9);
    Path path(rig);
    rig.command(CommandKind::Retrace, 1, 1);
    rig.start(1);
    rig.run_until_idle();
    EXPECT_FALSE(rig.alarmed(Alarm::RecordInvalid, 1));
    EXPECT_NEAR(rig.position(1), 0, 1e-9);
    EXPECT_NEAR(rig.position(2), 0, 1e-9);
    rig.command(CommandKind::SingleBlock, 1, 0);
    rig.command(CommandKind::Retrace, 1, 0);
    rig.start(1);
    rig.run_until_idle();
    EXPECT_EQ(rig.state(1), ChannelState::Ended);
    EXPECT_NEAR(rig.position(1), 30, 1e-9);
    double worst = 0, longest = 0;
    for (std::size_t i = 0; i < path.points.size(); ++i) {
        worst = std::fmax(worst, off_path(path.points[i]));
        if (i > 0)
            longest = std::fmax(longest, std::hypot(path.points[i][0] - path.points[i - 1][0],
                                                    path.points[i][1] - path.points[i - 1][1]));
    }
    EXPECT_LT(worst, 1e-6);
    EXPECT_LT(longest, 0.051) << "50 mm/s are 0.05 mm a tick";
}

// What the wheel takes back at such a stop, it takes back once too.
TEST(ProgramHandwheel, TakesABlockBackOnceThatSingleBlockHasEnded) {
    TickRig rig;
    push_path(rig);
    rig.command(CommandKind::SingleBlock, 1, 1);
    rig.start(1);
    rig.run_until_idle();
    rig.start(1);
    rig.run_until_idle();
    rig.command(CommandKind::ProgramHandwheel, 1, 1);
    rig.command(CommandKind::Handwheel, 1, -500, 0, 0, 1);
    rig.start(1);
    Path path(rig);
    rig.run_until_idle();
    EXPECT_FALSE(rig.alarmed(Alarm::RecordInvalid, 1));
    EXPECT_NEAR(rig.position(1), 0, 1e-6);
    EXPECT_NEAR(rig.position(2), 0, 1e-6);
    for (std::size_t i = 1; i < path.points.size(); ++i)
        ASSERT_LT(std::hypot(path.points[i][0] - path.points[i - 1][0],
                             path.points[i][1] - path.points[i - 1][1]),
                  0.051);
}

TEST(Retrace, IsRefusedWhileTheProgramRuns) {
    TickRig rig;
    push_path(rig);
    rig.start(1);
    rig.run(300);
    rig.command(CommandKind::Retrace, 1, 1);
    rig.run_until_idle();
    EXPECT_TRUE(rig.alarmed(Alarm::RetraceRefused, 1));
    EXPECT_EQ(rig.state(1), ChannelState::Ended);
}

// Whatever has moved the axes off the path: they are not set onto it, the way back is refused.
TEST(Retrace, IsRefusedWhereTheAxesAreNotOnThePathAnyMore) {
    TickRig rig;
    push_path(rig);
    rig.command(CommandKind::SingleBlock, 1, 1);
    rig.start(1);
    rig.run_until_idle();
    ASSERT_EQ(rig.state(1), ChannelState::ProgramStop);
    const double z = rig.position(2);
    for (int i = 1; i <= 100; ++i) {
        rig.machine->core().axes[1].move_to(z + i * 0.01);
        rig.run(1);
    }
    ASSERT_NEAR(rig.position(2), z + 1, 1e-9);
    rig.command(CommandKind::Retrace, 1, 1);
    rig.start(1);
    double last = rig.position(2), step = 0;
    rig.on_tick = [&] {
        step = std::fmax(step, std::fabs(rig.position(2) - last));
        last = rig.position(2);
    };
    rig.run(300);
    EXPECT_TRUE(rig.alarmed(Alarm::RecordInvalid, 1));
    EXPECT_EQ(step, 0);
}

TEST(Retrace, GoesThroughTheBlocksWithTheMachineLocked) {
    TickRig rig;
    push_path(rig);
    rig.command(CommandKind::MachineLock, 1, 1);
    rig.start(1);
    rig.run(900);
    rig.command(CommandKind::FeedHold, 1);
    rig.run(200);
    ASSERT_EQ(rig.state(1), ChannelState::Held);
    const double x = rig.position(1), z = rig.position(2);
    rig.command(CommandKind::Retrace, 1, 1);
    rig.start(1);
    rig.run_until_idle();
    EXPECT_FALSE(rig.alarmed(Alarm::RecordInvalid, 1));
    EXPECT_TRUE(rig.alarmed(Alarm::RetraceEnds, 1));
    rig.command(CommandKind::Retrace, 1, 0);
    rig.start(1);
    rig.run_until_idle();
    EXPECT_EQ(rig.state(1), ChannelState::Ended);
    EXPECT_EQ(rig.position(1), x);
    EXPECT_EQ(rig.position(2), z);
}

TEST(Retrace, ForgetsWithAReset) {
    TickRig rig;
    push_path(rig);
    rig.start(1);
    rig.run(500);
    rig.command(CommandKind::FeedHold, 1);
    rig.run(100);
    rig.command(CommandKind::Retrace, 1, 1);
    rig.start(1);
    rig.run(100);
    rig.command(CommandKind::Reset, 1);
    rig.run(200);
    EXPECT_EQ(rig.state(1), ChannelState::Reset);
    EXPECT_EQ(rig.speed_of(1), 0);
    EXPECT_EQ(rig.speed_of(2), 0);
}

// Two channels meet twice; the wheel takes them forwards, back through both waits, and forwards to
// the end.
TEST(ProgramHandwheel, DrivesAGroupForwardsAndBackThroughItsWaits) {
    TickRig rig;
    rig.push(1, rig.line(1, {10, 0}, 50, kExactStop));
    rig.push(1, rig.wait(1, 501, 3));
    rig.push(1, rig.line(1, {10, 0}, 50, kExactStop));
    rig.push(1, rig.wait(1, 502, 3));
    rig.push(1, rig.line(1, {10, 0}, 50, kExactStop));
    rig.push(1, rig.stop(1, StopReason::M30));
    rig.push(2, rig.line(2, {40, 0}, 50, kExactStop));
    rig.push(2, rig.wait(2, 501, 3));
    rig.push(2, rig.line(2, {5, 0}, 50, kExactStop));
    rig.push(2, rig.wait(2, 502, 3));
    rig.push(2, rig.line(2, {20, 0}, 50, kExactStop));
    rig.push(2, rig.stop(2, StopReason::M30));
    rig.command(CommandKind::ProgramHandwheel, 1, 1);
    rig.start(1);
    rig.start(2);
    rig.run(300);
    EXPECT_EQ(rig.position(1), 0) << "nothing moves before the wheel does";
    rig.command(CommandKind::Handwheel, 1, 60, 0, 0, 1);  // 1.2 s of the programs
    rig.run_until_idle();
    const double there1 = rig.position(1), there2 = rig.position(3);
    EXPECT_GT(there1, 20);
    EXPECT_LT(there1, 30);
    EXPECT_GT(there2, 45);
    // Neither may be between the waits while the other is not.
    rig.on_tick = [&] {
        const double a = rig.position(1), b = rig.position(3);
        EXPECT_FALSE(a < 10 - 1e-9 && b > 40 + 1e-9) << a << " " << b;
        EXPECT_FALSE(a > 10 + 1e-9 && b < 40 - 1e-9) << a << " " << b;
        EXPECT_FALSE(a < 20 - 1e-9 && b > 45 + 1e-9) << a << " " << b;
        EXPECT_FALSE(a > 20 + 1e-9 && b < 45 - 1e-9) << a << " " << b;
    };
    rig.command(CommandKind::Handwheel, 1, -500, 0, 0, 1);
    rig.run_until_idle();
    EXPECT_NEAR(rig.position(1), 0, 1e-6);
    EXPECT_NEAR(rig.position(3), 0, 1e-6);
    rig.command(CommandKind::Handwheel, 1, 500, 0, 0, 1);
    rig.run_until_idle();
    EXPECT_EQ(rig.state(1), ChannelState::Ended);
    EXPECT_EQ(rig.state(2), ChannelState::Ended);
    EXPECT_NEAR(rig.position(1), 30, 1e-9);
    EXPECT_NEAR(rig.position(3), 65, 1e-9);
}

TEST(ProgramHandwheel, MustBeSwitchedOnFirst) {
    TickRig rig;
    rig.command(CommandKind::Handwheel, 1, 10, 0, 0, 1);
    rig.run(5);
    EXPECT_TRUE(rig.alarmed(Alarm::NotReady, 1));
}

TEST(FirstPart, StopsBeforeEachTool) {
    TickRig rig;
    rig.command(CommandKind::FirstPart, 1, 1);
    rig.push(1, rig.line(1, {10, 0}, 50, kExactStop));
    rig.push(1, rig.aux(1, 'T', 202));
    rig.push(1, rig.line(1, {10, 0}, 50, kExactStop));
    rig.push(1, rig.stop(1, StopReason::M30));
    rig.start(1);
    rig.run_until_idle();
    EXPECT_EQ(rig.state(1), ChannelState::ProgramStop);
    EXPECT_EQ(rig.machine->channel(0).stop_reason(), StopReason::FirstPart);
    EXPECT_EQ(rig.machine->core().signals.nc(signals::cn_tcode(1)), 0);
    rig.start(1);
    rig.run_until_idle();
    EXPECT_EQ(rig.state(1), ChannelState::Ended);
    EXPECT_EQ(rig.machine->core().signals.nc(signals::cn_tcode(1)), 202);
}

}  // namespace
}  // namespace polyturn::kernel
