// What an operator does all day, driven by touches and keys only, against a real controller with a running two-channel job. Each task
// has a most of actions.

#include "hmi/machine/channel_words.hpp"
#include "hmi/screens/manual.hpp"
#include "hmi/screens/offsets.hpp"
#include "hmi/screens/programs.hpp"
#include "tests/unit/hmi/controller.hpp"
#include "tests/unit/hmi/screen_checks.hpp"

namespace polyturn::hmi {
namespace {

class Tasks : public ::testing::Test {
protected:
    static void SetUpTestSuite() { g_controller = new Controller; }
    static void TearDownTestSuite() { delete g_controller, g_controller = nullptr; }
    void SetUp() override {
        Choices choices;
        choices.instance = g_controller->name.toStdString();
        choices.language = "en", choices.theme = "dark";
        window = std::make_unique<MainWindow>(choices);
        window->resize(1280, 800);
        window->show();
        ASSERT_TRUE(waitFor([&] { return live().connected() && live().channels().size() == 2; }));
        g_controller->press("reset");
        ASSERT_TRUE(waitFor([&] { return state(1) != ChannelState::Running && state(2) != ChannelState::Running && state(1) != ChannelState::Held; }));
        ASSERT_TRUE(live().status().machine_state == 2 || g_controller->press("machine_on"));
        ASSERT_TRUE(waitFor([&] { return static_cast<MachineStep>(live().status().step) == MachineStep::Ready || static_cast<MachineStep>(live().status().step) == MachineStep::NotReferenced; }));
    }
    const Live& live() const { return window->desk().live; }
    ChannelState state(unsigned channel) const { return static_cast<ChannelState>(live().channel(channel).state); }
    template <class Kind> Kind& screenOf() const {
        for (Screen* one : window->screens())
            if (auto* found = dynamic_cast<Kind*>(one)) return *found;
        throw std::runtime_error("no such screen");
    }
    void startJob() {
        const QString job = QString(POLYTURN_SOURCE_DIR) + "/examples/jobs/shaft/shaft.job.toml";
        ASSERT_TRUE(g_controller->press("select " + job));
        ASSERT_TRUE(g_controller->press("cycle_start"));
        ASSERT_TRUE(waitFor([&] { return state(1) == ChannelState::Running; })) << waitWords(live(), 1).toStdString();
    }

