// A channel that speaks sinumerik has no numbered offsets: the screens show the edges of its tools,
// with the services of the offset table.
#include <QFile>

#include "hmi/machine/programs/setup_sheet.hpp"
#include "hmi/machine/tools/edge_words.hpp"
#include "hmi/screens/tools/offsets.hpp"
#include "hmi/screens/tools/tools.hpp"
#include "tests/unit/hmi/tasks.hpp"

namespace polyturn::hmi {
namespace {

class EdgeTasks : public Tasks {
protected:
    static void SetUpTestSuite() { g_controller = new Controller({}, {"N2900=00000001"}); }
    void SetUp() override {
        Tasks::SetUp();
        if (HasFatalFailure()) return;
        write("edges.job.toml",
              "name = \"edges\"\nsetup = \"edges.setup.toml\"\n"
              "[programs]\n1 = { file = \"FIRST.MPF\", language = \"sinumerik\" }\n"
              "2 = { file = \"SECOND.nc\", language = \"fanuc\" }\n");
        write("edges.setup.toml",
              "[channel.1.tool.41]\nname = \"ROUGH_80\"\n"
              "[channel.1.tool.41.edge.1]\nDP3 = 125.0\n"
              "DP4 = 40.0\n");
        write("FIRST.MPF", "N10 G90 G18 DIAMON\nN20 T9 D1\nN30 G0 X300 Z300\nN40 M0\nN50 M30\n");
        write("SECOND.nc", "O0002\nN10 M30\n");
        if (!live().tools().rows[40].used) {
            tools({"add", "41", "name=ROUGH_80", "kind=500", "D1.DP1=500", "D1.DP2=3", "D1.DP3=120",
                   "D1.DP4=40", "D1.DP6=0.8", "D2.DP1=500", "D2.DP3=121"});
            tools({"add", "42", "name=DRILL_12", "kind=200"});
            tools({"load", "41", "1", "9"});
        }
        ASSERT_TRUE(g_controller->press("select " + folder.filePath("edges.job.toml")));
        ASSERT_TRUE(waitFor([&] {
            return live().programLanguage(1) == Dialect::Sinumerik &&
                   live().programLanguage(2) == Dialect::Fanuc && live().tools().rows[41].used &&
                   live().tools().rows[40].magazine == 1;
        }));
    }
    void tools(QStringList words) {
        ASSERT_TRUE(
            g_controller->run(QStringList{"tools"} << words << "--instance" << g_controller->name))
            << words.join(' ').toStdString();
    }
    void write(const QString& name, const char* text) {
        QFile file(folder.filePath(name));
        ASSERT_TRUE(file.open(QIODevice::WriteOnly));
        file.write(text);
    }
    double dp(int edge, int parameter, int tool = 41) const {
        return edgeValue(live(), {tool, edge}, parameter);
    }
    int columnOf(Offsets& offsets, const QString& title) const {
        for (int i = 0; i < static_cast<int>(offsets.table().columns.size()); ++i)
            if (offsets.table().columns[static_cast<std::size_t>(i)].title == title) return i;
        return -1;
    }
    QTemporaryDir folder;
};

TEST_F(EdgeTasks, StandInPlaceOfTheNumberedOffsets) {
    Operator hand(*window);
    hand.screen("offsets");
    Offsets& offsets = screenOf<Offsets>();
    frames(*window);
    Table& table = offsets.table();
    EXPECT_EQ(table.column(), columnOf(offsets, "L1")) << "what is typed first is no type";
    ASSERT_EQ(table.rows(), 3)
        << "D1 and D2 of one tool, and D1 of the other, which has no value yet";
    EXPECT_TRUE(table.cell(0, 0).text.contains("ROUGH_80") && table.cell(0, 0).text.contains("T41"))
        << table.cell(0, 0).text.toStdString();
    EXPECT_TRUE(table.cell(1, 0).text.isEmpty()) << "a tool is named once";
    EXPECT_EQ(table.cell(1, 1).text, "2");
    EXPECT_TRUE(table.cell(2, 0).text.contains("DRILL_12"));
    struct {
        const char* title;
        const char* text;
    } facts[] = {{"Type", "500"},     {"Tip", "3"},         {"L1", "120.000"},  {"L2", "40.000"},
                 {"Radius", "0.800"}, {"Wear L1", "0.000"}, {"Wear R", "0.000"}};
    for (const auto& [title, text] : facts) {
        ASSERT_GE(columnOf(offsets, title), 0) << title;
        EXPECT_EQ(table.cell(0, columnOf(offsets, title)).text, text) << title;
    }
    hand.soft("Work zeros");
    EXPECT_EQ(table.columns[0].title, "Zero");
    hand.soft("Tool edges");
    // The other channel speaks fanuc: its table has numbers.
    hand.key(Qt::Key_2, Qt::ControlModifier);
    frames(*window);
    EXPECT_EQ(table.columns[0].title, "No.");
    hand.key(Qt::Key_1, Qt::ControlModifier);
    frames(*window);
    EXPECT_EQ(table.rows(), 3);
    noWordIsShortened(*window);
}

TEST_F(EdgeTasks, TakeAWearInFourActionsAndTheUndoIsGuarded) {
    Operator hand(*window);
    hand.screen("offsets");
    Offsets& offsets = screenOf<Offsets>();
    frames(*window);
    const int wear = columnOf(offsets, "Wear L1"), l1 = columnOf(offsets, "L1");
    const double before = dp(1, kDpWear);
    hand.touchCell(offsets.table(), 0, wear);
    hand.type("-0.02");
    hand.soft("+ Input");
    EXPECT_LE(hand.actions, 4);
    ASSERT_TRUE(waitFor([&] { return std::abs(dp(1, kDpWear) - (before - 0.02)) < 1e-9; }));
    const auto told = [&] {
        int lines = 0;
        for (const Sheet* sheet : offsets.sheets())
            for (const Item& one : sheet->items())
                lines += one.text.contains(QString::fromUtf8("0.000 → -0.020"));
        return lines;
    };
    EXPECT_TRUE(waitFor([&] { return told() > 0; })) << "in its history";
    // asked for again before it was answered
    offsets.table().choose(0, l1);
    offsets.table().choose(0, wear);
    offsets.table().choose(0, l1);
    offsets.table().choose(0, wear);
    frames(*window, 500);
    EXPECT_EQ(told(), 1);
    hand.soft("Undo");
    ASSERT_TRUE(waitFor([&] { return std::abs(dp(1, kDpWear) - before) < 1e-9; }));
    // 50/2, +0.05, as in every field
    hand.touchCell(offsets.table(), 1, l1);
    hand.type("240/2");
    hand.soft("Input");
    ASSERT_TRUE(waitFor([&] { return std::abs(dp(2, kDpLength) - 120) < 1e-9; }));
    hand.type("+0.05");
    hand.soft("Input");
    ASSERT_TRUE(waitFor([&] { return std::abs(dp(2, kDpLength) - 120.05) < 1e-9; }));
    // What somebody else has changed since stays.
    tools({"set", "41", "D2.DP3=130"});
    ASSERT_TRUE(waitFor([&] { return dp(2, kDpLength) == 130; }));
    hand.soft("Undo");
    frames(*window, 300);
    EXPECT_EQ(dp(2, kDpLength), 130);
    // A tool without values gets its first edge by the first one.
    hand.touchCell(offsets.table(), 2, columnOf(offsets, "Type"));
    hand.type("200");
    hand.soft("Input");
    ASSERT_TRUE(waitFor([&] { return dp(1, kDpType, 42) == 200; }));
    hand.soft("New edge");
    ASSERT_TRUE(waitFor([&] { return dp(2, kDpType, 42) == 200; }));
    tools({"set", "42", "D1.DP1=0", "D2.DP1=0"});
}

// machine = zero + value + length (L1 of a turning tool along X, true length): what has been
// entered acts at the next T or D.
TEST_F(EdgeTasks, AreMeasuredAndShownBesideWhatIsApplied) {
    ASSERT_TRUE(g_controller->press("reference all"));
    ASSERT_TRUE(waitFor(
        [&] { return static_cast<MachineStep>(live().status().step) == MachineStep::Ready; }));
    for (const char* key : {"mode L1=auto", "mode L2=auto"}) ASSERT_TRUE(g_controller->press(key));
    ASSERT_TRUE(g_controller->press("cycle_start L1"));
    ASSERT_TRUE(waitFor([&] { return state(1) == ChannelState::ProgramStop; }))
        << waitWords(live(), 1).toStdString();
    ASSERT_TRUE(waitFor([&] {
        return live().view(1).known && live().view(1).picture.tool == 41 &&
               live().view(1).picture.edge == 1;
    })) << live().view(1).picture.tool;
    Operator hand(*window);
    hand.screen("offsets");
    Offsets& offsets = screenOf<Offsets>();
    frames(*window);
    hand.touchCell(offsets.table(), 0, columnOf(offsets, "L1"));
    frames(*window);
    EXPECT_TRUE(standsOn(offsets.sheets(), "Applied now"));
    EXPECT_TRUE(standsOn(offsets.sheets(), "Active"));
    EXPECT_TRUE(standsOn(offsets.sheets(), "120.000"));
    hand.type("52.48");
    hand.soft("Measured");
    hand.soft("Measured");  // asked once more
    const auto stands = [&] {
        double zero = 0;
        if (!live().zeroNow(1, 0, zero))
            zero = live().tableZero(1, 0, live().view(1).picture.zero_row);
        // the machine's X is a true length, the workpiece's a diameter
        return live().status().axes[0].act - zero - 52.48 / 2 - dp(1, kDpWear);
    };
    EXPECT_TRUE(waitFor([&] { return std::abs(dp(1, kDpLength) - stands()) < 1e-3; }))
        << dp(1, kDpLength) << " is not " << stands();
    frames(*window);
    EXPECT_TRUE(standsOn(offsets.sheets(), "Active at the next T or D"));
    hand.soft("Undo");
    EXPECT_TRUE(waitFor([&] { return std::abs(dp(1, kDpLength) - 120) < 1e-9; }));
    g_controller->press("reset");
}

// A long table is looked through by number, tool or name; what has been found is entered as ever.
TEST_F(EdgeTasks, AreFoundByToolEdgeAndName) {
    Operator hand(*window);
    hand.screen("offsets");
    Offsets& offsets = screenOf<Offsets>();
    frames(*window);
    Table& table = offsets.table();
    ASSERT_EQ(table.rows(), 3);
    Sheet* field = nullptr;
    for (Sheet* one : offsets.sheets())
        if (!one->fields().empty()) field = one;
    ASSERT_NE(field, nullptr);
    hand.touch(field, Offsets::kFindHit);
    ASSERT_TRUE(window->entry().isVisible()) << "letters for a finger";
    hand.type("drill");
    hand.key(Qt::Key_Return);
    frames(*window);
    ASSERT_EQ(table.rows(), 1);
    EXPECT_TRUE(table.cell(0, 0).text.contains("DRILL_12"));
    const int l1 = columnOf(offsets, "L1");
    hand.touchCell(table, 0, l1);
    hand.type("77");
    hand.soft("Input");
    ASSERT_TRUE(waitFor([&] { return dp(1, kDpLength, 42) == 77; })) << "the row that is shown";
    EXPECT_EQ(dp(1, kDpLength), 120);
    hand.soft("Undo");
    ASSERT_TRUE(waitFor([&] { return dp(1, kDpLength, 42) == 0; }));
    const QString kept = offsets.state();
    hand.key(Qt::Key_Escape);
    EXPECT_EQ(table.rows(), 3);
    offsets.restore(kept);
    EXPECT_EQ(table.rows(), 1) << "kept over a restart";
    for (const auto& [typed, rows] :
         {std::pair{"41", 2}, {"T42", 1}, {"D2", 1}, {"4", 0}, {"rough", 2}, {"", 3}}) {
        offsets.find(typed);
        EXPECT_EQ(table.rows(), rows) << typed;
    }
    offsets.find("D2");
    EXPECT_TRUE(table.cell(0, 0).text.contains("ROUGH_80"))
        << "named though its first edge is not shown";
    hand.soft("Work zeros");
    EXPECT_GT(table.rows(), 20) << "another table, another search";
    for (const auto& [typed, rows] : {std::pair{"55", 1}, {"p12", 1}, {"g5", 0}}) {
        offsets.find(typed);
        if (rows) {
            EXPECT_EQ(table.rows(), rows) << typed;
        } else {
            EXPECT_GT(table.rows(), 4) << typed;
        }
    }
    hand.soft("Tool edges");
    hand.key(Qt::Key_2, Qt::ControlModifier);
    frames(*window);
    offsets.find("3");
    EXPECT_EQ(table.rows(), 1);
    EXPECT_EQ(table.cell(0, 0).text, "3");
    offsets.find("");
    hand.key(Qt::Key_1, Qt::ControlModifier);
}

// The last edge of a tool goes by two presses, whole, and comes back whole; base lengths have
// columns of their own.
TEST_F(EdgeTasks, GoAndComeBackWholeAndHaveBaseLengths) {
    Operator hand(*window);
    hand.screen("offsets");
    Offsets& offsets = screenOf<Offsets>();
    frames(*window);
    const auto deletes = [&] {
        for (const SoftKey& one : offsets.keys())
            if (one.text == "Delete edge") return one.enabled;
        return false;
    };
    hand.touchCell(offsets.table(), 0, columnOf(offsets, "L1"));
    frames(*window);
    EXPECT_FALSE(deletes()) << "D2 would stand without a D1";
    hand.touchCell(offsets.table(), 1, columnOf(offsets, "L1"));
    hand.soft("Base lengths");
    ASSERT_GE(columnOf(offsets, "Base L1"), 0);
    EXPECT_EQ(columnOf(offsets, "Wear L1"), -1);
    hand.touchCell(offsets.table(), 1, columnOf(offsets, "Base L1"));
    hand.type("7.5");
    hand.soft("Input");
    ASSERT_TRUE(waitFor([&] { return dp(2, kDpBase) == 7.5; }));
    hand.touchCell(offsets.table(), 1, columnOf(offsets, "Base L1"));
    const double length = dp(2, kDpLength);
    hand.soft("Delete edge");
    frames(*window, 200);
    EXPECT_EQ(dp(2, kDpType), 500) << "one press deletes nothing";
    hand.soft("Delete edge");
    ASSERT_TRUE(waitFor([&] { return edgeOf(live(), {41, 2}) == nullptr; }));
    frames(*window);
    EXPECT_EQ(offsets.table().rows(), 2);
    hand.soft("Undo");
    ASSERT_TRUE(waitFor([&] {
        return dp(2, kDpBase) == 7.5 && dp(2, kDpType) == 500 && dp(2, kDpLength) == length;
    }));
    // Somebody has made it anew meanwhile: that stays.
    hand.touchCell(offsets.table(), 1, columnOf(offsets, "Base L1"));
    hand.soft("Delete edge");
    hand.soft("Delete edge");
    ASSERT_TRUE(waitFor([&] { return edgeOf(live(), {41, 2}) == nullptr; }));
    tools({"set", "41", "D2.DP1=500", "D2.DP3=121"});
    ASSERT_TRUE(waitFor([&] { return dp(2, kDpLength) == 121; }));
    hand.soft("Undo");
    frames(*window, 300);
    EXPECT_EQ(dp(2, kDpBase), 0);
    EXPECT_EQ(dp(2, kDpLength), 121);
    hand.soft("Base lengths");
    EXPECT_GE(columnOf(offsets, "Wear L1"), 0);
    hand.soft("Base lengths");
    noWordIsShortened(*window);  // makes the screens anew
}

// The page of a tool shows them, and leads to where they are entered.
TEST_F(EdgeTasks, StandOnThePageOfTheirTool) {
    Tools& page = screenOf<Tools>();
    Operator hand(*window);
    hand.screen("tools");
    hand.soft("Tool data");
    frames(*window);
    page.list().choose(page.rowOf(41));
    frames(*window);
    int found = -1;
    for (int row = 0; row < page.table().rows(); ++row)
        if (page.table().cell(row, 0).text == "D2  L1") found = row;
    ASSERT_GE(found, 0);
    EXPECT_EQ(page.table().cell(found, 1).text, "121.000");
    page.table().choose(found);
    hand.type("5");
    hand.key(Qt::Key_Return);
    frames(*window, 200);
    EXPECT_EQ(dp(2, kDpLength), 121) << "read only";
    if (window->screen()->name() == QString("tools")) hand.soft("To the offsets");
    EXPECT_EQ(window->screen()->name(), QString("offsets"));
    Offsets& offsets = screenOf<Offsets>();
    EXPECT_EQ(offsets.table().cell(offsets.table().row(), 1).text, "2");
}

// On the command line an edge stands in the place of a number.
TEST_F(EdgeTasks, AreEnteredAndTakenBackOnTheCommandLine) {
    const auto offsets = [&](QStringList words) {
        return g_controller->run(QStringList{"offsets"} << words << "--instance"
                                                        << g_controller->name);
    };
    const double wear = dp(1, kDpWear), radius = dp(1, kDpRadius);
    ASSERT_TRUE(offsets({"set", "L1", "T41.D1", "wear", "X=0.02"}));
    ASSERT_TRUE(waitFor([&] { return std::abs(dp(1, kDpWear) - 0.02) < 1e-9; }))
        << "L1 of a turning tool lies along X";
    ASSERT_TRUE(offsets({"set", "L1", "T41", "DP12=0.01", "DP6=0.4", "--incremental"}));
    ASSERT_TRUE(waitFor([&] {
        return std::abs(dp(1, kDpWear) - 0.03) < 1e-9 &&
               std::abs(dp(1, kDpRadius) - radius - 0.4) < 1e-9;
    }));
    ASSERT_TRUE(offsets({"set", "L1", "T41.D1", "wear", "X=0.05", "--plane", "19"}));
    ASSERT_TRUE(waitFor([&] { return std::abs(dp(1, kDpWear + 2) - 0.05) < 1e-9; }))
        << "in G19 L3 does";
    ASSERT_TRUE(offsets({"undo", "L1", "T41.D1"}));
    ASSERT_TRUE(waitFor([&] { return dp(1, kDpWear + 2) == 0; }));
    ASSERT_TRUE(offsets({"undo", "L1", "T41.D1"}));
    ASSERT_TRUE(waitFor([&] { return std::abs(dp(1, kDpRadius) - radius) < 1e-9; }));
    ASSERT_TRUE(offsets({"undo", "L1", "T41"}));
    ASSERT_TRUE(waitFor([&] { return std::abs(dp(1, kDpWear) - 0.02) < 1e-9; }));
    tools({"set", "41", "D1.DP12=" + QString::number(wear)});
    EXPECT_FALSE(offsets({"set", "L1", "T41.D13", "DP12=0.01"}));
    EXPECT_FALSE(offsets({"set", "L1", "3", "X=1"})) << "a number needs its table";
    EXPECT_FALSE(offsets({"undo", "L1", "41"}));
}

TEST_F(EdgeTasks, AreComparedWithThoseOfTheSetupFile) {
    const JobSheet sheet = readJobSheet(folder.filePath("edges.job.toml"), live().machineFolder(),
                                        DisplayLanguage::English);
    const auto edges = compareEdges(live(), sheet);
    ASSERT_EQ(edges.size(), 1u);
    EXPECT_FALSE(edges[0].same());
    EXPECT_EQ(edgeText(live(), edges[0], OffsetSide::Wanted, OffsetPart::Geometry, true),
              "L1 125.000  L2 40.000");
    EXPECT_EQ(edgeText(live(), edges[0], OffsetSide::Entered, OffsetPart::Geometry, false),
              "L1 120.000");
    EXPECT_TRUE(jobDiffers(live(), sheet).contains("L1 T41 D1"))
        << jobDiffers(live(), sheet).toStdString();
    EXPECT_TRUE(sheetText(live(), sheet).contains("L1 125.000"));
}

}  // namespace
}  // namespace polyturn::hmi
