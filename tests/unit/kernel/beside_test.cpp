#include <algorithm>

#include "tests/unit/kernel/rig.hpp"

namespace polyturn::kernel {
namespace {

void set(TickRig& rig, std::uint32_t slot, double value) { rig.command(CommandKind::SetSignal, 0, value, 0, slot, 1); }

TEST(Beside, PlcAxesGoTogetherEachWithItsFeed) {
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
    for (const KernelEvent& e : rig.log) begun += e.kind == static_cast<std::uint32_t>(KernelEventKind::BesideBegin), ended += e.kind == static_cast<std::uint32_t>(KernelEventKind::BesideEnd);
    EXPECT_EQ(begun, 2);
    EXPECT_EQ(ended, 2);
}

TEST(Beside, StopsWhenThePlcTakesItsRequestBack) {
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

TEST(Beside, AnAxisOfAMovingProgramIsRefused) {
    TickRig rig;
    rig.push(1, rig.line(1, {50, 0}, 10));
    rig.start(1);
    rig.run(100);
    set(rig, signals::ap_paxr(1), 1);
    rig.run(50);
    EXPECT_TRUE(rig.alarmed(Alarm::BesideRefused, 1));
    rig.run(5500);
    EXPECT_NEAR(rig.position(1), 50, 1e-9);
}

TEST(Beside, PositioningAxisOfAProgramRunsWhileItCutsAndIsWaitedFor) {
    TickRig rig;
    PathRecord beside = rig.blank(1, RecordKind::Beside);
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

TEST(Contour, IsWatchedAcrossThePathOnly) {
    for (const bool tight : {false, true}) {
        TickRig rig([&](params::Table& t, RunOptions&) {
            params::put(t, params::pt_contour_tol, 0.05, 1);
            params::put(t, params::n0511_feedforward, 0, 1), params::put(t, params::n0511_feedforward, 0, 2);
            if (tight) params::put(t, params::n0504_position_gain, 10, 2);   // one axis lags more: the tool leaves the line
        });
        rig.push(1, rig.line(1, {30, 30}, 50));
        rig.start(1);
        rig.run(1500);
        EXPECT_EQ(rig.alarmed(Alarm::ContourDeviates, 1), tight);
    }
}

}  // namespace
}  // namespace polyturn::kernel
