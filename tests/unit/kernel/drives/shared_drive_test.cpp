// A C axis and its spindle on one drive (nct_parameters_part1 7.1), rigid tapping (16.4), and cuts
// that wait for the spindle.
#include "tests/unit/kernel/rig.hpp"

namespace polyturn::kernel {
namespace {

// A5 is C of L1 on spindle S1.
class CAxis : public ::testing::Test {
protected:
    TickRig rig{[](params::Table& t, RunOptions& o) {
        params::put(t, params::n0002_axis_assign, 1, 5);
        params::put(t, params::n0106_axis_properties, 2, 5);
        params::put(t, params::n0503_axis_output_address, 41, 5);
        params::put(t, params::n0603_spindle_output_address, 41, 1);
        params::put(t, params::n0304_rapid, 36000, 5);
        params::put(t, params::n0305_max_feed, 36000, 5);
        params::put(t, params::n0400_acceleration, 3600, 5);
        params::put(t, params::n0401_acc_tc, 0.05, 5);
        params::put(t, params::n0504_position_gain, 40, 5);
        params::put(t, params::n0511_feedforward, 1, 5);
        params::put(t, params::n0515_feed_forward_control, 3, 5);
        params::put(t, params::n0516_inpos, 0.01, 5);
        params::put(t, params::n0744_r1_s_inpos, 0.002, 1);
        params::put(t, params::n1508_r1_acc_in_tapping, 20, 1);
        params::put(t, params::n1532_r1_tapping_gain, 40, 1);
        o.start_known[4] = 1;
    }};
    SpindleUnit& spindle() { return rig.machine->core().spindles[0]; }
    PathRecord turn_c(double from, double to) {
        PathRecord r = rig.line(1, {0.001, 0}, 100);
        r.axis_count = 1;
        r.axis[0] = 4;
        r.start[0] = from;
        r.end[0] = to;
        r.length = std::fabs(to - from);
        r.v_max = 600;
        r.a_max = 3600;
        r.j_max = 72000;
        return r;
    }
    PathRecord drains(PathRecord r) {
        r.flags |= kDrains;
        return r;
    }
};

TEST_F(CAxis, TurnsTheSpindlesMotorWhileTheSpindleStands) {
    rig.push(1, turn_c(0, 90));
    rig.start(1);
    rig.run_until_idle();
    EXPECT_NEAR(rig.position(5), 90, 1e-9);
    EXPECT_NEAR(spindle().true_angle(), 90, 0.01);
    EXPECT_EQ(rig.machine->core().signals.nc(signals::sn_axis(1)), 1);
}

TEST_F(CAxis, IsRefusedWhileTheSpindleTurns) {
    rig.push(1, rig.spindle(1, 500));
    rig.push(1, rig.aux(1, 'M', 3));
    rig.push(1, rig.dwell(1, 0.5));
    rig.push(1, turn_c(0, 90));
    rig.start(1);
    rig.run(2000);
    EXPECT_TRUE(rig.alarmed(Alarm::AxisIsSpindle, 1));
    EXPECT_EQ(rig.machine->core().signals.nc(signals::sn_axis(1)), 0);
}

TEST_F(CAxis, WaitsForTheSpindleToStopAndKnowsWhereItIsBehindABarrier) {
    rig.push(1, rig.spindle(1, 500));
    rig.push(1, rig.aux(1, 'M', 3));
    rig.push(1, rig.dwell(1, 1.0));
    rig.push(1, drains(rig.aux(1, 'M', 5)));
    rig.start(1);
    rig.run(3000);
    EXPECT_FALSE(rig.alarmed(Alarm::AxisDisplaced));
    const double at = rig.machine->core().axes[4].command();
    EXPECT_GT(at, 360.0);
    EXPECT_NEAR(std::remainder(at - spindle().true_angle(), 360.0), 0.0, 0.01)
        << "the position was kept while it turned";
    rig.push(1, turn_c(at, at + 45));
    rig.run(2000);
    EXPECT_NEAR(rig.machine->core().axes[4].measured(), at + 45, 0.01);
}

TEST_F(CAxis, RefusesAProgramThatDoesNotKnowThatItWasTurned) {
    rig.push(1, rig.spindle(1, 500));
    rig.push(1, rig.aux(1, 'M', 3));
    rig.push(1, rig.dwell(1, 1.0));
    rig.push(1, rig.aux(1, 'M', 5));
    rig.push(1, turn_c(0, 90));
    rig.start(1);
    double fastest = 0;
    rig.on_tick = [&] {
        fastest = std::max(fastest, std::fabs(rig.machine->core().axes[4].velocity()));
    };
    rig.run(4000);
    EXPECT_TRUE(rig.alarmed(Alarm::AxisDisplaced, 1));
}

TEST_F(CAxis, StaysASpindleWhereThePlcDetachesTheAxis) {
    rig.plc_program = [](const PlcInputs& in, PlcOutputs& out) {
        TickRig::lathe(in, out);
        out.signal[signals::ap_detchr(5)] = 1;
    };
    rig.run(50);
    EXPECT_EQ(rig.machine->core().signals.nc(signals::sn_axis(1)), 0);
    rig.plc_program = [](const PlcInputs& in, PlcOutputs& out) {
        TickRig::lathe(in, out);
        out.signal[signals::ap_detchr(5)] = 0;
        out.signal[signals::sp_sdetchr(1)] = 1;
    };
    rig.run(50);
    EXPECT_EQ(rig.machine->core().signals.nc(signals::sn_axis(1)), 1);
    EXPECT_EQ(rig.machine->core().signals.nc(signals::sn_sdetcha(1)), 1);
}

// M19 closes the loop; then Z goes 10 mm down and up again with a pitch of 1 mm.
TEST_F(CAxis, SpindleTurnsAlongWithATappingMove) {
    rig.plc_program = [](const PlcInputs& in, PlcOutputs& out) {
        if (in.signal[signals::cn_mcode(1)] == 19) {
            out.signal[signals::sp_rot(1)] = 19;
            out.signal[signals::sp_oreq(1)] = 1;
        }
        if (in.signal[signals::cn_mcode(1)] != 19 || in.signal[signals::sn_inpos(1)])
            out.signal[signals::cp_mfin(1)] = in.signal[signals::cn_mstr(1)];
    };
    rig.push(1, rig.aux(1, 'M', 19));
    for (const double way : {-10.0, 10.0}) {
        PathRecord r = rig.line(1, {0, way}, 10);  // 600 1/min
        r.flags |=
            kTapping | kOverrideLocked | kExactStop | (way > 0 ? std::uint32_t{kTapOut} : 0u);
        r.axis[r.axis_count] = kMaxAxes;
        r.end[r.axis_count] = -way;
        rig.push(1, r);
    }
    rig.start(1);
    double worst = 0, deepest = 0, start = 0, fastest_change = 0, before = 0;
    rig.on_tick = [&] {
        if (rig.position(2) == 0 && deepest == 0) start = spindle().position();
        deepest = std::min(deepest, rig.position(2));
        worst = std::max(
            worst, std::fabs(spindle().position() - start + rig.machine->core().axes[1].target()));
        const double v = rig.speed_of(2);
        fastest_change = std::max(fastest_change, std::fabs(v - before) / 0.001);
        before = v;
    };
    rig.run_until_idle();
    EXPECT_NEAR(deepest, -10, 1e-6);
    EXPECT_LT(worst, 1e-9) << "one revolution a millimetre, at every tick";
    EXPECT_LE(fastest_change, 20 * 1.001) << "N1508: 20 rev/s2";
    EXPECT_FALSE(rig.alarmed(Alarm::FollowingError));
    EXPECT_NEAR(rig.position(2), 0, 1e-9);
}

TEST_F(CAxis, TappingWithAnOpenLoopIsRefused) {
    PathRecord r = rig.line(1, {0, -10}, 10);
    r.flags |= kTapping;
    r.axis[r.axis_count] = kMaxAxes;
    r.end[r.axis_count] = 10;
    rig.push(1, r);
    rig.start(1);
    rig.run_until_idle();
    EXPECT_TRUE(rig.alarmed(Alarm::SpindleNotClosed, 1));
    EXPECT_NEAR(rig.position(2), 0, 1e-3);
}

TEST(SpindleSpeed, IsWaitedForByACutThatBeginsFromStandstillAndNotByARapid) {
    TickRig rig;
    rig.push(1, rig.spindle(1, 1500));
    rig.push(1, rig.aux(1, 'M', 3));
    rig.push(1, rig.line(1, {5, 0}, 0, kRapid | kExactStop));
    const std::uint64_t cut = rig.push(1, rig.line(1, {0, -10}, 10, kExactStop));
    rig.push(1, rig.spindle(1, 1400));
    rig.push(1, rig.line(1, {0, -10}, 10));
    (void)cut;
    rig.start(1);
    double rapid_done = 0, cut_begins = 0;
    rig.on_tick = [&] {
        const double now = static_cast<double>(rig.machine->core().tick);
        if (rapid_done == 0 && rig.position(1) == 5) rapid_done = now;
        if (cut_begins == 0 && rig.position(2) < 0) cut_begins = now;
    };
    rig.run_until_idle();
    EXPECT_LT(rapid_done, 300);
    EXPECT_NEAR(cut_begins, 950, 60) << "95 % of 1500 1/min at 1500 1/min a second";
}

TEST(SpindleSpeed, IsKeptUntilTheAxesThatCutWithItRest) {
    TickRig rig;
    int rotation = 3;
    rig.plc_program = [&](const PlcInputs& in, PlcOutputs& out) {
        TickRig::lathe(in, out);
        out.signal[signals::sp_rot(1)] = rotation;
    };
    rig.push(1, rig.spindle(1, 1200));
    PathRecord cut = rig.line(1, {0, -100}, 0.5);
    cut.feed_mode = static_cast<std::uint8_t>(FeedMode::PerRevolution);
    rig.push(1, cut);
    rig.start(1);
    rig.run(1500);
    EXPECT_NEAR(rig.speed_of(2), -10, 0.1);
    rotation = 5;
    double least = 1e9;  // of the spindle while the axis moved
    rig.on_tick = [&] {
        if (std::fabs(rig.speed_of(2)) > 0.1)
            least = std::min(least, rig.machine->core().spindles[0].command());
    };
    rig.run(1500);
    EXPECT_TRUE(rig.alarmed(Alarm::SpindleStands, 1));
    EXPECT_EQ(rig.speed_of(2), 0);
    EXPECT_EQ(least, 1200);
    EXPECT_EQ(rig.machine->core().spindles[0].command(), 0) << "then it stops";
}

TEST(SpindleSpeed, IsNotWaitedForWhereTheParameterSaysSo) {
    TickRig rig([](params::Table& t, RunOptions&) { params::put(t, params::pt_feed_waits, 0, 1); });
    rig.push(1, rig.spindle(1, 1500));
    rig.push(1, rig.aux(1, 'M', 3));
    rig.push(1, rig.line(1, {0, -1}, 10));
    rig.start(1);
    rig.run(400);
    EXPECT_NEAR(rig.position(2), -1, 1e-6);
}

TEST(SpindleSpeed, ThatIsNeverReachedIsAnAlarmAndNoHang) {
    TickRig rig([](params::Table& t, RunOptions&) {
        params::put(t, params::pt_encoder_counts, 2048, 1);  // it counts half of what N0608 says
    });
    rig.push(1, rig.spindle(1, 1500));
    rig.push(1, rig.aux(1, 'M', 3));
    rig.push(1, rig.line(1, {0, -1}, 10));
    rig.start(1);
    rig.run_until_idle();
    EXPECT_TRUE(rig.alarmed(Alarm::SpindleTooSlow, 1));
}

}  // namespace
}  // namespace polyturn::kernel
