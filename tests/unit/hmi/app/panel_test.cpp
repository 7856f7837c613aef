// What the panel's pages do against a real controller: the log of stops, measured parts, the
// computer's settings, help for a code.
#include <QFile>
#include <QJsonArray>

#include "hmi/machine/programs/code_help.hpp"
#include "hmi/screens/machine/alarms.hpp"
#include "hmi/screens/machine/diagnosis.hpp"
#include "hmi/screens/machine/parameters.hpp"
#include "hmi/screens/machine/system.hpp"
#include "hmi/screens/overview/manual.hpp"
#include "hmi/screens/tools/offsets.hpp"
#include "tests/unit/hmi/tasks.hpp"

namespace polyturn::hmi {
namespace {

class PanelTasks : public Tasks {};

TEST_F(PanelTasks, TheLogOfStopsTellsWhenHowLongAndWhy) {
    startJob();
    ASSERT_TRUE(g_controller->press("feed_hold L1"));
    ASSERT_TRUE(waitFor([&] { return state(1) == ChannelState::Held; }));
    QTest::qWait(3'000);
    ASSERT_TRUE(g_controller->press("cycle_start L1"));
    ASSERT_TRUE(waitFor(
        [&] { return state(1) == ChannelState::Running || state(1) == ChannelState::Waiting; }));
    Operator hand(*window);
    hand.screen("alarms");
    hand.soft("Log of stops");
    StopLog& book = screenOf<Alarms>().stops().book();
    const auto held = [&]() -> const StopEntry* {
        for (const StopEntry& one : book.all())
            if (one.cause == "hold" && one.channel == 1 && one.seconds > 0 && !one.stands)
                return &one;
        return nullptr;
    };
    ASSERT_TRUE(waitFor([&] { return held() != nullptr; })) << book.whyNot().toStdString();
    EXPECT_NEAR(held()->seconds, 3, 1.5);
    EXPECT_LT(held()->begin.secsTo(QDateTime::currentDateTime()), 30);
    EXPECT_TRUE(held()->program.endsWith(".nc")) << held()->program.toStdString();
    EXPECT_GT(held()->line, 0u);
    const auto sums = book.sums();
    EXPECT_TRUE(std::any_of(sums.begin(), sums.end(), [](const StopSum& one) {
        return one.cause == "hold" && one.count >= 1 && one.seconds > 1;
    }));
    // One that still stands goes on counting; the reset of a running program is a stop too.
    ASSERT_TRUE(g_controller->press("reset"));
    ASSERT_TRUE(waitFor([&] {
        return !book.all().empty() && book.all().front().stands &&
               book.all().front().cause == "reset";
    }));
    EXPECT_FALSE(g_controller->run({"stops", "--instance", g_controller->name, "--most", "0"}))
        << "bounded";
    EXPECT_TRUE(g_controller->run({"stops", "--instance", g_controller->name, "--json"}));
    noWordIsShortened(*window);
}

// On an upright panel too positions stand above the keyboard while a block is typed, and nothing
// lies over anything.
TEST_F(PanelTasks, PositionsAreSeenWhileABlockIsTyped) {
    Manual& manual = screenOf<Manual>();
    Operator hand(*window);
    hand.screen("manual");
    for (const QSize size : {QSize(768, 1024), QSize(1024, 768), QSize(1280, 800)}) {
        SCOPED_TRACE(size.width());
        window->resize(size);
        frames(*window);
        hand.soft("MDI");
        frames(*window);
        hand.type("G4 X1.");
        frames(*window);
        EXPECT_TRUE(manual.axes().isVisible() && manual.pad().isVisible() &&
                    manual.side().isVisible());
        EXPECT_TRUE(standsOn({&manual.axes()}, "Workpiece") &&
                    standsOn({&manual.axes()}, "Machine"));
        EXPECT_TRUE(standsOn({&manual.side()}, "G4 X1."));
        for (const auto& [a, b] : {std::pair<QWidget*, QWidget*>{&manual.axes(), &manual.pad()},
                                   {&manual.axes(), &manual.side()},
                                   {&manual.pad(), &manual.side()}})
            EXPECT_FALSE(a->geometry().intersects(b->geometry()));
        if (size.height() > size.width()) {
            EXPECT_TRUE(standsOn({&manual.axes()}, "To go") &&
                        standsOn({&manual.axes()}, "Follow. error"));
        }
        for (const Sheet* sheet : manual.sheets())
            EXPECT_TRUE(manual.rect().contains(sheet->geometry()));
        hand.key(Qt::Key_Escape);
        manual.typeMdi({});
    }
    window->resize(768, 1024);
    noWordIsShortened(*window);
    window->resize(1280, 800);
    ASSERT_TRUE(g_controller->press("mode L1=auto"));
}

// What happened in the night is read in the morning, after the power was off.
TEST_F(PanelTasks, AlarmsOutliveTheController) {
    Operator hand(*window);
    const auto ofNight = [](const AlarmEntry& one) { return one.place.contains("night.nc"); };
    ASSERT_TRUE(waitFor([&] {
        const auto& all = window->context().alarms.all();
        if (std::any_of(all.begin(), all.end(), ofNight)) return true;
        g_controller->press("select L1=/nowhere/last/night.nc");
        g_controller->press("cycle_start L1");
        QTest::qWait(300);
        return false;
    }));
    const auto told = std::count_if(window->context().alarms.all().begin(),
                                    window->context().alarms.all().end(), ofNight);
    frames(*window, 2'000);  // the store has it
    g_controller->stop();
    ASSERT_TRUE(waitFor([&] { return !live().connected(); }));
    g_controller->start();
    ASSERT_TRUE(waitFor([&] { return live().connected(); }));
    hand.screen("alarms");
    hand.soft("History");
    Alarms& alarms = screenOf<Alarms>();
    const auto found = [&] {
        return std::find_if(alarms.rows().begin(), alarms.rows().end(), ofNight);
    };
    ASSERT_TRUE(waitFor([&] { return found() != alarms.rows().end() && found()->told; }))
        << alarms.rows().size()
        << (alarms.rows().empty() ? QString()
                                  : alarms.rows().back().number + alarms.rows().back().place)
               .toStdString();
    EXPECT_FALSE(found()->standing);
    EXPECT_FALSE(found()->remedy.isEmpty());
    frames(*window, 60);
    for (const char* field : {"Cause", "Remedy", "Place"})
        EXPECT_TRUE(standsOn(alarms.sheets(), field)) << field;
    EXPECT_EQ(std::count_if(alarms.rows().begin(), alarms.rows().end(), ofNight), told)
        << "each once";
}

// The kernel knows lines of blocks, not their files: whoever tells the alarm says which program it
// was.
TEST_F(PanelTasks, AnAlarmOfTheKernelNamesItsProgram) {
    QFile file(g_controller->folder.filePath("counts.nc"));
    ASSERT_TRUE(file.open(QIODevice::WriteOnly));
    file.write("O0007\nN10 G4 X0.2\nN20 M30\n");
    file.close();
    for (const char* line : {"N2308 L1=1", "N2307 L1=0"})
        ASSERT_TRUE(g_controller->run({"params", "set", line, "--instance", g_controller->name}));
    const auto told = [&] {
        const auto& all = window->context().alarms.all();
        return std::find_if(all.begin(), all.end(), [](const AlarmEntry& one) {
                   return one.number == "PT0563" && one.place.contains("counts.nc");
               }) != all.end();
    };
    ASSERT_TRUE(g_controller->press("select L1=" + file.fileName()) &&
                g_controller->press("cycle_start L1"));
    EXPECT_TRUE(waitFor([&] { return told(); }, 30))
        << (window->context().alarms.all().empty()
                ? QString()
                : window->context().alarms.all().back().number + " " +
                      window->context().alarms.all().back().place)
               .toStdString();
    EXPECT_TRUE(
        g_controller->run({"params", "set", "N2308 L1=0", "--instance", g_controller->name}));
}

TEST_F(PanelTasks, TheLogOfStopsOutlivesTheController) {
    StopLog& book = screenOf<Alarms>().stops().book();
    Operator hand(*window);
    hand.screen("alarms");
    hand.soft("Log of stops");
    ASSERT_TRUE(waitFor([&] { return !book.all().empty(); })) << "of the test before";
    const std::size_t before = book.all().size();
    g_controller->stop();
    ASSERT_TRUE(waitFor([&] { return !live().connected(); }));
    g_controller->start();
    ASSERT_TRUE(waitFor([&] { return live().connected() && book.all().size() >= before; }));
    for (const StopEntry& one : book.all())
        EXPECT_GE(one.seconds, 0) << one.cause.toStdString()
                                  << ": a controlled end closes what stands";
}

TEST_F(PanelTasks, AMeasuredPartCorrectsTheWear) {
    Operator hand(*window);
    hand.screen("offsets");
    hand.soft("Measured parts");
    PartsPage& parts = screenOf<Offsets>().parts();
    hand.soft("New dimension");
    ASSERT_TRUE(waitFor([&] { return parts.dimensions().size() == 1; }));
    const auto enter = [&](int column, const QString& text) {
        hand.touchCell(parts.table(), 0, column);
        hand.type(text);
        hand.key(Qt::Key_Return);
    };
    enter(PartsPage::kNominal, "40");
    ASSERT_TRUE(waitFor([&] { return parts.dimensions()[0].value("nominal").toDouble() == 40; }));
    enter(PartsPage::kTool, "1");
    ASSERT_TRUE(g_controller->run({"tools", "add", "1", "name=PART_TOOL", "type=1", "h=17",
                                   "--instance", g_controller->name}));
    for (const char* value : {"40.01", "40.012", "40.014"}) {
        const int before = parts.dimensions()[0].value("measured").toInt();
        enter(PartsPage::kMeasured, value);
        ASSERT_TRUE(waitFor([&] {
            return parts.dimensions()[0].value("measured").toInt() == before + 1;
        })) << value;
    }
    EXPECT_EQ(parts.dimensions()[0].value("deviations").toArray().size(), 3);
    EXPECT_NEAR(parts.dimensions()[0].value("trend").toDouble(), 0.002, 1e-9);
    const auto wear = [&] { return live().store(1).offsets[17].wear[0]; };
    const double before = wear();
    hand.soft("Accept proposal");
    frames(*window, 300);
    EXPECT_EQ(wear(), before) << "one press writes nothing";
    hand.soft("Accept proposal");
    EXPECT_TRUE(waitFor([&] { return std::abs(wear() - before + 0.014) < 1e-9; })) << wear();
    EXPECT_TRUE(waitFor([&] { return parts.dimensions()[0].value("measured").toInt() == 0; }))
        << "what was measured before says nothing about the next part";
    noWordIsShortened(*window);
    g_controller->run({"tools", "delete", "1", "--instance", g_controller->name});
}

// What a screen has asked is answered when the screen is another one: the language was changed
// meanwhile.
TEST_F(PanelTasks, AnAnswerForAScreenThatIsGoneHurtsNobody) {
    Operator hand(*window);
    for (int round = 0; round < 12; ++round) {
        for (const char* name : {"offsets", "tools", "system", "alarms"}) {
            hand.screen(name);
            window->screen()->turnTo(window->screen()->pages() - 1);
            window->frame();
            hand.key(Qt::Key_F11);
            QTest::qWait(5);
        }
    }
    window->setDisplayLanguage(DisplayLanguage::English);
    EXPECT_TRUE(
        waitFor([&] { return live().connected() && window->context().requests.waiting() < 3; }));
}

// The operating system's programs, played: they note what they were asked, one of them refuses.
TEST_F(PanelTasks, TheComputersSettingsAreChangedByItsProgramsOrRefusedInTheirWords) {
    QTemporaryDir folder;
    const auto program = [&](const char* name, const QString& text) {
        QFile file(folder.filePath(name));
        ASSERT_TRUE(file.open(QIODevice::WriteOnly));
        file.write(QString("#!/bin/sh\necho %1 \"$@\" >> %2/asked\n%3\n")
                       .arg(name, folder.path(), text)
                       .toUtf8());
        file.setPermissions(QFile::ReadOwner | QFile::WriteOwner | QFile::ExeOwner);
    };
    program(
        "timedatectl",
        "case \"$1\" in show) echo Timezone=Europe/Prague; echo NTP=yes;; set-time) echo 'Failed "
        "to set time: Automatic time synchronization is enabled' >&2; exit 1;; esac");
    program(
        "localectl",
        "echo \"System has not been booted with systemd as init system (PID 1). Can't operate.\" "
        ">&2; exit 1");
    program("xset",
            "if [ \"$1\" = q ]; then echo '  auto repeat delay:  500    repeat rate:  20'; fi");
    const QByteArray display = qgetenv("DISPLAY");
    qputenv("DISPLAY", ":9");
    program("nmcli", "echo 'Error: NetworkManager is not running.' >&2; exit 8");
    const QByteArray path = qgetenv("PATH");
    qputenv("PATH", folder.path().toUtf8() + ":/bin:/usr/bin");
    Operator hand(*window);
    hand.screen("system");
    hand.soft("Panel computer");
    SettingsPage& page = screenOf<System>().settings();
    using What = ComputerSetting::What;
    ASSERT_TRUE(waitFor([&] { return !page.computer().busy(); }));
    EXPECT_EQ(page.computer().value(What::Zone), "Europe/Prague");
    EXPECT_EQ(page.computer().whyNot(What::Address), "Error: NetworkManager is not running.")
        << "said, in the system's words";
    EXPECT_FALSE(page.computer().whyNot(What::Wins1).isEmpty());
    EXPECT_EQ(page.computer().whyNot(What::Layout), "This computer runs without systemd")
        << "a sentence that each such computer says is said in the reader's language";
    frames(*window, 300);  // the level has come
    hand.touchCell(page.table(), 1, 2);
    hand.key(Qt::Key_Return);
    ASSERT_TRUE(window->entry().isVisible());
    for (int i = 0; i < 20; ++i) QTest::keyClick(window.get(), Qt::Key_Backspace);
    hand.type("Europe/Budapest");
    hand.key(Qt::Key_Return);
    QFile asked(folder.filePath("asked"));
    ASSERT_TRUE(waitFor([&] {
        return asked.open(QIODevice::ReadOnly) &&
                       asked.readAll().contains("timedatectl set-timezone Europe/Budapest")
                   ? true
                   : (asked.close(), false);
    })) << page.told().toStdString();
    ASSERT_TRUE(waitFor([&] { return !page.computer().busy(); }));
    hand.touchCell(page.table(), 0, 2);
    hand.key(Qt::Key_Return);
    for (int i = 0; i < 30; ++i) QTest::keyClick(window.get(), Qt::Key_Backspace);
    hand.type("2026-01-31 06:00:00");
    hand.key(Qt::Key_Return);
    EXPECT_TRUE(waitFor([&] {
        return page.told().contains("Automatic time synchronization is enabled");
    })) << page.told().toStdString();
    hand.key(Qt::Key_Return);
    for (int i = 0; i < 30; ++i) QTest::keyClick(window.get(), Qt::Key_Backspace);
    hand.type("tomorrow");
    hand.key(Qt::Key_Return);
    EXPECT_TRUE(page.told().contains("2026-01-31 06:00:00"))
        << "wrong text is refused before anybody is asked: " << page.told().toStdString();
    ASSERT_TRUE(waitFor([&] { return !page.computer().busy(); }));
    // time before a key repeats: numbers calculate here too
    hand.touchCell(page.table(), 12, 2);
    hand.key(Qt::Key_Return);
    for (int i = 0; i < 30; ++i) QTest::keyClick(window.get(), Qt::Key_Backspace);
    hand.type("+50/2");
    hand.key(Qt::Key_Return);
    EXPECT_TRUE(waitFor([&] {
        asked.close();
        return asked.open(QIODevice::ReadOnly) && asked.readAll().contains("xset r rate 525 20");
    })) << page.told().toStdString();
    qputenv("PATH", path);
    qputenv("DISPLAY", display);
    noWordIsShortened(*window);
}

TEST(ComputerSettings, MasksAndAddresses) {
    EXPECT_EQ(prefixOf("255.255.255.0"), 24);
    EXPECT_EQ(prefixOf("0.0.0.0"), 0);
    EXPECT_EQ(prefixOf("255.255.255.255"), 32);
    EXPECT_EQ(prefixOf("255.0.255.0"), -1);
    EXPECT_EQ(prefixOf("none"), -1);
    for (int prefix = 0; prefix <= 32; ++prefix) EXPECT_EQ(prefixOf(maskOf(prefix)), prefix);
    EXPECT_TRUE(ipv4("192.168.1.10"));
    EXPECT_FALSE(ipv4("192.168.1"));
    EXPECT_FALSE(ipv4("192.168.1.256"));
}

TEST(ComputerSettings, TheKeyboardOfAPanelWithoutDisplayServer) {
    EXPECT_EQ(layoutIn("# keyboard\nXKBMODEL=\"pc105\"\nXKBLAYOUT=\"us,cz\"\n"), "us,cz");
    EXPECT_EQ(layoutIn("XKBLAYOUT=hu\n"), "hu") << "as localectl writes it";
    EXPECT_EQ(layoutIn("#XKBLAYOUT=hu\n"), "");
    EXPECT_EQ(layoutIn("XKBLAYOUT=\"\"\n"), "");
    EXPECT_EQ(layoutIn("XKBLAYOUT=hu; rm\n"), "");
    EXPECT_EQ(layoutIn(""), "");
}

TEST(CodeHelp, FindsThePlaceOfAWord) {
    struct Row {
        const char* line;
        int column;
        const char *language, *page, *find;
    };
    constexpr Row kRows[] = {
        {"N10 G1 X40.", 5, "fanuc", "reference_fanuc.md", "G1"},
        {"N10 G01X40.", 6, "nct", "reference_fanuc.md", "G1"},
        {"G71 U2. R0.5", 0, "fanuc", "reference_fanuc.md", "G71"},
        {"G7.1 C20.", 4, "mefi", "reference_fanuc.md", "G7.1"},
        {"G1 X10", 1, "fagor", "reference_fagor.md", "G01"},
        {"CYCLE95(\"CONT\")", 3, "sinumerik", "reference_sinumerik.md", "CYCLE95"},
        {"M30", 1, "fanuc", "reference_fanuc.md", "M30"},
        {"M00", 1, "nct", "reference_fanuc.md", "M0"},
        {"M17", 1, "sinumerik", "reference_sinumerik.md", "M17"},
        {"M98 P1100", 1, "mefi", "reference_fanuc.md", "M98"},
        {"M98", 1, "fagor", "setup.md", "M codes of the built-in PLC"},
        {"M8", 1, "fanuc", "setup.md", "M codes of the built-in PLC"},
        {"M503 P12", 2, "fanuc", "programmer.md", "Waiting"},
        {"N10 G1 X40.", 8, "fanuc", "", ""},
    };
    for (const Row& row : kRows) {
        SCOPED_TRACE(row.line);
        const CodePlace place = placeOfCode(wordAt(row.line, row.column), row.language);
        EXPECT_EQ(place.page, row.page);
        EXPECT_EQ(place.find, row.find);
    }
}

TEST_F(PanelTasks, AParameterTellsWhoChangedItAndWhatTheFileHas) {
    Operator hand(*window);
    hand.screen("parameters");
    Parameters& screen = screenOf<Parameters>();
    const auto set = [&](const QString& line) {
        return g_controller->run({"params", "set", line, "--instance", g_controller->name});
    };
    ASSERT_TRUE(set("N0304 A2=23000") && set("N0304 A2=23500"));
    screen.find("N0304");
    ASSERT_TRUE(waitFor([&] { return screen.table().rows() >= 4; }));
    hand.soft("Differs from file");
    ASSERT_TRUE(waitFor([&] { return screen.table().rows() == 1; })) << screen.table().rows();
    hand.soft("History");
    ASSERT_TRUE(waitFor([&] { return screen.changes() == 2; })) << screen.changes();
    noWordIsShortened(*window);
    hand.screen("parameters");
    ASSERT_TRUE(set("N0304 A2=24000"));
}

// The bits of a parameter have the room of the keys until somebody types a number.
TEST_F(PanelTasks, BitsShowAllOfTheirMeanings) {
    Operator hand(*window);
    hand.screen("parameters");
    for (const DisplayLanguage display_language : kDisplayLanguages) {
        window->setDisplayLanguage(display_language);
        window->showScreen(5);
        Parameters& now = screenOf<Parameters>();
        now.find("N0106");
        frames(*window, 60);
        EXPECT_FALSE(now.pad().isVisible());
        EXPECT_GT(now.detail().height(), now.height() * 0.8);
        QTest::keyClick(window.get(), Qt::Key_5);
        EXPECT_TRUE(waitFor([&] { return now.pad().isVisible(); })) << "a typed number is seen";
        now.pad().clear();
    }
    window->setDisplayLanguage(DisplayLanguage::English);
}

// After a crash or with another theme each screen stands where it stood.
TEST_F(PanelTasks, EachScreenComesBackAsItWas) {
    Operator hand(*window);
    const auto again = [&] {
        window->setDark(false);
        frames(*window);
        window->setDark(true);
        frames(*window);
    };
    hand.screen("parameters");
    screenOf<Parameters>().find("N0304");
    hand.soft("Compensation tables");
    again();
    EXPECT_TRUE(standsOn(screenOf<Parameters>().sheets(), "Compensation tables"));
    hand.soft("Compensation tables");
    hand.soft("History");
    again();
    EXPECT_TRUE(standsOn(screenOf<Parameters>().sheets(), "Changes of N0304"));
    hand.soft("History");
    frames(*window);
    EXPECT_GE(screenOf<Parameters>().table().rows(), 4);
    screenOf<Manual>().typeMdi("G0 X100 Z2");
    again();
    EXPECT_TRUE(screenOf<Manual>().state().endsWith(" G0 X100 Z2"))
        << screenOf<Manual>().state().toStdString();
    screenOf<Manual>().typeMdi({});
    screenOf<Parameters>().find({});
}

// As the command line and files write them; the rows of the bits keep their room while somebody
// types.
TEST_F(PanelTasks, EightDigitsAreBits) {
    Operator hand(*window);
    hand.screen("parameters");
    Parameters& screen = screenOf<Parameters>();
    screen.find("N2905");
    frames(*window);
    const auto value = [&] { return live().table().numbers[params::find("N2905")->first_slot]; };
    const double before = value();
    const int room = screen.detail().height();
    hand.type("00000011");
    frames(*window);
    EXPECT_TRUE(screen.pad().isVisible());
    EXPECT_EQ(screen.detail().height(), room);
    EXPECT_FALSE(screen.pad().geometry().intersects(screen.table().geometry()));
    EXPECT_FALSE(screen.pad().geometry().intersects(screen.detail().geometry()));
    hand.key(Qt::Key_Return);
    ASSERT_TRUE(waitFor([&] { return value() == 3; })) << value();
    frames(*window);
    EXPECT_EQ(screen.table().cell(0, 2).text, QString("00000011"));
    // and a number is a number
    hand.type("4");
    hand.key(Qt::Key_Return);
    ASSERT_TRUE(waitFor([&] { return value() == 4; })) << value();
    hand.soft("Undo");
    hand.soft("Undo");
    ASSERT_TRUE(waitFor([&] { return value() == before; })) << value();
}

// What somebody else has entered since is not taken back; and two presses faster than the store
// answers take back two.
TEST_F(PanelTasks, UndoOfAParameterTakesBackOnlyWhatStillStandsThere) {
    Operator hand(*window);
    hand.screen("parameters");
    Parameters& screen = screenOf<Parameters>();
    screen.find("N0516");  // a window in mm
    const auto value = [&] { return live().table().numbers[params::find("N0516")->first_slot]; };
    const auto set = [&](const char* to) {
        return g_controller->run(
            {"params", "set", QString("N0516 A1=%1").arg(to), "--instance", g_controller->name});
    };
    ASSERT_TRUE(set("0.01"));
    ASSERT_TRUE(waitFor([&] { return value() == 0.01; }));
    hand.touchCell(screen.table(), 0, 0);
    hand.type("0.02");
    hand.key(Qt::Key_Return);
    ASSERT_TRUE(waitFor([&] { return value() == 0.02; }));
    ASSERT_TRUE(set("0.05"));
    ASSERT_TRUE(waitFor([&] { return value() == 0.05; }));
    hand.soft("Undo");
    frames(*window, 700);
    EXPECT_EQ(value(), 0.05);
    EXPECT_TRUE(standsOn(window->ownSheets(), "0.05"));
    EXPECT_TRUE(standsOn(window->ownSheets(), "it stays"));
    ASSERT_TRUE(set("0.01"));
    ASSERT_TRUE(waitFor([&] { return value() == 0.01; }));
    hand.type("0.02");
    hand.key(Qt::Key_Return);
    ASSERT_TRUE(waitFor([&] { return value() == 0.02; }));
    hand.type("0.03");
    hand.key(Qt::Key_Return);
    ASSERT_TRUE(waitFor([&] { return value() == 0.03; }));
    hand.soft("Undo");
    hand.soft("Undo");
    EXPECT_TRUE(waitFor([&] { return value() == 0.01; })) << value();
}

// 50/3 is no whole number: rounded in silence it would be another one than was typed.
TEST_F(PanelTasks, AWholeNumberIsNotRounded) {
    Operator hand(*window);
    hand.screen("parameters");
    Parameters& screen = screenOf<Parameters>();
    const auto whole =
        std::find_if(params::rows().begin(), params::rows().end(), [](const params::Row& row) {
            return row.type == params::Type::Int && row.scope == params::Scope::Global;
        });
    ASSERT_NE(whole, params::rows().end());
    screen.find(fromView(whole->number));
    frames(*window);
    const double before = live().table().numbers[whole->first_slot];
    hand.type("50/3");
    EXPECT_FALSE(screen.pad().ready());
    EXPECT_TRUE(standsOn({&screen.pad()}, "wanted: a whole number"));
    hand.key(Qt::Key_Return);
    frames(*window, 300);
    EXPECT_EQ(screen.pad().text(), QString("50/3"));
    EXPECT_EQ(live().table().numbers[whole->first_slot], before);
    screen.pad().clear();
}

TEST_F(PanelTasks, ABitIsTurnedOverByKeysAlone) {
    Operator hand(*window);
    hand.screen("parameters");
    screenOf<Parameters>().find("N1200");
    frames(*window, 60);
    const auto bits = [&] {
        return static_cast<unsigned>(live().table().numbers[params::find("N1200")->first_slot]);
    };
    const unsigned before = bits();
    for (int bit = 0; bit < 8; ++bit) hand.key(Qt::Key_Left);
    hand.key(Qt::Key_Right);
    hand.key(Qt::Key_Space);
    ASSERT_TRUE(waitFor([&] { return bits() == (before ^ 2u); })) << bits();
    hand.key(Qt::Key_Space);
    ASSERT_TRUE(waitFor([&] { return bits() == before; })) << bits();
    hand.key(Qt::Key_Tab);  // to the groups
    hand.key(Qt::Key_Down);
    EXPECT_EQ(screenOf<Parameters>().state().section('|', 0, 0), "1");
}

// A touch that only looks changes nothing: the second one must be of the same bit of the same
// parameter, with nothing between, and soon.
TEST_F(PanelTasks, ABitIsTurnedOverByTheSecondTouchOfIt) {
    Operator hand(*window);
    hand.screen("parameters");
    Parameters& screen = screenOf<Parameters>();
    const auto bits = [&](const char* number) {
        return static_cast<unsigned>(live().table().numbers[params::find(number)->first_slot]);
    };
    const auto find = [&](const char* number) {
        screen.find(number);
        frames(*window);
    };
    constexpr int kFirstBit = 1;
    const unsigned one = bits("N1200"), other = bits("N0106");
    ASSERT_EQ(params::find("N1200")->bits.front().number, 0u);
    ASSERT_EQ(params::find("N0106")->bits.front().number, 0u);
    find("N1200");
    hand.touch(&screen.detail(), kFirstBit);
    // at the same row of the list
    find("N0106");
    hand.touch(&screen.detail(), kFirstBit);
    find("N1200");
    hand.touch(&screen.detail(), kFirstBit);
    QTest::qWait(4'200);  // thought about for too long
    hand.touch(&screen.detail(), kFirstBit);
    // keys have been at another bit
    hand.key(Qt::Key_Right);
    hand.key(Qt::Key_Left);
    hand.touch(&screen.detail(), kFirstBit);
    frames(*window, 500);
    EXPECT_EQ(bits("N1200"), one);
    EXPECT_EQ(bits("N0106"), other);
    hand.touch(&screen.detail(), kFirstBit);
    ASSERT_TRUE(waitFor([&] { return bits("N1200") == (one ^ 1u); }));
    // what has turned it over chooses nothing
    hand.touch(&screen.detail(), kFirstBit);
    frames(*window, 500);
    EXPECT_EQ(bits("N1200"), one ^ 1u);
    hand.touch(&screen.detail(), kFirstBit);
    ASSERT_TRUE(waitFor([&] { return bits("N1200") == one; }));
}

// A word of the language shown finds a parameter, and so does the English one of a builder's
// document.
TEST_F(PanelTasks, SearchUnderstandsTheLanguageShownAndEnglish) {
    for (const auto& [display_language, word] : {std::pair{DisplayLanguage::Czech, "rychloposuv"},
                                                 {DisplayLanguage::Russian, "ускорен"},
                                                 {DisplayLanguage::Hungarian, "gyorsjárat"}}) {
        window->setDisplayLanguage(display_language);
        window->showScreen(5);
        Parameters& screen = screenOf<Parameters>();
        for (const char* searched : {word, "in rapid moves", "N0304"}) {
            screen.find(searched);
            EXPECT_TRUE(waitFor([&] { return screen.table().rows() > 0; })) << searched;
        }
        window->showScreen(8);
        Diagnosis& diagnosis = screenOf<Diagnosis>();
        diagnosis.turnTo(0);
        diagnosis.find("the axis is in position");
        EXPECT_GE(diagnosis.table().rows(), 2) << "in English";
    }
    window->setDisplayLanguage(DisplayLanguage::English);
}

TEST_F(PanelTasks, TheRelativeCounterGoesIntoAnOffset) {
    Operator hand(*window);
    hand.screen("offsets");
    Offsets& offsets = screenOf<Offsets>();
    offsets.table().choose(7, 1);
    hand.soft("Relative zero");
    frames(*window, 300);
    ASSERT_TRUE(g_controller->press("mode L1=jog"));
    const double from = live().status().axes[0].cmd;
    ASSERT_TRUE(g_controller->press("jog A1+ 0.4s"));
    ASSERT_TRUE(waitFor([&] {
        return std::abs(live().status().axes[0].cmd - from) > 0.2 &&
               !(live().status().axes[0].flags & kMoving);
    }));
    const double way = 2 * (live().status().axes[0].cmd - from);  // the table has diameters
    const double before = live().store(1).offsets[8].geometry[0];
    hand.soft("Relative input");
    frames(*window, 200);
    EXPECT_EQ(live().store(1).offsets[8].geometry[0], before) << "one press writes nothing";
    hand.soft("Relative input");
    EXPECT_TRUE(waitFor([&] {
        return std::abs(live().store(1).offsets[8].geometry[0] - way) < 0.05;
    })) << live().store(1).offsets[8].geometry[0]
        << " " << way;
    hand.soft("Undo");
    EXPECT_TRUE(
        waitFor([&] { return std::abs(live().store(1).offsets[8].geometry[0] - before) < 1e-9; }));
    ASSERT_TRUE(g_controller->press("mode L1=auto"));
}

// The hours of the machine go to the store every ten seconds; on the screen they run with the cycle
// beside them.
TEST_F(PanelTasks, TotalsAreOfTheSameMomentAsTheCycle) {
    Operator hand(*window);
    hand.screen("diagnosis");
    Diagnosis& diagnosis = screenOf<Diagnosis>();
    diagnosis.turnTo(4);
    startJob();
    LiveTotals totals;
    const std::size_t operation = params::n2301_operation_time.first_slot,
                      power = params::n2300_power_on_time.first_slot;
    const auto follow = [&](int ms) {
        QElapsedTimer time;
        time.start();
        while (time.elapsed() < ms) {
            QTest::qWait(16);
            totals.follow(live());
        }
    };
    // may be ten seconds old, and what was since then comes with the next
    const double storedBefore = live().table().numbers[power];
    ASSERT_TRUE(waitFor([&] {
        follow(50);
        return live().table().numbers[power] != storedBefore;
    }));
    follow(100);
    const double operated = totals.ms(operation), on = totals.ms(power),
                 cycle = live().channel(1).cycle_s;
    const std::int64_t tick = live().status().tick;
    ASSERT_GE(operated, 0);
    follow(4'000);
    const double cycled = (live().channel(1).cycle_s - cycle) * 1e3,
                 passed = live().seconds(live().status().tick - tick) * 1e3;
    ASSERT_EQ(state(1), ChannelState::Running);
    EXPECT_NEAR(totals.ms(operation) - operated, cycled, 300);
    EXPECT_NEAR(totals.ms(power) - on, passed, 300);
    // what is stored is the same: it only comes later
    ASSERT_TRUE(waitFor([&] {
        follow(50);
        return std::abs(live().table().numbers[power] - totals.ms(power)) < 1'500;
    }));
    QString shown;
    for (int row = 0; row < diagnosis.table().rows(); ++row)
        if (diagnosis.table().cell(row, 0).text == "Power on")
            shown = diagnosis.table().cell(row, 2).text;
    EXPECT_FALSE(shown.isEmpty());
    EXPECT_TRUE(waitFor([&] {
        for (int row = 0; row < diagnosis.table().rows(); ++row)
            if (diagnosis.table().cell(row, 0).text == "Power on")
                return diagnosis.table().cell(row, 2).text != shown;
        return false;
    })) << "it stands for ten seconds: "
        << shown.toStdString();
    EXPECT_EQ(totals.ms(params::n2306_no_of_total_parts.first_slot), -1) << "no time";
}

// Parts wanted are N2308; N2305 is the M code that counts them.
TEST_F(PanelTasks, CountersShowWhatTheySay) {
    ASSERT_TRUE(
        g_controller->run({"params", "set", "N2308 L1=77", "--instance", g_controller->name}));
    Operator hand(*window);
    hand.screen("diagnosis");
    Diagnosis& diagnosis = screenOf<Diagnosis>();
    diagnosis.turnTo(4);
    ASSERT_TRUE(waitFor(
        [&] { return params::get(live().table(), params::n2308_no_of_parts_reqrd, 1) == 77; }));
    bool found = false;
    for (int row = 0; row < diagnosis.table().rows(); ++row) {
        const QString title = diagnosis.table().cell(row, 0).text,
                      value = diagnosis.table().cell(row, 2).text;
        EXPECT_FALSE(value.contains("ms") || value.contains("M code") || value.contains("count"))
            << title.toStdString() << ": " << value.toStdString();
        found = found || (title == "Parts wanted" && value == "77");
    }
    EXPECT_TRUE(found);
    ASSERT_TRUE(
        g_controller->run({"params", "set", "N2308 L1=0", "--instance", g_controller->name}));
}

}  // namespace
}  // namespace polyturn::hmi