    std::unique_ptr<MainWindow> window;
    static Controller* g_controller;
};
Controller* Tasks::g_controller = nullptr;

TEST_F(Tasks, CorrectAWearByTwoHundredthsInFourActions) {
    const double before = live().store(1).offsets[3].wear[0];
    Operator hand(*window);
    hand.screen("offsets");
    Offsets& offsets = screenOf<Offsets>();
    hand.touchCell(offsets.table(), 2, 5);       // offset 3: X Z R T, then wear X
    hand.type("-0.02");
    hand.soft("+ Input");
    EXPECT_LE(hand.actions, 4);
    ASSERT_TRUE(waitFor([&] { return std::abs(live().store(1).offsets[3].wear[0] - (before - 0.02)) < 1e-9; }));
}

TEST_F(Tasks, SelectAJobAndStartItInFiveActions) {
    Programs& programs = screenOf<Programs>();
    programs.restore("0|" + QString(POLYTURN_SOURCE_DIR) + "/examples/jobs/shaft/O1001.nc");   // the folder shown last
    Operator hand(*window);
    hand.screen("programs");
    int row = -1;
    for (int i = 0; i < programs.files().rows(); ++i)
        if (programs.files().cell(i, 0).text == "shaft") row = i;
    ASSERT_GE(row, 0);
    hand.touchCell(programs.files(), row, 0);
    hand.soft("Select job");
    ASSERT_TRUE(waitFor([&] { return !live().view(1).programs.empty() && QString::fromStdString(live().view(1).programs[0]).endsWith("O1001.nc") && !live().view(2).programs.empty(); }));
    hand.soft("Start all");
    EXPECT_LE(hand.actions, 5);
    EXPECT_TRUE(waitFor([&] { return state(1) == ChannelState::Running; }));
}

TEST_F(Tasks, WhoWaitsForWhomIsSeenAtOneLook) {
    startJob();
    ASSERT_TRUE(waitFor([&] { return state(2) == ChannelState::Waiting; }));
    Operator hand(*window);
    hand.screen("overview");
    EXPECT_LE(hand.actions, 1);
    const Plight plightOfTwo = plight(live(), window->desk().alarms, 2);
    EXPECT_EQ(plightOfTwo.kind, Plight::Kind::Waits);
    EXPECT_TRUE(plightOfTwo.text.contains("L1")) << plightOfTwo.text.toStdString();
    EXPECT_TRUE(plightOfTwo.text.contains("M50")) << plightOfTwo.text.toStdString();
    // The running block and what holds at it: the overview is not empty while the job runs.
    ASSERT_TRUE(waitFor([&] { return live().view(1).known && live().view(1).picture.codes[0] == 'G'; }));
    EXPECT_EQ(live().view(1).picture.geometry, 1);
    noWordIsShortened(*window);
}

TEST_F(Tasks, LeaveAHoldJogAwayAndReturn) {
    startJob();
    QTest::qWait(300);
    Operator hand(*window);
    hand.screen("manual");
    hand.soft("Hold L1");
    ASSERT_TRUE(waitFor([&] { return state(1) == ChannelState::Held && !(live().status().axes[0].flags & kMoving) && !(live().status().axes[1].flags & kMoving); }));
    const double left_at = live().status().axes[0].cmd;
    QTest::qWait(300);
    hand.soft("Leave the hold L1");
    Manual& manual = screenOf<Manual>();
    ASSERT_TRUE(waitFor([&] { return (live().channel(1).start_missing >> 7 & 1u) != 0; }));
    hand.touch(&manual.axes(), Manual::kStepHits + 5);     // 10 mm
    hand.touch(&manual.axes(), Manual::jogHit(1, true));
    ASSERT_TRUE(waitFor([&] { return std::abs(live().status().axes[0].cmd - left_at) > 1.0 && !(live().status().axes[0].flags & kMoving); })) << live().status().axes[0].cmd;
    hand.soft("Return L1");
    ASSERT_TRUE(waitFor([&] { return std::abs(live().status().axes[0].cmd - left_at) < 1e-9 && (live().channel(1).start_missing >> 7 & 1u) == 0; }));
    hand.soft("Start L1");
    EXPECT_LE(hand.actions, 8);
    EXPECT_TRUE(waitFor([&] { return state(1) == ChannelState::Running || state(1) == ChannelState::Waiting; }));
}

TEST_F(Tasks, SetAZeroWhereTheAxisStands) {
    Operator hand(*window);
    hand.screen("offsets");
    Offsets& offsets = screenOf<Offsets>();
    hand.soft("Work zeros");
    hand.touchCell(offsets.table(), 2, 2);      // external, G54, G55: Z
    hand.type("5");
    hand.soft("This is here");
    hand.soft("This is here");                   // asked once more
    EXPECT_LE(hand.actions, 6);
    const double machine = live().status().axes[1].act;
    const double tool = live().view(1).known ? live().view(1).picture.tool_shift[1] : 0.0;
    EXPECT_TRUE(waitFor([&] { return std::abs(live().store(1).zeros[2 * kChannelAxes + 1] - (machine - tool - 5)) < 1e-4; }, 10)) << live().store(1).zeros[2 * kChannelAxes + 1];
}

TEST_F(Tasks, AJogKeyMovesAsLongAsItIsHeld) {
    Operator hand(*window);
    hand.screen("manual");
    Manual& manual = screenOf<Manual>();
    hand.touch(&manual.axes(), Manual::kStepHits);
    const double from = live().status().axes[1].cmd;
    const QPoint key = manual.axes().boxOf(Manual::jogHit(2, true)).center().toPoint();
    QTest::mousePress(&manual.axes(), Qt::LeftButton, {}, key);
    QTest::qWait(900);
    QTest::mouseRelease(&manual.axes(), Qt::LeftButton, {}, key);
    ASSERT_TRUE(waitFor([&] { return !(live().status().axes[1].flags & kMoving); }, 10));
    EXPECT_GT(std::abs(live().status().axes[1].cmd - from), 0.5);
}

TEST_F(Tasks, TheScreensComeBackWithTheController) {
    g_controller->stop();
    ASSERT_TRUE(waitFor([&] { return !live().connected(); }, 10));
    g_controller->start();
    ASSERT_TRUE(waitFor([&] { return live().connected() && live().channels().size() == 2; }));
}

}  // namespace
}  // namespace polyturn::hmi
