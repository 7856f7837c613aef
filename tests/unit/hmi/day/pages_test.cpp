// Pages that act: the wheel, a tool called from its station, part transfer, the editor, help; and
// machines with many channels.
#include <QFile>

#include "hmi/screens/machine/alarms.hpp"
#include "hmi/screens/machine/diagnosis.hpp"
#include "hmi/screens/overview/manual.hpp"
#include "hmi/screens/programs/programs.hpp"
#include "tests/unit/hmi/tasks.hpp"

namespace polyturn::hmi {
namespace {

// On the machine with a counter spindle that takes the part over.
class PageTasks : public Tasks {
protected:
    static void SetUpTestSuite() { g_controller = new Controller("transfer"); }
};

TEST_F(PageTasks, TheSpindleIsTurnedByHand) {
    ASSERT_TRUE(g_controller->press("mode L1=auto"));
    Operator hand(*window);
    hand.screen("manual");
    hand.soft("Wheel, tool, transfer");
    HandPage& page = screenOf<Manual>().hand();
    ASSERT_TRUE(waitFor([&] { return live().plc(signals::cp_turretopen(1)) == 0; }))
        << "a turret on its way holds the spindle";
    ASSERT_TRUE(waitFor([&] { return page.spindleBlock().startsWith("G97 S"); }))
        << page.spindleBlock().toStdString();
    const QString name = "Spindle " + page.spindleBlock().mid(4);
    hand.soft(name);
    frames(*window, 300);
    EXPECT_LT(std::abs(live().status().spindles[0].speed), 1) << "one press must not turn it";
    hand.soft(name);
    EXPECT_TRUE(standsOn(window->ownSheets(), "choose Jog or MDI")) << "no key changes the mode";
    ASSERT_TRUE(g_controller->press("mode L1=jog"));
    ASSERT_TRUE(waitFor(
        [&] { return static_cast<ChannelMode>(live().channel(1).mode) == ChannelMode::Jog; }));
    hand.soft(name);
    hand.soft(name);
    ASSERT_TRUE(waitFor([&] { return std::abs(live().status().spindles[0].speed) > 100; }));
    EXPECT_EQ(static_cast<ChannelMode>(live().channel(1).mode), ChannelMode::Jog);
    ASSERT_TRUE(
        waitFor([&] { return page.spindleBlock() == "M5" && state(1) != ChannelState::Running; }));
    hand.soft("Spindle stop");
    EXPECT_TRUE(waitFor([&] { return std::abs(live().status().spindles[0].speed) < 1; }));
}

TEST_F(PageTasks, TheWheelTurnsAnAxisByKeysByTouchAndByTheDial) {
    Operator hand(*window);
    hand.screen("manual");
    hand.soft("Wheel, tool, transfer");
    HandPage& page = screenOf<Manual>().hand();
    hand.soft("Handwheel");
    ASSERT_TRUE(waitFor([&] {
        return static_cast<ChannelMode>(live().channel(1).mode) == ChannelMode::Handwheel;
    }));
    hand.key(Qt::Key_Down);  // X, then Z
    ASSERT_EQ(page.axis(), 2u);
    const auto stands = [&] { return !(live().status().axes[1].flags & kMoving); };
    const auto place = [&] { return live().status().axes[1].cmd; };
    ASSERT_TRUE(waitFor(stands, 10));
    const double from = place();
    hand.touch(&page.wheel(), HandPage::kFactorHits + 2);  // a hundred clicks a click: 0.1 mm
    hand.key(Qt::Key_Right);
    hand.key(Qt::Key_Plus);
    hand.touch(&page.wheel(), HandPage::kPlusHit);
    EXPECT_TRUE(waitFor([&] { return std::abs(place() - from - 0.3) < 1e-6; })) << place() - from;
    const QRectF dial = page.wheel().boxOf(HandPage::kDialHit);
    const auto point = [&](double turn) {
        return (dial.center() + QPointF(std::cos(turn * 6.2831853), std::sin(turn * 6.2831853)) *
                                    dial.width() * 0.4)
            .toPoint();
    };
    QTest::mousePress(&page.wheel(), Qt::LeftButton, {}, point(0));
    // a quarter back
    for (int i = 1; i <= 25; ++i) {
        QTest::mouseMove(&page.wheel(), point(-i / 100.0));
        QTest::qWait(2);
    }
    QTest::mouseRelease(&page.wheel(), Qt::LeftButton, {}, point(-0.25));
    EXPECT_TRUE(waitFor([&] { return stands() && place() < from - 2.0; })) << place() - from;
    EXPECT_NEAR(place() - from, 0.3 - 2.5, 0.21);
    noWordIsShortened(*window);
}

TEST_F(PageTasks, AToolIsCalledFromItsStation) {
    Operator hand(*window);
    hand.screen("manual");
    hand.soft("Wheel, tool, transfer");
    HandPage& page = screenOf<Manual>().hand();
    hand.touchCell(page.tools(), 4, 0);  // station 5
    EXPECT_EQ(page.toolBlock(), "T0505");
    ASSERT_TRUE(g_controller->press("mode L1=jog"));
    hand.soft("Call T0505");
    frames(*window, 200);
    EXPECT_FALSE(live().view(1).known && live().view(1).picture.tool == 5)
        << "one press must not turn the turret";
    hand.soft("Call T0505");
    EXPECT_TRUE(waitFor([&] { return live().view(1).known && live().view(1).picture.tool == 5; }));
}

// Whichever channel is chosen: the steps are said by the turrets that take part.
TEST_F(PageTasks, PartTransferGoesStepByStep) {
    Operator hand(*window);
    hand.screen("manual");
    hand.soft("Wheel, tool, transfer");
    HandPage& page = screenOf<Manual>().hand();
    ASSERT_TRUE(g_controller->press("mode L1=jog L2=jog"));
    const auto choose = [&](int row) { hand.touchCell(page.steps(), row, 1); };
    const auto step = [&](int row) {
        choose(row);
        const double lit = live().channel(2).lit_s;
        hand.soft("Do this step");
        hand.soft("Do this step");
        EXPECT_TRUE(waitFor([&] { return live().channel(2).lit_s > lit; }))
            << "the block has begun";
        EXPECT_TRUE(waitFor([&] {
            return state(2) != ChannelState::Running && state(2) != ChannelState::Waiting;
        }));
    };
    const auto isOpen = [&](unsigned spindle) {
        return live().plc(signals::sp_unclamped(spindle)) != 0;
    };
    choose(1);  // M11 while plain S means the main spindle
    hand.soft("Do this step");
    hand.soft("Do this step");
    EXPECT_TRUE(standsOn(window->ownSheets(), "means S1 now"));
    frames(*window, 300);
    EXPECT_FALSE(isOpen(1)) << "the main chuck holds a part";
    EXPECT_FALSE(isOpen(2));
    // M72 M11
    step(0);
    step(1);
    EXPECT_TRUE(waitFor([&] { return isOpen(2); })) << "the counter chuck is open";
    EXPECT_FALSE(isOpen(1));
    step(5);  // M10
    EXPECT_TRUE(waitFor([&] { return !isOpen(2); }));
    step(11);  // M71
}

TEST_F(PageTasks, TheEditorMarksFaultsWhileOneTypes) {
    QTemporaryDir folder;
    QFile file(folder.filePath("O0007.nc"));
    ASSERT_TRUE(file.open(QIODevice::WriteOnly));
    file.write("O0007\nN10 G98 G0 X40. Z5.\nN20 G1 X4.0. F200.\nN30 M30\n");
    file.close();
    Programs& programs = screenOf<Programs>();
    programs.restore("0|" + file.fileName());
    Operator hand(*window);
    hand.screen("programs");
    hand.soft("Edit");
    EditorPage& editor = programs.editor();
    ASSERT_EQ(editor.file(), file.fileName());
    ASSERT_TRUE(waitFor([&] { return !editor.checking() && !editor.faults().empty(); }));
    EXPECT_EQ(editor.faults().front().line, 3);
    EXPECT_GT(editor.faults().front().column, 0);
    EXPECT_FALSE(editor.edit().extraSelections().isEmpty());
    // take the second point away
    QTextCursor cursor(editor.edit().document()->findBlockByNumber(2));
    cursor.movePosition(QTextCursor::Right, QTextCursor::MoveAnchor, 12);
    editor.edit().setTextCursor(cursor);
    QTest::keyClick(&editor.edit(), Qt::Key_Backspace);
    ASSERT_EQ(editor.edit().document()->findBlockByNumber(2).text(), "N20 G1 X4.0 F200.");
    EXPECT_TRUE(waitFor([&] { return !editor.checking() && editor.faults().empty(); }))
        << (editor.faults().empty() ? "" : editor.faults().front().text.toStdString());
    EXPECT_TRUE(editor.changed());
    hand.soft("Save");
    EXPECT_TRUE(waitFor([&] { return !editor.changed(); })) << "it is written beside";
    ASSERT_TRUE(file.open(QIODevice::ReadOnly));
    EXPECT_EQ(file.readAll(), "O0007\nN10 G98 G0 X40. Z5.\nN20 G1 X4.0 F200.\nN30 M30\n");
    EXPECT_EQ(QDir(folder.path()).entryList(QDir::Files | QDir::Hidden).size(), 1)
        << "nothing is left beside it";
}

// What the PLC says of its machine, in the language of the screens: here the built-in one's first
// message.
TEST_F(PageTasks, AMessageOfTheMachinesBuilderIsReadInTheReadersLanguage) {
    for (const char* key : {"reset", "mode L1=mdi"})
        ASSERT_TRUE(waitFor([&] { return g_controller->press(key); })) << key;
    ASSERT_TRUE(waitFor([&] {
        return std::abs(live().status().spindles[0].speed) > 100 ||
               (g_controller->press("hand_key L1 G97 M3 S500"), QTest::qWait(500), false);
    }));
    const auto told = [&]() -> const AlarmEntry* {
        for (const AlarmEntry& one : window->context().alarms.all())
            if (one.told && one.text.contains("the chuck must not open while the spindle turns"))
                return &one;
        return nullptr;
    };
    ASSERT_TRUE(waitFor([&] {
        return told() || (g_controller->press("hand_key L1 M11"), QTest::qWait(500), false);
    }));
    EXPECT_EQ(told()->remedy, "Program M5 before M11.");
    const auto at = told() - window->context().alarms.all().data();
    window->setDisplayLanguage(DisplayLanguage::Russian);
    const AlarmEntry& entry = window->context().alarms.all()[static_cast<std::size_t>(at)];
    ASSERT_TRUE(waitFor([&] { return entry.told; }));
    EXPECT_TRUE(entry.text.contains(QString::fromUtf8(
        "патрон нельзя разжать при вращении шпинделя; причина: M11 до останова шпинделя")))
        << entry.text.toStdString();
    EXPECT_EQ(entry.remedy, QString::fromUtf8("Запрограммируйте M5 перед M11."));
    window->setDisplayLanguage(DisplayLanguage::English);
    for (const char* key : {"reset", "mode L1=mdi", "hand_key L1 M5", "reset", "mode L1=auto"})
        ASSERT_TRUE(waitFor([&] { return g_controller->press(key); })) << key;
}

// Which spindle follows which, and since which M code of which channel.
TEST_F(PageTasks, ACouplingTellsSinceWhichCode) {
    for (const char* key : {"reset", "mode L2=mdi"})
        ASSERT_TRUE(waitFor([&] { return g_controller->press(key); })) << key;
    ASSERT_TRUE(waitFor([&] {
        return live().status().spindles[1].master == 1 ||
               (g_controller->press("hand_key L2 M60"), QTest::qWait(500), false);
    }));
    Operator hand(*window);
    hand.screen("diagnosis");
    hand.soft("Couplings");
    Table& table = screenOf<Diagnosis>().table();
    const auto cell = [&](int column) {
        return table.rows() ? table.cell(0, column).text : QString();
    };
    EXPECT_TRUE(waitFor([&] { return cell(0) == "S2" && cell(1) == "S1"; }))
        << cell(0).toStdString();
    EXPECT_TRUE(cell(3).startsWith("M60 L2")) << cell(3).toStdString();
    for (const char* key : {"hand_key L2 M62", "reset", "mode L2=auto"})
        ASSERT_TRUE(waitFor([&] { return g_controller->press(key); })) << key;
}

TEST_F(PageTasks, TheHelpKeyOpensThePageOfWhatIsChosen) {
    Operator hand(*window);
    hand.screen("tools");
    hand.key(Qt::Key_Help);
    ASSERT_TRUE(window->help().isVisible());
    EXPECT_TRUE(window->help().text().toPlainText().contains("Enter tools and load them"));
    EXPECT_EQ(window->help().text().textCursor().selectedText(), "2. Enter tools and load them")
        << "it stands at the place";
    hand.key(Qt::Key_Escape);
    EXPECT_FALSE(window->help().isVisible());
    hand.screen("parameters");
    hand.key(Qt::Key_H, Qt::ControlModifier);
    EXPECT_TRUE(window->help().text().toPlainText().startsWith("N0"))
        << window->help().text().toPlainText().left(80).toStdString();
    const auto place = [&] {
        return window->help().text().toPlainText().indexOf("The machine is its parameters");
    };
    ASSERT_TRUE(waitFor([&] { return place() >= 0; })) << "the manual's page of it";
    EXPECT_LT(place() - window->help().text().toPlainText().indexOf("Level"), 200) << "right below";
    hand.key(Qt::Key_Escape);
    // What the tests before have left may still be coming to its end: each key is pressed until it
    // is taken.
    for (const char* key : {"mode L1=auto", "select L1=/nowhere/at/all.nc"})
        ASSERT_TRUE(waitFor([&] { return g_controller->press(key); })) << key;
    hand.screen("alarms");
    ASSERT_TRUE(waitFor([&] {
        return window->context().alarms.standing() ||
               (g_controller->press("cycle_start L1"), QTest::qWait(300),
                window->context().alarms.standing());
    }));
    const AlarmEntry alarm = *window->context().alarms.standing();
    ASSERT_TRUE(waitFor([&] { return !screenOf<Alarms>().rows().empty(); }));
    frames(*window, 100);
    hand.key(Qt::Key_Help);
    const QString text = window->help().text().toPlainText();
    EXPECT_TRUE(text.contains(alarm.number) && text.contains(alarm.remedy.left(20)))
        << text.left(200).toStdString();
    g_controller->press("reset");
}

}  // namespace
}  // namespace polyturn::hmi
