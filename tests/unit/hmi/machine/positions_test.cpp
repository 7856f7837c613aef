// What the workpiece positions of a real controller contain: the travelled tool offset and what
// nose-radius compensation adds, as F3104 DAL and DAC say (fanuc_lathe 2.1).
#include <QFile>

#include "hmi/screens/tools/offsets.hpp"
#include "ipc/model/machine/store/work_zeros.hpp"
#include "tests/places.hpp"
#include "tests/unit/hmi/tasks.hpp"

namespace polyturn::hmi {
namespace {

class Positions : public Tasks {
protected:
    // Along the part with G42 and tip 3, radius 0.8: the tip stands 0.8 before the programmed Z, at
    // the programmed X; the wear of X is 0.2 in diameter. The program stops within compensation.
    static constexpr const char* kProgram =
        "O77\nG40 G98\nG10 P1 X0.2 Z0. R0.\nG10 P10001 X0. Z0. R0.8 Q3\n"
        "T0101\nG0 X60. Z2.\nG42 G1 X50. Z0. F3000\n"
        "Z-10.\nM0\nZ-20.\nG40 X60.\nM30\n";

    void runTo(const QStringList& parameters, const char* program = kProgram) {
        const QString path = g_controller->folder.filePath("O0077.nc");
        QFile file(path);
        ASSERT_TRUE(file.open(QIODevice::WriteOnly));
        file.write(program);
        file.close();
        g_controller->press("reset");
        ASSERT_TRUE(waitFor([&] { return state(1) == ChannelState::Reset; }));
        for (const QString& line : parameters)
            ASSERT_TRUE(
                g_controller->run({"params", "set", line, "--instance", g_controller->name}));
        ASSERT_TRUE(g_controller->press("select L1=" + path));
        ASSERT_TRUE(g_controller->press("cycle_start L1"));
        ASSERT_TRUE(waitFor([&] {
            return state(1) == ChannelState::ProgramStop &&
                   !(live().status().axes[0].flags & kMoving) &&
                   !(live().status().axes[1].flags & kMoving);
        }));
    }
    double shownAt(unsigned place) const {
        double at = 0;
        EXPECT_TRUE(live().workpiece(1, place, live().status().axes[place].cmd, at));
        return at;
    }
};

TEST_F(Positions, ContainToolOffsetAndNoseRadiusAsF3104Says) {
    struct Row {
        const char* bits;
        double x, z;
    };
    constexpr Row kRows[] = {
        // radii
        {"00000000", 25.1, -10.8},
        {"01000000", 25.0, -10.8},  // DAL
        {"10000000", 25.1, -10.0},  // DAC
        {"11000000", 25.0, -10.0},
    };
    for (const Row& row : kRows) {
        SCOPED_TRACE(row.bits);
        runTo({QString("F3104 L1=") + row.bits});
        ASSERT_FALSE(HasFatalFailure());
        EXPECT_TRUE(waitFor([&] { return std::abs(shownAt(1) - row.z) < 1e-6; })) << shownAt(1);
        EXPECT_NEAR(shownAt(0), row.x, 1e-6);
    }
    // A reset ends compensation: the tool stands where it stands.
    g_controller->press("reset");
    ASSERT_TRUE(waitFor([&] { return state(1) == ChannelState::Reset; }));
    EXPECT_TRUE(waitFor([&] { return std::abs(shownAt(1) + 10.8) < 1e-6; })) << shownAt(1);
    // ... and cancels the tool offset (1.6): nothing is left that DAL could take off.
    EXPECT_TRUE(waitFor([&] { return std::abs(shownAt(0) - 25.1) < 1e-6; })) << shownAt(0);
}

// fanuc_lathe 10.5: absolute displays are rectangular, the machine's show the axes. 30 degrees: X
// 30 (radius) is 34.641 of the slide, which takes Z 10 - 30 tan 30 = -7.321.
TEST_F(Positions, AreAtRightAnglesWhereTheSlideIsInclined) {
    runTo({"F8210 L1=30", "F8200 L1=00000001"}, "O77\nG40 G98\nG0 X60. Z10.\nM0\nM30\n");
    ASSERT_FALSE(HasFatalFailure());
    const auto stands = [&](unsigned place, double at) {
        return std::abs(live().status().axes[place].act - at) < 2e-3;
    };
    EXPECT_TRUE(waitFor([&] { return stands(0, 34.641) && stands(1, -7.321); }))
        << live().status().axes[0].act << " " << live().status().axes[1].act;
    EXPECT_NEAR(shownAt(0), 30.0, 2e-3);
    EXPECT_NEAR(shownAt(1), 10.0, 3e-3);  // of two axes
    // What is left of a block that has been stopped on its way, and what is there, are together
    // where it ends: X 10 (a radius), Z 10.
    runTo({}, "O77\nG40 G98\nG0 X60. Z10.\nM0\nG1 X20. F200.\nM30\n");
    ASSERT_FALSE(HasFatalFailure());
    ASSERT_TRUE(g_controller->press("cycle_start L1"));
    ASSERT_TRUE(waitFor([&] { return shownAt(0) < 28; }));
    ASSERT_TRUE(g_controller->press("feed_hold L1"));
    ASSERT_TRUE(waitFor([&] {
        return state(1) == ChannelState::Held && !(live().status().axes[0].flags & kMoving);
    }));
    EXPECT_TRUE(waitFor([&] {
        return live().toGo(1, 0) < -1 && std::abs(shownAt(0) + live().toGo(1, 0) - 10.0) < 5e-3;
    }));
    EXPECT_NEAR(shownAt(1) + live().toGo(1, 1), 10.0, 5e-3);
    g_controller->press("reset");
    ASSERT_TRUE(waitFor([&] { return state(1) == ChannelState::Reset; }));
    // The keys of the screen: the zero of X is to be here, and the tool that stands here measures
    // 40 in Z.
    Operator hand(*window);
    hand.screen("offsets");
    hand.soft("Work zeros");
    Offsets& offsets = screenOf<Offsets>();
    hand.touchCell(offsets.table(), 3, 1);  // external, G54, G55, G56: X
    hand.soft("Zero here");
    hand.soft("Zero here");
    double x = 0;
    ASSERT_TRUE(live().fromZero(1, 0, live().status().axes[0].act, x));
    const double upright = x + live().view(1).picture.shift[0];
    EXPECT_TRUE(waitFor([&] {
        return std::abs(live().store(1).zeros[3 * kChannelAxes] - 2 * upright) < 5e-3;
    })) << live().store(1).zeros[3 * kChannelAxes]
        << " is not " << 2 * upright;
    EXPECT_GT(std::abs(2 * upright - 2 * live().status().axes[0].act), 1)
        << "the slide itself stands elsewhere";
    // The external zero and the work shift act with each of the others, whichever the program has
    // chosen.
    const auto says = [&](const QString& text) {
        for (Sheet* sheet : window->screen()->sheets())
            for (const Item& item : sheet->items())
                if (item.text == text) return true;
        return false;
    };
    for (const int row : {0, 7}) {
        hand.touchCell(offsets.table(), row, 1);
        EXPECT_TRUE(waitFor([&] { return says("All zeros together"); })) << row;
        EXPECT_FALSE(says("Not in use by the running program")) << row;
    }
    hand.touchCell(offsets.table(), 4, 1);
    EXPECT_TRUE(waitFor([&] { return says("Not in use by the running program"); }));
    ASSERT_TRUE(g_controller->run(
        {"params", "set", "F8200 L1=00000000", "--instance", g_controller->name}));
}

// What is entered after the end of a program counts for positions and for what is measured, as it
// will for the next program.
TEST_F(Positions, CountTheTablesWhileNothingRuns) {
    ASSERT_TRUE(g_controller->set("zero L1 G54 Z=-50"));
    runTo({"F3104 L1=00000000"}, "O77\nG40 G98\nT0100\nG0 X60. Z5.\nM0\nM30\n");
    ASSERT_FALSE(HasFatalFailure());
    EXPECT_NEAR(shownAt(1), 5, 1e-6);
    ASSERT_TRUE(g_controller->press("cycle_start L1"));
    ASSERT_TRUE(waitFor([&] { return state(1) == ChannelState::Ended; }));
    ASSERT_TRUE(g_controller->set("zero L1 G54 Z=-40"));
    // measured
    ASSERT_TRUE(waitFor([&] { return std::abs(live().status().axes[1].act + 45) < 5e-4; }))
        << live().status().axes[1].act;
    EXPECT_TRUE(waitFor([&] { return std::abs(shownAt(1) + 5) < 1e-6; }, 5)) << shownAt(1);
    Operator hand(*window);
    hand.screen("offsets");
    hand.soft("Tool offsets");
    hand.touchCell(screenOf<Offsets>().table(), 4, 2);  // offset 5: geometry Z
    hand.type("0");
    hand.soft("Measured");
    hand.soft("Measured");
    EXPECT_TRUE(
        waitFor([&] { return std::abs(live().store(1).offsets[5].geometry[2] + 5) < 5e-3; }, 10))
        << live().store(1).offsets[5].geometry[2];
    ASSERT_TRUE(g_controller->set("zero L1 G54 Z=0"));
}

// What a program adds to a zero (G52) is nothing that waits; what is entered while it runs does.
TEST_F(Positions, OnlyWhatIsEnteredWaitsForTheNextBlocks) {
    ASSERT_TRUE(g_controller->set("zero L1 G54 Z=-50"));
    runTo({"F3104 L1=00000000"},
          "O77\nG40 G98\nT0100\nG52 Z-3.\nG0 X60. Z5.\nM0\nG0 Z6.\nM0\nM30\n");
    ASSERT_FALSE(HasFatalFailure());
    Operator hand(*window);
    hand.screen("offsets");
    hand.soft("Work zeros");
    hand.touchCell(screenOf<Offsets>().table(), 1, 2);  // external, G54: Z
    const auto says = [&](const QString& text) {
        window->screen()->refresh();
        for (Sheet* sheet : window->screen()->sheets())
            for (const Item& one : sheet->items())
                if (one.text == text) return true;
        return false;
    };
    EXPECT_TRUE(waitFor([&] { return says("Active"); }, 5));
    EXPECT_FALSE(says("Active from the next blocks"));
    ASSERT_TRUE(g_controller->set("zero L1 G54 Z=-49"));
    EXPECT_TRUE(waitFor([&] { return says("Active from the next blocks"); }, 10));
    // what has been read before is driven as it was read
    for (int start = 0; start < 2; ++start) {
        ASSERT_TRUE(g_controller->press("cycle_start L1"));
        (void)waitFor(
            [&] { return state(1) == ChannelState::Running || state(1) == ChannelState::Ended; },
            2);
        ASSERT_TRUE(waitFor([&] {
            return state(1) == ChannelState::ProgramStop || state(1) == ChannelState::Ended;
        }));
    }
    EXPECT_TRUE(waitFor([&] { return says("Active"); }, 5));
    ASSERT_TRUE(g_controller->set("zero L1 G54 Z=0"));
}

// A selection moves nothing and takes no tool away: what is shown stays as it is until the program
// begins.
TEST_F(Positions, KeepTheToolWhenAProgramIsSelected) {
    // DAL: positions are without the offset
    ASSERT_TRUE(g_controller->run(
        {"params", "set", "F3104 L1=01000000", "--instance", g_controller->name}));
    ASSERT_TRUE(g_controller->run({"offsets", "set", "L1", "9", "geometry", "X=40", "Z=30", "R=0",
                                   "T=3", "--instance", g_controller->name}));
    ASSERT_TRUE(g_controller->press("mode L1=mdi"));
    ASSERT_TRUE(g_controller->press("hand_key L1 T0909"));
    ASSERT_TRUE(
        waitFor([&] { return live().view(1).known && live().view(1).picture.geometry == 9; }));
    ASSERT_TRUE(waitFor([&] {
        return state(1) != ChannelState::Running && live().plc(signals::cp_turretopen(1)) == 0;
    }));
    frames(*window, 100);
    const double before = shownAt(1),
                 tool = live().view(1).toolShift[1] - live().view(1).toolShown[1];
    ASSERT_GT(std::abs(tool), 1) << "the tool counts in what is shown";
    const QString path = g_controller->folder.filePath("O0078.nc");
    QFile file(path);
    ASSERT_TRUE(file.open(QIODevice::WriteOnly));
    file.write("O78\nM30\n");
    file.close();
    ASSERT_TRUE(g_controller->press("select L1=" + path));
    ASSERT_TRUE(waitFor([&] {
        return !live().view(1).known && !live().view(1).programs.empty() &&
               QString::fromStdString(live().view(1).programs[0]).endsWith("O0078.nc");
    }));
    EXPECT_NEAR(shownAt(1), before, 1e-6);
}

// The keys of both setters write what was touched; the workpiece setter counts the offset of the
// probe that is in use, and what has been typed is what the surface is to be.
TEST_F(Positions, SettersAreReadByTheirKeys) {
    const auto run = [&](const QStringList& words) {
        return g_controller->run(QStringList(words) << "--instance" << g_controller->name);
    };
    ASSERT_TRUE(
        run({"params", "set", "N3012 L1=5", "N0209 L1=12.5", "N0319 L1=600", "N3014 L1=6"}));
    ASSERT_TRUE(run({"offsets", "set", "L1", "9", "geometry", "X=40", "Z=30", "R=0", "T=3"}));
    ASSERT_TRUE(g_controller->press("mode L1=mdi"));
    ASSERT_TRUE(g_controller->press("hand_key L1 T0909"));
    ASSERT_TRUE(waitFor([&] {
        return live().view(1).known && live().view(1).picture.geometry == 9;
    })) << live().view(1).picture.geometry;
    ASSERT_TRUE(waitFor([&] {
        return state(1) != ChannelState::Running && live().plc(signals::cp_turretopen(1)) == 0;
    }));
    ASSERT_TRUE(g_controller->press("mode L1=jog"));
    ASSERT_TRUE(waitFor(
        [&] { return static_cast<ChannelMode>(live().channel(1).mode) == ChannelMode::Jog; }));
    ASSERT_TRUE(run({"set", "CP_TMEAS L1=1"}));
    const auto touch = [&](int input) {
        ASSERT_TRUE(g_controller->press("jog A2- 3s"));
        ASSERT_TRUE(waitFor([&] { return (live().status().axes[1].flags & kMoving) != 0; }));
        ASSERT_TRUE(run({"set", QString("input %1=1").arg(input)}));
        ASSERT_TRUE(waitFor([&] {
            return live().channel(1).touched == -2 &&
                   live().channel(1).touched_at == (input == 5 ? 1u : 3u);
        }));
        ASSERT_TRUE(run({"release", QString("input %1").arg(input)}));
        ASSERT_TRUE(waitFor([&] { return !(live().status().axes[1].flags & kMoving); }));
    };
    Operator hand(*window);
    hand.screen("offsets");
    Offsets& offsets = screenOf<Offsets>();
    touch(6);
    hand.soft("Work zeros");
    hand.touchCell(offsets.table(), 2, 2);  // external, G54, G55: Z
    hand.type("3");
    hand.soft("Workpiece setter");
    hand.soft("Workpiece setter");
    const double zero = live().status().axes[1].skip - 30 - 3;
    EXPECT_TRUE(waitFor([&] {
        return std::abs(live().store(1).zeros[2 * kChannelAxes + 1] - zero) < 1e-3;
    })) << live().store(1).zeros[2 * kChannelAxes + 1]
        << " is not " << zero;
    touch(5);
    hand.soft("Tool offsets");
    hand.touchCell(offsets.table(), 10, 2);  // offset 11
    hand.soft("Tool setter");
    hand.soft("Tool setter");
    const double length = live().status().axes[1].skip - 12.5;
    EXPECT_TRUE(waitFor([&] {
        return std::abs(live().store(1).offsets[11].geometry[2] - length) < 1e-3;
    })) << live().store(1).offsets[11].geometry[2]
        << " is not " << length;
    ASSERT_TRUE(run({"release", "CP_TMEAS L1"}));
    ASSERT_TRUE(g_controller->press("mode L1=auto"));
}

// Who jogs by the largest number reads the same one on the overview and by hand: the workpiece's,
// and each column has its name.
TEST_F(Positions, TheLargeNumberByHandIsTheWorkpiecesAsOnTheOverview) {
    ASSERT_TRUE(g_controller->set("zero L1 G54 Z=-100"));
    g_controller->press("reset");
    ASSERT_TRUE(waitFor([&] { return state(1) == ChannelState::Reset; }));
    // it begins with the zero as entered, whatever ran before
    ASSERT_TRUE(g_controller->press("select L1=" + QString(kSourceFolder) +
                                    "/examples/jobs/shaft/O1001.nc"));
    Operator hand(*window);
    for (const char* name : {"overview", "manual"}) {
        SCOPED_TRACE(name);
        hand.screen(name);
        const auto largest = [&] {
            const double machine = live().status().axes[1].act;
            double workpiece = 0;
            if (!live().workpiece(1, 1, machine, workpiece) || std::abs(workpiece - machine) < 50)
                return false;
            const QString wanted = lengthText(workpiece, 3), other = lengthText(machine, 3);
            const Item* large = nullptr;
            bool names = false, beside = false;
            for (Sheet* sheet : window->screen()->sheets()) {
                for (const Item& one : sheet->items()) {
                    if (one.text == wanted &&
                        (!large || one.font.pixelSize() > large->font.pixelSize()))
                        large = &one;
                    names |= one.text == "Workpiece";
                }
                for (const Item& one : sheet->items())  // in the same row
                    beside |= large && one.text == other &&
                              std::abs(one.box.center().y() - large->box.center().y()) < 12 &&
                              one.font.pixelSize() < large->font.pixelSize() &&
                              one.box.left() > large->box.left();
            }
            return names && beside;
        };
        EXPECT_TRUE(waitFor(largest, 10));
    }
    ASSERT_TRUE(g_controller->set("zero L1 G54 Z=0"));
}

}  // namespace
}  // namespace polyturn::hmi
