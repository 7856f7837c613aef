// What an operator does all day, driven by touches and keys only, against a real controller with a
// running two-channel job. Each task has a most of actions.

#include "tests/unit/hmi/tasks.hpp"

#include <QWheelEvent>

#include "hmi/screens/machine/system.hpp"
#include "hmi/screens/overview/manual.hpp"
#include "hmi/screens/programs/programs.hpp"
#include "hmi/screens/tools/offsets.hpp"
#include "ipc/requests/start_words.hpp"
#include "ipc/model/machine/store/work_zeros.hpp"
#include "tests/places.hpp"

namespace polyturn::hmi {
namespace {

TEST_F(Tasks, CorrectAWearByTwoHundredthsInFourActions) {
    startJob();
    const double before = live().store(1).offsets[3].wear[0];
    Operator hand(*window);
    hand.screen("offsets");
    Offsets& offsets = screenOf<Offsets>();
    hand.touchCell(offsets.table(), 2, 5);  // offset 3: X Z R T, then wear X
    hand.type("-0.02");
    hand.soft("+ Input");
    EXPECT_LE(hand.actions, 4);
    ASSERT_TRUE(waitFor(
        [&] { return std::abs(live().store(1).offsets[3].wear[0] - (before - 0.02)) < 1e-9; }));
    EXPECT_EQ(state(1), ChannelState::Running);
}

// What somebody else has changed since stays: who takes back takes back his own.
TEST_F(Tasks, UndoTakesBackOnlyWhatStillStandsThere) {
    ASSERT_TRUE(g_controller->set("offset L1 8 wear X=0"));
    Operator hand(*window);
    hand.screen("offsets");
    Offsets& offsets = screenOf<Offsets>();
    hand.soft("Tool offsets");
    hand.touchCell(offsets.table(), 7, 5);
    const auto wear = [&] { return live().store(1).offsets[8].wear[0]; };
    const auto enter = [&] {
        hand.type("0.01");
        hand.soft("Input");
        return waitFor([&] { return std::abs(wear() - 0.01) < 1e-9; });
    };
    const auto undo = [&] {
        frames(*window);
        for (const SoftKey& one : offsets.keys())
            if (one.text == "Undo") return one;
        return SoftKey{};
    };
    ASSERT_TRUE(enter());
    ASSERT_TRUE(waitFor([&] { return undo().enabled; }));
    EXPECT_EQ(undo().object, "L1 8 X");
    ASSERT_TRUE(g_controller->set("offset L1 8 wear X=0.5"));
    ASSERT_TRUE(waitFor([&] { return std::abs(wear() - 0.5) < 1e-9; }));
    hand.soft("Undo");
    frames(*window, 500);
    EXPECT_NEAR(wear(), 0.5, 1e-9);
    EXPECT_TRUE(standsOn(window->ownSheets(), "0.500"));
    EXPECT_FALSE(undo().enabled);
    ASSERT_TRUE(g_controller->set("offset L1 8 wear X=0"));
    ASSERT_TRUE(waitFor([&] { return wear() == 0; }));
    ASSERT_TRUE(enter());
    hand.soft("Undo");
    EXPECT_TRUE(waitFor([&] { return wear() == 0; }));
}

TEST_F(Tasks, SelectAJobAndStartItInFiveActions) {
    Programs& programs = screenOf<Programs>();
    // the folder shown last
    programs.restore("0|" + QString(kSourceFolder) + "/examples/jobs/shaft/O1001.nc");
    Operator hand(*window);
    hand.screen("programs");
    int row = -1;
    for (int i = 0; i < programs.files().rows(); ++i)
        if (programs.files().cell(i, 0).text == "shaft") row = i;
    ASSERT_GE(row, 0);
    hand.touchCell(programs.files(), row, 0);
    hand.soft("Select job");
    ASSERT_TRUE(waitFor([&] {
        return !live().view(1).programs.empty() &&
               QString::fromStdString(live().view(1).programs[0]).endsWith("O1001.nc") &&
               !live().view(2).programs.empty();
    }));
    hand.soft("Start all");
    hand.soft("Start all");  // asked once more, as on the overview
    EXPECT_LE(hand.actions, 5);
    EXPECT_TRUE(waitFor([&] { return state(1) == ChannelState::Running; }));
}

TEST_F(Tasks, WhoWaitsForWhomIsSeenAtOneLook) {
    startJob();
    ASSERT_TRUE(waitFor([&] { return state(2) == ChannelState::Waiting; }));
    Operator hand(*window);
    hand.screen("overview");
    EXPECT_LE(hand.actions, 1);
    const Plight plightOfTwo = plight(live(), window->context().alarms, 2);
    EXPECT_EQ(plightOfTwo.kind, Plight::Kind::Waits);
    EXPECT_TRUE(plightOfTwo.text.contains("L1")) << plightOfTwo.text.toStdString();
    EXPECT_TRUE(plightOfTwo.text.contains("M50")) << plightOfTwo.text.toStdString();
    // The running block and what holds at it: the overview is not empty while the job runs.
    ASSERT_TRUE(
        waitFor([&] { return live().view(1).known && live().view(1).picture.codes[0] == 'G'; }));
    EXPECT_EQ(live().view(1).picture.geometry, 1);
    noWordIsShortened(*window);
}

TEST_F(Tasks, LeaveAHoldJogAwayAndReturn) {
    startJob();
    frames(*window, 300);
    Operator hand(*window);
    hand.screen("manual");
    hand.soft("Hold L1");
    ASSERT_TRUE(waitFor([&] {
        return state(1) == ChannelState::Held && !(live().status().axes[0].flags & kMoving) &&
               !(live().status().axes[1].flags & kMoving);
    }));
    const double left_at = live().status().axes[0].cmd;
    frames(*window, 300);
    hand.soft("Jog in hold L1");
    Manual& manual = screenOf<Manual>();
    ASSERT_TRUE(waitFor(
        [&] { return (live().channel(1).start_missing & start_bit("back_on_path")) != 0; }));
    hand.touch(&manual.axes(), Manual::kStepHits + 5);  // 10 mm
    hand.touch(&manual.axes(), Manual::jogHit(1, true));
    ASSERT_TRUE(waitFor([&] {
        return std::abs(live().status().axes[0].cmd - left_at) > 1.0 &&
               !(live().status().axes[0].flags & kMoving);
    })) << live().status().axes[0].cmd;
    // axes move: asked once more
    hand.soft("Return L1");
    hand.soft("Return L1");
    ASSERT_TRUE(waitFor([&] {
        return std::abs(live().status().axes[0].cmd - left_at) < 1e-9 &&
               (live().channel(1).start_missing & start_bit("back_on_path")) == 0;
    }));
    hand.soft("Start L1");
    EXPECT_LE(hand.actions, 8);
    EXPECT_TRUE(waitFor(
        [&] { return state(1) == ChannelState::Running || state(1) == ChannelState::Waiting; }));
}

TEST_F(Tasks, SetAZeroWhereTheAxisStands) {
    startAndHoldJob();
    Operator hand(*window);
    hand.screen("offsets");
    Offsets& offsets = screenOf<Offsets>();
    hand.soft("Work zeros");
    hand.touchCell(offsets.table(), 2, 2);  // external, G54, G55: Z
    hand.type("5");
    hand.soft("This is here");
    hand.soft("This is here");  // asked once more
    EXPECT_LE(hand.actions, 6);
    const double machine = live().status().axes[1].act;
    const double tool = live().view(1).known ? live().view(1).picture.tool_shift[1] : 0.0;
    EXPECT_TRUE(waitFor([&] {
        return std::abs(live().store(1).zeros[2 * kChannelAxes + 1] - (machine - tool - 5)) < 1e-4;
    })) << live().store(1).zeros[2 * kChannelAxes + 1];
}

// Single block in both channels, then start after start, until one of them waits for the other.
TEST_F(Tasks, SingleBlockBothChannelsToAWait) {
    startJob();
    Operator hand(*window);
    hand.screen("overview");
    hand.soft("Single block all");
    ASSERT_TRUE(waitFor([&] {
        return (live().channel(1).keys & kKeySingleBlock) &&
               (live().channel(2).keys & kKeySingleBlock);
    }));
    const auto waits = [&] {
        return state(1) == ChannelState::Waiting || state(2) == ChannelState::Waiting;
    };
    for (int start = 0; start < 6 && !waits(); ++start) {
        ASSERT_TRUE(waitFor([&] {
            return waits() ||
                   (state(1) != ChannelState::Running && state(2) != ChannelState::Running);
        }));
        if (waits()) break;
        const auto place = [&] {
            return std::tuple(live().channel(1).line, live().channel(2).line,
                              live().channel(1).lit_s + live().channel(2).lit_s);
        };
        const auto before = place();
        hand.soft("Start all");
        ASSERT_TRUE(waitFor([&] { return waits() || place() != before; }));
    }
    EXPECT_TRUE(waitFor(waits));
    EXPECT_LE(hand.actions, 8);
    EXPECT_TRUE(waitWords(live(), 1).contains("L2") || waitWords(live(), 2).contains("L1"));
    hand.soft("Single block all");
    EXPECT_TRUE(waitFor([&] { return !(live().channel(1).keys & kKeySingleBlock); }));
}

// Who is in need of Hold looks at no page: the keys of the channel stay where they are, and the
// page is gone when the screen comes back.
TEST_F(Tasks, HoldStaysInItsPlaceBesideTheSwitches) {
    Operator hand(*window);
    hand.screen("overview");
    const auto texts = [&] {
        QStringList out;
        for (const SoftKey& one : window->screen()->keys()) out << one.text;
        return out;
    };
    const QStringList first = texts();
    hand.soft("Program control");
    const QStringList switches = texts();
    ASSERT_EQ(switches.size(), 10);
    EXPECT_EQ(switches.mid(0, 4), first.mid(0, 4));
    EXPECT_EQ(switches[1], "Hold L1");
    EXPECT_EQ(switches[9], "More");
    hand.soft("More");
    ASSERT_EQ(texts().size(), 10);
    EXPECT_EQ(texts().mid(0, 4), first.mid(0, 4));
    EXPECT_EQ(texts()[9], "Back");
    hand.screen("programs");
    hand.screen("overview");
    EXPECT_EQ(texts(), first);
}

// The kernel takes machine lock between programs only: pressed within one it would act later, when
// nobody thinks of it.
TEST_F(Tasks, MachineLockIsPressedBetweenProgramsOnly) {
    const auto lockKey = [&] { return window->screen()->keys()[8]; };
    Operator hand(*window);
    hand.screen("overview");
    hand.soft("Program control");
    ASSERT_EQ(lockKey().text, "Machine lock L1");
    ASSERT_TRUE(waitFor([&] { return lockKey().enabled; }));
    startJob();
    EXPECT_FALSE(lockKey().enabled);
    ASSERT_TRUE(g_controller->press("reset"));
    ASSERT_TRUE(waitFor([&] { return lockKey().enabled; }));
    ASSERT_TRUE(g_controller->press("machine_lock L1=on"));
    ASSERT_TRUE(waitFor([&] { return lockKey().on; }));
    EXPECT_FALSE(lockKey().confirm.isEmpty()) << "that the axes go again is asked for as well";
    ASSERT_TRUE(g_controller->press("machine_lock L1=off"));
    EXPECT_TRUE(waitFor([&] { return !lockKey().on; }));
}

TEST_F(Tasks, StartAllAsksWhereAChannelWouldBeginItsProgram) {
    Operator hand(*window);
    hand.screen("overview");
    const auto asks = [&] { return !window->screen()->keys()[4].confirm.isEmpty(); };
    startJob();
    ASSERT_TRUE(waitFor(
        [&] { return state(2) == ChannelState::Running || state(2) == ChannelState::Waiting; }));
    EXPECT_FALSE(asks());
    ASSERT_TRUE(g_controller->press("feed_hold L1"));
    ASSERT_TRUE(g_controller->press("reset L2"));
    ASSERT_TRUE(
        waitFor([&] { return state(1) == ChannelState::Held && state(2) == ChannelState::Reset; }));
    EXPECT_EQ(window->screen()->keys()[4].text, "Start all");
    EXPECT_TRUE(asks()) << "L2 would run from its beginning beside a program that is held";
}

// The tip touches a diameter that has been measured: geometry follows from where the axis stands.
TEST_F(Tasks, MeasureAToolByItsTouch) {
    startAndHoldJob();
    Operator hand(*window);
    hand.screen("offsets");
    Offsets& offsets = screenOf<Offsets>();
    hand.soft("Tool offsets");
    hand.touchCell(offsets.table(), 4, 1);  // offset 5: geometry X
    hand.type("52.48");
    hand.soft("Measured");
    hand.soft("Measured");  // asked once more
    EXPECT_LE(hand.actions, 6);
    const auto stands = [&] {
        const AxisStatus& axis = live().status().axes[0];
        const ChannelStore& store = live().store(1);
        const double zero =
            live().view(1).known
                ? 2 * (live().view(1).picture.shift[0] - live().view(1).picture.tool_shift[0])
                : store.zeros[0] + store.zeros[kChannelAxes] +
                      store.zeros[kZeroShift * kChannelAxes];
        return 2 * axis.act - zero - 52.48 - store.offsets[5].wear[0];  // X is shown as a diameter
    };
    EXPECT_TRUE(waitFor([&] {
        return std::abs(live().store(1).offsets[5].geometry[0] - stands()) < 1e-3;
    })) << live().store(1).offsets[5].geometry[0]
        << " is not " << stands();
}

// A controller in which nothing has been selected yet.
class FreshTasks : public Tasks {};

// Nothing that would only be interrupted is started, and what is missing is said before.
TEST_F(FreshTasks, AStartSaysThatNoProgramIsSelected) {
    const QString program = QString(kSourceFolder) + "/examples/programs/O0050.nc";
    ASSERT_TRUE(waitFor([&] { return lacksProgram(live(), 1) && lacksProgram(live(), 2); }));
    EXPECT_TRUE(startNeeds(live(), 1).join(' ').contains("no program is selected"))
        << startNeeds(live(), 1).join(' ').toStdString();
    EXPECT_TRUE(startPlan(live(), 0).begin.empty());
    Operator hand(*window);
    hand.screen("overview");
    hand.soft("Start all");
    frames(*window, 300);
    EXPECT_TRUE(standsOn(window->ownSheets(), "L1 L2: no program is selected"));
    EXPECT_EQ(state(1), ChannelState::Reset);
    ASSERT_TRUE(g_controller->press("select L2=" + program));
    ASSERT_TRUE(waitFor([&] { return !lacksProgram(live(), 2); }));
    EXPECT_EQ(startPlan(live(), 0).begin, std::vector<unsigned>{2});
    EXPECT_EQ(startPlan(live(), 0).passed, std::vector<unsigned>{1});
    ASSERT_TRUE(g_controller->press("select L1=" + program));
    ASSERT_TRUE(waitFor([&] { return !lacksProgram(live(), 1); }));
    EXPECT_EQ(startPlan(live(), 0).begin, (std::vector<unsigned>{1, 2}));
    ASSERT_TRUE(g_controller->press("mode L1=mdi"));
    ASSERT_TRUE(
        waitFor([&] { return startNeeds(live(), 1).join(' ').contains("no block is entered"); }));
    EXPECT_EQ(startPlan(live(), 0).passed, std::vector<unsigned>{1})
        << "nothing is entered that could begin";
    ASSERT_TRUE(g_controller->press("mode L1=auto"));
}

// Whoever presses: the kernel refuses, with a number and what to do; here it is the key of one
// channel.
TEST_F(FreshTasks, AStartOfOneChannelIsRefusedByTheKernel) {
    for (const char* channel : {"L1", "L2"})
        ASSERT_TRUE(g_controller->press(QString("mode %1=mdi").arg(channel)));
    ASSERT_TRUE(waitFor([&] { return lacksProgram(live(), 2); }));
    Operator hand(*window);
    hand.screen("overview");
    hand.key(Qt::Key_2, Qt::ControlModifier);
    hand.soft("Start L2");
    EXPECT_TRUE(waitFor([&] {
        const AlarmEntry* alarm = window->context().alarms.standing(2);
        return alarm && alarm->number == "PT0535" && alarm->text.contains("no block is entered");
    }));
    for (const char* channel : {"L1", "L2"})
        ASSERT_TRUE(g_controller->press(QString("mode %1=auto").arg(channel)));
}

// A start behind an interruption begins at the first block: whoever has forgotten that the program
// was somewhere else is asked.
TEST_F(Tasks, AStartAfterAnInterruptedProgramAsksFirst) {
    startJob();
    ASSERT_TRUE(waitFor([&] { return live().channel(1).line > 3; }));
    ASSERT_TRUE(g_controller->press("reset"));
    ASSERT_TRUE(waitFor([&] {
        return state(1) == ChannelState::Reset && live().channel(1).broken_off > 0 &&
               live().channel(1).start_missing == 0;
    }));
    Operator hand(*window);
    hand.screen("overview");
    hand.key(Qt::Key_1, Qt::ControlModifier);
    hand.soft("Start L1");
    frames(*window, 300);
    EXPECT_EQ(state(1), ChannelState::Reset);
    hand.soft("Start L1");
    ASSERT_TRUE(waitFor(
        [&] { return state(1) == ChannelState::Running || state(1) == ChannelState::Waiting; }));
    EXPECT_EQ(live().channel(1).broken_off, 0u);
}

// «Ready» is a machine that does nothing.
TEST_F(Tasks, TheTopBarSaysThatProgramsRun) {
    startJob();
    frames(*window, 100);
    EXPECT_TRUE(standsOn(window->ownSheets(), "Programs run"));
    EXPECT_FALSE(standsOn(window->ownSheets(), "The machine is ready"));
    ASSERT_TRUE(g_controller->press("feed_hold"));
    ASSERT_TRUE(waitFor([&] {
        return state(1) == ChannelState::Held &&
               (state(2) == ChannelState::Held || state(2) == ChannelState::Waiting);
    }));
    frames(*window, 100);
    EXPECT_TRUE(standsOn(window->ownSheets(), "Programs stand"))
        << "who waits for one that stands, stands";
    ASSERT_TRUE(g_controller->press("reset"));
}

// While a program runs axes are not moved by hand: the keys are pale, and say why.
TEST_F(Tasks, JogKeysOfARunningProgramSayWhyTheyDoNothing) {
    startJob();
    Operator hand(*window);
    hand.screen("manual");
    frames(*window, 100);
    Manual& manual = screenOf<Manual>();
    hand.touch(&manual.axes(), Manual::jogHit(1, true));
    frames(*window, 60);
    EXPECT_TRUE(standsOn(window->ownSheets(),
                         "A program runs: axes are moved by hand in a hold, after «Jog in hold»"));
    EXPECT_EQ(window->context().alarms.standing(1), nullptr) << "nothing was asked of the kernel";
}

// Who is in need of a key looks for it at its place: it is the same on every screen that has it.
TEST_F(Tasks, HoldStartAndResetHaveTheirPlacesOnEveryScreen) {
    std::map<QString, std::set<std::size_t>> places;
    std::map<QString, int> screens;
    for (std::size_t i = 0; i < window->screens().size(); ++i) {
        Screen* screen = window->screens()[i];
        for (int page = 0; page < (QString(screen->name()) == "manual" ? 2 : 1); ++page) {
            screen->turnTo(page);
            const auto keys = screen->keys();
            for (std::size_t k = 0; k < keys.size(); ++k)
                for (const char* word :
                     {"Start L1", "Hold L1", "Reset L1", "Start all", "Hold all", "Reset all"})
                    if (keys[k].text == word) {
                        places[word].insert(k);
                        ++screens[word];
                    }
        }
        screen->turnTo(0);
    }
    for (const auto& [word, where] : places) EXPECT_EQ(where.size(), 1u) << word.toStdString();
    EXPECT_GE(screens["Start L1"], 2);
    EXPECT_GE(screens["Hold L1"], 3);
    EXPECT_GE(screens["Reset L1"], 3);
    EXPECT_GE(screens["Start all"], 2);
}

// By a finger and the wheel too, and a bar shows that there is more.
TEST_F(Tasks, TheSynchronisedViewIsScrolledByTouch) {
    Programs& programs = screenOf<Programs>();
    programs.restore(QString("0|") + kSourceFolder + "/examples/jobs/shaft/shaft.job.toml");
    Operator hand(*window);
    hand.screen("programs");
    hand.soft("Check, waits");
    ASSERT_TRUE(waitFor([&] { return !programs.dryRun().running() && programs.dryRun().any(); }));
    frames(*window, 100);
    FreeSheet& view = programs.picture();
    const QPoint from(view.width() / 2, view.height() / 2);
    QTest::mousePress(&view, Qt::LeftButton, {}, from);
    for (int i = 1; i <= 5; ++i) QTest::mouseMove(&view, from - QPoint(0, i * px(24)));
    QTest::mouseRelease(&view, Qt::LeftButton, {}, from - QPoint(0, 5 * px(24)));
    EXPECT_EQ(programs.firstRow(), 5);
    const auto turn = [&](int by) {
        QWheelEvent wheel(QPointF(from), view.mapToGlobal(QPointF(from)), {}, QPoint(0, by),
                          Qt::NoButton, Qt::NoModifier, Qt::NoScrollPhase, false);
        QCoreApplication::sendEvent(&view, &wheel);
    };
    turn(-120);
    EXPECT_EQ(programs.firstRow(), 8);
    turn(120);
    turn(120);
    turn(120);
    EXPECT_EQ(programs.firstRow(), 0);
}

TEST(RestartPlaces, ATextOrACommentCallsNoTool) {
    EXPECT_EQ(toolCallOf("N20 T0101 M6"), 20);
    EXPECT_EQ(toolCallOf("/2 N30 G97 S800 T3"), 30);
    EXPECT_EQ(toolCallOf("N40 T=\"CUT 1\" D1"), 40);
    EXPECT_EQ(toolCallOf("n50t5"), 50);
    for (const char* line :
         {"N20 MSG(\"CUT 1\")", "N20 #MSG [\"CUT 1\"]", "N20 MSG \"CUT 1\"", "N20 G1 X4 (T5 COMES)",
          "N20 G1 ; T5", "N20 GOT1=5", "T5", "N20 G4 F2"})
        EXPECT_FALSE(toolCallOf(line)) << line;
}

// Another theme makes the screens anew: the places are no less there.
TEST_F(Tasks, PlacesOfARestartOutlastTheTheme) {
    startJob();
    ASSERT_TRUE(
        waitFor([&] { return live().channel(1).block > 60 && live().channel(1).file == 0; }));
    ASSERT_TRUE(g_controller->press("reset"));
    ASSERT_TRUE(waitFor(
        [&] { return state(1) == ChannelState::Reset && state(2) == ChannelState::Reset; }));
    Operator hand(*window);
    hand.screen("programs");
    hand.soft("Restart in the middle");
    hand.soft("All from their last tool call");
    const std::int64_t stood = screenOf<Programs>().restartPage().stood(1);
    ASSERT_GT(stood, 0);
    window->setDark(false);
    frames(*window);
    EXPECT_EQ(screenOf<Programs>().restartPage().stood(1), stood);
    EXPECT_EQ(screenOf<Programs>().restartPage().wanted(1), 20);
    window->setDark(true);
}

// A tool breaks: reset, say that a new insert is in, go on where its tool was called.
TEST_F(Tasks, RestartAfterABrokenTool) {
    startJob();
    ASSERT_TRUE(
        waitFor([&] { return live().channel(1).block > 60 && live().channel(1).file == 0; }));
    Operator hand(*window);
    hand.screen("overview");
    hand.soft("Hold all");
    ASSERT_TRUE(waitFor([&] { return state(1) == ChannelState::Held; }));
    hand.soft("Reset all");
    hand.soft("Reset all");  // asked once more
    ASSERT_TRUE(waitFor(
        [&] { return state(1) == ChannelState::Reset && state(2) == ChannelState::Reset; }));
    hand.screen("programs");
    Programs& programs = screenOf<Programs>();
    hand.soft("Restart in the middle");
    hand.soft("All from their last tool call");
    EXPECT_EQ(programs.restartPage().wanted(1), 20);
    EXPECT_EQ(programs.restartPage().wanted(2), 20);
    hand.soft("Restart");
    hand.soft("Restart");  // the axes are free
    ASSERT_TRUE(waitFor([&] {
        return live().channel(1).restart == static_cast<unsigned>(RestartState::AtBlock) &&
               live().channel(2).restart == static_cast<unsigned>(RestartState::AtBlock);
    })) << live().channel(1).restart
        << " " << live().channel(2).restart;
    hand.soft("Start all");
    hand.soft("Start all");  // asked once more
    EXPECT_LE(hand.actions, 11);
    EXPECT_TRUE(waitFor(
        [&] { return state(1) == ChannelState::Running && live().channel(1).block >= 20; }));
}

TEST_F(Tasks, RestoreABackup) {
    startJob();
    System& system = screenOf<System>();
    QTemporaryDir folder;
    system.readFolder(folder.filePath("new/folder"));  // the store makes it
    Operator hand(*window);
    hand.screen("system");
    hand.soft("Save now");
    // listed when the store has answered
    ASSERT_TRUE(waitFor([&] { return system.files().rows() == 2; })) << "the way up and the backup";
    const double before = live().store(1).offsets[9].geometry[2];
    ASSERT_TRUE(g_controller->set(QString("offset L1 9 geometry Z=%1").arg(before + 12.5)));
    ASSERT_TRUE(waitFor(
        [&] { return std::abs(live().store(1).offsets[9].geometry[2] - before - 12.5) < 1e-9; }));
    hand.soft("What would change");
    ASSERT_TRUE(waitFor([&] { return system.right().rows() >= 1; })) << system.note().toStdString();
    hand.soft("Restore");
    EXPECT_NEAR(live().store(1).offsets[9].geometry[2], before + 12.5, 1e-9)
        << "one press must not restore";
    hand.soft("Restore");  // asked once more
    EXPECT_LE(hand.actions, 6);
    EXPECT_TRUE(waitFor([&] {
        return std::abs(live().store(1).offsets[9].geometry[2] - before) < 1e-9;
    })) << live().store(1).offsets[9].geometry[2];
}

TEST_F(Tasks, AJogKeyMovesAsLongAsItIsHeld) {
    Operator hand(*window);
    hand.screen("manual");
    Manual& manual = screenOf<Manual>();
    hand.touch(&manual.axes(), Manual::kStepHits);
    const double from = live().status().axes[1].cmd;
    const QPoint key = manual.axes().boxOf(Manual::jogHit(2, true)).center().toPoint();
    // Pressed once. Screens that are silent for a moment let go of it, so nothing else runs beside
    // this test (real_time).
    const auto travel = [&] { return std::abs(live().status().axes[1].cmd - from); };
    QTest::mousePress(&manual.axes(), Qt::LeftButton, {}, key);
    EXPECT_TRUE(waitFor([&] { return travel() > 0.5; }, 10))
        << "the key was held for 10 s and the axis has moved " << travel() << " mm";
    QTest::mouseRelease(&manual.axes(), Qt::LeftButton, {}, key);
    ASSERT_TRUE(waitFor([&] { return !(live().status().axes[1].flags & kMoving); }));
}

// Step and held, the second axis, an override: everything on the screen without a touch.
TEST_F(Tasks, AnAxisIsMovedByKeysAlone) {
    Operator hand(*window);
    hand.screen("manual");
    const auto stands = [&] { return !(live().status().axes[1].flags & kMoving); };
    const auto before = live().status().axes[1].cmd;
    hand.key(Qt::Key_Down);
    for (int step = 0; step < 6; ++step) hand.key(Qt::Key_Left);
    for (int step = 0; step < 4; ++step) hand.key(Qt::Key_Right);  // 1 mm
    hand.key(Qt::Key_Plus);
    ASSERT_TRUE(waitFor([&] {
        return std::abs(live().status().axes[1].cmd - before - 1.0) < 1e-9 && stands();
    })) << live().status().axes[1].cmd - before;
    for (int step = 0; step < 4; ++step) hand.key(Qt::Key_Left);  // as held
    QTest::keyPress(window.get(), Qt::Key_Minus);
    EXPECT_TRUE(waitFor([&] { return live().status().axes[1].cmd < before + 0.5; }, 10))
        << "the key was held for 10 s: " << live().status().axes[1].cmd - before
        << " mm from the start";
    QTest::keyRelease(window.get(), Qt::Key_Minus);
    ASSERT_TRUE(waitFor(stands));
    const double override = live().channel(1).feed_override;
    hand.key(Qt::Key_PageDown);
    ASSERT_TRUE(waitFor([&] { return live().channel(1).feed_override < override; }));
    hand.key(Qt::Key_PageUp);
    ASSERT_TRUE(waitFor([&] { return live().channel(1).feed_override >= override; }));
    hand.key(Qt::Key_PageDown, Qt::ControlModifier);
    EXPECT_EQ(window->context().channel, 2u);
    hand.key(Qt::Key_PageUp, Qt::ControlModifier);
    EXPECT_EQ(window->context().channel, 1u);
}

// The cover of the panel lock must not keep a finger's key down for ever.
TEST_F(Tasks, TheLockLetsGoOfAHeldJogKey) {
    Operator hand(*window);
    hand.screen("manual");
    Manual& manual = screenOf<Manual>();
    hand.touch(&manual.axes(), Manual::kStepHits);
    const auto moves = [&] { return (live().status().axes[1].flags & kMoving) != 0; };
    const QPoint key = manual.axes().boxOf(Manual::jogHit(2, false)).center().toPoint();
    QTest::mousePress(&manual.axes(), Qt::LeftButton, {}, key);
    ASSERT_TRUE(waitFor(moves, 10))
        << "the key was held for 10 s and the axis has not begun to move";
    window->lock(true);
    ASSERT_TRUE(waitFor([&] { return !moves(); }))
        << "the key was still down when the panel was locked";
    const double stood = live().status().axes[1].cmd;
    QTest::qWait(800);
    EXPECT_EQ(live().status().axes[1].cmd, stood);
    QTest::mouseRelease(&manual.axes(), Qt::LeftButton, {}, key);
    QTest::keyPress(window.get(), Qt::Key_Minus);  // nothing begins beneath the cover
    frames(*window, 500);
    QTest::keyRelease(window.get(), Qt::Key_Minus);
    EXPECT_EQ(live().status().axes[1].cmd, stood);
    window->lock(false);
}

TEST_F(Tasks, WhoHitsTheEmergencyStopTwiceDoesNotSwitchTheMachineOn) {
    Operator hand(*window);
    hand.screen("manual");
    bool off = false;
    for (int hit = 0; hit < 17; ++hit) {  // longer than the key stays that of the stop by itself
        hand.key(Qt::Key_F10);
        QTest::qWait(300);
        off |= live().status().machine_state == 0;
        ASSERT_FALSE(off && live().status().machine_state != 0) << "switched on by hit " << hit;
    }
    ASSERT_TRUE(waitFor([&] { return live().status().machine_state == 0; }));
    QTest::qWait(800);
    EXPECT_EQ(live().status().machine_state, 0u);
    ASSERT_TRUE(waitFor([&] {
        for (const SoftKey& key : screenOf<Manual>().keys())
            if (key.text == word("Machine on")) return !key.confirm.isEmpty();
        return false;
    }));
    hand.soft("Machine on");
    frames(*window, 300);
    EXPECT_EQ(live().status().machine_state, 0u) << "one press must not switch it on";
    hand.soft("Machine on");
    EXPECT_TRUE(waitFor([&] { return live().status().machine_state == 2; }));
}

TEST_F(Tasks, AStartWithoutABlockInMdiStartsNothing) {
    startJob();
    ASSERT_TRUE(g_controller->press("reset"));
    ASSERT_TRUE(waitFor(
        [&] { return state(1) == ChannelState::Reset && state(2) == ChannelState::Reset; }));
    ASSERT_TRUE(g_controller->press("mode L1=mdi"));
    ASSERT_TRUE(waitFor(
        [&] { return static_cast<ChannelMode>(live().channel(1).mode) == ChannelMode::Mdi; }));
    Operator hand(*window);
    hand.screen("manual");
    hand.soft("Start L1");
    hand.screen("overview");
    hand.soft("Start L1");
    frames(*window, 500);
    EXPECT_EQ(state(1), ChannelState::Reset);
    ASSERT_TRUE(g_controller->press("reset L1"));
    ASSERT_TRUE(g_controller->press("mode L1=auto"));
}

// F3202: the maker's macros O9000 and on are nobody's to read or change.
TEST_F(Tasks, AProtectedProgramIsNeitherShownNorEdited) {
    QTemporaryDir folder;
    for (const char* name : {"O9001.nc", "O0901.nc"}) {
        QFile file(folder.filePath(name));
        ASSERT_TRUE(file.open(QIODevice::WriteOnly));
        file.write("G4 X1.\n");
    }
    ASSERT_TRUE(g_controller->set("F3202 L1=16"));
    ASSERT_TRUE(waitFor([&] { return params::bit(live().table(), params::f3202, 1, 4); }));
    Programs& programs = screenOf<Programs>();
    Operator hand(*window);
    hand.screen("programs");
    for (const auto& [name, kept] : {std::pair{"O9001.nc", true}, {"O0901.nc", false}}) {
        SCOPED_TRACE(name);
        programs.filesPage().readFolder(folder.path(), name);
        ASSERT_TRUE(waitFor([&] { return programs.filesPage().chosenPath().endsWith(name); }));
        EXPECT_EQ(programs.filesPage().whyNotChanged().contains("F3202"), kept)
            << programs.filesPage().whyNotChanged().toStdString();
    }
    ASSERT_TRUE(g_controller->set("F3202 L1=0"));
}

TEST_F(Tasks, TheScreensComeBackWithTheController) {
    g_controller->stop();
    ASSERT_TRUE(waitFor([&] { return !live().connected(); }));
    g_controller->start();
    ASSERT_TRUE(waitFor([&] { return live().connected() && live().channels().size() == 2; }));
}

}  // namespace
}  // namespace polyturn::hmi
