#include "tests/unit/kernel/rig.hpp"

namespace polyturn::kernel {
namespace {

PathRecord thread_record(TickRig& rig, double length, double lead,
                         std::uint32_t flags = kThreadEnd) {
    PathRecord r = rig.line(1, {0, -length}, 0, kThread | kOverrideLocked | kExactStop | flags);
    r.feed_mode = static_cast<std::uint8_t>(FeedMode::Thread);
    r.lead = lead;
    r.start_angle = 90;
    return r;
}
void turn(TickRig& rig, double rpm, int direction = 3) {
    rig.push(1, rig.spindle(1, rpm));
    rig.push(1, rig.aux(1, 'M', direction));
}

class ThreadPhaseOf : public ::testing::TestWithParam<double> {};

TEST_P(ThreadPhaseOf, IsThatOfTheStartAngle) {
    const double rpm = GetParam(), lead = 2.0;
    TickRig rig;
    turn(rig, rpm);
    rig.push(1, thread_record(rig, 40, lead));
    rig.push(1, rig.stop(1, StopReason::M30));
    rig.start(1);
    double worst_cmd = 0, worst_act = 0;
    double angle_before = 0;
    int samples = 0;
    rig.on_tick = [&] {
        const auto& core = rig.machine->core();
        const double cmd = core.axes[1].command();
        // The measured position belongs to the moment of the command a tick ago.
        const double true_angle = core.spindles[0].true_angle();
        const auto off = [](double phase) { return phase - 360 * std::round(phase / 360); };
        if (cmd < -20 && cmd > -36) {  // constant pitch, run-in over
            worst_cmd = std::max(worst_cmd, std::fabs(off(-cmd / lead * 360 - (true_angle - 90))));
            const double act = core.axes[1].measured();
            worst_act =
                std::max(worst_act, std::fabs(off(-act / lead * 360 - (angle_before - 90))));
            ++samples;
        }
        angle_before = true_angle;
    };
    rig.run_until_idle();
    EXPECT_EQ(rig.state(1), ChannelState::Ended);
    EXPECT_NEAR(rig.position(2), -40, 1e-9);
    EXPECT_GT(samples, 50);
    EXPECT_LT(worst_cmd, 0.02) << rpm;
    EXPECT_LT(worst_act, 0.1) << rpm;
}
INSTANTIATE_TEST_SUITE_P(Speeds, ThreadPhaseOf,
                         ::testing::Values(300.0, 500.0, 777.0, 1000.0, 1500.0));

TEST(Thread, HoldActsBehindIt) {
    TickRig rig;
    turn(rig, 500);
    rig.push(1, thread_record(rig, 20, 2));
    rig.push(1, rig.line(1, {10, 0}, 50));
    rig.start(1);
    while (rig.position(2) > -5) rig.tick();
    rig.command(CommandKind::FeedHold, 1);
    rig.run_until_idle();
    EXPECT_NEAR(rig.position(2), -20, 1e-9);
    EXPECT_EQ(rig.position(1), 0);
    EXPECT_EQ(rig.state(1), ChannelState::Held);
}

TEST(Thread, OfAnyStandingSpindleIsAnAlarm) {
    TickRig rig;
    rig.push(1, thread_record(rig, 20, 2));
    rig.start(1);
    rig.run_until_idle();
    EXPECT_TRUE(rig.alarmed(Alarm::ThreadSpindleStands, 1));
    EXPECT_EQ(rig.position(2), 0);
}

TEST(Thread, TooFastForTheAxesNamesTheSpeedThatWouldDo) {
    TickRig rig;
    turn(rig, 4000);
    rig.push(1, thread_record(rig, 50, 4));  // 267 mm/s, the axis does 200
    rig.start(1);
    rig.run_until_idle();
    ASSERT_TRUE(rig.alarmed(Alarm::ThreadSpindleTooFast, 1));
    for (const KernelEvent& e : rig.log)
        if (e.code == static_cast<int>(Alarm::ThreadSpindleTooFast)) {
            EXPECT_NE(std::string(e.text.data()).find("3000 1/min"), std::string::npos)
                << e.text.data();
        }
}

TEST(Thread, StartsOnlyWhenItIsWhollyThere) {
    TickRig rig;
    turn(rig, 500);
    rig.push(1, thread_record(rig, 20, 2, 0));
    rig.start(1);
    rig.run(2000);
    EXPECT_EQ(rig.position(2), 0);
    PathRecord last = thread_record(rig, 10, 2, kThreadEnd | kThreadChained);
    rig.push(1, last);
    rig.run_until_idle();
    EXPECT_NEAR(rig.position(2), -30, 1e-9);
    EXPECT_TRUE(rig.find(KernelEventKind::RecordEnd, 1, last.note));
}

TEST(Thread, IsDrivenToItsEndWhenItsChannelDies) {
    TickRig rig;
    turn(rig, 500);
    rig.push(1, thread_record(rig, 20, 2));
    rig.push(1, rig.line(1, {10, 0}, 50));
    rig.start(1);
    while (rig.position(2) > -5) rig.tick();
    rig.command(CommandKind::ProcessDied, 0, 0, 0, static_cast<std::uint32_t>(kProcessChannel));
    rig.run_until_idle();
    EXPECT_NEAR(rig.position(2), -20, 1e-9);
    EXPECT_EQ(rig.position(1), 0);
    EXPECT_EQ(rig.state(1), ChannelState::Dead);
}

// A thread at X 0 whose way out is 4 mm in X. Limits of the raw differences of `.cmd` are watched
// on the whole way.
struct HeldThread {
    TickRig rig;
    PathRecord thread;
    std::array<double, 2> last{}, last_v{};
    double most_v = 0, most_a = 0;

