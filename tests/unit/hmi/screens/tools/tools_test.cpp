// The screen of tools against a real store: loaded, moved and unloaded by touch, by dragging and by
// keys; what it shows is what the store has.
#include "hmi/screens/tools/tools.hpp"

#include "hmi/screens/overview/overview.hpp"
#include "tests/unit/hmi/tasks.hpp"

namespace polyturn::hmi {
namespace {

class ToolTasks : public Tasks {
protected:
    void SetUp() override {
        Tasks::SetUp();
        for (int tool = 1; tool <= 3; ++tool)
            g_controller->run(
                {"tools", "unload", QString::number(tool), "--instance", g_controller->name});
        for (int tool = 1; tool <= 3; ++tool)
            g_controller->run(
                {"tools", "delete", QString::number(tool), "--instance", g_controller->name});
        add({"1", "name=ROUGH_80", "type=1", "h=1", "kind=500", "life_kind=pieces", "life=10",
             "warning=2"});
        add({"2", "name=FINISH_35", "type=3", "h=3", "kind=510"});
        add({"3", "name=GROOVE_3", "type=5", "h=5", "kind=520", "life_kind=minutes", "life=45",
             "counter=44", "warning=5"});
        ASSERT_TRUE(
            g_controller->run({"tools", "load", "1", "1", "1", "--instance", g_controller->name}));
        ASSERT_TRUE(waitFor([&] { return row(3).used && row(1).magazine == 1; }));
    }
    void add(QStringList words) {
        ASSERT_TRUE(g_controller->run(QStringList{"tools", "add"} << words << "--instance"
                                                                  << g_controller->name))
            << words.join(' ').toStdString();
    }
    const ToolRow& row(int tool) const {
        return live().tools().rows[static_cast<std::size_t>(tool - 1)];
    }
};

TEST_F(ToolTasks, ATurretShowsItsStationsAndWhatStandsThere) {
    Operator hand(*window);
    hand.screen("tools");
    Tools& tools = screenOf<Tools>();
    EXPECT_EQ(tools.picture().shown(), 1);
    ASSERT_NE(tools.picture().chosen(), nullptr);
    EXPECT_EQ(tools.picture().chosen()->kind, static_cast<std::uint32_t>(PlaceKind::Turret));
    for (int station = 1; station <= 12; ++station)
        EXPECT_FALSE(tools.picture().boxOf(tools.picture().placeHit(station)).isEmpty()) << station;
    window->resize(768, 1024);
    frames(*window, 100);
    int named = 0;
    for (const Item& item : tools.picture().items()) named += item.text == "ROUGH_80";
    EXPECT_EQ(named, 2) << "in the middle, and in the place itself";
    window->resize(1280, 800);
    frames(*window, 100);
    EXPECT_EQ(tools.list().rows(), 3);
    EXPECT_EQ(toolWords(row(3)).sign, Sign::Warning) << "as its colour";
    EXPECT_NEAR(lifeLeft(row(3)), 1.0 / 45, 1e-9);
    EXPECT_LT(lifeLeft(row(2)), 0) << "its life is not watched";
    noWordIsShortened(*window);
}

// Magazines are taken at the start: a chain and a matrix.
class ChainTasks : public ToolTasks {
protected:
    static void SetUpTestSuite() {
        g_controller = new Controller({}, {"N2912=24", "N2905=00001000", "N2920=4", "N2921=6"});
    }
};

// A chain's places are small: the names about the chosen place are drawn large enough to be read
// from where one stands.
TEST_F(ChainTasks, NamesInAChainCanBeRead) {
    const auto chain = [&] {
        for (std::size_t i = 0; i < live().places().count; ++i)
            if (static_cast<PlaceKind>(live().places().places[i].kind) == PlaceKind::Chain)
                return live().places().places[i].magazine;
        return 0;
    };
    ASSERT_TRUE(waitFor([&] { return chain() != 0; })) << "the chain of N2912 is not there";
    ASSERT_TRUE(g_controller->run(
        {"tools", "load", "3", QString::number(chain()), "3", "--instance", g_controller->name}));
    Tools& tools = screenOf<Tools>();
    for (const QSize size : {QSize(1024, 768), QSize(768, 1024)}) {
        window->resize(size);
        window->showScreen(4);
        tools.picture().show(chain());
        tools.picture().choose(3);
        frames(*window, 100);
        int named = 0;
        for (const Item& item : tools.picture().items()) {
            if (item.kind != Item::Kind::Text || item.text.isEmpty()) continue;
            EXPECT_GE(item.font.pixelSize(), 12) << item.text.toStdString();
            named += item.text == "GROOVE_3";
        }
        EXPECT_GE(named, 1) << size.width();
        const auto& places = live().places();
        for (std::size_t i = 0; i < places.count; ++i) {  // of a matrix all that have room
            if (static_cast<PlaceKind>(places.places[i].kind) != PlaceKind::Matrix) continue;
            tools.picture().show(places.places[i].magazine);
            EXPECT_FALSE(
                tools.picture().boxOf(tools.picture().placeHit(places.places[i].pot)).isEmpty())
                << size.width() << " " << places.places[i].pot;
        }
    }
}

// One is chosen, in the picture or in the list: a place without a tool has no row, and says why
// nothing is loaded there.
TEST_F(ToolTasks, AnEmptyPlaceMarksNoRow) {
    Operator hand(*window);
    hand.screen("tools");
    Tools& tools = screenOf<Tools>();
    frames(*window);
    EXPECT_TRUE(tools.list().marked) << "the first place has a tool";
    hand.touch(&tools.picture(), tools.picture().placeHit(2));
    frames(*window);
    EXPECT_FALSE(tools.list().marked);
    EXPECT_TRUE(standsOn(tools.sheets(), "M1 / 2"));
    EXPECT_TRUE(standsOn(tools.sheets(), "To load: choose a tool without a place in the list"));
}

// A text has letters in the place of a number's keys, and what is typed stands beside what was
// there.
TEST_F(ToolTasks, ATextShowsWhatIsTyped) {
    Operator hand(*window);
    hand.screen("tools");
    Tools& tools = screenOf<Tools>();
    hand.soft("Tool data");
    tools.table().choose(0);  // the name
    hand.type("AB");
    frames(*window);
    EXPECT_FALSE(standsOn(tools.sheets(), "Choose a field"));
    EXPECT_TRUE(standsOn(tools.sheets(), "AB"));
    EXPECT_TRUE(standsOn(tools.sheets(), "ROUGH_80"));
    tools.table().choose(1);
    frames(*window);
    EXPECT_TRUE(standsOn(tools.sheets(), "Input"));
    EXPECT_FALSE(standsOn(tools.sheets(), "+ Input"))
        << "to the number by which it is called nothing is added";
}

TEST_F(ToolTasks, AToolIsLoadedByKeysAlone) {
    Operator hand(*window);
    hand.screen("tools");
    Tools& tools = screenOf<Tools>();
    hand.key(Qt::Key_Tab);   // to the list
    hand.key(Qt::Key_Down);  // FINISH_35
    EXPECT_EQ(tools.tool(), 2);
    hand.soft("Load");
    // from station 1 to 3
    hand.key(Qt::Key_Right);
    hand.key(Qt::Key_Right);
    hand.key(Qt::Key_Return);
    EXPECT_TRUE(waitFor([&] { return row(2).magazine == 1 && row(2).pot == 3; }))
        << row(2).magazine << "/" << row(2).pot;
    hand.soft("Unload");
    EXPECT_TRUE(waitFor([&] { return row(2).magazine == 0; }));
}

// Nobody knows in which channel the offset of a tool on the shelf is: no wear of a working tool is
// lost.
TEST_F(ToolTasks, ANewInsertOutsideATurretLeavesTheWearOfTheChosenChannel) {
    for (const char* offset : {"1", "3"})
        ASSERT_TRUE(g_controller->set(QString("offset L1 %1 wear X=0.05").arg(offset)));
    ASSERT_TRUE(
        g_controller->run({"tools", "set", "2", "counter=4", "--instance", g_controller->name}));
    ASSERT_TRUE(waitFor([&] {
        return row(2).counter == 4 && live().store(1).offsets[1].wear[0] == 0.05 &&
               live().store(1).offsets[3].wear[0] == 0.05;
    }));
    Operator hand(*window);
    hand.screen("tools");
    Tools& tools = screenOf<Tools>();
    hand.key(Qt::Key_Tab);   // to the list
    hand.key(Qt::Key_Down);  // FINISH_35, in no magazine
    ASSERT_EQ(tools.tool(), 2);
    hand.soft("New insert");
    hand.soft("New insert");
    ASSERT_TRUE(waitFor([&] { return row(2).counter == 0; }));
    frames(*window, 300);
    EXPECT_EQ(live().store(1).offsets[3].wear[0], 0.05);
    hand.key(Qt::Key_Up);  // in the turret of L1
    ASSERT_EQ(tools.tool(), 1);
    hand.soft("New insert");
    hand.soft("New insert");
    EXPECT_TRUE(waitFor([&] { return live().store(1).offsets[1].wear[0] == 0; }));
    ASSERT_TRUE(g_controller->set("offset L1 3 wear X=0"));
}

TEST_F(ToolTasks, AToolIsDraggedFromTheListFromPlaceToPlaceAndBack) {
    Operator hand(*window);
    hand.screen("tools");
    Tools& tools = screenOf<Tools>();
    const auto drag = [](QWidget* from, const QPoint& start, QWidget* to, const QPoint& end) {
        QTest::mousePress(from, Qt::LeftButton, {}, start);
        const QPoint there = from->mapFromGlobal(to->mapToGlobal(end));
        for (int step = 1; step <= 8; ++step) {
            QTest::mouseMove(from, start + (there - start) * step / 8);
            QTest::qWait(5);
        }
        QTest::mouseRelease(from, Qt::LeftButton, {}, there);
    };
    const auto station = [&](int number) {
        return tools.picture().boxOf(tools.picture().placeHit(number)).center().toPoint();
    };
    const QPoint line = tools.list().cellBox(tools.rowOf(3), 1).center().toPoint();
    drag(&tools.list(), line, &tools.picture(), station(7));
    ASSERT_TRUE(waitFor([&] { return row(3).magazine == 1 && row(3).pot == 7; }))
        << row(3).magazine << "/" << row(3).pot;
    drag(&tools.picture(), station(7), &tools.picture(), station(9));
    ASSERT_TRUE(waitFor([&] { return row(3).pot == 9; })) << row(3).pot;
    // taken: the store refuses, it stays
    drag(&tools.picture(), station(9), &tools.picture(), station(1));
    frames(*window, 400);
    EXPECT_EQ(row(3).pot, 9);
    drag(&tools.picture(), station(9), &tools.list(), tools.list().rect().center());
    EXPECT_TRUE(waitFor([&] { return row(3).magazine == 0; }));
}

TEST_F(ToolTasks, TheListIsFilteredByWhatIsTypedAndByState) {
    Operator hand(*window);
    hand.screen("tools");
    Tools& tools = screenOf<Tools>();
    hand.type("groo");
    EXPECT_EQ(tools.list().rows(), 1);
    EXPECT_EQ(tools.rowOf(3), 0);
    hand.key(Qt::Key_Escape);
    EXPECT_EQ(tools.list().rows(), 3);
    hand.soft("Filter");  // in this magazine
    EXPECT_EQ(tools.list().rows(), 1);
    // not loaded, to be replaced
    hand.soft("Filter");
    hand.soft("Filter");
    EXPECT_EQ(tools.list().rows(), 0);
    ASSERT_TRUE(
        g_controller->run({"tools", "set", "2", "worn=1", "--instance", g_controller->name}));
    EXPECT_TRUE(waitFor([&] { return tools.list().rows() == 1; }));
}

TEST_F(ToolTasks, DataAreEnteredAndWrongOnesRefused) {
    Operator hand(*window);
    hand.screen("tools");
    Tools& tools = screenOf<Tools>();
    hand.touchCell(tools.list(), tools.rowOf(2), 1);
    hand.soft("Tool data");
    ASSERT_EQ(tools.table().cell(4, 0).text, "Offset number");
    hand.touchCell(tools.table(), 4, 1);
    hand.type("23");
    hand.key(Qt::Key_Return);
    EXPECT_TRUE(waitFor([&] { return row(2).h_cell == 23; })) << row(2).h_cell;
    hand.touchCell(tools.table(), 0, 1);
    hand.type("FIN");
    hand.key(Qt::Key_Return);
    EXPECT_TRUE(waitFor([&] { return toolName(row(2), 2) == "FIN"; }))
        << toolName(row(2), 2).toStdString();
    hand.touchCell(tools.table(), 4, 1);
    // cells go to 999
    hand.type("5000");
    hand.key(Qt::Key_Return);
    frames(*window, 400);
    EXPECT_EQ(row(2).h_cell, 23);
    noWordIsShortened(*window);
}

TEST_F(ToolTasks, LifeTellsWhatStopsTheMachineFirst) {
    ASSERT_TRUE(
        g_controller->run({"tools", "load", "3", "1", "5", "--instance", g_controller->name}));
    Operator hand(*window);
    hand.screen("tools");
    Tools& tools = screenOf<Tools>();
    hand.soft("Life");
    ASSERT_TRUE(waitFor([&] { return tools.table().rows() == 3; }));
    hand.soft("Pallets");
    hand.soft("Presetter");
    noWordIsShortened(*window);
}

// What the presetter has said of one offset is not entered into another one.
TEST_F(ToolTasks, TheAnswerOfThePresetterIsForgottenWithItsOffset) {
    QTemporaryDir folder;
    QFile file(folder.filePath("tool.pgm"));
    ASSERT_TRUE(file.open(QIODevice::WriteOnly));
    file.write("P5 4 4 255\n" + QByteArray(16, '\x80'));
    file.close();
    Operator hand(*window);
    hand.screen("tools");
    PresetterPage& page = screenOf<Tools>().presetter();
    hand.soft("Presetter");
    page.readFolder(folder.path());
    const auto measure = [&] {
        hand.soft("Measure");
        return waitFor([&] {
            return !page.busy() && (!page.failure().isEmpty() || !page.answer().isEmpty());
        });
    };
    const auto forgotten = [&] { return page.failure().isEmpty() && page.answer().isEmpty(); };
    ASSERT_TRUE(measure());
    hand.touchCell(page.values(), 0, 1);
    hand.type("7");
    hand.key(Qt::Key_Return);
    EXPECT_TRUE(waitFor(forgotten, 5));
    ASSERT_TRUE(measure());
    frames(*window, 100);
    EXPECT_FALSE(forgotten()) << "it is of this one";
    hand.key(Qt::Key_2, Qt::ControlModifier);
    EXPECT_TRUE(waitFor(forgotten, 5));
}

// The life of a tool ends while the job runs: from the message to the restart.
TEST_F(ToolTasks, ReplaceAWornInsertFromMessageToRestartInTwelveActions) {
    const auto parameter = [&](const char* line) {
        ASSERT_TRUE(g_controller->run({"params", "set", line, "--instance", g_controller->name}))
            << line;
    };
    parameter("N2900=00000001");
    parameter("PT_LIFE_END L1=1");
    for (const char* job : {"tool_a.nc", "tool_b.nc"}) {
        QFile file(g_controller->folder.filePath(job));
        ASSERT_TRUE(file.open(QIODevice::WriteOnly));
        file.write(QString(job) == "tool_a.nc"
                       ? "O0001\nN10 T0100\nN20 G98 G0 X80. Z20.\n"
                         "N30 M500 P12\nN40 G1 Z15. F600.\nN50 M30\n"
                       : "O0002\nN10 M500 P12\nN20 G98 G1 Z18. F600.\nN30 M30\n");
    }
    ASSERT_TRUE(g_controller->run({"tools", "set", "1", "life=1", "counter=0", "warning=0",
                                   "--instance", g_controller->name}));
    ASSERT_TRUE(g_controller->press("select L1=" + g_controller->folder.filePath("tool_a.nc")) &&
                g_controller->press("select L2=" + g_controller->folder.filePath("tool_b.nc")));
    ASSERT_TRUE(g_controller->press("cycle_start"));
    ASSERT_TRUE(waitFor([&] { return (row(1).state & kToolWorn) != 0; })) << row(1).counter;
    ASSERT_TRUE(waitFor(
        [&] { return state(1) != ChannelState::Running && state(2) != ChannelState::Running; }));
    // the message is there: from here on it is the operator's turn
    Operator hand(*window);
    hand.screen("alarms");
    hand.screen("tools");
    Tools& tools = screenOf<Tools>();
    hand.touch(&tools.picture(), tools.picture().placeHit(1));
    EXPECT_EQ(tools.tool(), 1);
    hand.soft("New insert");
    hand.soft("New insert");  // asked once more
    ASSERT_TRUE(waitFor([&] { return !(row(1).state & kToolWorn) && row(1).counter == 0; }));
    hand.screen("overview");
    hand.soft("Reset all");
    hand.soft("Start all");
    hand.soft("Start all");  // asked once more
    EXPECT_LE(hand.actions, 12);
    EXPECT_TRUE(waitFor([&] { return row(1).counter == 1; }))
        << "the next part is made with the new insert";
    parameter("N2900=00000000");
}

}  // namespace
}  // namespace polyturn::hmi
