// A program asks and an operator answers on the panel: pattern by touch, values by the pad, the key
// at the foot; put away and brought back.
#include <QFile>

#include "hmi/screens/overview/operation_keys.hpp"
#include "tests/unit/hmi/tasks.hpp"

namespace polyturn::hmi {
namespace {

class DialogueTasks : public Tasks {
protected:
    void write(const char* name, const char* text) const {
        QFile file(g_controller->folder.filePath(name));
        ASSERT_TRUE(file.open(QIODevice::WriteOnly));
        file.write(text);
    }
    void begin() {
        // HOLE: BOLT, GRID
        write("O9500.nc",
              "O9500\nG65 H90 P072079 Q076069\nG65 H91 P1 Q066079 R076084\n"
              "G65 H91 P2 Q071082 R073068\nM99\n");
        write("O9502.nc",
              "O9502\nG65 H92 P071082 Q073068\nG65 H93 P500 Q080073 R084067 I072000\n"
              "G65 H93 P501 Q067079 R085078 I084000\nG65 H94 P079078 Q076089\n"
              "M99\n");
        write("O0001.nc", "O1\nM98 P9500\n#502=#500*2\nG4 X0.1\nM30\n");
        ASSERT_TRUE(g_controller->press("mode L1=auto"));
        ASSERT_TRUE(g_controller->press("reference all"));
        ASSERT_TRUE(waitFor(
            [&] { return static_cast<MachineStep>(live().status().step) == MachineStep::Ready; }));
        ASSERT_TRUE(g_controller->press("select L1=" + g_controller->folder.filePath("O0001.nc")));
        ASSERT_TRUE(g_controller->press("cycle_start L1"));
        ASSERT_TRUE(waitFor([&] { return asks(); }));
    }
    bool asks() const { return view().channel() == 1 && view().title() == "HOLE"; }
    DialogueView& view() const { return window->dialogue(); }
};

TEST_F(DialogueTasks, APatternIsChosenAndItsValuesEntered) {
    begin();
    Operator hand(*window);
    EXPECT_TRUE(view().isVisible());
    // meant for what was there before
    hand.key(Qt::Key_2);
    hand.key(Qt::Key_Return);
    hand.key(Qt::Key_F10);
    frames(*window, 100);
    EXPECT_TRUE(view().isVisible());
    EXPECT_EQ(view().title(), "HOLE");
    QTest::qWait(MainWindow::kComesUpMs);
    EXPECT_EQ(view().keys()[kHoldAllPlace].text, "Hold all") << "where it is on all screens";
    ASSERT_EQ(view().table().rows(), 2);
    EXPECT_EQ(view().sheets().size(), 3u) << "a menu has no field for figures";
    noWordIsShortened(*window);
    ASSERT_TRUE(waitFor([&] { return view().channel() == 1; }));
    // another screen has put it away: the line at the top
    if (!view().isVisible()) hand.touch(window->ownSheets()[0], 5);
    hand.key(Qt::Key_2);  // the pattern by its number
    hand.key(Qt::Key_Return);
    ASSERT_TRUE(waitFor([&] { return view().title() == "GRID"; }));
    QTest::qWait(MainWindow::kComesUpMs);
    EXPECT_EQ(view().table().cell(0, 1).text, "PITCH");
    EXPECT_EQ(view().sheets().size(), 4u);
    hand.type("25/2");
    hand.key(Qt::Key_Return);
    ASSERT_TRUE(waitFor([&] { return view().table().cell(0, 2).text.startsWith("12.5"); }))
        << "every screen sees it";
    hand.type("3");
    hand.key(Qt::Key_Return);
    hand.key(Qt::Key_Escape);  // put away, the program still waits
    EXPECT_FALSE(view().isVisible());
    EXPECT_EQ(state(1), ChannelState::ProgramStop);
    frames(*window, 60);
    hand.touch(window->ownSheets()[0], 5);
    ASSERT_TRUE(view().isVisible());
    hand.soft("INPUT");
    EXPECT_TRUE(waitFor([&] { return state(1) == ChannelState::Ended; }));
    EXPECT_FALSE(view().isVisible());
    EXPECT_TRUE(waitFor([&] {
        return live().store(1).variables[0] == 12.5 && live().store(1).variables[1] == 3 &&
               live().store(1).variables[2] == 25;
    })) << live().store(1).variables[0];
}

// Who types an offset types it into the offset; Hold and Reset of the channel that he looks at stay
// where they are.
TEST_F(DialogueTasks, NothingComesOverWhatSomebodyDoes) {
    Operator hand(*window);
    hand.screen("offsets");
    hand.type("123");
    begin();
    frames(*window, 200);
    EXPECT_FALSE(view().isVisible());
    hand.type("45");
    hand.key(Qt::Key_Escape);
    hand.touch(window->ownSheets()[0], 5);  // the line at the top
    EXPECT_TRUE(view().isVisible());
    ASSERT_TRUE(g_controller->press("reset L1"));
    ASSERT_TRUE(waitFor([&] { return !view().isVisible(); }));
    hand.screen("overview");
    hand.key(Qt::Key_2, Qt::ControlModifier);
    begin();  // in L1
    frames(*window, 200);
    EXPECT_FALSE(view().isVisible());
    hand.key(Qt::Key_D, Qt::ControlModifier);
    EXPECT_TRUE(view().isVisible());
    ASSERT_TRUE(g_controller->press("reset L1"));
    ASSERT_TRUE(waitFor([&] { return !view().isVisible(); }));
    hand.key(Qt::Key_1, Qt::ControlModifier);
}

TEST_F(DialogueTasks, AResetTakesThePageAway) {
    begin();
    ASSERT_TRUE(g_controller->press("reset L1"));
    EXPECT_TRUE(waitFor([&] { return !view().isVisible() && view().channel() == 0; }));
}

}  // namespace
}  // namespace polyturn::hmi
