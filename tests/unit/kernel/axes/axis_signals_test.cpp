// What axes and parameters tell the PLC (nct_parameters_part1 3.7, 12, 13, 2.1; part 2, 24):
// position switches, index positions, lubrication, free parameters, the free timer.
#include <bit>

#include "tests/unit/kernel/rig.hpp"

namespace polyturn::kernel {
namespace {

using params::Table;

TEST(PositionSwitches, TellWhereTheAxisIsOnlyWhileItIsReferencedAndAttached) {
    TickRig rig([](Table& t, RunOptions&) {
        params::put(t, params::nth(params::n1101_sw1_axis_number, 3), 2);
        params::put(t, params::nth(params::n1133_sw1_min_pos, 3), -20);
        params::put(t, params::nth(params::n1165_sw1_max_pos, 3), -10);
    });
    const auto seen = [&] {
        const auto& s = rig.machine->core().signals;
        return std::array{s.nc(signals::n_sw(3)), s.nc(signals::n_swn(3)), s.nc(signals::n_swp(3))};
    };
    rig.push(1, rig.line(1, {0, -15}, 50));
    rig.push(1, rig.dwell(1, 0.1));
    rig.push(1, rig.line(1, {0, -15}, 50));
    rig.start(1);
    rig.run(15);
    EXPECT_EQ(seen(), (std::array{0, 0, 1}));
    rig.run(420);
    EXPECT_EQ(seen(), (std::array{1, 0, 0}));
    rig.run_until_idle();
    rig.run(11);
    EXPECT_EQ(seen(), (std::array{0, 1, 0}));
    rig.command(CommandKind::SetSignal, 0, 1, 0, signals::ap_detchr(2), 1);
    rig.run(25);
    EXPECT_EQ(seen(), (std::array{0, 0, 0}));
    rig.command(CommandKind::SetSignal, 0, 0, 0, signals::ap_detchr(2), 1);
    rig.run(25);
    EXPECT_EQ(seen(), (std::array{0, 0, 0}));  // attached again, and without a reference point
}

TEST(IndexPosition, IsToldWithinInposOfAMultiple) {
    TickRig rig([](Table& t, RunOptions&) {
        params::put(t, params::n0106_axis_properties, 8, 2);
        params::put(t, params::n0110_indexing_amount, 5, 2);
    });
    const auto at = [&] { return rig.machine->core().signals.nc(signals::an_indp(2)); };
    rig.run(12);
    EXPECT_EQ(at(), 1);
    rig.start(1);
    for (const double by : {-2.5, -2.5, 0.02, 9.98}) {
        rig.push(1, rig.line(1, {0, by}, 50));
        rig.push(1, rig.dwell(1, 0.2));
        rig.run_until_idle();
        rig.run(250);
        EXPECT_EQ(at(), std::fabs(std::remainder(rig.position(2), 5.0)) < 0.005) << rig.position(2);
    }
}

TEST(Lubrication, IsAskedForOnePlcCycleEachTimeTheDistanceIsTravelled) {
    TickRig rig(
        [](Table& t, RunOptions&) { params::put(t, params::n1273_lubrication_distance, 30, 2); });
    int asked = 0;
    bool before = false;
    rig.plc_program = [&](const PlcInputs& in, PlcOutputs& out) {
        const bool now = in.signal[signals::an_lubr(2)] != 0;
        asked += now;
        EXPECT_FALSE(now && before);
        before = now;
        TickRig::lathe(in, out);
    };
    rig.push(1, rig.line(1, {0, -50}, 50));
    rig.push(1, rig.line(1, {0, 50}, 50));
    rig.start(1);
    rig.run_until_idle();
    rig.run(50);
    EXPECT_EQ(asked, 3);  // 100 mm in both directions
}

TEST(FreeParameters, AreSignalsOfThePlc) {
    TickRig rig([](Table& t, RunOptions&) {
        params::put(t, params::nth(params::n1200_plc_bits0, 6), 1 << 3);
        params::put(t, params::nth(params::n1209_plc_dword1, 32), -7);
        params::put(t, params::nth(params::n1241_plc_double1, 2), 1.25);
    });
    rig.run(2);
    const auto& s = rig.machine->core().signals;
    EXPECT_EQ(s.nc(signals::n_p53()), 1);
    EXPECT_EQ(s.nc(signals::n_p54()), 0);
    EXPECT_EQ(s.nc(signals::n_pdw32()), -7);
    const auto low = static_cast<std::uint32_t>(s.nc(signals::n_pdb2())),
               high = static_cast<std::uint32_t>(s.nc(signals::n_pdb2() + 1));
    EXPECT_EQ(std::bit_cast<double>(static_cast<std::uint64_t>(high) << 32 | low), 1.25);
}

TEST(FreeTimer, RunsWhileThePlcLetsIt) {
    TickRig rig(
        [](Table& t, RunOptions&) { params::put(t, params::n2303_interval_meter, 500, 2); });
    rig.command(CommandKind::SetSignal, 0, 1, 0, signals::cp_tmren(2), 1);
    rig.run(300);
    rig.command(CommandKind::SetSignal, 0, 0, 0, signals::cp_tmren(2), 1);
    rig.run(300);
    rig.command(CommandKind::EndRun);
    rig.run(5);
    EXPECT_NEAR(params::get(rig.machine->core().table, params::n2303_interval_meter, 2), 800, 5);
}

}  // namespace
}  // namespace polyturn::kernel
