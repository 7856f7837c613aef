// What an operator at the panel was misled by, or stuck at, each as he met it: a folder that is not
// the one on the disk, a new tool whose name goes to another one, an alarm whose cause is hidden.
#include <QFile>
#include <QTemporaryDir>

#include "hmi/screens/machine/alarms.hpp"
#include "hmi/screens/overview/manual.hpp"
#include "hmi/screens/programs/programs.hpp"
#include "hmi/screens/tools/tools.hpp"
#include "tests/unit/hmi/tasks.hpp"

namespace polyturn::hmi {
namespace {

class OperatorDay : public Tasks {
protected:
    void write(const QString& name, const QByteArray& text) {
        QFile file(folder.filePath(name));
        ASSERT_TRUE(file.open(QIODevice::WriteOnly)) << name.toStdString();
        file.write(text);
    }
    bool shown(const QString& words) {
        frames(*window);
        return standsOn(window->screen()->sheets(), words);
    }
    bool told(const QString& words) {
        frames(*window);
        return standsOn(window->ownSheets(), words);
    }
    bool listed(const QString& name) {
        frames(*window);
        Table& files = screenOf<Programs>().files();
        for (int row = 0; row < files.rows(); ++row)
            if (files.cell(row, 0).text == name) return true;
        return false;
    }
    // A program into the channel that is chosen, from a folder of its own.
    void select(unsigned channel, const QString& name) {
        ASSERT_TRUE(
            g_controller->press(QString("select L%1=%2").arg(channel).arg(folder.filePath(name))));
        ASSERT_TRUE(waitFor([&] {
            return !live().view(channel).programs.empty() &&
                   QString::fromStdString(live().view(channel).programs[0]).endsWith(name);
        }));
    }
    QTemporaryDir folder;
};

// A program from a stick, and one that has just been saved: the list and the text beside it are
// those of the disk, without going up and into the folder again.
TEST_F(OperatorDay, TheFolderOnTheScreenIsTheOneOnTheDisk) {
    write("first.nc", "O1\nN10 G4 X1.\nM30\n");
    Operator hand(*window);
    hand.screen("programs");
    screenOf<Programs>().filesPage().readFolder(folder.path(), "first.nc");
    ASSERT_TRUE(waitFor([&] { return shown("N10 G4 X1."); }));
    write("second.nc", "O2\nM30\n");
    EXPECT_TRUE(waitFor([&] { return listed("second.nc"); }, 15)) << "while one looks at it";
    hand.screen("overview");
    write("first.nc", "O1\nN10 G4 X1.\nN20 G4 X12.5\nM30\n");
    write("third.nc", "O3\nM30\n");
    hand.screen("programs");
    EXPECT_TRUE(waitFor([&] { return listed("third.nc"); }, 15));
    EXPECT_TRUE(waitFor([&] { return shown("N20 G4 X12.5"); }, 15)) << "the text as it is now";
    EXPECT_EQ(screenOf<Programs>().filesPage().chosenPath(), folder.filePath("first.nc"))
        << "what was chosen stays chosen";
}

// «Tool 2 is new: enter what it is», and the name that is typed goes to tool 2.
TEST_F(OperatorDay, WhatIsEnteredBehindNewToolIsOfTheNewOne) {
    for (const char* tool : {"1", "2"})
        g_controller->run({"tools", "delete", tool, "--instance", g_controller->name});
    ASSERT_TRUE(g_controller->run(
        {"tools", "add", "1", "name=ROUGH_80", "type=1", "--instance", g_controller->name}));
    const auto& rows = live().tools().rows;
    ASSERT_TRUE(waitFor([&] { return rows[0].used; }));
    Operator hand(*window);
    hand.screen("tools");
    hand.soft("Tool data");
    ASSERT_TRUE(waitFor([&] { return shown("ROUGH_80"); }));
    hand.soft("New tool");
    ASSERT_TRUE(waitFor([&] { return told("is new: enter what it is"); }));
    ASSERT_TRUE(waitFor([&] { return rows[1].used; }));
    frames(*window, 200);
    hand.type("DRILL_8");
    hand.key(Qt::Key_Return);
    EXPECT_TRUE(waitFor([&] { return QString(rows[1].name.data()) == "DRILL_8"; }, 10));
    EXPECT_STREQ(rows[0].name.data(), "ROUGH_80") << "the tool that was there keeps its name";
    for (const char* tool : {"1", "2"})
        g_controller->run({"tools", "delete", tool, "--instance", g_controller->name});
}

// L1 stops at a wrong word, L2 then waits for a channel that does not come: the touch on the alarm
// of the bar opens that alarm, and not the newest of what came of it; a key goes to the wrong line.
TEST_F(OperatorDay, ATouchOnTheAlarmOpensItAndAKeyGoesToItsLine) {
    write("wrong.nc", "O1\nN10 G4 X0.2\nN20 G1 X\nM30\n");
    write("waits.nc", "O2\nN10 M500 P12\nM30\n");
    select(1, "wrong.nc");
    select(2, "waits.nc");
    ASSERT_TRUE(waitFor([&] {
        return live().channel(1).start_missing == 0 && live().channel(2).start_missing == 0;
    }));
    ASSERT_TRUE(g_controller->press("cycle_start"));
    const auto& all = window->context().alarms.all();
    ASSERT_TRUE(waitFor([&] {
        return state(1) == ChannelState::Interrupted &&
               std::any_of(all.begin(), all.end(), [](const AlarmEntry& one) {
                   return one.channel == 2 && one.severity == Severity::Warning && one.standing;
               });
    }));
    Operator hand(*window);
    hand.screen("overview");
    frames(*window, 200);
    Sheet* top = window->ownSheets()[0];
    const AlarmEntry* alarm = window->context().alarms.standing();
    ASSERT_TRUE(alarm && alarm->channel == 1);
    const QString text = alarm->text;
    for (const Item& item : top->items())
        if (item.text.contains(text)) {
            QTest::mouseClick(top, Qt::LeftButton, {}, item.box.center().toPoint());
            break;
        }
    ASSERT_STREQ(window->screen()->name(), "alarms");
    Alarms& alarms = screenOf<Alarms>();
    const int row = alarms.state().section(' ', 1, 1).toInt();
    ASSERT_LT(row, static_cast<int>(alarms.rows().size()));
    EXPECT_EQ(alarms.rows()[static_cast<std::size_t>(row)].text.toStdString(), text.toStdString());
    hand.soft("Open the program");
    ASSERT_STREQ(window->screen()->name(), "programs");
    Programs& programs = screenOf<Programs>();
    EXPECT_TRUE(waitFor([&] {
        frames(*window);
        return programs.editor().file() == folder.filePath("wrong.nc") &&
               programs.editor().edit().textCursor().blockNumber() == 2;
    })) << "the third line";
    ASSERT_TRUE(g_controller->press("reset"));
}

// A block typed in automatic mode is refused at Enter; a start right behind it must not run the
// program instead.
TEST_F(OperatorDay, AStartWithALineInTheMdiFieldDoesNotRunTheProgram) {
    ASSERT_TRUE(g_controller->press("mode L1=auto"));
    write("long.nc", "O1\nN10 G4 X20.\nM30\n");
    select(1, "long.nc");
    ASSERT_TRUE(waitFor([&] { return live().channel(1).start_missing == 0; }));
    Manual& manual = screenOf<Manual>();
    Operator hand(*window);
    hand.screen("manual");
    hand.touch(&manual.side(), Manual::kMdiHit);
    EXPECT_TRUE(shown("MDI mode takes blocks")) << "in this mode the field takes none";
    hand.type("G0 X170.");
    hand.soft("Start L1");
    frames(*window, 500);
    EXPECT_NE(state(1), ChannelState::Running);
    EXPECT_TRUE(told("The line of MDI is not entered"));
    hand.key(Qt::Key_Escape);  // who leaves the field means the program
    hand.soft("Start L1");
    EXPECT_TRUE(waitFor([&] { return state(1) == ChannelState::Running; }));
    manual.typeMdi({});
    ASSERT_TRUE(g_controller->press("reset"));
}

// In a hold «Jog» meant a refusal that advised a reset, which would have cost the part.
TEST_F(OperatorDay, JogInAHoldIsPointedToItsKey) {
    startAndHoldJob();
    const std::size_t before = window->context().alarms.all().size();
    Operator hand(*window);
    hand.screen("manual");
    hand.soft("Jog");
    EXPECT_TRUE(told("Jog in hold L1"));
    frames(*window, 600);
    EXPECT_EQ(window->context().alarms.all().size(), before) << "no alarm that advises a reset";
    EXPECT_EQ(static_cast<ChannelMode>(live().channel(1).mode), ChannelMode::Auto);
    hand.soft("MDI");
    frames(*window, 600);
    EXPECT_EQ(window->context().alarms.all().size(), before) << "a hold takes blocks in the field";
    hand.key(Qt::Key_Escape);
    ASSERT_TRUE(g_controller->press("reset"));
}

// One key enters what the job brings, zeros and offsets, and another takes it back.
TEST_F(OperatorDay, TheJobsZerosAndOffsetsAreEnteredByOneKey) {
    write("part.job.toml",
          "name = \"part\"\nsetup = \"part.setup.toml\"\n"
          "[programs]\n1 = { file = \"one.nc\", language = \"fanuc\" }\n"
          "[zeros]\n1 = { G54 = { Z = -150.0 } }\n");
    write("part.setup.toml",
          "[channel.1.offset.27]\ngeometry = { X = 12.5, R = 0.8, T = 3 }\nwear = { X = 0.04 }\n");
    write("one.nc", "O1\nM30\n");
    const auto& offset = [&]() -> const auto& { return live().store(1).offsets[27]; };
    ASSERT_TRUE(g_controller->set("offset L1 27 geometry X=1.25"));
    ASSERT_TRUE(g_controller->set("zero L1 G54 Z=-20"));
    ASSERT_TRUE(waitFor([&] { return offset().geometry[0] == 1.25; }));
    Operator hand(*window);
    hand.screen("programs");
    screenOf<Programs>().filesPage().readFolder(folder.path(), "part.job.toml");
    ASSERT_TRUE(waitFor([&] { return shown("entered: -20.000") && shown("X 12.500"); }));
    hand.soft("Select job");
    ASSERT_TRUE(waitFor([&] { return told("L1 27"); }));
    const auto& line = window->ownSheets()[2]->items();
    EXPECT_TRUE(std::any_of(line.begin(), line.end(), [](const Item& one) {
        return one.kind == Item::Kind::Sign && one.sign == Sign::Warning;
    })) << "other offsets than the job's are a warning";
    hand.soft("Enter zeros, offsets");
    hand.soft("Enter zeros, offsets");
    EXPECT_TRUE(waitFor([&] {
        return live().store(1).zeros[kZeroG54 * kChannelAxes + 1] == -150 &&
               offset().geometry[0] == 12.5 && offset().wear[0] == 0.04;
    }));
    EXPECT_TRUE(waitFor([&] { return told("part.job.toml"); }));
    hand.soft("Undo zeros, offsets");
    EXPECT_TRUE(waitFor([&] {
        return live().store(1).zeros[kZeroG54 * kChannelAxes + 1] == -20 &&
               offset().geometry[0] == 1.25 && offset().wear[0] == 0;
    }));
    ASSERT_TRUE(g_controller->set("offset L1 27 geometry X=0"));
    ASSERT_TRUE(g_controller->set("zero L1 G54 Z=0"));
}

// A key that finds nothing says so: behind it «Start all» would begin everything anew.
TEST_F(OperatorDay, NoToolCallToRestartAtIsTold) {
    write("plain.nc", "O1\nN10 G4 X20.\nM30\n");
    for (const unsigned channel : {1u, 2u}) select(channel, "plain.nc");
    ASSERT_TRUE(waitFor([&] { return live().channel(1).start_missing == 0; }));
    ASSERT_TRUE(g_controller->press("cycle_start L1"));
    ASSERT_TRUE(waitFor([&] { return state(1) == ChannelState::Running; }));
    frames(*window, 300);
    ASSERT_TRUE(g_controller->press("reset L1"));
    ASSERT_TRUE(waitFor([&] { return state(1) == ChannelState::Reset; }));
    Operator hand(*window);
    hand.screen("programs");
    hand.soft("Restart in the middle");
    hand.soft("All from their last tool call");
    EXPECT_TRUE(told("No tool has been called"));
}

// A start that lacks something says that it is blocked, and by what.
TEST_F(OperatorDay, WhatBlocksAStartIsNotSaidToBeNeeded) {
    ASSERT_TRUE(g_controller->press("mode L1=mdi"));
    Operator hand(*window);
    hand.screen("overview");
    EXPECT_TRUE(waitFor([&] { return shown("Start blocked: no block is entered"); }, 20));
    EXPECT_FALSE(shown("A start needs"));
    ASSERT_TRUE(g_controller->press("mode L1=auto"));
}

// A fault of another program of the job has no line in this one.
TEST_F(OperatorDay, AFaultOfAnotherProgramHasNoPlaceInThisOne) {
    write("two.job.toml",
          "name = \"two\"\n[programs]\n1 = { file = \"good.nc\", language = \"fanuc\" }\n"
          "2 = { file = \"bad.nc\", language = \"fanuc\" }\n");
    write("good.nc", "O1\nN10 G4 X1.\nM30\n");
    write("bad.nc", "O2\nN10 G1 X\nM30\n");
    Operator hand(*window);
    hand.screen("programs");
    screenOf<Programs>().filesPage().readFolder(folder.path(), "good.nc");
    ASSERT_TRUE(waitFor([&] { return shown("N10 G4 X1."); }));
    hand.soft("Edit");
    EXPECT_TRUE(waitFor([&] { return shown("bad.nc:2"); }));
    for (Sheet* sheet : window->screen()->sheets())
        for (const Item& item : sheet->items())
            EXPECT_FALSE(item.text.startsWith("0:")) << item.text.toStdString();
    hand.key(Qt::Key_Escape);
}

// Of many channels a row of them is a range: the words behind them are read.
TEST(ChannelLists, OfManyAreRanges) {
    std::vector<unsigned> all(16);
    for (unsigned i = 0; i < all.size(); ++i) all[i] = i + 1;
    EXPECT_EQ(channelList(all), QString::fromUtf8("L1–L16"));
    EXPECT_EQ(channelList({1, 2}), "L1 L2");
    EXPECT_EQ(channelList({1, 3, 4, 5, 6, 9}), QString::fromUtf8("L1 L3–L6 L9"));
}

}  // namespace
}  // namespace polyturn::hmi
