#include <algorithm>

#include "tests/unit/kernel/rig.hpp"

namespace polyturn::kernel {
namespace {

void set(TickRig& rig, std::uint32_t slot, double value) {
    rig.command(CommandKind::SetSignal, 0, value, 0, slot, 1);
}

TEST(PositioningAxis, PlcAxesGoTogetherEachWithItsFeed) {
    TickRig rig;
    set(rig, signals::ap_paxpos(3), 20'000);
    set(rig, signals::ap_paxfeed(3), 1200);
    set(rig, signals::ap_paxpos(4), -5'000);
    set(rig, signals::ap_paxr(3), 1);
    set(rig, signals::ap_paxr(4), 1);
    rig.run(100);
    EXPECT_EQ(rig.machine->core().signals.nc(signals::an_paxa(3)), 1);
    EXPECT_NEAR(rig.speed_of(3), 20, 0.1);
    rig.run(1500);
    EXPECT_NEAR(rig.position(3), 20, 1e-9);
    EXPECT_NEAR(rig.position(4), -5, 1e-9);
    EXPECT_EQ(rig.machine->core().signals.nc(signals::an_paxa(3)), 0);
    int begun = 0, ended = 0;
    for (const KernelEvent& e : rig.log) {
        begun += e.kind == static_cast<std::uint32_t>(KernelEventKind::PositioningBegin);
        ended += e.kind == static_cast<std::uint32_t>(KernelEventKind::PositioningEnd);
    }
    EXPECT_EQ(begun, 2);
    EXPECT_EQ(ended, 2);
}

TEST(PositioningAxis, StopsWhenThePlcTakesItsRequestBack) {
    TickRig rig;
    set(rig, signals::ap_paxpos(3), 100'000);
    set(rig, signals::ap_paxfeed(3), 600);
    set(rig, signals::ap_paxr(3), 1);
    rig.run(1000);
    set(rig, signals::ap_paxr(3), 0);
    rig.run(300);
    EXPECT_NEAR(rig.position(3), 10, 1);
    EXPECT_EQ(rig.machine->core().signals.nc(signals::an_paxa(3)), 0);
}

TEST(PositioningAxis, AnAxisOfAMovingProgramIsRefused) {
    TickRig rig;
    rig.push(1, rig.line(1, {50, 0}, 10));
    rig.start(1);
    rig.run(100);
    set(rig, signals::ap_paxr(1), 1);
    rig.run(50);
    EXPECT_TRUE(rig.alarmed(Alarm::PositioningRefused, 1));
    rig.run(5500);
    EXPECT_NEAR(rig.position(1), 50, 1e-9);
}

TEST(PositioningAxis, PositioningAxisOfAProgramRunsWhileItCutsAndIsWaitedFor) {
    TickRig rig;
    PathRecord beside = rig.blank(1, RecordKind::PositioningAxis);
    beside.axis_count = 1;
    beside.axis[0] = 0;
    beside.end[0] = 30;
    beside.v_max = 15;
    rig.push(1, beside);
    rig.push(1, rig.line(1, {0, 10}, 20));
    PathRecord await = rig.blank(1, RecordKind::Await);
    await.axis_count = 1;
    await.axis[0] = 0;
    rig.push(1, await);
    rig.place(1, 0, 30);
    rig.push(1, rig.line(1, {0, 10}, 20));
    rig.start(1);
    rig.run(800);
    EXPECT_NEAR(rig.position(2), 10, 1e-9);
    EXPECT_GT(rig.position(1), 10);
    rig.run(500);
    EXPECT_NEAR(rig.position(2), 10, 1e-9);
    rig.run(2000);
    EXPECT_NEAR(rig.position(1), 30, 1e-9);
    EXPECT_NEAR(rig.position(2), 20, 1e-9);
}

PathRecord to_place(TickRig& rig, double end, double speed) {
    PathRecord beside = rig.blank(1, RecordKind::PositioningAxis);
    beside.axis_count = 1;
    beside.axis[0] = 0;
    beside.end[0] = end;
    beside.v_max = speed;
    return beside;
}

TEST(PositioningAxis, PositioningAxisObeysTheOverrideAndTheHoldOfItsProgram) {
    TickRig rig;
    rig.push(1, to_place(rig, 30, 20));
    rig.push(1, rig.dwell(1, 10));
    rig.command(CommandKind::FeedOverride, 1, 0.5);
    rig.start(1);
    rig.run(500);
    EXPECT_NEAR(rig.speed_of(1), 10, 0.1);
    rig.command(CommandKind::FeedHold, 1);
    rig.run(300);
    const double held = rig.position(1);
    EXPECT_EQ(rig.speed_of(1), 0);
    rig.run(500);
    EXPECT_EQ(rig.position(1), held);
    rig.start(1);
    rig.command(CommandKind::FeedOverride, 1, 1);
    rig.run(2000);
    EXPECT_NEAR(rig.position(1), 30, 1e-9);
    EXPECT_FALSE(rig.alarmed(Alarm::NotReady));
}

TEST(PositioningAxis, AResetEndsThePositioningAxisOfItsProgramOnly) {
    TickRig rig;
    rig.push(1, to_place(rig, 100, 20));
    rig.push(1, rig.dwell(1, 10));
    rig.start(1);
    set(rig, signals::ap_paxpos(3), 100'000);
    set(rig, signals::ap_paxfeed(3), 1200);
    set(rig, signals::ap_paxr(3), 1);
    rig.run(500);
    rig.command(CommandKind::Reset, 1);
    rig.run(400);
    EXPECT_LT(rig.position(1), 20);
    EXPECT_EQ(rig.speed_of(1), 0);
}

TEST(PositioningAxis, ASpindlePositionedBesideThePathIsWaitedForWhereTheProgramSays) {
    TickRig rig;
    rig.plc_program = [](const PlcInputs& in, PlcOutputs& out) {
        TickRig::lathe(in, out);
        if (in.signal[signals::cn_mcode(1)] != 19) return;
        out.signal[signals::sp_rot(1)] = 19;
        out.signal[signals::sp_oreq(1)] = 1;
        if (!in.signal[signals::sn_inpos(1)])
            out.signal[signals::cp_mfin(1)] = in.signal[signals::cn_mstr(1)] - 1;
    };
    PathRecord place = rig.blank(1, RecordKind::SpindleMode);
    place.code = static_cast<std::int32_t>(SpindleModeCode::Position);
    place.value = 90;
    place.spindle = 1;
    place.flags |= kPositioning;
    rig.push(1, place);
    PathRecord orient = rig.aux(1, 'M', 19);
    orient.flags |= kPositioning;
    rig.push(1, orient);
    rig.push(1, rig.line(1, {5, 0}, 100));
    PathRecord await = rig.blank(1, RecordKind::Await);
    await.axis_count = 1;
    await.axis[0] = static_cast<std::uint8_t>(kMaxAxes);
    rig.push(1, await);
    rig.push(1, rig.line(1, {5, 0}, 100));
    rig.start(1);
    rig.run(250);
    EXPECT_NEAR(rig.position(1), 5, 1e-9);  // it has not waited to begin
    EXPECT_FALSE(rig.machine->core().spindles[0].in_position());
    for (int i = 0; i < 20'000 && rig.position(1) < 5.001; ++i) rig.tick();
    EXPECT_TRUE(rig.machine->core().spindles[0].closed());
    EXPECT_TRUE(rig.machine->core().spindles[0].in_position());
    rig.run(500);
    EXPECT_NEAR(rig.position(1), 10, 1e-9);
}

TEST(Superposed, HandwheelAddsItsWayToARunningProgramWithinTheLimitsOfTheAxis) {
    TickRig rig;
    rig.command(CommandKind::Superpose, 1);
    rig.run(2);
    rig.push(1, rig.line(1, {100, 0}, 1000, kRapid));
    rig.start(1);
    rig.run(50);
    rig.command(CommandKind::Handwheel, 0, 2000, 0, 1, 1);  // 2 mm
    double before = rig.position(1), v = rig.speed_of(1);
    for (int i = 0; i < 3000; ++i) {
        rig.tick();
        const double speed = (rig.position(1) - before) * 1000;
        EXPECT_LE(std::fabs(speed), TickRig::kVelocity * 1.0001);
        EXPECT_LE(std::fabs(speed - v) * 1000, TickRig::kAcceleration * 1.001);
        before = rig.position(1);
        v = speed;
    }
    EXPECT_NEAR(rig.position(1), 102, 1e-6);
    EXPECT_NEAR(rig.machine->core().axes[0].overlay(), 2, 1e-9);
    EXPECT_NEAR(rig.machine->core().axes[0].own(), 100, 1e-9);
    rig.command(CommandKind::Reset, 1);
    rig.run(50);
    EXPECT_NEAR(rig.position(1), 102, 1e-6);
    EXPECT_NEAR(rig.machine->core().axes[0].own(), 102, 1e-6);  // it is the axis' own position now
}

TEST(Retract, LeavesTheWorkWhenTheMainsFail) {
    TickRig rig([](params::Table& t, RunOptions&) {
        params::put(t, params::pt_retract, 5, 1);
        params::put(t, params::pt_retract, 2.5, 2);
    });
    rig.push(1, rig.line(1, {0, -80}, 20));
    rig.start(1);
    rig.run(1000);
    set(rig, signals::plc_power(), 1);
    rig.run(30);
    EXPECT_TRUE(rig.alarmed(Alarm::PowerFailed));
    EXPECT_EQ(rig.machine->core().signals.nc(signals::cn_retract(1)), 1);
    rig.run(800);
    EXPECT_NEAR(rig.position(1), 5, 1e-9);
    EXPECT_LT(rig.position(2), -15);
    EXPECT_EQ(rig.machine->core().signals.nc(signals::cn_retract(1)), 0);
    EXPECT_TRUE(rig.machine->core().all_stop);
}

TEST(Retract, LeavesTheWorkWhenAPartnerDies) {
    TickRig rig([](params::Table& t, RunOptions&) {
        params::put(t, params::pt_partner_death, 3, 1);
        params::put(t, params::pt_retract, 5, 1);
        params::put(t, params::pt_retract, 3, 3);
    });
    rig.push(1, rig.line(1, {0, -80}, 20));
    rig.push(2, rig.line(2, {0, -80}, 20));
    rig.start(1);
    rig.start(2);
    rig.run(500);
    rig.command(CommandKind::ProcessDied, 0, 0, 0, static_cast<std::uint32_t>(kProcessChannel) + 1);
    rig.run(9000);  // what the dead one had committed is driven to its end
    EXPECT_TRUE(rig.alarmed(Alarm::ChannelDied, 2));
    EXPECT_NEAR(rig.position(1), 5, 1e-9);
    EXPECT_LT(rig.position(2), -9);
    EXPECT_GT(rig.position(2), -15);
    EXPECT_NEAR(rig.position(3), 3, 1e-9);
    EXPECT_EQ(rig.state(1), ChannelState::Interrupted);
}

TEST(Home, AProgramFindsTheReferencePointOfAnAxisThatHasNone) {
    TickRig rig([](params::Table& t, RunOptions& o) {
        o.ready = 1;
        params::put(t, params::n0900_reference_type, 2, 2);  // the first zero pulse
        params::put(t, params::n0904_zerodis, 5, 2);
        params::put(t, params::n0303_ref_feed, 600, 2);
        params::put(t, params::n0302_ref_rapid, 1200, 2);
        params::put(t, params::n0200_reference_position1, 7, 2);
        params::put(t, params::pt_ref_order, 0, 2);
    });
    rig.machine->core().axes[1].referenced = false;
    PathRecord home = rig.blank(1, RecordKind::Home);
    home.axis_count = 2;
    home.axis[0] = 0;
    home.axis[1] = 1;
    home.flags |= kDrains;
    rig.push(1, home);
    rig.start(1);
    rig.run(6000);
    EXPECT_TRUE(rig.machine->core().axes[1].referenced);
    EXPECT_FALSE(rig.machine->core().axes[1].moving());
    EXPECT_EQ(rig.position(1), 0);  // it had one
    EXPECT_FALSE(rig.find(KernelEventKind::Alarm));
    EXPECT_FALSE(rig.heard[0].empty());
    EXPECT_EQ(rig.heard[0].back().kind,
              static_cast<std::uint32_t>(ChannelEventKind::BarrierReached));
}

TEST(FixedStop, HoldsTheAxisWhereItIsMetAndComesBackWhenReleased) {
    TickRig rig([](params::Table& t, RunOptions&) {
        params::put(t, params::pt_drive_stop, 12.0, 2);
        params::put(t, params::pt_stop_error, 0.05, 2);
    });
    set(rig, signals::ap_torq(2), 100);
    rig.run(20);
    rig.push(1, [&] {
        PathRecord r = rig.line(1, {0, 40}, 10);
        r.flags |= kSkipMove | kFixedStop | kDrains;
        r.code = -1;
        return r;
    }());
    rig.start(1);
    rig.run(2500);
    EXPECT_EQ(rig.machine->core().signals.nc(signals::an_fixed(2)), 1);
    EXPECT_NEAR(rig.machine->core().axes[1].measured(), 12, 1e-3);
    EXPECT_LT(rig.position(2), 14);
    EXPECT_EQ(rig.machine->core().state, MachineState::On);
    set(rig, signals::ap_torq(2), 0);
    rig.run(800);
    EXPECT_NEAR(rig.position(2), 12, 1e-2);
    EXPECT_EQ(rig.machine->core().signals.nc(signals::an_fixed(2)), 0);
}

TEST(FixedStop, AProgramLimitsTheTorqueItselfAndTheWayWithoutAStopIsAnAlarm) {
    for (const bool there : {true, false}) {
        TickRig rig([&](params::Table& t, RunOptions&) {
            if (there) params::put(t, params::pt_drive_stop, 12.0, 2);
            params::put(t, params::pt_stop_error, 0.05, 2);
        });
        const auto torque = [&](double value) {
            PathRecord r = rig.blank(1, RecordKind::Torque);
            r.axis_count = 1;
            r.axis[0] = 1;
            r.value = value;
            return r;
        };
        rig.push(1, torque(100));
        PathRecord move = rig.line(1, {0, 40}, 10);
        move.flags |= kSkipMove | kFixedStop | kStopMustCome;
        move.code = -1;
        rig.push(1, move);
        rig.push(1, torque(0));
        rig.start(1);
        rig.run(there ? 2500 : 6000);
        EXPECT_EQ(rig.alarmed(Alarm::FixedStopMissed, 1), !there);
        if (!there) continue;
        rig.run(500);
        EXPECT_EQ(rig.machine->core().signals.nc(signals::an_fixed(2)), 0);
        EXPECT_NEAR(rig.position(2), 12, 1e-2);
        EXPECT_FALSE(rig.machine->core().axes[1].beside);
    }
}

TEST(Contour, IsWatchedAcrossThePathOnly) {
    for (const bool tight : {false, true}) {
        TickRig rig([&](params::Table& t, RunOptions&) {
            params::put(t, params::pt_contour_tol, 0.05, 1);
            params::put(t, params::n0511_feedforward, 0, 1);
            params::put(t, params::n0511_feedforward, 0, 2);
            // one axis lags more: the tool leaves the line
            if (tight) params::put(t, params::n0504_position_gain, 10, 2);
        });
        rig.push(1, rig.line(1, {30, 30}, 50));
        rig.start(1);
        rig.run(1500);
        EXPECT_EQ(rig.alarmed(Alarm::ContourDeviates, 1), tight);
    }
}

}  // namespace
}  // namespace polyturn::kernel
