// What the workpiece positions of a real controller contain: the travelled tool offset and what nose-radius compensation adds, as
// F3104 DAL and DAC say (fanuc_lathe 2.1).
#include <QFile>

#include "tests/unit/hmi/tasks.hpp"

namespace polyturn::hmi {
namespace {

class Positions : public Tasks {
protected:
    // Along the part with G42 and tip 3, radius 0.8: the tip stands 0.8 before the programmed Z, at the programmed X; the wear of X
    // is 0.2 in diameter. The program stops within compensation.
    static constexpr const char* kProgram = "O77\nG40 G98\nG10 P1 X0.2 Z0. R0.\nG10 P10001 X0. Z0. R0.8 Q3\nT0101\nG0 X60. Z2.\nG42 G1 X50. Z0. F3000\nZ-10.\nM0\nZ-20.\nG40 X60.\nM30\n";

    void runTo(const QStringList& parameters, const char* program = kProgram) {
        const QString path = g_controller->folder.filePath("O0077.nc");
        QFile file(path);
        ASSERT_TRUE(file.open(QIODevice::WriteOnly));
        file.write(program);
        file.close();
        g_controller->press("reset");
        ASSERT_TRUE(waitFor([&] { return state(1) == ChannelState::Reset; }));
        for (const QString& line : parameters) ASSERT_TRUE(g_controller->run({"params", "set", line, "--instance", g_controller->name}));
        ASSERT_TRUE(g_controller->press("select L1=" + path));
        ASSERT_TRUE(g_controller->press("cycle_start L1"));
        ASSERT_TRUE(waitFor([&] { return state(1) == ChannelState::ProgramStop && !(live().status().axes[0].flags & kMoving) && !(live().status().axes[1].flags & kMoving); }));
    }
    double shownAt(unsigned place) const {
        double at = 0;
        EXPECT_TRUE(live().workpiece(1, place, live().status().axes[place].cmd, at));
        return at;
    }
};

TEST_F(Positions, ContainToolOffsetAndNoseRadiusAsF3104Says) {
    struct Row { const char* bits; double x, z; };
    constexpr Row kRows[] = {   // radii
        {"00000000", 25.1, -10.8},
        {"01000000", 25.0, -10.8},   // DAL
        {"10000000", 25.1, -10.0},   // DAC
        {"11000000", 25.0, -10.0},
    };
    for (const Row& row : kRows) {
        SCOPED_TRACE(row.bits);
        runTo({QString("F3104 L1=") + row.bits});
        ASSERT_FALSE(HasFatalFailure());
        EXPECT_TRUE(waitFor([&] { return std::abs(shownAt(1) - row.z) < 1e-6; }, 5)) << shownAt(1);
        EXPECT_NEAR(shownAt(0), row.x, 1e-6);
    }
    // A reset ends compensation: the tool stands where it stands.
    g_controller->press("reset");
    ASSERT_TRUE(waitFor([&] { return state(1) == ChannelState::Reset; }));
    EXPECT_TRUE(waitFor([&] { return std::abs(shownAt(1) + 10.8) < 1e-6; }, 5)) << shownAt(1);
    // ... and cancels the tool offset (1.6): nothing is left that DAL could take off.
    EXPECT_TRUE(waitFor([&] { return std::abs(shownAt(0) - 25.1) < 1e-6; }, 5)) << shownAt(0);
}

// fanuc_lathe 10.5: absolute displays are rectangular, the machine's show the axes. 30 degrees: X 30 (radius) is 34.641 of the slide,
// which takes Z 10 - 30 tan 30 = -7.321.
TEST_F(Positions, AreAtRightAnglesWhereTheSlideIsInclined) {
    runTo({"F8210 L1=30", "F8200 L1=00000001"}, "O77\nG40 G98\nG0 X60. Z10.\nM0\nM30\n");
    ASSERT_FALSE(HasFatalFailure());
    const auto stands = [&](unsigned place, double at) { return std::abs(live().status().axes[place].act - at) < 2e-3; };
    EXPECT_TRUE(waitFor([&] { return stands(0, 34.641) && stands(1, -7.321); }, 5)) << live().status().axes[0].act << " " << live().status().axes[1].act;
    EXPECT_NEAR(shownAt(0), 30.0, 2e-3);
    EXPECT_NEAR(shownAt(1), 10.0, 3e-3);   // of two axes
    g_controller->press("reset");
    ASSERT_TRUE(waitFor([&] { return state(1) == ChannelState::Reset; }));
    ASSERT_TRUE(g_controller->run({"params", "set", "F8200 L1=00000000", "--instance", g_controller->name}));
}

}  // namespace
}  // namespace polyturn::hmi
