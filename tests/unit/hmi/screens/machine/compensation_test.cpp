// Compensation tables as curves: positions and values as the parameters and the cells have them.
// Then the page: values of every kind of table entered by touch and keys, on a machine that has
// them.
#include <QDir>
#include <QFile>

#include "hmi/machine/bodies/compensation_curves.hpp"
#include "hmi/screens/machine/parameters.hpp"
#include "ipc/model/machine/load_machine.hpp"
#include "tests/places.hpp"
#include "tests/unit/hmi/tasks.hpp"

namespace polyturn::hmi {
namespace {

using Kind = CompensationCurve::Kind;

std::vector<CompensationCurve> curvesOf(const std::vector<std::string>& lines,
                                        const std::string& cells) {
    LoadedMachine loaded =
        load_machine({std::string(kSourceFolder) + "/examples/machines/twin-turret", {}, lines});
    for (const Diagnosis& one : loaded.diagnoses) ADD_FAILURE() << one.text();
    std::vector<Diagnosis> wrong;
    const CompensationTables tables = parse_compensation(cells, "machine.compensation", wrong);
    EXPECT_TRUE(wrong.empty());
    return compensationCurves(*loaded.table, derive_machine_config(*loaded.table), tables);
}

TEST(CompensationCurves, HaveThePointsOfAPitchTableInBothDirections) {
    // Cells 10500 to 10504, 50 mm apart, machine zero at 10502; a second table for the way back
    // from 10600 on.
    const auto curves = curvesOf({"N2500 A2=00000011", "N2501 A2=50", "N2502 A2=10502",
                                  "N2503 A2=10500", "N2504 A2=10504", "N2505 A2=10600"},
                                 "10500=-0.004\n10501=-0.002\n10502=0\n10503=0.003\n"
                                 "10504=0.007\n10600=-0.005\n10601=0\n10602=0\n"
                                 "10603=0\n10604=0.001\n");
    ASSERT_EQ(curves.size(), 2u);
    EXPECT_EQ(curves[0].kind, Kind::Pitch);
    EXPECT_EQ(curves[0].moving, 2u);
    EXPECT_TRUE(curves[0].on);
    ASSERT_EQ(curves[0].points.size(), 5u);
    const double at[] = {-100, -50, 0, 50, 100}, value[] = {-0.004, -0.002, 0, 0.003, 0.007};
    for (std::size_t i = 0; i < 5; ++i) {
        EXPECT_EQ(curves[0].points[i].number, static_cast<std::int64_t>(10500 + i));
        EXPECT_DOUBLE_EQ(curves[0].points[i].at, at[i]);
        EXPECT_NEAR(curves[0].points[i].value, value[i], 1e-7);
    }
    EXPECT_EQ(curves[1].kind, Kind::PitchBack);
    EXPECT_EQ(curves[1].points.front().number, 10600);
    EXPECT_DOUBLE_EQ(curves[1].points.front().at, -100);
    EXPECT_NEAR(curves[1].points.back().value, 0.001, 1e-7);
}

TEST(CompensationCurves, HaveTheFourPositionsOfGradientAndStraightness) {
    const auto curves =
        curvesOf({"N2800 A1=00000001", "N2801 A1=-10",      "N2802 A1=0",    "N2803 A1=20",
                  "N2804 A1=60",       "N2805 A1=0.001",    "N2806 A1=0",    "N2807 A1=-0.002",
                  "N2808 A1=0.004",    "N2600 L1=00000001", "N2602 L1=2",    "N2608 L1=1",
                  "N2623 L1=-5",       "N2624 L1=5",        "N2625 L1=15",   "N2626 L1=25",
                  "N2635 L1=0.01",     "N2636 L1=0.02",     "N2637 L1=0.03", "N2638 L1=0.04"},
                 "");
    ASSERT_EQ(curves.size(), 2u);
    EXPECT_EQ(curves[0].kind, Kind::Gradient);
    EXPECT_DOUBLE_EQ(curves[0].points[3].at, 60);
    EXPECT_DOUBLE_EQ(curves[0].points[2].value, -0.002);
    EXPECT_EQ(curves[1].kind, Kind::Straightness);  // pair 2
    EXPECT_EQ(curves[1].moving, 2u);
    EXPECT_EQ(curves[1].corrected, 1u);
    EXPECT_DOUBLE_EQ(curves[1].points[1].at, 5);
    EXPECT_DOUBLE_EQ(curves[1].points[3].value, 0.04);
}

TEST(CompensationCurves, AMachineWithoutTablesHasNone) { EXPECT_TRUE(curvesOf({}, "").empty()); }

TEST(CompensationCurves, HaveTheRowsOfAGrid) {
    // X and Z of L1, 3 by 2 points, machine zero at the second of X; N2701 is not used and counts
    // one point, whatever N2704 says.
    const std::vector<std::string> lines = {"N2700 L1=1",  "N2702 L1=2",  "N2703 L1=3",
                                            "N2704 L1=9",  "N2705 L1=2",  "N2706 L1=1",
                                            "N2709 L1=50", "N2711 L1=100"};
    const std::string cells =
        "3D L1 0=0.1 0 1\n3D L1 1=0 0 0\n3D L1 2=0.2 0 2\n3D L1 3=0.3 0 3\n3D L1 4=0.4 0 4\n";
    const auto curves = curvesOf(lines, cells);
    ASSERT_EQ(curves.size(), 1u);
    EXPECT_EQ(curves[0].kind, Kind::Grid);
    EXPECT_EQ(curves[0].count, 6);
    EXPECT_DOUBLE_EQ(curves[0].largest, 4);
    std::vector<Diagnosis> none;
    const CompensationTables tables = parse_compensation(cells, "x", none);
    GridRow row = firstRow(curves[0].grid);
    EXPECT_EQ(row.place[0], 1);
    const CompensationCurve x = gridRow(curves[0], tables, row);
    ASSERT_EQ(x.points.size(), 3u);
    EXPECT_EQ(x.moving, 1u);
    EXPECT_EQ(x.corrected, 1u);
    EXPECT_DOUBLE_EQ(x.points[0].at, -50);
    EXPECT_NEAR(x.points[2].value, 0.2, 1e-7);
    row.component = 2;
    row.along = 2;
    row.place[0] = 2;
    const CompensationCurve z = gridRow(curves[0], tables, row);
    ASSERT_EQ(z.points.size(), 2u);
    EXPECT_EQ(z.moving, 2u);
    EXPECT_EQ(z.corrected, 2u);
    EXPECT_EQ(z.points[1].number, 5);
    EXPECT_DOUBLE_EQ(z.points[1].at, 100);
    EXPECT_FALSE(z.points[1].given) << "nobody has measured it";
    EXPECT_EQ(within({1, 1, {7, 7, -7}}, curves[0].grid).place,
              (std::array<std::int64_t, 3>{2, 0, 0}));
    EXPECT_EQ(within({1, 1, {}}, curves[0].grid).along, 0u);
}

TEST(CompensationCurves, ThePeriodicOneBeginsAtMachineZero) {
    const auto curves = curvesOf({"N0106 A2=00000100", "N2500 A2=00001000", "N2507 A2=1",
                                  "N2508 A2=10000", "N2509 A2=10004", "N2510 A2=4"},
                                 "10000=0\n10001=0.001\n10002=0\n10003=0\n10004=0\n");
    ASSERT_EQ(curves.size(), 1u);
    EXPECT_EQ(curves[0].kind, Kind::Periodic);
    EXPECT_TRUE(curves[0].on);
    EXPECT_EQ(curves[0].count, 5);
    EXPECT_DOUBLE_EQ(curves[0].points[1].at, 1);
    EXPECT_NEAR(curves[0].points[1].value, 0.001, 1e-7);
}

class CompensationTasks : public Tasks {
protected:
    static inline QTemporaryDir* g_folder = nullptr;
    static QString file() { return g_folder->filePath("lathe/machine.compensation"); }
    static void SetUpTestSuite() {
        g_folder = new QTemporaryDir;
        const QString from = QString(kSourceFolder) + "/examples/machines/twin-turret",
                      to = g_folder->filePath("lathe");
        QDir().mkpath(to);
        for (const QString& name : QDir(from).entryList(QDir::Files))
            QFile::copy(from + "/" + name, to + "/" + name);
        QFile parameters(to + "/machine.params");
        parameters.setPermissions(QFile::ReadOwner | QFile::WriteOwner);
        ASSERT_TRUE(parameters.open(QIODevice::Append));
        // Pitch of Z; X by Z straightness; four positions of X; a grid of 3 by 4.
        for (const char* line :
             {"N2500 A2=1", "N2501 A2=10", "N2502 A2=10005", "N2503 A2=10000", "N2504 A2=10010",
              "N2601 L1=2", "N2607 L1=1", "N2613 L1=10100", "N2800 A1=1", "N2801 A1=0",
              "N2802 A1=10", "N2803 A1=20", "N2804 A1=30", "N2700 L1=1", "N2701 L1=2", "N2703 L1=3",
              "N2704 L1=4", "N2709 L1=50", "N2710 L1=100"}) {
            parameters.write(line);
            parameters.write("\n");
        }
        parameters.close();
        QFile cells(file());
        ASSERT_TRUE(cells.open(QIODevice::WriteOnly));
        for (int i = 0; i <= 10; ++i)
            cells.write(QString("%1=%2\n%3=0\n")
                            .arg(10000 + i)
                            .arg(0.001 * (i - 5))
                            .arg(10100 + i)
                            .toUtf8());
        for (int i = 0; i < 12; ++i)
            cells.write(QString("3D L1 %1=0 %2 0\n").arg(i).arg(0.0005 * i).toUtf8());
        cells.close();
        g_controller = new Controller(to);
    }
    static void TearDownTestSuite() {
        Tasks::TearDownTestSuite();
        delete g_folder, g_folder = nullptr;
    }
    static QString text() {
        QFile cells(file());
        return cells.open(QIODevice::ReadOnly) ? QString::fromUtf8(cells.readAll()) : QString();
    }
    bool kept(const QString& line) {
        return waitFor([&] { return ("\n" + text()).contains("\n" + line + "\n"); }, 20);
    }
    double number(const char* row, unsigned instance) const {
        return live().table().numbers[params::find(row)->first_slot + instance - 1];
    }
    CompensationPage& open(Operator& hand) {
        hand.screen("parameters");
        hand.soft("Compensation tables");
        CompensationPage& page = screenOf<Parameters>().compensation();
        EXPECT_TRUE(waitFor([&] {
            frames(*window, 20);
            return page.ready() && !page.all().empty();
        }));
        return page;
    }
    void choose(Operator& hand, CompensationPage& page, Kind kind) {
        for (std::size_t i = 0; i < page.all().size(); ++i)
            if (page.all()[i].kind == kind) {
                hand.touchCell(page.curves(), static_cast<int>(i), 0);
                return frames(*window);
            }
        FAIL() << "there is no such table";
    }
};

TEST_F(CompensationTasks, AStraightnessCellIsEnteredAddedToAndTakenBack) {
    Operator hand(*window);
    CompensationPage& page = open(hand);
    ASSERT_EQ(page.all().size(), 4u) << "gradient, pitch, straightness, grid";
    choose(hand, page, Kind::Straightness);
    EXPECT_TRUE(standsOn({&page.graph()}, "A1 X by A2 Z: straightness"));
    hand.touchCell(page.points(), 3, 2);
    frames(*window);
    EXPECT_TRUE(standsOn({&page.pad()}, "Cell 10103"));
    hand.type("0.05/2");
    hand.key(Qt::Key_Return);
    ASSERT_TRUE(kept("10103=0.025")) << text().toStdString();
    ASSERT_TRUE(waitFor([&] {
        frames(*window, 20);
        return page.points().cell(3, 2).text == "0.0250";
    }));
    EXPECT_EQ(page.points().cell(3, 3).text, "+0.0250") << "the difference to what was there";
    EXPECT_TRUE(standsOn({&page.graph()}, "thin: before"));
    hand.type("+0.005");
    hand.key(Qt::Key_Return);
    ASSERT_TRUE(kept("10103=0.03"));
    hand.soft("Undo");
    ASSERT_TRUE(kept("10103=0.025"));
    hand.soft("Undo");
    ASSERT_TRUE(kept("10103=0"));
    EXPECT_TRUE(kept("10000=-0.005")) << "nothing else is lost";
    EXPECT_TRUE(kept("3D L1 4=0 0.002 0"));
    hand.soft("Compensation tables");
}

TEST_F(CompensationTasks, AGridIsEnteredRowByRowByTouchAndByKeys) {
    Operator hand(*window);
    CompensationPage& page = open(hand);
    choose(hand, page, Kind::Grid);
    ASSERT_EQ(page.points().rows(), 3) << "along X";
    hand.touch(&page.graph(), CompensationPage::kCorrectedHit + 1);
    hand.touch(&page.graph(), CompensationPage::kOnHit + 1);
    frames(*window);
    EXPECT_EQ(page.row().place[1], 1);
    EXPECT_TRUE(standsOn({&page.graph()}, "100.000"));
    EXPECT_TRUE(standsOn({&page.graph()}, "pale: the rows beside it"));
    hand.touchCell(page.points(), 1, 2);
    hand.type("0.004");
    hand.soft("Input");
    ASSERT_TRUE(kept("3D L1 4=0 0.004 0")) << text().toStdString();
    hand.soft("Undo");
    ASSERT_TRUE(kept("3D L1 4=0 0.002 0"));
    // The same with keys: along Z, through X 50, corrected X.
    hand.soft("Along axis");
    hand.soft("Corrected axis");
    frames(*window);
    ASSERT_EQ(page.points().rows(), 4);
    hand.key(Qt::Key_Right);
    frames(*window);
    EXPECT_EQ(page.row().place[0], 1);
    hand.key(Qt::Key_Home);
    hand.key(Qt::Key_Down);
    hand.key(Qt::Key_Down);
    hand.type("-0.001");
    hand.key(Qt::Key_Return);
    ASSERT_TRUE(kept("3D L1 7=-0.001 0.0035 0")) << text().toStdString();
    hand.soft("Undo");
    ASSERT_TRUE(kept("3D L1 7=0 0.0035 0"));
    // Machine zero corrects nothing.
    hand.key(Qt::Key_Left);
    hand.key(Qt::Key_Home);
    hand.type("0.001");
    hand.key(Qt::Key_Return);
    ASSERT_TRUE(waitFor(
        [&] {
            frames(*window, 20);
            return standsOn(window->ownSheets(), "machine zero");
        },
        20));
    EXPECT_TRUE(kept("3D L1 0=0 0 0"));
    hand.soft("Compensation tables");
}

TEST_F(CompensationTasks, FourPositionsAndWhatDescribesATableAreParameters) {
    Operator hand(*window);
    CompensationPage& page = open(hand);
    choose(hand, page, Kind::Gradient);
    hand.touchCell(page.points(), 1, 1);
    frames(*window);
    EXPECT_TRUE(standsOn({&page.pad()}, "N2802 A1"));
    hand.type("12");
    hand.key(Qt::Key_Return);
    ASSERT_TRUE(waitFor([&] { return number("N2802", 1) == 12; }));
    hand.touchCell(page.points(), 1, 2);
    hand.type("0.01/4");
    hand.key(Qt::Key_Return);
    ASSERT_TRUE(waitFor([&] { return number("N2806", 1) == 0.0025; }));
    hand.soft("Undo");
    ASSERT_TRUE(waitFor([&] { return number("N2806", 1) == 0; }));
    // Layout: the points move when their distance does.
    choose(hand, page, Kind::Pitch);
    hand.touchCell(page.settings(), 1, 2);
    frames(*window);
    EXPECT_TRUE(standsOn({&page.pad()}, "N2501 A2"));
    hand.type("+10");
    hand.key(Qt::Key_Return);
    ASSERT_TRUE(waitFor([&] { return number("N2501", 2) == 20; }));
    ASSERT_TRUE(waitFor([&] {
        frames(*window, 20);
        return page.points().cell(0, 1).text == "-100.000";
    }));
    hand.soft("Undo");
    ASSERT_TRUE(waitFor([&] { return number("N2501", 2) == 10; }));
    hand.soft("Undo");
    ASSERT_TRUE(waitFor([&] { return number("N2802", 1) == 10; }));
    // A table that is not described yet can be chosen, and described here.
    hand.soft("All tables");
    frames(*window);
    EXPECT_GT(page.all().size(), 12u);
    hand.soft("All tables");
    frames(*window);
    EXPECT_EQ(page.all().size(), 4u);
    hand.soft("Compensation tables");
}

TEST_F(CompensationTasks, WhatSomebodyElseEntersIsSeenAndAFileIsTaken) {
    Operator hand(*window);
    CompensationPage& page = open(hand);
    choose(hand, page, Kind::Pitch);
    QString other = text();
    other.replace("10010=0.005", "10010=0.75");
    QFile cells(g_folder->filePath("measured.compensation"));
    ASSERT_TRUE(cells.open(QIODevice::WriteOnly));
    cells.write(other.toUtf8());
    cells.close();
    hand.soft("Take a measured file");
    for (int i = 0; i < 200; ++i) hand.key(Qt::Key_Backspace);
    hand.type(cells.fileName());
    hand.key(Qt::Key_Return);
    ASSERT_TRUE(kept("10010=0.75"));
    ASSERT_TRUE(waitFor([&] {
        frames(*window, 20);
        return page.points().cell(10, 2).text == "0.7500";
    }));
    other.replace("10010=0.75", "10010=0.005");
    QFile kernels(file());
    ASSERT_TRUE(kernels.open(QIODevice::WriteOnly));  // as a program does it
    kernels.write(other.toUtf8());
    kernels.close();
    ASSERT_TRUE(waitFor([&] {
        frames(*window, 20);
        return page.points().cell(10, 2).text == "0.0050";
    }));
    hand.soft("Compensation tables");
}

TEST_F(CompensationTasks, NoWordIsShortened) {
    noWordIsShortened(*window);
    window->resize(800, 1280);
    noWordIsShortened(*window);
}

}  // namespace
}  // namespace polyturn::hmi
