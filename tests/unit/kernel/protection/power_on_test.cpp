// The way from power-on to ready, and back to it after a fault.
#include "ipc/model/machine/machine_step.hpp"
#include "tests/unit/kernel/rig.hpp"

namespace polyturn::kernel {
namespace {

// The steps that were told, in order.
std::vector<std::string_view> steps(const TickRig& rig) {
    std::vector<std::string_view> out;
    for (const KernelEvent& e : rig.log)
        if (e.kind == static_cast<std::uint32_t>(KernelEventKind::MachineState))
            out.push_back(machine_step_text(static_cast<std::uint32_t>(e.code)).name);
    return out;
}
using Steps = std::vector<std::string_view>;

TEST(PowerOn, LeadsFromOffOverReferencingToReadyAndSaysEachStep) {
    TickRig rig([](params::Table& t, RunOptions& options) {
        options.ready = 0;
        // X by its zero pulse, the others absolute
        for (unsigned a = 1; a <= 4; ++a)
            params::put(t, params::n0900_reference_type, a == 1 ? 0x02 : 0x08, a);
        params::put(t, params::n0303_ref_feed, 600, 1);
        params::put(t, params::n0904_zerodis, 10, 1);
    });
    rig.run(5);
    EXPECT_EQ(rig.machine->core().state, MachineState::Off);
    rig.command(CommandKind::MachineOn);
    rig.run(5);
    EXPECT_EQ(steps(rig), (Steps{"not_referenced"}));
    rig.start(1);
    rig.run(2);
    EXPECT_TRUE(rig.alarmed(Alarm::NotReady, 1));
    EXPECT_EQ(rig.machine->core().signals.nc(signals::n_ready()), 0);
    rig.command(CommandKind::Reference);
    rig.run(5);
    rig.run_until_idle();
    EXPECT_EQ(steps(rig), (Steps{"not_referenced", "referencing", "ready"}));
    EXPECT_EQ(rig.machine->core().signals.nc(signals::n_ready()), 1);
}

TEST(PowerOn, AfterAnEmergencyStopPassesThroughOffForAPlcCycle) {
    TickRig rig;
    rig.run(5);
    rig.command(CommandKind::EmergencyStop);
    rig.run(5);
    rig.command(CommandKind::MachineOn);
    rig.run(1);
    EXPECT_EQ(rig.machine->core().state, MachineState::Off);
    rig.run(20);
    EXPECT_EQ(rig.machine->core().state, MachineState::On);
    EXPECT_EQ(steps(rig), (Steps{"emergency_stop", "off", "ready"}));
}

TEST(PowerOn, WaitsUntilTheAxesHaveBrakedBeforeThePowerGoes) {
    TickRig rig;
    rig.push(1, rig.line(1, {200, 0}, 150));
    rig.start(1);
    rig.run(400);
    ASSERT_GT(rig.speed_of(1), 100);
    double fastest_change = 0, before = rig.speed_of(1);
    rig.on_tick = [&] {
        const double v = rig.speed_of(1);
        fastest_change = std::max(fastest_change, std::fabs(v - before) / 0.001);
        before = v;
    };
    rig.command(CommandKind::EmergencyStop);
    rig.run(3);
    rig.command(CommandKind::MachineOn);
    rig.run(3);
    EXPECT_GT(rig.speed_of(1), 1);
    EXPECT_EQ(rig.machine->core().state, MachineState::EmergencyStop);
    rig.run(100);
    EXPECT_EQ(rig.machine->core().state, MachineState::On);
    EXPECT_LE(fastest_change, 10'000 * 1.01) << "PT_ESTOP_DEC";
}

TEST(PowerOn, ReleasingTheButtonAloneDoesNotSwitchOn) {
    TickRig rig;
    rig.command(CommandKind::EmergencyStop);
    rig.run(5);
    rig.command(CommandKind::ReleaseStop);
    rig.run(100);
    EXPECT_EQ(rig.machine->core().state, MachineState::Off);
}

TEST(PowerOn, IsRefusedByNameWhileTheCircuitIsOpen) {
    TickRig rig;
    rig.command(CommandKind::SetSignal, 0, 1, 0, signals::plc_estop(), 1);
    rig.run(5);
    EXPECT_EQ(rig.machine->core().state, MachineState::EmergencyStop);
    rig.command(CommandKind::MachineOn);
    rig.run(30);
    EXPECT_EQ(rig.machine->core().state, MachineState::EmergencyStop);
    EXPECT_TRUE(rig.alarmed(Alarm::MachineOnRefused));
    rig.command(CommandKind::ReleaseSignal, 0, 0, 0, signals::plc_estop(), 1);
    rig.run(20);
    rig.command(CommandKind::MachineOn);
    rig.run(30);
    EXPECT_EQ(rig.machine->core().state, MachineState::On);
}

TEST(PowerOn, IsRefusedWhileADriveKeepsItsFault) {
    TickRig rig;
    rig.run(5);
    rig.command(CommandKind::DriveFault, 0, 1, 0, 2);
    rig.run(20);
    EXPECT_EQ(rig.machine->core().state, MachineState::EmergencyStop);
    rig.command(CommandKind::MachineOn);
    rig.run(40);
    EXPECT_NE(rig.machine->core().state, MachineState::On);
    EXPECT_TRUE(rig.alarmed(Alarm::MachineOnRefused));
    rig.command(CommandKind::DriveFault, 0, 0, 0, 2);
    rig.run(20);
    rig.command(CommandKind::MachineOn);
    rig.run(40);
    EXPECT_EQ(rig.machine->core().state, MachineState::On);
}

// 10.4: an absolute axis that was moved while the power was off is not referenced until the
// operator says so.
TEST(PowerOn, AnAbsoluteAxisThatMovedWhileOffNeedsTheOperator) {
    for (const double moved : {0.05, 0.5}) {
        auto rig = std::make_unique<TickRig>([&](params::Table& t, RunOptions& options) {
            options.ready = 0;
            for (unsigned a = 1; a <= 4; ++a) params::put(t, params::n0900_reference_type, 0x08, a);
            params::put(t, params::n0909_abs_position_alarm_distance, 0.1, 1);
            options.start_known[0] = 1;
            options.start_position[0] = 20 + moved;
        });
        // The rig's store is new; what it kept of an earlier day:
        rig->store->totals.draft().last_position.fill(std::numeric_limits<double>::quiet_NaN());
        rig->store->totals.draft().last_position[0] = 20;
        rig->store->totals.publish();
        auto again = std::make_unique<Machine>(*rig->kernel, *rig->supervisor, *rig->store);
        ASSERT_TRUE(rig->store->parameters.read(again->core().table));
        again->start();
        EXPECT_EQ(again->core().axes[0].referenced, moved < 0.1);
        EXPECT_TRUE(again->core().axes[1].referenced);
    }
}

// 10.2 E: raw - N0907 + N0200; one number corrected moves the machine coordinate of the same place.
TEST(PowerOn, AnAbsoluteEncoderIsReadWithItsReferenceAndPosition) {
    TickRig rig([](params::Table& t, RunOptions& options) {
        for (unsigned a = 1; a <= 4; ++a) params::put(t, params::n0900_reference_type, 0x08, a);
        params::put(t, params::n0907_endat_machine_reference, 100, 1);
        params::put(t, params::n0200_reference_position1, 30, 1);
        options.start_known[0] = 0;
    });
    rig.store->totals.draft().last_position.fill(std::numeric_limits<double>::quiet_NaN());
    // what the encoder showed when it was switched off
    rig.store->totals.draft().last_position[0] = 120;
    rig.store->totals.publish();
    Machine again(*rig.kernel, *rig.supervisor, *rig.store);
    ASSERT_TRUE(rig.store->parameters.read(again.core().table));
    again.start();
    EXPECT_NEAR(again.core().axes[0].command(), 50, 1e-9);
}

}  // namespace
}  // namespace polyturn::kernel
