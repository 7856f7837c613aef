#include <algorithm>

#include "tests/unit/kernel/rig.hpp"

namespace polyturn::kernel {
namespace {

// S2 follows S1: SP_SYNCR of the PLC, or a record.
void two_spindles(params::Table& t, RunOptions&) {
    for (unsigned s = 1; s <= 2; ++s) {
        params::put(t, params::n0701_r1_spindle_gain, 20, s);
        params::put(t, params::n0761_r1_s_serrl1, 0, s);
        params::put(t, params::n0769_r1_s_serrl2, 0, s);
        params::put(t, params::n0777_r1_s_serrl3, 0, s);
    }
    params::put(t, params::pt_spindle_master, 1, 2);
}

void turn_main(TickRig& rig, double rpm, int code = 3) {
    rig.push(1, rig.spindle(1, rpm));
    rig.push(1, rig.aux(1, 'M', code));
    rig.start(1);
}
void request(TickRig& rig, std::uint32_t slot, double value) {
    rig.command(value != 0 ? CommandKind::SetSignal : CommandKind::ReleaseSignal, 0, value, 0, slot,
                1);
}

double apart(TickRig& rig, double ratio = 1.0) {  // degrees that S2 is ahead of ratio * S1
    const auto& s = rig.machine->core().spindles;
    return std::remainder(
        (s[1].simulated()->true_position() - ratio * s[0].simulated()->true_position()) * 360.0,
        360.0);
}

TEST(SpindleCoupling, TakesTheFollowerUpToTheTurningMasterWithinItsRamp) {
    TickRig rig(two_spindles);
    turn_main(rig, 1000);
    rig.run(1500);
    request(rig, signals::sp_syncr(2), 1);
    double before = 0, steepest = 0;
    for (int i = 0; i < 4000; ++i) {
        rig.tick();
        const double now = rig.machine->core().spindles[1].command();  // 1/min
        steepest = std::max(steepest, std::fabs(now - before) / 0.001);
        before = now;
    }
    EXPECT_LE(steepest, 1500 * 1.01);
    EXPECT_NEAR(rig.machine->core().spindles[1].speed(), 1000, 2);
    EXPECT_EQ(rig.machine->core().signals.nc(signals::sn_synca(2)), 1);
    EXPECT_EQ(rig.machine->core().signals.nc(signals::sn_follow(2)), 1);
    const double there = apart(rig);
    rig.run(500);
    EXPECT_NEAR(apart(rig), there, 0.3);
}

TEST(SpindleCoupling, KeepsThePhaseWhateverTheMasterDoes) {
    TickRig rig([](params::Table& t, RunOptions& o) {
        two_spindles(t, o);
        params::put(t, params::n0685_spindle_phase_shift, 1024, 2);  // a quarter of a turn
    });
    turn_main(rig, 800);
    rig.run(1500);
    request(rig, signals::sp_phaser(2), 1);
    request(rig, signals::sp_syncr(2), 1);
    rig.run(4000);
    ASSERT_EQ(rig.machine->core().signals.nc(signals::sn_synca(2)), 1);
    EXPECT_NEAR(apart(rig), 90, 0.3);
    rig.push(1, rig.spindle(1, 1500));
    for (int i = 0; i < 3000; ++i) {
        rig.tick();
        ASSERT_NEAR(apart(rig), 90, 3) << i;
    }
    EXPECT_NEAR(apart(rig), 90, 0.3);
    rig.push(1, rig.aux(1, 'M', 5));
    rig.run(4000);
    EXPECT_NEAR(rig.machine->core().spindles[0].speed(), 0, 0.5);
    EXPECT_NEAR(apart(rig), 90, 0.3);
}

// The drive of S2 turns a little faster than it is told (N0683): its loop alone leaves it ahead;
// N0785 pulls that out, and no more.
TEST(SpindleCoupling, IsPulledOntoItsPhaseByN0785) {
    double left[2];
    for (const bool pulled : {false, true}) {
        TickRig rig([&](params::Table& t, RunOptions& o) {
            two_spindles(t, o);
            params::put(t, params::n0683_spindle_speed_offset, 0.02, 2);  // V of 10
            params::put(t, params::n0785_r1_s_synchr_k, pulled ? 4 : 0, 2);
        });
        turn_main(rig, 600);
        rig.run(1500);
        request(rig, signals::sp_phaser(2), 1);
        request(rig, signals::sp_syncr(2), 1);
        rig.run(6000);
        left[pulled] = std::fabs(apart(rig));
        rig.run(4000);
        EXPECT_NEAR(std::fabs(apart(rig)), left[pulled], 0.5) << "it stays where it is";
        EXPECT_NEAR(rig.machine->core().spindles[1].speed(), 600, 3);
    }
    EXPECT_GT(left[false], 2.0) << "without it there is something to pull";
    EXPECT_LT(left[true], 0.5);
}

TEST(SpindleCoupling, FollowsBackwardsWithARatio) {
    TickRig rig([](params::Table& t, RunOptions& o) {
        two_spindles(t, o);
        params::put(t, params::pt_sync_turns, -2, 2);
    });
    turn_main(rig, 600);
    request(rig, signals::sp_syncr(2), 1);  // from standstill
    rig.run(4000);
    EXPECT_NEAR(rig.machine->core().spindles[1].speed(), -1200, 3);
    const double there = apart(rig, -2);
    rig.run(1000);
    EXPECT_NEAR(std::remainder(apart(rig, -2) - there, 360), 0, 0.5);
}

TEST(SpindleCoupling, MasterIsNoFasterThanItsFollowerCanBe) {
    TickRig rig([](params::Table& t, RunOptions& o) {
        two_spindles(t, o);
        params::put(t, params::n0650_r1_s_max, 900, 2);
    });
    turn_main(rig, 500);
    request(rig, signals::sp_syncr(2), 1);
    rig.run(3000);
    rig.push(1, rig.spindle(1, 3000));
    rig.run(5000);
    EXPECT_NEAR(rig.machine->core().spindles[0].speed(), 900, 2);
}

TEST(SpindleCoupling, RefusesAMasterThatIsTooFastAlready) {
    TickRig rig([](params::Table& t, RunOptions& o) {
        two_spindles(t, o);
        params::put(t, params::n0650_r1_s_max, 900, 2);
    });
    turn_main(rig, 2000);
    rig.run(2500);
    request(rig, signals::sp_syncr(2), 1);
    rig.run(50);
    EXPECT_TRUE(rig.alarmed(Alarm::SpindleCoupleRefused));
    EXPECT_EQ(rig.machine->core().signals.nc(signals::sn_follow(2)), 0);
}

TEST(SpindleCoupling, GoesOnByItselfWhenItEnds) {
    TickRig rig(two_spindles);
    turn_main(rig, 1000);
    request(rig, signals::sp_syncr(2), 1);
    rig.run(4000);
    request(rig, signals::sp_syncr(2), 0);
    double before = rig.machine->core().spindles[1].command();
    rig.run(200);
    const double now = rig.machine->core().spindles[1].speed();
    EXPECT_GT(now, before - 1500 * 0.25);  // brakes on its ramp, for nobody turns it
    rig.run(2000);
    EXPECT_NEAR(rig.machine->core().spindles[1].speed(), 0, 0.5);
}

TEST(SpindleCoupling, OfAProgramHoldsItUntilItRunsSynchronously) {
    TickRig rig(two_spindles);
    turn_main(rig, 1000);
    rig.run(1500);
    PathRecord on = rig.blank(1, RecordKind::SpindleMode);
    on.code = static_cast<std::int32_t>(SpindleModeCode::Couple);
    on.spindle = 1;
    on.axis[0] = static_cast<std::uint8_t>(kMaxAxes + 1);
    on.axis[1] = kNoHelix;
    on.shape[0] = 2;
    on.shape[1] = 1;
    on.shape[2] = 0;
    on.mask = 2;
    rig.push(1, on);
    rig.push(1, rig.line(1, {0, -1}, 10));
    rig.run(50);
    EXPECT_EQ(rig.position(2), 0.0);
    rig.run(9000);
    EXPECT_NEAR(rig.position(2), -1, 1e-9);
    EXPECT_NEAR(rig.machine->core().spindles[1].speed(), 2000, 5);
    rig.push(2, rig.spindle(2, 500, 2));  // nobody commands a follower
    rig.start(2);
    rig.run(10);
    EXPECT_TRUE(rig.alarmed(Alarm::SpindleFollows, 2));
    PathRecord off = on;
    off.code = static_cast<std::int32_t>(SpindleModeCode::Uncouple);
    off.note = 0;
    rig.push(1, off);
    rig.push(1, rig.line(1, {0, 1}, 10));
    rig.run(3000);
    EXPECT_NEAR(rig.position(2), 0, 1e-9);
    EXPECT_NEAR(rig.machine->core().spindles[1].speed(), 0, 0.5);
}

TEST(SpindleCoupling, TellsATornFollowerFromALaggingOne) {
    TickRig rig([](params::Table& t, RunOptions& o) {
        two_spindles(t, o);
        params::put(t, params::pt_sync_error, 5, 2);
    });
    turn_main(rig, 1000);
    request(rig, signals::sp_syncr(2), 1);
    rig.run(4000);
    ASSERT_FALSE(rig.alarmed(Alarm::SpindleSlipped));
    rig.machine->core().spindles[1].simulated()->jam(true);
    rig.run(500);
    EXPECT_TRUE(rig.alarmed(Alarm::SpindleSlipped));
    EXPECT_EQ(rig.machine->core().state, MachineState::EmergencyStop);
}

// A cut of the channel that owns the follower: M3 on it says nothing of the way it turns now
// (sinumerik part 3, 7.18).
TEST(SpindleCoupling, ACutWaitsForTheFollowerToRunSynchronouslyAndNotForItsOwnM3) {
    TickRig rig([](params::Table& t, RunOptions& o) {
        two_spindles(t, o);
        params::put(t, params::pt_sync_turns, -2, 2);
    });
    rig.plc_program = [](const PlcInputs& in, PlcOutputs& out) {
        TickRig::lathe(in, out);
        out.signal[signals::sp_rot(2)] = 3;
    };
    turn_main(rig, 600);
    rig.push(2, rig.spindle(2, 500, 2));
    rig.push(2, rig.dwell(2, 2.0));
    rig.push(2, rig.line(2, {0, -1}, 10));
    rig.start(2);
    rig.run(1500);
    request(rig, signals::sp_syncr(2), 1);
    bool early = false, was_synchronous = false;
    rig.on_tick = [&] {
        was_synchronous = was_synchronous || rig.machine->core().spindles[1].follows_well();
        early = early || (rig.position(4) != 0 && !was_synchronous);
    };
    rig.run(18'000);
    EXPECT_EQ(rig.machine->core().signals.nc(signals::sn_synca(2)), 1);
    EXPECT_NEAR(rig.machine->core().spindles[1].speed(), -1200, 3);
    EXPECT_FALSE(rig.alarmed(Alarm::SpindleTooSlow));
    EXPECT_NEAR(rig.position(4), -1, 1e-9);
    EXPECT_FALSE(early);
}

PathRecord coupling_of_s2(TickRig& rig) {
    PathRecord on = rig.blank(1, RecordKind::SpindleMode);
    on.code = static_cast<std::int32_t>(SpindleModeCode::Couple);
    on.spindle = 1;
    on.axis[0] = static_cast<std::uint8_t>(kMaxAxes + 1);
    on.axis[1] = kNoHelix;
    on.shape[0] = 1;
    on.shape[1] = 1;
    on.shape[2] = 0;
    return on;
}

// A5 is C of L2 on S2. Whoever machines with it keeps it, in hold and at a barrier too; behind the
// end of the program it is free.
TEST(SpindleCoupling, DoesNotTakeTheDriveOfACAxisWithWhichAnotherProgramWorks) {
    enum class Owner { Works, Holds, Waits, Ended };
    for (const Owner owner : {Owner::Works, Owner::Holds, Owner::Waits, Owner::Ended}) {
        SCOPED_TRACE(static_cast<int>(owner));
        TickRig rig([](params::Table& t, RunOptions& o) {
            two_spindles(t, o);
            params::put(t, params::n0002_axis_assign, 2, 5);
            params::put(t, params::n0106_axis_properties, 2, 5);
            params::put(t, params::n0503_axis_output_address, 41, 5);
            params::put(t, params::n0603_spindle_output_address, 41, 2);
            params::put(t, params::n0304_rapid, 36000, 5);
            params::put(t, params::n0305_max_feed, 36000, 5);
            params::put(t, params::n0400_acceleration, 3600, 5);
            params::put(t, params::n0401_acc_tc, 0.05, 5);
            params::put(t, params::n0504_position_gain, 40, 5);
            params::put(t, params::n0511_feedforward, 1, 5);
            params::put(t, params::n0515_feed_forward_control, 3, 5);
            params::put(t, params::n0516_inpos, 0.01, 5);
            o.start_known[4] = 1;
        });
        PathRecord turn = rig.line(2, {0.001, 0}, 100);
        turn.axis_count = 1;
        turn.axis[0] = 4;
        turn.start[0] = 0;
        turn.end[0] = turn.length = 30;
        turn.v_max = 600;
        turn.a_max = 3600;
        turn.j_max = 72000;
        rig.push(2, turn);
        if (owner == Owner::Waits)
            rig.push(2, rig.wait(2, 500, 0b11));
        else if (owner == Owner::Ended)
            rig.push(2, rig.stop(2, StopReason::M30));
        else
            rig.push(2, rig.dwell(2, 100));
        rig.start(2);
        rig.run(1000);
        if (owner == Owner::Holds) rig.command(CommandKind::FeedHold, 2);
        rig.run(200);
        ASSERT_NEAR(rig.position(5), 30, 1e-9);
        ASSERT_EQ(rig.machine->core().signals.nc(signals::sn_axis(2)), 1);
        rig.push(1, coupling_of_s2(rig));
        rig.start(1);
        rig.run(500);
        const bool free = owner == Owner::Ended;
        EXPECT_EQ(rig.alarmed(Alarm::SpindleCoupleRefused, 1), !free);
        EXPECT_EQ(rig.machine->core().signals.nc(signals::sn_axis(2)), free ? 0 : 1);
        EXPECT_EQ(rig.machine->core().signals.nc(signals::sn_follow(2)), free ? 1 : 0);
    }
}

// its thread, tap or constant surface speed
TEST(SpindleCoupling, DoesNotTakeASpindleThatAnotherChannelNeeds) {
    for (const std::uint32_t locked_by : {0u, 1u, 2u}) {
        TickRig rig(two_spindles);
        rig.machine->core().spindles[1].locked_by = locked_by;
        rig.push(1, coupling_of_s2(rig));
        rig.start(1);
        rig.run(500);
        EXPECT_EQ(rig.alarmed(Alarm::SpindleCoupleRefused, 1), locked_by == 2) << locked_by;
        EXPECT_EQ(rig.machine->core().signals.nc(signals::sn_follow(2)), locked_by == 2 ? 0 : 1)
            << locked_by;
    }
}

}  // namespace
}  // namespace polyturn::kernel
