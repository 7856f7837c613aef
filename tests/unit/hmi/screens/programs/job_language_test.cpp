// A job may be in another language than PT_LANGUAGE: what screens say of its programs is in that of
// the job.
#include <QFile>

#include "hmi/screens/overview/overview.hpp"
#include "hmi/screens/programs/programs.hpp"
#include "tests/places.hpp"
#include "tests/unit/hmi/tasks.hpp"

namespace polyturn::hmi {
namespace {

// Two programs that meet at a marker, in a folder with the job that has them.
class JobLanguage : public Tasks {
protected:
    void SetUp() override {
        Tasks::SetUp();
        if (HasFatalFailure()) return;
        write(
            "markers.job.toml",
            "name = \"markers\"\n[programs]\n1 = { file = \"FIRST.MPF\", language = \"sinumerik\" "
            "}\n"
            "2 = { file = \"SECOND.MPF\", language = \"sinumerik\" }\n"
            "[zeros]\n1 = { G54 = { Z = -150.0 } }\n");
        write("FIRST.MPF", "N10 G90 G95\nN20 WAITM(3,1,2)\nN30 M30\n");
        write("SECOND.MPF", "N10 G4 F60\nN20 WAITM(3,1,2)\nN30 M30\n");
    }
    void TearDown() override {
        g_controller->press("reset");
        g_controller->press("ignore_waits L1=off");
        g_controller->press("select " + QString(kSourceFolder) +
                            "/examples/jobs/shaft/shaft.job.toml");
    }
    void write(const QString& name, const char* text) {
        QFile file(folder.filePath(name));
        ASSERT_TRUE(file.open(QIODevice::WriteOnly));
        file.write(text);
    }
    void choose(const QString& name) {
        Programs& programs = screenOf<Programs>();
        programs.restore("0|" + folder.filePath(name));
        ASSERT_TRUE(
            waitFor([&] { return programs.filesPage().chosenPath() == folder.filePath(name); }));
    }
    bool shown(const QString& text) const { return standsOn(window->screen()->sheets(), text); }
    // in the line of messages
    bool told(const QString& text) const { return standsOn(window->ownSheets(), text); }
    QTemporaryDir folder;
};

TEST_F(JobLanguage, NamesItsWaitsAndOpensItsReference) {
    ASSERT_TRUE(g_controller->press("reference all"));
    ASSERT_TRUE(waitFor(
        [&] { return static_cast<MachineStep>(live().status().step) == MachineStep::Ready; }));
    for (const char* key : {"mode L1=auto", "mode L2=auto"}) ASSERT_TRUE(g_controller->press(key));
    ASSERT_TRUE(g_controller->press("select " + folder.filePath("markers.job.toml")));
    ASSERT_TRUE(waitFor([&] {
        return live().language(1) == Dialect::Sinumerik && live().language(2) == Dialect::Sinumerik;
    }));
    EXPECT_EQ(live().panelLanguage(1), Dialect::Fanuc)
        << "what is entered by hand stays the machine's";
    ASSERT_TRUE(g_controller->press("cycle_start"));
    ASSERT_TRUE(waitFor([&] { return state(1) == ChannelState::Waiting; }))
        << waitWords(live(), 1).toStdString();
    EXPECT_TRUE(waitWords(live(), 1).contains("WAITM(3)")) << waitWords(live(), 1).toStdString();
    EXPECT_FALSE(waitWords(live(), 1).contains("M3 "));
    Operator hand(*window);
    hand.screen("overview");
    ASSERT_TRUE(waitFor([&] { return live().view(1).known; }));
    EXPECT_EQ(screenOf<Overview>().help().page, "reference_sinumerik.md");
}

// Its zeros are not taken over: what is entered holds, and the sheet and the line of the selection
// say so.
TEST_F(JobLanguage, WhatItHasOtherwiseIsTold) {
    ASSERT_TRUE(g_controller->set("zero L1 G54 Z=-20"));
    choose("markers.job.toml");
    Operator hand(*window);
    hand.screen("programs");
    EXPECT_TRUE(waitFor([&] { return shown("entered: -20.000"); }));
    hand.soft("Select job");
    EXPECT_TRUE(waitFor([&] { return told("L1 G54 Z"); }));
    ASSERT_TRUE(waitFor([&] {
        return !live().view(1).programs.empty() &&
               QString::fromStdString(live().view(1).programs[0]).endsWith("FIRST.MPF");
    }));
    EXPECT_DOUBLE_EQ(live().store(1).zeros[kZeroG54 * kChannelAxes + 1], -20.0);
    ASSERT_TRUE(g_controller->set("zero L1 G54 Z=-150"));
    EXPECT_TRUE(waitFor([&] { return shown("entered") && !shown("entered: "); }));
    ASSERT_TRUE(g_controller->set("zero L1 G54 Z=0"));
}

// One key enters them all, asked for twice; another takes back what still stands.
TEST_F(JobLanguage, ItsZerosAreEnteredTogetherAndTakenBack) {
    write("zeros.job.toml",
          "name = \"zeros\"\n[programs]\n1 = { file = \"FIRST.MPF\", language = \"sinumerik\" }\n"
          "[zeros]\n1 = { G54 = { Z = -150.0 }, G55 = { X = 1.5, Z = -80.0 } }\n");
    const auto zero = [&](std::size_t row, std::size_t place) {
        return live().store(1).zeros[row * kChannelAxes + place];
    };
    for (const char* words : {"zero L1 G54 Z=-20", "zero L1 G55 X=1.5", "zero L1 G55 Z=4"})
        ASSERT_TRUE(g_controller->set(words));
    choose("zeros.job.toml");
    Operator hand(*window);
    hand.screen("programs");
    ASSERT_TRUE(waitFor([&] { return shown("entered: -20.000") && zero(kZeroG54 + 1, 1) == 4; }));
    hand.soft("Enter zeros, offsets");
    frames(*window, 300);
    EXPECT_EQ(zero(kZeroG54, 1), -20) << "one press enters nothing";
    EXPECT_TRUE(standsOn(window->ownSheets(), "L1 G54 Z")) << "the question names them";
    hand.soft("Enter zeros, offsets");
    ASSERT_TRUE(waitFor([&] { return zero(kZeroG54, 1) == -150 && zero(kZeroG54 + 1, 1) == -80; }));
    EXPECT_EQ(zero(kZeroG54 + 1, 0), 1.5);
    ASSERT_TRUE(waitFor([&] { return told("zeros.job.toml"); }));
    ASSERT_TRUE(g_controller->set("zero L1 G55 Z=-81"));  // measured meanwhile
    ASSERT_TRUE(waitFor([&] { return zero(kZeroG54 + 1, 1) == -81; }));
    // that one is offered again, and not wanted
    hand.soft("Enter zeros, offsets");
    ASSERT_TRUE(g_controller->set("zero L1 G55 Z=-80"));
    ASSERT_TRUE(waitFor([&] { return zero(kZeroG54 + 1, 1) == -80; }));
    hand.soft("Undo zeros, offsets");
    ASSERT_TRUE(waitFor([&] { return zero(kZeroG54, 1) == -20 && zero(kZeroG54 + 1, 1) == 4; }));
    for (const char* words : {"zero L1 G54 Z=0", "zero L1 G55 X=0", "zero L1 G55 Z=0"})
        ASSERT_TRUE(g_controller->set(words));
}

// So are offsets of its setup file; the line of the selection tells of the files as they are now,
// whatever the sheet has read before.
TEST_F(JobLanguage, OtherOffsetsThanThoseOfItsSetupFileAreTold) {
    write("offsets.job.toml",
          "name = \"offsets\"\nsetup = \"offsets.setup.toml\"\n"
          "[programs]\n1 = { file = \"FIRST.MPF\", language = \"sinumerik\" }\n");
    write("offsets.setup.toml", "[channel.1.offset.27]\ngeometry = { X = 12.5 }\n");
    ASSERT_TRUE(g_controller->set("offset L1 27 geometry X=12.5"));
    choose("offsets.job.toml");
    Operator hand(*window);
    hand.screen("programs");
    EXPECT_TRUE(waitFor([&] { return shown("X 12.500") && shown("entered"); }));
    write("offsets.setup.toml", "[channel.1.offset.27]\ngeometry = { X = 13.75 }\n");
    hand.soft("Select job");
    EXPECT_TRUE(waitFor([&] { return told("L1 27"); }));
    EXPECT_DOUBLE_EQ(live().store(1).offsets[27].geometry[0], 12.5) << "what is entered holds";
    ASSERT_TRUE(g_controller->set("offset L1 27 geometry X=0"));
    const JobSheet sheet = readJobSheet(folder.filePath("offsets.job.toml"), live().machineFolder(),
                                        DisplayLanguage::English);
    EXPECT_TRUE(waitFor([&] {
        return sheetText(live(), sheet).contains("X 13.750") &&
               sheetText(live(), sheet).contains("X 0.000");
    })) << sheetText(live(), sheet).toStdString();
}

// A sheet that is longer than its place: a touch on its last line, or the right key, turns the
// page.
TEST_F(JobLanguage, ALongSheetIsTurned) {
    QByteArray setup;
    for (int offset = 1; offset <= 60; ++offset)
        setup += QString("[channel.1.offset.%1]\ngeometry = { X = %2 }\n")
                     .arg(offset)
                     .arg(500 + offset)
                     .toUtf8();
    write("long.job.toml",
          "name = \"long\"\nsetup = \"long.setup.toml\"\n"
          "[programs]\n1 = { file = \"FIRST.MPF\", language = \"sinumerik\" }\n");
    write("long.setup.toml", setup.constData());
    choose("long.job.toml");
    Operator hand(*window);
    hand.screen("programs");
    ASSERT_TRUE(waitFor([&] { return shown("Next page") && shown("X 501.000"); }));
    EXPECT_FALSE(shown("X 560.000"));
    int turns = 0;
    while (!shown("X 560.000") && turns < 20) {
        hand.key(Qt::Key_Right);
        ++turns;
    }
    EXPECT_TRUE(shown("X 560.000") && shown("From the beginning"));
    EXPECT_FALSE(shown("X 501.000"));
    hand.key(Qt::Key_Right);
    EXPECT_TRUE(shown("X 501.000"));
}

// The check of the job beside the machine, and the programs in the editor.
TEST_F(JobLanguage, IsThatOfTheSynchronisedViewAndOfTheEditor) {
    choose("markers.job.toml");
    Programs& programs = screenOf<Programs>();
    Operator hand(*window);
    hand.screen("programs");
    hand.soft("Check, waits");
    ASSERT_TRUE(waitFor([&] { return !programs.dryRun().running() && programs.dryRun().any(); }));
    EXPECT_TRUE(programs.dryRun().faults().empty());
    EXPECT_TRUE(waitFor([&] { return shown("WAITM(3)"); }));
    for (Sheet* sheet : window->screen()->sheets())
        for (const Item& one : sheet->items()) EXPECT_NE(one.text, "M3");
    choose("FIRST.MPF");
    hand.soft("Files");
    hand.soft("Edit");
    EXPECT_EQ(programs.editor().language(), "sinumerik");
}

// Beside a program alone no job says it: the channel in which it is selected does.
TEST_F(JobLanguage, IsThatOfTheChannelInWhichTheProgramIsSelected) {
    ASSERT_TRUE(g_controller->press("select " + folder.filePath("markers.job.toml")));
    ASSERT_TRUE(waitFor([&] {
        return live().language(1) == Dialect::Sinumerik && !live().view(1).programs.empty() &&
               QString::fromStdString(live().view(1).programs[0]) == folder.filePath("FIRST.MPF");
    }));
    ASSERT_TRUE(QFile::remove(folder.filePath("markers.job.toml")));
    choose("FIRST.MPF");
    Operator hand(*window);
    hand.screen("programs");
    hand.soft("Edit");
    EXPECT_EQ(screenOf<Programs>().editor().language(), "sinumerik");
}

// Check and dry run from the editor are those of the text in it: it is saved first, and asked for;
// of the job that has the program.
TEST_F(JobLanguage, CheckFromTheEditorIsOfWhatHasBeenTyped) {
    choose("FIRST.MPF");
    Programs& programs = screenOf<Programs>();
    Operator hand(*window);
    hand.screen("programs");
    hand.soft("Edit");
    EditorPage& editor = programs.editor();
    ASSERT_TRUE(waitFor(
        [&] { return editor.file() == folder.filePath("FIRST.MPF") && !editor.opening(); }));
    QTextCursor end(editor.edit().document());
    editor.edit().setTextCursor(end);
    QTest::keyClicks(&editor.edit(), "N5 G1 X1 X2 F1");
    QTest::keyClick(&editor.edit(), Qt::Key_Return);
    ASSERT_TRUE(editor.changed());
    hand.soft("Check, waits");
    EXPECT_TRUE(editor.changed()) << "asked first";
    hand.soft("Check, waits");
    ASSERT_TRUE(waitFor([&] {
        return !editor.changed() && !programs.dryRun().running() && programs.dryRun().any();
    }));
    EXPECT_EQ(programs.dryRun().job(), folder.filePath("markers.job.toml"));
    ASSERT_FALSE(programs.dryRun().faults().empty());
    EXPECT_EQ(programs.dryRun().faults().front().at.line, 1u);
    EXPECT_FALSE(editor.isVisible());
}

// What a program alone is faulted for, the other programs of its job do: a spindle that runs, a
// wait that is met.
TEST_F(JobLanguage, TheEditorChecksItsTextWithinTheJob) {
    write("ONE.nc", "O1\nN10 G97 S500 M3\nN20 M500\nN30 M30\n");
    write("TWO.nc", "O2\nN10 M500\nN20 G0 X40. Z5.\nN30 G99 G1 Z0. F0.1\nN40 M30\n");
    write("both.job.toml",
          "name = \"both\"\n[programs]\n1 = { file = \"ONE.nc\", language = \"fanuc\" }\n"
          "2 = { file = \"TWO.nc\", language = \"fanuc\" }\n");
    choose("TWO.nc");
    Programs& programs = screenOf<Programs>();
    Operator hand(*window);
    hand.screen("programs");
    hand.soft("Edit");
    EditorPage& editor = programs.editor();
    ASSERT_TRUE(waitFor([&] {
        return editor.file() == folder.filePath("TWO.nc") && !editor.opening() && editor.checking();
    }));
    ASSERT_TRUE(waitFor([&] { return !editor.checking(); }));
    // A warning stays that another channel starts the spindle; alone it is an alarm.
    for (const auto& fault : editor.faults()) EXPECT_FALSE(fault.error) << fault.text.toStdString();
    // The text in the editor, not the file: its wait is another one now.
    QTextCursor wait(editor.edit().document()->findBlockByNumber(1));
    wait.movePosition(QTextCursor::EndOfBlock);
    editor.edit().setTextCursor(wait);
    QTest::keyClick(&editor.edit(), Qt::Key_Backspace);
    QTest::keyClicks(&editor.edit(), "1");
    const auto wrong = [&] {
        return std::any_of(editor.faults().begin(), editor.faults().end(),
                           [](const auto& fault) { return fault.error; });
    };
    EXPECT_TRUE(waitFor([&] { return !editor.checking() && wrong(); }));
}

// A program that no job has is checked alone, in the channel that keys speak to.
TEST_F(JobLanguage, AProgramAloneIsCheckedInTheChannelOfTheKeys) {
    write("O7.nc", "O7\nN10 G0 X40. Z5.\nN20 M30\n");
    choose("O7.nc");
    Programs& programs = screenOf<Programs>();
    Operator hand(*window);
    hand.key(Qt::Key_2, Qt::ControlModifier);  // L2
    ASSERT_EQ(window->context().channel, 2u);
    hand.screen("programs");
    hand.soft("Edit");
    ASSERT_TRUE(waitFor([&] {
        return programs.editor().file() == folder.filePath("O7.nc") && !programs.editor().opening();
    }));
    hand.soft("Simulation, timeline");
    ASSERT_TRUE(waitFor([&] { return !programs.dryRun().running() && programs.dryRun().any(); }));
    EXPECT_EQ(programs.dryRun().job(), folder.filePath("O7.nc"));
    EXPECT_TRUE(programs.dryRun().channels().contains(2));
    hand.key(Qt::Key_1, Qt::ControlModifier);
}

// The way back and waits that are passed over: chosen at the panel, and seen there.
TEST_F(JobLanguage, TheWayBackAndTheWaitsArePressedAndSeen) {
    startJob();
    ASSERT_TRUE(waitFor([&] {
        return live().channel(1).file == 0 && live().channel(1).line == 10 &&
               (live().status().axes[0].flags & kMoving);
    })) << "N70, the face: no function is under way in it";
    ASSERT_TRUE(g_controller->press("feed_hold"));
    ASSERT_TRUE(waitFor([&] {
        return state(1) == ChannelState::Held && !(live().status().axes[0].flags & kMoving);
    }));
    ASSERT_EQ(live().channel(1).line, 10u);
    Operator hand(*window);
    hand.screen("overview");
    hand.soft("Program control");
    EXPECT_EQ(window->screen()->keys()[9].text, "More");
    hand.soft("More");
    hand.soft("Path backwards L1");
    hand.soft("Path backwards L1");
    EXPECT_TRUE(waitFor(
        [&] { return (live().channel(1).keys & kKeyRetrace) && window->screen()->keys()[4].on; }));
    hand.soft("Path backwards L1");
    EXPECT_TRUE(waitFor([&] { return !(live().channel(1).keys & kKeyRetrace); }));
    hand.soft("Ignore waits L1");
    hand.soft("Ignore waits L1");
    EXPECT_TRUE(waitFor([&] {
        return (live().channel(1).keys & kKeyIgnoreWaits) && window->screen()->keys()[5].on;
    }));
    EXPECT_TRUE(waitFor([&] { return shown("NWT") || shown("Waits ignored"); }));
    hand.soft("Ignore waits L1");
    EXPECT_TRUE(waitFor([&] { return !(live().channel(1).keys & kKeyIgnoreWaits); }));
    hand.soft("Back");
    EXPECT_EQ(window->screen()->keys()[4].text, "Start all");
    ASSERT_TRUE(g_controller->press("reset"));
    ASSERT_TRUE(waitFor([&] { return state(1) == ChannelState::Reset; }));
    hand.soft("Program control");
    hand.soft("More");
    EXPECT_FALSE(window->screen()->keys()[4].enabled) << "a way back is chosen in a hold only";
}

}  // namespace
}  // namespace polyturn::hmi
