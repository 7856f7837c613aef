// Referencing, worked out from nct_parameters_part1 10.2: where the axis is called what, and what
// is said when it fails.
#include "tests/unit/kernel/rig.hpp"

namespace polyturn::kernel {
namespace {

using params::Table;

// A1 with a rapid of 50 and a creep of 4 mm/s; the machine starts with A1 at 75.
struct Bench {
    explicit Bench(std::int64_t type, const std::function<void(Table&)>& more = {})
        : rig([&](Table& t, RunOptions& options) {
              params::put(t, params::n0900_reference_type, type, 1);
              params::put(t, params::n0302_ref_rapid, 3000, 1);
              params::put(t, params::n0303_ref_feed, 240, 1);
              params::put(t, params::n0901_reference_distance, -200, 1);
              params::put(t, params::n0902_switch_length, 40, 1);
              params::put(t, params::n0904_zerodis, 10, 1);
              params::put(t, params::n0200_reference_position1, 12, 1);
              options.start_known[0] = 1;
              options.start_position[0] = 75;
              if (more) more(t);
          }) {}
    void press() { rig.command(CommandKind::Reference, 0, 1, 0, 1); }
    void decsw(int on) { rig.command(CommandKind::SetSignal, 0, on, 0, signals::ap_decsw(1), 1); }
    const AxisUnit& axis() { return rig.machine->core().axes[0]; }
    TickRig rig;
};

TEST(Homing, BySwitchAloneTheEdgeIsTheReferencePoint) {
    Bench b(0x01);
    b.press();
    b.rig.run(1500);
    EXPECT_NEAR(b.rig.speed_of(1), -50, 1e-9);
    EXPECT_FALSE(b.axis().referenced);
    b.decsw(1);
    b.rig.run(1000);
    EXPECT_NEAR(b.rig.speed_of(1), 4, 1e-9);  // off the switch, DIR = 0
    const double edge = b.axis().measured();
    b.decsw(0);
    b.rig.run_until_idle();
    EXPECT_TRUE(b.axis().referenced);
    // What was called `edge` is 12 now; the axis stopped a little beyond it.
    EXPECT_GT(b.rig.position(1), 12);
    EXPECT_LT(b.rig.position(1), 12.5);
    EXPECT_LT(edge, 12 - 1);
}

TEST(Homing, TheSwitchThatDoesNotComeOrDoesNotGoIsSaidByName) {
    Bench missing(0x01, [](Table& t) { params::put(t, params::n0901_reference_distance, 20, 1); });
    missing.press();
    missing.rig.run_until_idle();
    EXPECT_TRUE(missing.rig.alarmed(Alarm::ReferenceNoSwitch, 1));
    EXPECT_FALSE(missing.axis().referenced);
    EXPECT_NEAR(missing.rig.position(1), 95, 2.0);  // N0901 = +20 from 75, and the way to brake
    Bench stuck(0x21);
    stuck.decsw(1);
    stuck.press();
    stuck.rig.run_until_idle();
    EXPECT_TRUE(stuck.rig.alarmed(Alarm::ReferenceSwitchNotLeft, 1));
    EXPECT_NEAR(stuck.rig.position(1), 75 - 40, 0.5);  // DIR = 1: downwards, N0902
}

TEST(Homing, ByZeroPulseAloneTheFirstPulseIsTheReferencePointAndN0906LiesBehindIt) {
    Bench b(0x02, [](Table& t) { params::put(t, params::n0906_reference_shift, -3, 1); });
    b.press();
    b.rig.run_until_idle();
    EXPECT_TRUE(b.axis().referenced);
    EXPECT_NEAR(b.rig.position(1), 12, 1e-9);  // driven there: the pulse was called 15
}

TEST(Homing, ARepeatedReferenceFindsTheSameCoordinates) {
    for (const std::int64_t type : {0x02, 0x22, 0x04, 0x24}) {
        SCOPED_TRACE(type);
        Bench b(type, [](Table& t) {
            params::put(t, params::n0904_zerodis, 20, 1);
            params::put(t, params::n0905_basdist, 1000, 1);
        });
        b.press();
        b.rig.run_until_idle();
        const double true_slide = static_cast<SimulatedDrive*>(b.axis().drive())->true_position();
        // a coded scale knows where it is
        if (type & 4) { EXPECT_NEAR(b.rig.position(1), true_slide, 1e-3); }
        const double offset = b.rig.position(1) - true_slide;
        b.press();
        b.rig.run_until_idle();
        const double moved = static_cast<SimulatedDrive*>(b.axis().drive())->true_position();
        EXPECT_NEAR(std::remainder(b.rig.position(1) - moved - offset, 20.0), 0, 1e-3);
        EXPECT_FALSE(b.rig.alarmed(Alarm::ReferenceNoPulse));
    }
}

// The switch is left at a place that is `before` mm in front of a pulse.
void leave_switch(Bench& b, double before) {
    b.decsw(1);
    b.press();
    const double pulse = 92;  // 12 - N0906 + k * 10
    for (int i = 0; i < 20'000 && b.axis().measured() < pulse - before; ++i) b.rig.tick();
    b.decsw(0);
    b.rig.run_until_idle();
}

TEST(Homing, ThePulseMustLieInTheMiddleHalfBehindTheSwitch) {
    Bench good(0x03);
    leave_switch(good, 5);
    EXPECT_TRUE(good.axis().referenced);
    EXPECT_FALSE(good.rig.alarmed(Alarm::ReferencePulseEarly));
    Bench early(0x03);
    leave_switch(early, 1);
    EXPECT_TRUE(early.rig.alarmed(Alarm::ReferencePulseEarly, 1));
    EXPECT_FALSE(early.axis().referenced);
    Bench late(0x03);
    leave_switch(late, 9);
    EXPECT_TRUE(late.rig.alarmed(Alarm::ReferenceNoPulse, 1));
    // as if it had been left 6 mm before
    Bench moved(0x03, [](Table& t) { params::put(t, params::n0903_switch_shift, 3, 1); });
    leave_switch(moved, 9);
    EXPECT_TRUE(moved.axis().referenced);
}

// mefi_cnc8x6.md 4.1: the position memory is loaded with XR
TEST(Homing, AMefiConstantSaysWhereItStands) {
    Bench b(0x83, [](Table& t) {
        params::put(t, params::mefi_80, 30.5, 1);
        params::put(t, params::n0100_axis_name1, 'X', 1);
    });
    b.decsw(1);
    b.press();
    b.rig.run_until_idle();
    EXPECT_TRUE(b.axis().referenced);
    EXPECT_NEAR(b.rig.position(1), 30.5, 0.1);
    // REFVALUE beside N0200
    Bench fagor(0x83, [](Table& t) { params::put(t, params::fg_refvalue, 7, 1); });
    fagor.decsw(1);
    fagor.press();
    fagor.rig.run_until_idle();
    EXPECT_NEAR(fagor.rig.position(1), 19, 0.1);
}

TEST(Homing, WithGosThePulseIsSoughtFromTheSwitchOnAndNoWindowIsChecked) {
    Bench b(0x83);
    b.decsw(1);
    b.press();
    b.rig.run_until_idle();
    EXPECT_TRUE(b.axis().referenced);
    EXPECT_NEAR(b.rig.position(1), 12, 0.1);
}

TEST(Homing, AnAbsoluteAxisIsReferencedAtOnceAndThatOfADriveWhenTheDriveSaysSo) {
    Bench absolute(0x08);
    absolute.press();
    absolute.rig.run(2);
    EXPECT_TRUE(absolute.axis().referenced);
    EXPECT_NEAR(absolute.rig.position(1), 75, 1e-9);
    Bench drive(0x18);
    drive.rig.command(CommandKind::SetSignal, 0, 1, 0, signals::ap_rpe(1), 1);
    drive.rig.run(2);
    EXPECT_TRUE(drive.axis().referenced);
    drive.rig.command(CommandKind::SetSignal, 0, 0, 0, signals::ap_rpe(1), 1);
    drive.rig.run(2);
    EXPECT_FALSE(drive.axis().referenced);
}

// Two neighbouring marks of a coded scale tell where the axis is, in either direction and wherever
// it begins.
TEST(Homing, TwoCodedMarksTellThePlaceOfTheAxis) {
    for (const int type : {0x04, 0x24})
        for (const double wrong_by : {3.0, -41.5}) {
            SCOPED_TRACE(testing::Message() << "type " << type << ", " << wrong_by);
            Bench b(type, [](Table& t) {
                params::put(t, params::n0904_zerodis, 20, 1);
                params::put(t, params::n0905_basdist, 1000, 1);
            });
            b.rig.machine->core().axes[0].shift(wrong_by);  // what it is called now is wrong
            b.press();
            double before = b.rig.position(1), jump = 0;
            for (int i = 0; i < 20'000 && !b.rig.machine->idle(); ++i) {
                b.rig.tick();
                if (std::fabs(b.rig.position(1) - before) > 1) jump = b.rig.position(1) - before;
                before = b.rig.position(1);
            }
            EXPECT_TRUE(b.axis().referenced);
            EXPECT_NEAR(jump, -wrong_by, 0.01);
        }
}

TEST(Homing, AFloatingReferenceIsWhereItBegins) {
    Bench b(0x10);
    b.press();
    b.rig.run(2);
    EXPECT_TRUE(b.axis().referenced);
    EXPECT_NEAR(b.rig.position(1), 12, 1e-12);
}

TEST(Homing, AllGoInTheirOrder) {
    TickRig rig([](Table& t, RunOptions&) {
        for (unsigned a = 1; a <= 3; ++a) {
            params::put(t, params::n0900_reference_type, 2, a);
            params::put(t, params::n0303_ref_feed, 240, a);
            params::put(t, params::n0904_zerodis, 10, a);
        }
        params::put(t, params::pt_ref_order, 1, 1);
        params::put(t, params::pt_ref_order, 2, 2);
        params::put(t, params::pt_ref_order, 1, 3);
    });
    rig.command(CommandKind::Reference, 0, 1, 0, 0);
    bool second_waited = true;
    rig.on_tick = [&] {
        const auto& axes = rig.machine->core().axes;
        if (axes[1].moving() && !(axes[0].referenced && axes[2].referenced)) second_waited = false;
    };
    rig.run_until_idle();
    EXPECT_TRUE(second_waited);
    for (int a = 0; a < 3; ++a)
        EXPECT_TRUE(rig.machine->core().axes[static_cast<std::size_t>(a)].referenced);
}

TEST(Homing, DetachingLosesTheReferenceAndAProgramIsRefused) {
    Bench b(0x02);
    b.rig.command(CommandKind::SetSignal, 0, 1, 0, signals::ap_detchr(1), 1);
    b.rig.run(3);
    EXPECT_EQ(b.rig.machine->core().signals.nc(signals::an_detcha(1)), 1);
    b.rig.command(CommandKind::SetSignal, 0, 0, 0, signals::ap_detchr(1), 1);
    b.rig.run(3);
    EXPECT_EQ(b.rig.machine->core().signals.nc(signals::an_detcha(1)), 0);
    EXPECT_FALSE(b.axis().referenced);
    b.rig.start(1);
    b.rig.run(3);
    EXPECT_TRUE(b.rig.alarmed(Alarm::NotReady, 1));
}

// nct_parameters_part1 2.1, 5 (N0302), 10.2: an axis that has lost its reference must be homed
// again; until then its limits do not hold.
struct Lost {
    explicit Lost(std::int64_t order)
        : rig([order](Table& t, RunOptions&) {
              // ABS and FLO: AP_RPE says whether Z has its reference
              params::put(t, params::n0900_reference_type, 0x18, 2);
              params::put(t, params::n0302_ref_rapid, 600, 2);
              params::put(t, params::pt_ref_order, order, 2);
          }) {
        rpe(1);
        rig.run(30);
        EXPECT_TRUE(rig.machine->core().axes[1].referenced);
    }
    void rpe(int on) { rig.command(CommandKind::SetSignal, 0, on, 0, signals::ap_rpe(2), 1); }
    TickRig rig;
};

TEST(LostReference, StopsTheProgramThatMovesTheAxis) {
    Lost m(1);
    m.rig.push(1, m.rig.line(1, {-10, -40}, 50));
    m.rig.push(1, m.rig.stop(1, StopReason::M30));
    m.rig.start(1);
    m.rig.run(300);
    m.rpe(0);
    m.rig.run_until_idle();
    EXPECT_EQ(m.rig.state(1), ChannelState::Interrupted);
    EXPECT_TRUE(m.rig.alarmed(Alarm::AxisUnreferenced, 1));
    EXPECT_GT(m.rig.position(2), -25);
    EXPECT_NEAR(m.rig.position(2), 4 * m.rig.position(1), 1e-9) << "along the path";
}

TEST(LostReference, IsSaidBeforeTheAxisMovesAndLeavesTheOthersFree) {
    Lost m(1);
    m.rig.push(1, m.rig.line(1, {10, 0}, 50));
    // the path rests in front of it: the axis does not move at all
    m.rig.push(1, m.rig.dwell(1, 0.2));
    const PathRecord with_z = m.rig.line(1, {0, -5}, 50);
    m.rig.push(1, with_z);
    m.rig.push(1, m.rig.stop(1, StopReason::M30));
    m.rig.start(1);
    m.rig.run(50);
    m.rpe(0);
    m.rig.run_until_idle();
    EXPECT_NEAR(m.rig.position(1), 10, 1e-9);
    EXPECT_EQ(m.rig.position(2), 0);
    EXPECT_EQ(m.rig.state(1), ChannelState::Interrupted);
    const KernelEvent* alarm = m.rig.find(KernelEventKind::Alarm, 1);
    ASSERT_NE(alarm, nullptr);
    EXPECT_EQ(alarm->code, static_cast<int>(Alarm::AxisUnreferenced));
    EXPECT_EQ(alarm->line, with_z.line) << "the refused block";
}

// PT_REF_ORDER 0: programs may move it all the same, no faster than N0302.
TEST(LostReference, SlowsAnAxisThatNeedsNoneToN0302) {
    Lost m(0);
    m.rig.push(1, m.rig.line(1, {-10, -40}, 50));
    m.rig.push(1, m.rig.dwell(1, 0.2));
    m.rig.push(1, m.rig.line(1, {0, -15}, 0, kRapid));
    m.rig.push(1, m.rig.dwell(1, 0.2));
    m.rig.push(1, m.rig.line(1, {30, 0}, 0, kRapid));
    m.rig.push(1, m.rig.line(1, {-30, -15}, 50));
    m.rig.push(1, m.rig.stop(1, StopReason::M30));
    m.rig.start(1);
    m.rig.run(300);
    EXPECT_LT(m.rig.speed_of(2), -40);
    m.rpe(0);
    m.rig.run(150);
    double fastest = 0, fastest_x = 0;
    m.rig.on_tick = [&] {
        fastest = std::max(fastest, std::fabs(m.rig.speed_of(2)));
        fastest_x = std::max(fastest_x, m.rig.speed_of(1));
    };
    m.rig.run_until_idle();
    EXPECT_EQ(m.rig.state(1), ChannelState::Ended);
    EXPECT_NEAR(fastest, 10, 1e-6);
    EXPECT_GT(fastest_x, 100) << "the others are as fast as ever";
    EXPECT_NEAR(m.rig.position(2), -70, 1e-9);
}

}  // namespace
}  // namespace polyturn::kernel
