// Stroke ranges while axes move (nct_parameters_part1 11.4): the path stands on the limit, the way
// back is free.
#include "tests/unit/kernel/rig.hpp"

namespace polyturn::kernel {
namespace {

using params::Table;

void range1(Table& t, unsigned a, double low, double high) {
    params::put(t, params::n1000_range_enable, 1, a);
    params::put(t, params::n1002_range1a_positive, high, a);
    params::put(t, params::n1003_range1a_negative, low, a);
}

TEST(Stroke, APathStandsExactlyOnTheLimitWithinTheAxisLimits) {
    TickRig rig([](Table& t, RunOptions&) { range1(t, 1, -100, 12.5); });
    double v = 0, a = 0, worst_a = 0, before = 0;
    rig.on_tick = [&] {
        const double now = rig.position(1), nv = (now - before) / 0.001;
        worst_a = std::max(worst_a, std::fabs((nv - v) / 0.001));
        a = (nv - v) / 0.001;
        before = now;
        v = nv;
    };
    rig.push(1, rig.line(1, {10, 0}, 150));
    rig.push(1, rig.line(1, {20, 0}, 150));
    rig.start(1);
    rig.run_until_idle();
    EXPECT_NEAR(rig.position(1), 12.5, 1e-9);
    EXPECT_TRUE(rig.alarmed(Alarm::StrokeLimit, 1));
    EXPECT_EQ(rig.machine->core().signals.nc(signals::an_otp(1)), 1);
    EXPECT_EQ(rig.machine->core().signals.nc(signals::an_otn(1)), 0);
    EXPECT_LE(worst_a, TickRig::kAcceleration * 1.01);
    EXPECT_EQ(rig.state(1), ChannelState::Interrupted);
    rig.command(CommandKind::Reset, 1);
    rig.run_until_idle();
    rig.push(1, rig.line(1, {-5, 0}, 50));
    rig.start(1);
    rig.run_until_idle();
    EXPECT_NEAR(rig.position(1), 7.5, 1e-9);
    EXPECT_EQ(rig.machine->core().signals.nc(signals::an_otp(1)), 0);
}

TEST(Stroke, SetBIsSelectedPerSideAndPerChannel) {
    struct Row {
        std::int64_t strkcont;
        bool channel_b, positive_b, negative_b;
        double high, low;
    };
    constexpr Row kRows[] = {
        {0, false, false, false, 20, -20},
        {0, false, true, false, 8, -20},
        {0, false, false, true, 20, -8},
        {0, true, false, false, 20, -20},
        // ABA = 1: CP_LIMSEL alone
        {0x10, true, false, false, 8, -8},
        {0x10, false, true, true, 20, -20},
    };
    for (const Row& row : kRows)
        for (const int sign : {1, -1}) {
            SCOPED_TRACE(testing::Message() << row.strkcont << row.channel_b << row.positive_b
                                            << row.negative_b << sign);
            TickRig rig([&](Table& t, RunOptions&) {
                range1(t, 1, -20, 20);
                params::put(t, params::n1004_range1b_positive, 8, 1);
                params::put(t, params::n1005_range1b_negative, -8, 1);
                params::put(t, params::n1001_strkcont, row.strkcont, 1);
            });
            const auto set = [&](std::uint32_t slot, bool on) {
                rig.command(CommandKind::SetSignal, 0, on, 0, slot, 1);
            };
            set(signals::cp_limsel(1), row.channel_b);
            set(signals::ap_limselp(1), row.positive_b);
            set(signals::ap_limseln(1), row.negative_b);
            rig.run(2);
            rig.push(1, rig.line(1, {sign * 50.0, 0}, 100));
            rig.start(1);
            rig.run_until_idle();
            EXPECT_NEAR(rig.position(1), sign > 0 ? row.high : row.low, 1e-9);
        }
}

TEST(Stroke, ASetThatIsSelectedWhileTheProgramDwellsActsOnWhatIsPlannedAlready) {
    TickRig rig([](Table& t, RunOptions&) {
        range1(t, 1, -20, 20);
        params::put(t, params::n1004_range1b_positive, 8, 1);
        params::put(t, params::n1005_range1b_negative, -20, 1);
    });
    rig.push(1, rig.dwell(1, 0.2));
    rig.push(1, rig.line(1, {15, 0}, 100));
    rig.start(1);
    rig.run(50);
    rig.command(CommandKind::SetSignal, 0, 1, 0, signals::ap_limselp(1), 1);
    rig.run_until_idle();
    EXPECT_NEAR(rig.position(1), 8, 1e-9);
}

TEST(Stroke, ARangeThatThePlcSwitchesOffLimitsNothing) {
    TickRig rig([](Table& t, RunOptions&) { range1(t, 1, -20, 20); });
    rig.command(CommandKind::SetSignal, 0, 1, 0, signals::cp_lim1dis(1), 1);
    rig.push(1, rig.line(1, {30, 0}, 100));
    rig.start(1);
    rig.run_until_idle();
    EXPECT_NEAR(rig.position(1), 30, 1e-9);
    EXPECT_FALSE(rig.alarmed(Alarm::StrokeLimit));
}

TEST(Stroke, RangesTwoAndThreeCloseABoxOfAllTheirAxes) {
    for (const bool third : {false, true}) {
        TickRig rig([&](Table& t, RunOptions&) {
            for (unsigned a = 1; a <= 2; ++a) {
                params::put(t, params::n1000_range_enable, third ? 4 : 2, a);
                params::put(t,
                            third ? params::n1008_range3_positive : params::n1006_range2_positive,
                            30, a);
                params::put(t,
                            third ? params::n1009_range3_negative : params::n1007_range2_negative,
                            10, a);
            }
            params::put(t, params::n1001_strkcont, 2, 1);  // STE
        });
        rig.push(1, rig.line(1, {20, 0}, 100));  // X alone may be in between
        rig.push(1, rig.line(1, {0, 20}, 100));  // Z would enter
        rig.start(1);
        rig.run_until_idle();
        EXPECT_NEAR(rig.position(1), 20, 1e-9);
        EXPECT_NEAR(rig.position(2), 10, 2e-6);
        EXPECT_TRUE(rig.alarmed(Alarm::StrokeLimit, 1));
        EXPECT_EQ(rig.machine->core().signals.nc(signals::an_otp(2)), 1);
    }
}

TEST(Stroke, JogStopsOnTheBoxToo) {
    TickRig rig([&](Table& t, RunOptions&) {
        params::put(t, params::n1000_range_enable, 4, 1);
        params::put(t, params::n1008_range3_positive, 30, 1);
        params::put(t, params::n1009_range3_negative, 10, 1);
    });
    rig.run(25);  // the PLC has set the jog feed
    rig.command(CommandKind::Jog, 0, 5, 0, 1);
    rig.run_until_idle();
    EXPECT_NEAR(rig.position(1), 10, 2e-6);
    rig.command(CommandKind::Jog, 0, -0.5, 0, 1);
    rig.run_until_idle();
    EXPECT_LT(rig.position(1), 9);
}

}  // namespace
}  // namespace polyturn::kernel
