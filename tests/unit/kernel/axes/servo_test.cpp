// The position loop against a simulated drive: what each parameter of nct_parameters_part1 7 does
// must show.
#include "kernel/drives/simulated_drive.hpp"
#include "tests/unit/kernel/rig.hpp"

namespace polyturn::kernel {
namespace {

using params::Table;

// A1 without feed-forward unless told otherwise, in steady motion at 50 mm/s.
struct Moving {
    explicit Moving(const std::function<void(Table&)>& more = {})
        : rig([&](Table& t, RunOptions&) {
              params::put(t, params::n0515_feed_forward_control, 0, 1);
              params::put(t, params::n0518_time_constant3, 1.0 / 40, 1);
              params::put(t, params::n0519_serrl1, 0.1, 1);
              params::put(t, params::n0520_serrl2, 1, 1);
              params::put(t, params::n0521_serrl3, 10, 1);
              if (more) more(t);
          }) {
        rig.push(1, rig.line(1, {100, 0}, 50, kExactStop));
        rig.start(1);
        rig.run(1000);
    }
    const AxisUnit& axis() { return rig.machine->core().axes[0]; }
    const SimulatedDrive& drive() { return *static_cast<const SimulatedDrive*>(axis().drive()); }
    TickRig rig;
};

TEST(Servo, TheFollowingErrorIsSpeedByGainAndFeedForwardTakesItAway) {
    Moving plain;
    EXPECT_NEAR(plain.axis().error(), 50.0 / 40, 1e-3);
    EXPECT_FALSE(plain.axis().faulted());
    Moving half([](Table& t) {
        params::put(t, params::n0515_feed_forward_control, 1, 1);
        params::put(t, params::n0511_feedforward, 0.5, 1);
    });
    EXPECT_NEAR(half.axis().error(), 50.0 / 80, 1e-2);
    EXPECT_FALSE(half.axis().faulted());
}

TEST(Servo, TimeConstantOneDelaysTheCommandWithoutAFollowingErrorOfItsOwn) {
    Moving filtered([](Table& t) {
        params::put(t, params::n0508_time_constant1, 0.02, 1);
        params::put(t, params::n0520_serrl2, 5, 1);
    });
    EXPECT_NEAR(filtered.axis().error(), 50.0 / 40, 1e-3);
    EXPECT_NEAR(filtered.axis().command() - filtered.axis().measured(), 50.0 / 40 + 50 * 0.02,
                0.06);
}

TEST(Servo, TheThreeErrorLimitsStopTheMachine) {
    // a model that does not fit: 5 - 1.25 > 1
    Moving model([](Table& t) { params::put(t, params::n0518_time_constant3, 1.0 / 10, 1); });
    EXPECT_TRUE(model.rig.alarmed(Alarm::ModelError, 1));
    EXPECT_EQ(model.rig.machine->core().state, MachineState::EmergencyStop);
    Moving absolute([](Table& t) { params::put(t, params::n0521_serrl3, 1, 1); });
    EXPECT_TRUE(absolute.rig.alarmed(Alarm::FollowingError, 1));
    Moving stuck([](Table& t) {
        // breaks away at 30 mm/s: 0.75 mm of error
        params::put(t, params::pt_drive_friction, 30, 1);
        params::put(t, params::n0519_serrl1, 0.1, 1);
    });
    stuck.rig.run_until_idle();
    stuck.rig.command(CommandKind::Reset, 1);
    stuck.rig.run(600);
    stuck.rig.command(CommandKind::Step, 0, 0.5, 0, 1);
    stuck.rig.run(1500);
    EXPECT_TRUE(stuck.rig.alarmed(Alarm::StandstillError, 1));
}

TEST(Servo, StartBoostBreaksAStickingAxisAway) {
    const auto error_while_starting = [](bool boost) {
        Moving axis([&](Table& t) {
            params::put(t, params::pt_drive_friction, 8, 1);
            params::put(t, params::n0525_compensation_control, boost ? 12 : 0, 1);
            params::put(t, params::n0531_friction_comp_distance, 0.005, 1);
            params::put(t, params::n0529_friction_comp_amount, 10 * 60, 1);
            params::put(t, params::n0530_stop_judgement_period, 0.001, 1);
        });
        axis.rig.run_until_idle();
        axis.rig.command(CommandKind::Reset, 1);
        axis.rig.run(600);
        double most = 0;
        axis.rig.on_tick = [&] { most = std::max(most, std::fabs(axis.axis().error())); };
        axis.rig.push(1, axis.rig.line(1, {1, 0}, 2));
        axis.rig.start(1);
        axis.rig.run(400);
        return most;
    };
    EXPECT_GT(error_while_starting(false), 0.19);  // 8 mm/s by gain 40
    EXPECT_LT(error_while_starting(true), 0.19);
}

TEST(Servo, PlayIsAddedAtReversal) {
    const auto slide_after_return = [](double compensated) {
        Moving axis([&](Table& t) {
            params::put(t, params::pt_drive_backlash, 0.05, 1);
            params::put(t, params::n0523_backlash, compensated, 1);
        });
        axis.rig.push(1, axis.rig.line(1, {-30, 0}, 50));
        axis.rig.run_until_idle();
        axis.rig.run(300);
        return axis.drive().true_slide();
    };
    EXPECT_NEAR(slide_after_return(0), 70.05, 2e-3);
    EXPECT_NEAR(slide_after_return(0.05), 70.0, 2e-3);
}

TEST(Servo, ADualLoopWithoutDelayFollowsTheScaleAndADifferenceIsAnAlarm) {
    for (const double limit : {0.0, 0.02}) {
        Moving axis([&](Table& t) {
            params::put(t, params::pt_drive_backlash, 0.05, 1);
            params::put(t, params::n0002_axis_assign, 99, 11);
            params::put(t, params::n0534_dual_position_axis_number, 11, 1);
            params::put(t, params::n0536_dual_position_difference_error, limit, 1);
        });
        axis.rig.push(1, axis.rig.line(1, {-30, 0}, 50));
        axis.rig.run_until_idle();
        axis.rig.run(500);
        if (limit > 0) {
            EXPECT_TRUE(axis.rig.alarmed(Alarm::DualDifference, 1));
        } else {
            EXPECT_NEAR(axis.drive().true_slide(), 70.0, 2e-3);
        }
    }
}

TEST(Servo, ATandemSlaveTurnsWithItsMaster) {
    Moving axis([](Table& t) {
        params::put(t, params::n0533_tandem_master, 1, 2);
        params::put(t, params::n0514_servo_control, 0x80, 2);
    });
    const auto& slave =
        *static_cast<const SimulatedDrive*>(axis.rig.machine->core().axes[1].drive());
    EXPECT_NEAR(slave.true_speed(), 50, 1e-3);
}

TEST(Servo, MultiplyAndDivideScaleThePulsesExactly) {
    Moving axis([](Table& t) {
        params::put(t, params::n0512_multiply, 78125, 1);
        params::put(t, params::n0513_divide, 262144, 1);
    });
    EXPECT_NEAR(axis.axis().measured(), axis.drive().true_position() - 0.05, 2e-3);  // a tick ago
    axis.rig.run_until_idle();
    axis.rig.run(300);
    EXPECT_NEAR(axis.drive().true_position(), 100, 1e-5);
}

TEST(Servo, AnOpenLoopCountsItsPulsesUnlessToldNotTo) {
    TickRig rig;
    rig.command(CommandKind::SetSignal, 0, 1, 0, signals::ap_opnr(1), 1);
    rig.run(3);
    EXPECT_FALSE(rig.machine->core().axes[0].closed());
    rig.command(CommandKind::SetSignal, 0, 0, 0, signals::ap_opnr(1), 1);
    rig.run(3);
    EXPECT_TRUE(rig.machine->core().axes[0].closed());
    EXPECT_NEAR(rig.position(1), 0, 1e-6);
}

}  // namespace
}  // namespace polyturn::kernel