    HeldThread() {
        turn(rig, 600);
        thread = thread_record(rig, 40, 2);
        thread.retract[0] = 4;
        rig.push(1, thread);
        rig.push(1, rig.line(1, {10, 0}, 50));
        rig.push(1, rig.stop(1, StopReason::M30));
        rig.on_tick = [this] {
            for (unsigned a = 0; a < 2; ++a) {
                const double v = (rig.position(a + 1) - last[a]) / 0.001;
                most_v = std::max(most_v, std::fabs(v));
                most_a = std::max(most_a, std::fabs(v - last_v[a]) / 0.001);
                last[a] = rig.position(a + 1);
                last_v[a] = v;
            }
        };
        rig.start(1);
        while (rig.position(2) > -15) rig.tick();
    }
};

TEST(ThreadRetract, HoldLeavesTheThreadAndStandsOutsideIt) {
    HeldThread t;
    double z_when_clear = 0;
    t.rig.command(CommandKind::FeedHold, 1);
    while (t.rig.state(1) != ChannelState::Held) {
        t.rig.tick();
        if (t.rig.position(1) < 4 - 1e-6) z_when_clear = t.rig.position(2);
        ASSERT_GT(t.rig.position(2), -40);
    }
    t.rig.run(50);
    EXPECT_NEAR(t.rig.position(1), 4, 1e-6);
    EXPECT_LT(t.rig.position(2), -15);
    EXPECT_GT(t.rig.position(2), -35);  // not to the end of the thread
    // the thread goes on until the tool is out
    EXPECT_LE(t.rig.position(2), z_when_clear + 1e-9);
    EXPECT_TRUE(t.rig.find(KernelEventKind::RecordEnd, 1, t.thread.note));
    EXPECT_LT(t.most_v, TickRig::kVelocity * 1.01);
    EXPECT_LT(t.most_a, TickRig::kAcceleration * 1.01);
}

TEST(ThreadRetract, CycleStartRepeatsThePassFromItsBeginningWithTheSamePhase) {
    HeldThread t;
    t.rig.command(CommandKind::FeedHold, 1);
    while (t.rig.state(1) != ChannelState::Held) t.rig.tick();
    const double z_out = t.rig.position(2);
    bool crossed_in_the_part = false;
    double worst = 0;
    bool pass = false;
    const auto watch = t.rig.on_tick;
    t.rig.on_tick = [&] {
        watch();
        const double x = t.rig.position(1), z = t.rig.position(2);
        // back along Z outside, then in
        if (!pass && x < 4 - 1e-6 && z < -1e-6 && z > z_out + 1e-6) crossed_in_the_part = true;
        if (std::fabs(x) < 1e-9 && std::fabs(z) < 1e-9) pass = true;
        if (pass && z < -20 && z > -36) {
            const double phase =
                -z / 2.0 * 360 - (t.rig.machine->core().spindles[0].true_angle() - 90);
            worst = std::max(worst, std::fabs(phase - 360 * std::round(phase / 360)));
        }
    };
    t.rig.start(1);
    t.rig.run_until_idle();
    EXPECT_TRUE(pass);
    EXPECT_FALSE(crossed_in_the_part);
    EXPECT_LT(worst, 0.02);
    EXPECT_EQ(t.rig.state(1), ChannelState::Ended);
    EXPECT_NEAR(t.rig.position(1), 10, 1e-9);
    EXPECT_NEAR(t.rig.position(2), -40, 1e-9);
    EXPECT_LT(t.most_v, TickRig::kVelocity * 1.01);
    EXPECT_LT(t.most_a, TickRig::kAcceleration * 1.01);
}

TEST(ThreadRetract, HoldOnTheWayBackStandsAndGoesOn) {
    HeldThread t;
    t.rig.command(CommandKind::FeedHold, 1);
    while (t.rig.state(1) != ChannelState::Held) t.rig.tick();
    t.rig.start(1);
    t.rig.run(60);
    t.rig.command(CommandKind::FeedHold, 1);
    while (t.rig.state(1) != ChannelState::Held) t.rig.tick();
    t.rig.run(20);
    EXPECT_NEAR(t.rig.position(1), 4, 1e-6);
    t.rig.start(1);
    t.rig.run_until_idle();
    EXPECT_NEAR(t.rig.position(2), -40, 1e-9);
    EXPECT_EQ(t.rig.state(1), ChannelState::Ended);
}

TEST(ThreadRetract, ResetAndDeathActOutsideTheThread) {
    for (const bool dies : {false, true}) {
        HeldThread t;
        if (dies)
            t.rig.command(CommandKind::ProcessDied, 0, 0, 0,
                          static_cast<std::uint32_t>(kProcessChannel));
        else
            t.rig.command(CommandKind::Reset, 1);
        t.rig.run_until_idle();
        EXPECT_NEAR(t.rig.position(1), 4, 1e-6) << dies;
        EXPECT_GT(t.rig.position(2), -38) << dies;
        EXPECT_EQ(t.rig.state(1), dies ? ChannelState::Dead : ChannelState::Reset);
    }
}

TEST(ThreadRetract, NearTheEndTheThreadEndsWhileTheToolLeaves) {
    HeldThread t;
    while (t.rig.position(2) > -38.8) t.rig.tick();
    t.rig.command(CommandKind::FeedHold, 1);
    while (t.rig.state(1) != ChannelState::Held) t.rig.tick();
    EXPECT_GE(t.rig.position(2), -40 - 1e-9);
    EXPECT_NEAR(t.rig.position(1), 4, 1e-6);
    t.rig.start(1);
    t.rig.run_until_idle();
    EXPECT_EQ(t.rig.state(1), ChannelState::Ended);
}

TEST(ThreadRetract, EmergencyStopEndsAtRest) {
    HeldThread t;
    t.rig.command(CommandKind::FeedHold, 1);
    t.rig.run(20);
    t.rig.command(CommandKind::EmergencyStop);
    t.rig.run(3000);
    EXPECT_EQ(t.rig.speed_of(1), 0);
    EXPECT_EQ(t.rig.speed_of(2), 0);
}

}  // namespace
}  // namespace polyturn::kernel
