// Spindles in their position loop (nct_parameters_part1 8.4, 8.9, 9.1, 9.2), gear ranges and the
// watch on their speed.
#include "tests/unit/kernel/rig.hpp"

namespace polyturn::kernel {
namespace {

// A PLC that also orients: M19 and M24 ask for the loop, M3 to M5 open it; done when in position.
void orienting(const PlcInputs& in, PlcOutputs& out) {
    const int code = in.signal[signals::cn_mcode(1)];
    const bool fresh = out.signal[signals::cp_mfin(1)] != in.signal[signals::cn_mstr(1)];
    if (fresh) {
        out.signal[signals::sp_rot(1)] = code;
        out.signal[signals::sp_oreq(1)] = code == 19 || code == 24;
    }
    const bool waits = out.signal[signals::sp_oreq(1)] != 0;
    if (!waits || in.signal[signals::sn_inpos(1)])
        out.signal[signals::cp_mfin(1)] = in.signal[signals::cn_mstr(1)];
}

class PositionedSpindle : public ::testing::Test {
protected:
    TickRig rig{[this](params::Table& t, RunOptions&) {
        params::put(t, params::n0320_r1_s_rapid, 120, 1);
        params::put(t, params::n0405_r1_s_acc, 10, 1);
        params::put(t, params::n0744_r1_s_inpos, 0.002, 1);
        params::put(t, params::n0822_basic_angle_of_spnd_pos, 30, 1);
        if (adjust) adjust(t);
    }};
    static inline std::function<void(params::Table&)> adjust;
    SpindleUnit& spindle() { return rig.machine->core().spindles[0]; }
    int flag(NcSignal signal) { return rig.machine->core().signals.nc(signal(1)); }
    PathRecord position(double degrees, SpindleApproach how = SpindleApproach::Shortest,
                        double way = 0) {
        PathRecord r = rig.blank(1, RecordKind::SpindleMode);
        r.spindle = 1;
        r.code = static_cast<std::int32_t>(SpindleModeCode::Position);
        r.value = degrees;
        r.plane[0] = static_cast<std::uint8_t>(how);
        r.shape[2] = way;
        return r;
    }
    void SetUp() override { rig.plc_program = orienting; }
    void TearDown() override { adjust = nullptr; }
    double true_turns() { return spindle().simulated()->true_position(); }
};

TEST_F(PositionedSpindle, FindsItsZeroPulseAndComesToIt) {
    rig.push(1, rig.spindle(1, 600));
    rig.push(1, rig.aux(1, 'M', 3));
    rig.push(1, rig.dwell(1, 1.0));
    rig.push(1, rig.aux(1, 'M', 19));
    rig.push(1, rig.dwell(1, 0.5));
    rig.start(1);
    rig.run_until_idle();
    EXPECT_TRUE(spindle().closed());
    EXPECT_EQ(flag(signals::sn_inpos), 1);
    EXPECT_EQ(flag(signals::sn_sindp), 1);
    EXPECT_NEAR(std::remainder(true_turns(), 1.0), 0.0, 0.001);
    EXPECT_FALSE(rig.alarmed(Alarm::SpindleNotInPosition));
}

TEST_F(PositionedSpindle, TurnsByTheWayOfAnIndexingCodeInItsDirection) {
    rig.push(1, rig.aux(1, 'M', 19));
    rig.push(1, position(120, SpindleApproach::Incremental, 120));
    rig.push(1, position(90, SpindleApproach::Incremental, -30));
    rig.push(1, rig.dwell(1, 0.2));
    rig.start(1);
    double most = 0;
    bool off_index = false;
    rig.on_tick = [&] {
        if (spindle().closed()) most = std::max(most, true_turns());
        if (spindle().closed() && !flag(signals::sn_sindp)) off_index = true;
    };
    rig.run_until_idle();
    const double zero = std::floor(most);
    EXPECT_NEAR(most - zero, 120.0 / 360, 0.002);
    EXPECT_NEAR(true_turns() - zero, 90.0 / 360, 0.002);
    EXPECT_TRUE(off_index);
    EXPECT_EQ(flag(signals::sn_sindp), 1);
}

TEST_F(PositionedSpindle, RefusesAWayWithoutAClosedLoop) {
    rig.push(1, position(30, SpindleApproach::Incremental, 30));
    rig.start(1);
    rig.run_until_idle();
    EXPECT_TRUE(rig.alarmed(Alarm::SpindleNotClosed, 1));
}

// C90. under the address of N0817: nothing behind it closes the loop, as M19 does for its own
// angle.
TEST_F(PositionedSpindle, RefusesAnAngleByItsNameWithoutAClosedLoop) {
    PathRecord named = position(90);
    named.mask = 1;
    rig.push(1, named);
    rig.start(1);
    rig.run_until_idle();
    EXPECT_TRUE(rig.alarmed(Alarm::SpindleNotClosed, 1));
}

TEST_F(PositionedSpindle, TurnsToAnAngleByItsNameWhenTheLoopIsClosed) {
    rig.push(1, rig.aux(1, 'M', 19));
    PathRecord named = position(90);
    named.mask = 1;
    rig.push(1, named);
    rig.push(1, rig.dwell(1, 0.2));
    rig.start(1);
    rig.run_until_idle();
    EXPECT_FALSE(rig.alarmed(Alarm::SpindleNotClosed, 1));
    EXPECT_NEAR(true_turns() - std::floor(true_turns()), 90.0 / 360, 0.002);
}

TEST_F(PositionedSpindle, KnowsItsZeroPulseAfterTheFirstTimeAndTurnsTheShorterWay) {
    rig.push(1, rig.aux(1, 'M', 19));
    rig.push(1, rig.aux(1, 'M', 5));
    rig.push(1, position(300));
    rig.push(1, rig.aux(1, 'M', 19));
    rig.push(1, rig.dwell(1, 0.2));
    rig.start(1);
    double first = 0;
    rig.on_tick = [&] {
        if (first == 0 && flag(signals::sn_inpos)) first = true_turns();
    };
    rig.run_until_idle();
    EXPECT_NEAR(true_turns() - first, -60.0 / 360, 0.002);
}

TEST_F(PositionedSpindle, GoesToTheGridShift) {
    adjust = [](params::Table& t) { params::put(t, params::n0684_spindle_grid_shift, 1024, 1); };
    TickRig shifted([](params::Table& t, RunOptions&) {
        params::put(t, params::n0684_spindle_grid_shift, 1024, 1);
    });
    shifted.plc_program = orienting;
    shifted.push(1, shifted.aux(1, 'M', 19));
    shifted.push(1, shifted.dwell(1, 0.2));
    shifted.start(1);
    shifted.run_until_idle();
    const double turns = shifted.machine->core().spindles[0].simulated()->true_position();
    EXPECT_NEAR(turns - std::floor(turns), 0.25, 0.002);
}

TEST_F(PositionedSpindle, ClosesWhereItStandsWithoutASearch) {
    rig.push(1, rig.spindle(1, 300));
    rig.push(1, rig.aux(1, 'M', 3));
    rig.push(1, rig.dwell(1, 0.7123));
    rig.push(1, rig.aux(1, 'M', 24));
    rig.push(1, rig.dwell(1, 0.2));
    rig.start(1);
    double stood = -1;
    rig.on_tick = [&] {
        if (stood < 0 && spindle().closed()) stood = true_turns();
    };
    rig.run_until_idle();
    EXPECT_TRUE(spindle().closed());
    EXPECT_NEAR(true_turns(), stood, 0.01);
    EXPECT_NE(std::fabs(std::remainder(stood, 1.0)), 0.0);
}

TEST_F(PositionedSpindle, IsOrientedByItsSwitchOnceItHasItsSpeed) {
    TickRig switched([](params::Table& t, RunOptions&) {
        params::put(t, params::n0609_spindle_encoder_config, 16, 1);
    });
    SpindleUnit& unit = switched.machine->core().spindles[0];
    switched.plc_program = [&](const PlcInputs& in, PlcOutputs& out) {
        orienting(in, out);
        const double turns = unit.simulated()->true_position();
        // half a turn behind the zero pulse
        out.signal[signals::sp_osw(1)] = turns - std::floor(turns) > 0.5;
    };
    switched.push(1, switched.aux(1, 'M', 19));
    switched.push(1, switched.dwell(1, 0.2));
    switched.start(1);
    switched.run_until_idle();
    const double turns = unit.simulated()->true_position();
    // the PLC sees it up to two of its cycles late
    EXPECT_NEAR(turns - std::floor(turns), 0.52, 0.03);
}

TEST_F(PositionedSpindle, GivesUpWhenItsSwitchNeverComes) {
    TickRig lost([](params::Table& t, RunOptions&) {
        params::put(t, params::n0609_spindle_encoder_config, 16, 1);
        params::put(t, params::n0752_s_inpos_timeout, 1, 1);
    });
    lost.plc_program = orienting;
    lost.push(1, lost.spindle(1, 100));
    lost.push(1, lost.aux(1, 'M', 19));
    lost.start(1);
    lost.run(6000);
    EXPECT_TRUE(lost.alarmed(Alarm::SpindleNotOriented, 1));
}

TEST_F(PositionedSpindle, IsOrientedByItsProbeInput) {
    TickRig probed([](params::Table& t, RunOptions&) {
        params::put(t, params::n0609_spindle_encoder_config, 8, 1);
        params::put(t, params::n0684_spindle_grid_shift, 2048, 1);
    });
    probed.plc_program = orienting;
    probed.push(1, probed.aux(1, 'M', 19));
    probed.push(1, probed.dwell(1, 0.2));
    probed.start(1);
    probed.run_until_idle();
    const double turns = probed.machine->core().spindles[0].simulated()->true_position();
    EXPECT_NEAR(turns - std::floor(turns), 0.5, 0.003);
}

TEST_F(PositionedSpindle, KeepsItsLoopOpenWhereTheParameterSaysSo) {
    TickRig open([](params::Table& t, RunOptions&) {
        params::put(t, params::n0742_spindle_servo_control, 128, 1);
    });
    open.plc_program = orienting;
    open.push(1, open.aux(1, 'M', 19));
    open.start(1);
    open.run(4000);
    EXPECT_FALSE(open.machine->core().spindles[0].closed());
}

TEST_F(PositionedSpindle, GivesAnAlarmWhenItDoesNotComeIntoPosition) {
    TickRig weak([](params::Table& t, RunOptions&) {
        params::put(t, params::n0701_r1_spindle_gain, 0, 1);  // nothing holds it to its command
        params::put(t, params::n0752_s_inpos_timeout, 1, 1);
        for (const auto h :
             {params::n0761_r1_s_serrl1, params::n0769_r1_s_serrl2, params::n0777_r1_s_serrl3})
            params::put(t, h, 0, 1);
    });
    weak.plc_program = orienting;
    weak.push(1, weak.aux(1, 'M', 19));
    weak.start(1);
    weak.run(6000);
    EXPECT_TRUE(weak.alarmed(Alarm::SpindleNotInPosition));
}

TEST(SpindleRanges, LimitAndRampByTheEngagedOne) {
    TickRig rig([](params::Table& t, RunOptions&) {
        params::put(t, params::nth(params::n0650_r1_s_max, 2), 1000, 1);
        params::put(t, params::nth(params::n0642_r1_s_min, 2), 200, 1);
        params::put(t, params::nth(params::n0658_r1_s_jog_speed, 2), 7, 1);
    });
    int range = 2, creep = 0;
    rig.plc_program = [&](const PlcInputs& in, PlcOutputs& out) {
        TickRig::lathe(in, out);
        out.signal[signals::sp_range(1)] = range;
        out.signal[signals::sp_par(1)] = creep;
    };
    rig.push(1, rig.spindle(1, 3000));
    rig.push(1, rig.aux(1, 'M', 3));
    rig.start(1);
    rig.run(1000);
    const SpindleUnit& spindle = rig.machine->core().spindles[0];
    EXPECT_EQ(spindle.command(), 1000);
    rig.push(1, rig.spindle(1, 50));
    rig.run(100);
    EXPECT_EQ(spindle.command(), 200);
    creep = 1;
    rig.run(100);
    EXPECT_EQ(spindle.command(), 7);
    EXPECT_EQ(rig.machine->core().signals.nc(signals::sn_range(1)), 2);
    creep = 0;
    range = 0;
    rig.run(100);
    EXPECT_EQ(spindle.command(), 50);
}

TEST(SpindleWatch, SaysWhenTheSpeedLeavesBothBandsAfterItHasComeIn) {
    SpindleConfig config;
    config.encoder_counts = 4096;
    config.watch_time_s = 1.0;
    config.watch_start_percent = 5;
    config.watch_percent = 10;
    config.watch_rpm = 30;
    SpindleWatch watch;
    constexpr double kNone = std::numeric_limits<double>::quiet_NaN();
    watch.fluctuation(true, kNone, kNone, kNone, kNone);
    watch.update(config, 1000, 0, 0.01);  // far off: waits
    EXPECT_FALSE(watch.fluctuates());
    watch.update(config, 1000, 960, 0.01);  // within 5 %: begins
    watch.update(config, 1000, 901, 0.01);  // within 10 %
    EXPECT_FALSE(watch.fluctuates());
    watch.update(config, 1000, 899, 0.01);
    EXPECT_TRUE(watch.fluctuates());
    watch.update(config, 200, 205, 0.01);  // a new command begins anew
    watch.update(config, 200, 171, 0.01);  // outside 10 %, inside 30 1/min
    EXPECT_FALSE(watch.fluctuates());
    watch.fluctuation(true, 0.02, kNone, 1, 1);  // G26 P0.02 R1 D1
    // N0630 has passed though it is still far off
    for (int i = 0; i < 3; ++i) watch.update(config, 200, 100, 0.01);
    EXPECT_TRUE(watch.fluctuates());
    watch.fluctuation(false, 0, 0, 0, 0);
    EXPECT_FALSE(watch.fluctuates());
}

TEST(SpindleWatch, SaysNothingWithoutAnEncoder) {
    SpindleWatch watch;
    watch.update({}, 0, 0, 0.01);
    EXPECT_FALSE(watch.reached());
    EXPECT_FALSE(watch.standing());
}

}  // namespace
}  // namespace polyturn::kernel
