// Jogging a tool to the setter (nct part 1 4.3, N0319; part 2 31, N3012 and N3013).
#include "tests/unit/kernel/rig.hpp"

namespace polyturn::kernel {
namespace {

constexpr std::size_t kInput = 5, kProbe = 6;

struct Setter {
    TickRig rig;
    bool measuring = true;
    Setter()
        : rig([](params::Table& t, RunOptions&) {
              params::put(t, params::n3012_sensor_input_of_tool_setter_s1, 5, 1);
              params::put(t, params::n3015_sensor_input_of_workpiece_setter_s2, kProbe, 1);
              params::put(t, params::n0319_t_meas_feed, 300, 1);  // 5 mm/s
          }) {
        // A2 meets it at Z -10.25
        rig.machine->core().sensors.add({1, kInput, -1, -10.25, false});
        rig.plc_program = [this](const PlcInputs& in, PlcOutputs& out) {
            TickRig::lathe(in, out);
            out.signal[signals::cp_tmeas(1)] = measuring;
        };
        rig.command(CommandKind::Mode, 1, static_cast<double>(ChannelMode::Jog));
        rig.run(30);
    }
    void jog(double seconds) { rig.command(CommandKind::Jog, 1, seconds, 0, 2); }
    MachineStatus status() const {
        MachineStatus out;
        EXPECT_TRUE(rig.kernel->status.read(out));
        return out;
    }
};

TEST(ToolSetter, TheAxisStopsWhereTheToolTouchesItAndTheContactIsKept) {
    Setter s;
    s.jog(-10);
    s.rig.run(1500);
    EXPECT_NEAR(s.rig.speed_of(2), -5.0, 1e-6);  // N0319
    s.rig.run(2000);
    EXPECT_EQ(s.rig.speed_of(2), 0.0);
    EXPECT_LT(s.rig.position(2), -10.25);
    EXPECT_GT(s.rig.position(2), -10.40);  // it brakes
    const MachineStatus now = s.status();
    EXPECT_EQ(now.channels[0].touched, -2);
    EXPECT_EQ(now.channels[0].touched_at, 1u);
    EXPECT_NEAR(now.axes[1].skip, -10.25, 1e-6);
}

// Where the tip is at right angles follows from X and Z where the slide is inclined: both are told,
// of the same moment.
TEST(ToolSetter, TheOtherAxesOfTheChannelAreLatchedWithIt) {
    Setter s;
    s.rig.command(CommandKind::Jog, 1, -0.2, 0, 1);
    s.rig.run(1500);
    const double stands = s.rig.position(1);
    ASSERT_LT(stands, -0.1);
    s.jog(-10);
    s.rig.run(3500);
    ASSERT_EQ(s.status().channels[0].touched, -2);
    EXPECT_NEAR(s.status().axes[0].skip, stands, 1e-6);
}

TEST(ToolSetter, FurtherIntoItNoKeyMovesTheAxisAwayEveryKeyDoes) {
    Setter s;
    s.jog(-10);
    s.rig.run(4000);
    const double at = s.rig.position(2);
    s.jog(-1);
    s.rig.run(300);
    EXPECT_EQ(s.rig.position(2), at);
    EXPECT_TRUE(s.rig.alarmed(Alarm::NotReady, 1));
    s.jog(1);
    s.rig.run(2000);
    EXPECT_GT(s.rig.position(2), at + 4);
    EXPECT_EQ(s.status().channels[0].touched, -2);  // still to be read
}

TEST(ToolSetter, TheWorkpieceSetterStopsTheAxisLikewiseAndSaysWhichItWas) {
    Setter s;
    s.rig.machine->core().sensors.add({1, kProbe, -1, -3.5, false});
    s.jog(-10);
    s.rig.run(3000);
    EXPECT_EQ(s.rig.speed_of(2), 0.0);
    EXPECT_EQ(s.status().channels[0].touched, -2);
    EXPECT_EQ(s.status().channels[0].touched_at, 4u);  // N3015
    EXPECT_NEAR(s.status().axes[1].skip, -3.5, 1e-6);
    const double at = s.rig.position(2);
    s.jog(-1);
    s.rig.run(300);
    EXPECT_EQ(s.rig.position(2), at);
}

TEST(ToolSetter, TheRapidKeyDrivesNoFasterTowardsASetter) {
    Setter s;
    s.rig.command(CommandKind::RapidKey, 1, 1);
    s.jog(-10);
    s.rig.run(1500);
    EXPECT_NEAR(s.rig.speed_of(2), -5.0, 1e-6);
}

TEST(ToolSetter, WhileNothingIsMeasuredItsInputMeansNothing) {
    Setter s;
    s.measuring = false;
    s.rig.run(30);
    s.jog(-10);
    s.rig.run(4000);
    EXPECT_LT(s.rig.position(2), -20);
    EXPECT_EQ(s.status().channels[0].touched, 0);
}

}  // namespace
}  // namespace polyturn::kernel
