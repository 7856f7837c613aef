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

    void runTo(const QString& bits) {
        const QString path = g_controller->folder.filePath("O0077.nc");
        QFile file(path);
        ASSERT_TRUE(file.open(QIODevice::WriteOnly));
        file.write(kProgram);
        file.close();
        g_controller->press("reset");
        ASSERT_TRUE(waitFor([&] { return state(1) == ChannelState::Reset; }));
        ASSERT_TRUE(g_controller->run({"params", "set", "F3104 L1=" + bits, "--instance", g_controller->name}));
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
        runTo(row.bits);
        ASSERT_FALSE(HasFatalFailure());
        EXPECT_TRUE(waitFor([&] { return std::abs(shownAt(1) - row.z) < 1e-6; }, 5)) << shownAt(1);
        EXPECT_NEAR(shownAt(0), row.x, 1e-6);
    }
    // A reset ends compensation: the tool stands where it stands.
    g_controller->press("reset");
    ASSERT_TRUE(waitFor([&] { return state(1) == ChannelState::Reset; }));
    EXPECT_TRUE(waitFor([&] { return std::abs(shownAt(1) + 10.8) < 1e-6; }, 5)) << shownAt(1);
}

}  // namespace
}  // namespace polyturn::hmi
