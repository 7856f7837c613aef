// The picture of the machine: the stock as it is cut, bodies where protection has them, live and in
// a dry run.
#include "hmi/screens/graphics/graphics.hpp"

#include <QFile>
#include <cmath>

#include "hmi/screens/graphics/kept_paths.hpp"
#include "hmi/screens/programs/programs.hpp"
#include "tests/places.hpp"
#include "tests/unit/hmi/tasks.hpp"

namespace polyturn::hmi {
namespace {

text::JobStock bar(double diameter, double length) {
    text::JobStock stock;
    stock.diameter = diameter;
    stock.length = length;
    return stock;
}

TEST(CuttingScene, TakesAwayWhatTheTipHasPassed) {
    CuttingScene scene;
    scene.begin(bar(60, 100), {-150, 0, 1});
    scene.add(1, -150, 40, true);
    scene.add(1, -150, 20, true);
    scene.add(1, -190, 20, false);
    EXPECT_DOUBLE_EQ(scene.stock.radiusAt(-10), 20);
    EXPECT_DOUBLE_EQ(scene.stock.radiusAt(-60), 30);
    // From below it is the same part.
    scene.lift(2);
    scene.add(2, -150, -15, true);
    scene.add(2, -170, -15, false);
    EXPECT_DOUBLE_EQ(scene.stock.radiusAt(-10), 15);
    EXPECT_DOUBLE_EQ(scene.stock.radiusAt(-30), 20);
}

// A drill along the axis and a boring bar behind it leave the outside as it is.
TEST(CuttingScene, DrillsAndBoresAHole) {
    TurnedStock stock;
    stock.begin(60, 0, 100, 2);
    stock.cut(0, 31, 0, -0.5);  // faced
    EXPECT_DOUBLE_EQ(stock.radiusAt(1), 0);
    stock.cut(5, 0, -30, 0);
    EXPECT_DOUBLE_EQ(stock.radiusAt(-10), 30);
    EXPECT_DOUBLE_EQ(stock.boreAt(-10), 10);
    EXPECT_DOUBLE_EQ(stock.boreAt(-40), 0);
    stock.cut(2, 14, -20, 14);  // bored, then its ground faced
    stock.cut(-20, 14, -20, 5);
    EXPECT_DOUBLE_EQ(stock.radiusAt(-10), 30);
    EXPECT_DOUBLE_EQ(stock.boreAt(-10), 14);
    EXPECT_DOUBLE_EQ(stock.boreAt(-25), 10);
    stock.cut(2, 25, -15, 25);  // the outside is turned as before
    EXPECT_DOUBLE_EQ(stock.radiusAt(-10), 25);
    EXPECT_DOUBLE_EQ(stock.radiusAt(-18), 30);
    EXPECT_DOUBLE_EQ(stock.boreAt(-10), 14);
    stock.cut(-5, 26, -5, 12);  // faced into the hole
    EXPECT_DOUBLE_EQ(stock.radiusAt(-2), 0);
    EXPECT_DOUBLE_EQ(stock.radiusAt(-10), 25);
}

// A tube is turned from both sides, until the outside has come nearer to the hole than to where it
// was. Nobody says which tool it is: what it began with is what it goes on with.
TEST(CuttingScene, ATubeIsTurnedOutsideDownToAThinWall) {
    text::JobStock tube = bar(60, 100);
    tube.bore = 50;
    tube.face = 2;
    CuttingTool tool;
    tool.number = 1;
    const auto pass = [&](CuttingScene& scene, double radius) {
        scene.add(1, 5, radius, true, tool);
        scene.add(1, -30, radius, false, tool);
        scene.add(1, -30, 40, true, tool);
        scene.add(1, 5, 40, true, tool);
    };
    CuttingScene scene;
    scene.begin(tube, {0, 0, 1});
    for (const double radius : {29.0, 27.0, 25.5}) pass(scene, radius);
    EXPECT_DOUBLE_EQ(scene.stock.radiusAt(-10), 25.5);
    EXPECT_DOUBLE_EQ(scene.stock.boreAt(-10), 25);
    // A tool that says by its tip where it works is believed at its first cut.
    CuttingScene other;
    other.begin(tube, {0, 0, 1});
    tool.number = 2;
    tool.side = CutSide::Outside;
    pass(other, 26);
    EXPECT_DOUBLE_EQ(other.stock.radiusAt(-10), 26);
    EXPECT_DOUBLE_EQ(other.stock.boreAt(-10), 25);
    CuttingScene bored;
    bored.begin(tube, {0, 0, 1});
    tool.number = 3;
    tool.side = CutSide::Inside;
    pass(bored, 29);
    EXPECT_DOUBLE_EQ(bored.stock.radiusAt(-10), 30);
    EXPECT_DOUBLE_EQ(bored.stock.boreAt(-10), 29);
    // The same by guess, and then the outside by one that comes from there.
    CuttingScene both;
    both.begin(tube, {0, 0, 1});
    tool.number = 4;
    tool.side = CutSide::Unknown;
    for (const double radius : {26.0, 28.0, 29.0}) pass(both, radius);
    EXPECT_DOUBLE_EQ(both.stock.boreAt(-10), 29);
    EXPECT_DOUBLE_EQ(both.stock.radiusAt(-10), 30);
    tool.number = 5;
    both.add(1, -1, 40, true, tool);
    both.add(1, -1, 28, false, tool);
    EXPECT_LE(both.stock.radiusAt(-0.5), both.stock.boreAt(-0.5))
        << "faced from outside: nothing is left";
}

TEST(CuttingScene, ADrillMakesAHoleOfItsOwnDiameter) {
    TurnedStock stock;
    stock.begin(60, 0, 100, 2);
    CuttingTool drill;
    drill.hole = 4;
    stock.cut(5, 0, -30, 0, drill);
    EXPECT_DOUBLE_EQ(stock.boreAt(-10), 4);
    // a tool that leaves a faced centre along the axis drills nothing
    TurnedStock faced;
    faced.begin(60, 0, 100, 2);
    faced.cut(-1, 31, -1, 0);
    faced.cut(-1, 0, 5, 0);
    EXPECT_FALSE(faced.hollow());
}

TEST(CuttingTools, TheTipSaysTheSide) {
    for (const int tip : {3, 4, 8})
        EXPECT_EQ(sideOfTip(Dialect::Fanuc, tip), CutSide::Outside) << tip;
    for (const int tip : {1, 2, 6})
        EXPECT_EQ(sideOfTip(Dialect::Sinumerik, tip), CutSide::Inside) << tip;
    for (const int tip : {0, 5, 7, 9})
        EXPECT_EQ(sideOfTip(Dialect::Fanuc, tip), CutSide::Unknown) << tip;
    for (const int tip : {3, 4, 5})
        EXPECT_EQ(sideOfTip(Dialect::Fagor, tip), CutSide::Outside) << tip;
    for (const int tip : {1, 7, 8})
        EXPECT_EQ(sideOfTip(Dialect::Fagor, tip), CutSide::Inside) << tip;
}

// What is kept over a restart of the screens has both walls.
TEST(KeptPaths, HoldTheHoleToo) {
    CuttingScene scene;
    scene.begin(bar(60, 100), {0, 0, 1});
    CuttingTool drill;
    drill.hole = 6;
    drill.number = 2;
    scene.add(1, 5, 0, true, drill);
    scene.add(1, -40, 0, false, drill);
    KeptPaths kept;
    kept.machineRun = 7;
    kept.program = "O1.nc";
    kept.radii = scene.stock.radii();
    kept.holes = scene.stock.holes();
    const KeptPaths read = KeptPaths::read(kept.written());
    ASSERT_EQ(read.machineRun, 7u);
    CuttingScene again;
    again.begin(bar(60, 100), {0, 0, 1});
    again.stock.cutTo(read.radii, read.holes);
    EXPECT_DOUBLE_EQ(again.stock.boreAt(-20), 6);
    EXPECT_DOUBLE_EQ(again.stock.boreAt(-60), 0);
}

TEST(CuttingScene, AnArcGoesTheWayItIsProgrammed) {
    EXPECT_DOUBLE_EQ(arcTurn(M_PI / 2, false, false), M_PI / 2);
    EXPECT_DOUBLE_EQ(arcTurn(M_PI / 2, true, false), -1.5 * M_PI);
    EXPECT_DOUBLE_EQ(arcTurn(-M_PI / 2, false, false), 1.5 * M_PI);
    EXPECT_DOUBLE_EQ(arcTurn(0, true, true), -2 * M_PI);
    EXPECT_NEAR(arcTurn(-1e-9, false, false), 0, 1e-6);  // a short one whose end is rounded
}

// The job of a running program is looked for aside: what is cut meanwhile is cut when its blank is
// known.
TEST(CuttingScene, CutsWhatWasDrivenBeforeTheBlankWasKnown) {
    CuttingScene scene;
    scene.add(1, 110, 30, true);
    scene.add(1, 100, 20, true);
    scene.add(1, 80, 20, false);
    scene.lift(1);
    scene.add(1, 70, 5, false);  // it began here: nothing is cut on the way to it
    text::JobStock blank;
    blank.diameter = 60;
    blank.length = 50;
    blank.face = 0;
    blank.bore = 0;
    scene.begin(blank, {100, 0, 1});
    EXPECT_DOUBLE_EQ(scene.stock.radiusAt(-10), 30);
    scene.cutAgain(scene.trails);
    EXPECT_DOUBLE_EQ(scene.stock.radiusAt(-10), 20);
    EXPECT_DOUBLE_EQ(scene.stock.radiusAt(-25), 30);
    EXPECT_TRUE(scene.cut);
}

TEST(CuttingScene, KnowsAWorkpieceThatLooksTheOtherWay) {
    CuttingScene scene;
    scene.begin(bar(60, 100), {300, 0, -1});
    // room Z grows, the workpiece's falls
    scene.add(1, 300, 20, true);
    scene.add(1, 340, 20, false);
    EXPECT_DOUBLE_EQ(scene.stock.radiusAt(-20), 20);
    // in front of it, nothing is cut
    scene.add(1, 250, 0, true);
    scene.add(1, 250, -1, false);
    EXPECT_DOUBLE_EQ(scene.stock.radiusAt(-60), 30);
    // A cut across the axis behind the chuck takes nothing of the part away either.
    scene.lift(1);
    scene.add(1, 600, 5, true);
    scene.add(1, 600, 0, false);
    EXPECT_DOUBLE_EQ(scene.stock.radiusAt(-60), 30);
}

// G55 after G54, by a job's own zeros: the path goes on where it is in the machine, and the run has
// said where the first zero lies.
TEST(DryRunZeros, APathGoesOnInTheSystemThatItBeganIn) {
    QTemporaryDir folder;
    const auto write = [&](const char* name, const char* text) {
        QFile file(folder.filePath(name));
        ASSERT_TRUE(file.open(QIODevice::WriteOnly));
        file.write(text);
    };
    write("O1.nc", "O1\nG54 G98\nG0 X50. Z10.\nG55 G0 Z10.\nG1 Z5. F200.\nM30\n");
    write("two.job.toml",
          "name = \"two\"\n[programs]\n1 = { file = \"O1.nc\", language = \"fanuc\" }\n"
          "[zeros]\n1 = { G54 = { Z = -100.0 }, G55 = { Z = -300.0 } }\n");
    DryRun run;
    run.start(DryRun::How::Drive, {folder.filePath("two.job.toml")}, {});
    ASSERT_TRUE(waitFor([&] { return !run.running(); }));
    ASSERT_EQ(run.channels().count(1), 1u) << run.failure().toStdString();
    const RunChannel& channel = run.channels().at(1);
    ASSERT_EQ(channel.moves.size(), 3u);
    EXPECT_DOUBLE_EQ(channel.moves[0].z, 10);
    EXPECT_NEAR(channel.moves[1].z, 10 - 200, 1e-6);
    EXPECT_NEAR(channel.moves[2].z, 5 - 200, 1e-6);
    ASSERT_TRUE(channel.zero);
    EXPECT_NEAR(*channel.zero, -100, 1e-6);
}

// Colour is not the only signal: a path bears the name of its channel, not too often, and never
// twice at a place it passes again.
TEST(PathNames, StandAtEvenDistancesAndApartFromEachOther) {
    const QRectF room(0, 0, 1000, 500);
    PathNames names;
    for (int x = 0; x < 900; x += 3)
        names.goOn(QPointF(x, 100), QPointF(x + 3, 100), 200, 100, room);
    ASSERT_EQ(names.places().size(), 5u);
    for (std::size_t i = 1; i < 5; ++i)
        EXPECT_NEAR(names.places()[i].x() - names.places()[i - 1].x(), 200, 1e-6);
    // the next pass, in one piece, 30 pixels beside
    names.goOn(QPointF(900, 130), QPointF(0, 130), 200, 100, room);
    for (std::size_t i = 0; i < names.places().size(); ++i)
        for (std::size_t j = 0; j < i; ++j)
            EXPECT_GE(std::hypot(names.places()[i].x() - names.places()[j].x(),
                                 names.places()[i].y() - names.places()[j].y()),
                      100);
    names.goOn(QPointF(0, 130), QPointF(-5000, 130), 200, 100, room);
    for (const QPointF& place : names.places()) EXPECT_TRUE(room.contains(place));
    names.clear();
    names.goOn(QPointF(0, 0), QPointF(100, 0), 200, 100, room);
    EXPECT_EQ(names.places().size(), 1u) << "a short path has one too";
}

class GraphicsTasks : public Tasks {};

// Every box that protection publishes is in the picture, at the same place: both come from the same
// geometry.
TEST_F(GraphicsTasks, BodiesStandWhereProtectionHasThem) {
    Graphics& screen = screenOf<Graphics>();
    window->showScreen(6);
    ASSERT_TRUE(waitFor([&] { return screen.bodies().size() >= 4; }))
        << "two turrets and two chucks, guarded or not";
    for (const ShownBody& body : screen.bodies()) EXPECT_FALSE(body.guarded);
    ASSERT_TRUE(
        g_controller->run({"params", "set", "N1901 L1=20", "--instance", g_controller->name}));
    ASSERT_TRUE(
        g_controller->run({"params", "set", "N1902 L1=70", "--instance", g_controller->name}));
    ASSERT_TRUE(
        g_controller->run({"params", "set", "N1906 L1=-290", "--instance", g_controller->name}));
    ASSERT_TRUE(
        g_controller->run({"params", "set", "N2000 L1=15", "--instance", g_controller->name}));
    const auto status = std::make_unique<GuardStatus>();
    const bool published = waitFor([&] { return live().guard(*status) && status->count >= 3; });
    ASSERT_TRUE(published) << "protection is on";
    frames(*window, 200);
    ASSERT_TRUE(live().guard(*status));
    const auto shown = [&](const GuardBox& box) {
        for (const ShownBody& body : screen.bodies()) {
            // a carrier that is a point
            if (std::abs(body.at.x - box.x_low) < 0.01 && std::abs(body.at.z - box.z_low) < 0.01)
                return true;
            for (const auto& one : body.boxes)
                if (std::abs(one.x_low - box.x_low) < 0.01 &&
                    std::abs(one.x_high - box.x_high) < 0.01 &&
                    std::abs(one.z_low - box.z_low) < 0.01 &&
                    std::abs(one.z_high - box.z_high) < 0.01)
                    return true;
        }
        return false;
    };
    for (std::uint32_t i = 0; i < status->count; ++i)
        EXPECT_TRUE(shown(status->boxes[i]))
            << &status->names[status->boxes[i].body * 32] << " X " << status->boxes[i].x_low
            << " Z " << status->boxes[i].z_low;
    bool barrier = false, guarded = false;
    for (const ShownBody& body : screen.bodies()) {
        barrier |= body.barrier;
        guarded |= body.guarded && body.channel == 1;
    }
    EXPECT_TRUE(barrier);
    EXPECT_TRUE(guarded);
    for (const char* line : {"N2000 L1=0", "N1901 L1=0", "N1902 L1=0"})
        ASSERT_TRUE(g_controller->run({"params", "set", line, "--instance", g_controller->name}));
}

// The kernel is asked: an axis that it has stopped at its limit stands, in the picture, at the edge
// of its frame.
TEST_F(GraphicsTasks, TheTravelEndsWhereTheKernelStopsTheAxis) {
    Graphics& screen = screenOf<Graphics>();
    window->showScreen(6);
    const auto set = [&](const QString& line) {
        return g_controller->run({"params", "set", line, "--instance", g_controller->name});
    };
    const auto stroke = [&]() -> const ShownStroke* {
        for (const ShownStroke& one : screen.strokes())
            if (one.channel == 1) return &one;
        return nullptr;
    };
    const auto stood = [&] { return live().status().axes[1].cmd; };
    ASSERT_TRUE(waitFor([&] { return stroke() && std::isfinite(stroke()->allowed.zHigh); }));
    const double end = std::round(stood()) + 3;
    ASSERT_TRUE(set(QString("N1002 A2=%1").arg(end)));
    ASSERT_TRUE(g_controller->press("mode L1=jog"));
    for (int i = 0; i < 40 && live().nc(signals::an_otp(2)) == 0; ++i) {
        g_controller->press("jog A2+ 0.5s");
        QTest::qWait(300);
    }
    ASSERT_TRUE(waitFor([&] {
        return live().nc(signals::an_otp(2)) != 0 && !(live().status().axes[1].flags & kMoving);
    })) << stood();
    EXPECT_NEAR(stood(), end, 0.01);
    frames(*window, 200);
    const ShownBody* turret = nullptr;
    for (const ShownBody& body : screen.bodies())
        if (body.channel == 1) turret = &body;
    ASSERT_TRUE(turret && stroke());
    const double tip = turret->tipKnown ? turret->tip.z : turret->at.z;
    EXPECT_NEAR(
        std::min(std::abs(stroke()->allowed.zHigh - tip), std::abs(stroke()->allowed.zLow - tip)),
        0, 0.05)
        << tip;
    // A box that both axes must stay out of, as range 3 has it; open while one of them takes no
    // part that the tip is beyond.
    EXPECT_TRUE(stroke()->forbidden.empty());
    for (const char* line : {"N1008 A1=-20", "N1009 A1=-60", "N1008 A2=-200", "N1009 A2=-260",
                             "N1000 A1=00000101", "N1000 A2=00000101"})
        ASSERT_TRUE(set(line)) << line;
    ASSERT_TRUE(waitFor([&] { return stroke() && stroke()->forbidden.size() == 1; }));
    const auto& [range, box] = stroke()->forbidden.front();
    EXPECT_EQ(range, 3u);
    EXPECT_NEAR(box.xHigh - box.xLow, 40, 0.02);
    EXPECT_NEAR(box.zHigh - box.zLow, 60, 0.02);
    ASSERT_TRUE(g_controller->press("mode L1=auto"));
    for (const char* line : {"N1000 A1=00000001", "N1000 A2=00000001", "N1002 A2=800"})
        ASSERT_TRUE(set(line)) << line;
    ASSERT_TRUE(waitFor([&] { return stroke() && stroke()->forbidden.empty(); }));
}

// What is known of a tool is read from where it stands: the table of tools, its edge, the offset of
// the program.
TEST_F(GraphicsTasks, ADrillsDiameterIsThatOfItsData) {
    window->showScreen(6);
    const auto set = [&](const char* line) {
        return g_controller->run({"set", line, "--instance", g_controller->name});
    };
    ASSERT_TRUE(set("offset L1 9 geometry R=5.1"));
    ASSERT_TRUE(set("offset L1 9 geometry T=7"));
    ASSERT_TRUE(waitFor([&] { return live().store(1).offsets[9].geometry_r == 5.1; }));
    EXPECT_NEAR(cuttingTool(live(), 1, {9, 0, 9, 0}).hole, 5.1, 1e-5);
    EXPECT_EQ(cuttingTool(live(), 1, {9, 0, 9, 0}).side, CutSide::Unknown);
    ASSERT_TRUE(set("offset L1 9 geometry T=3"));  // a corner: the radius is that of the nose
    ASSERT_TRUE(waitFor([&] {
        return cuttingTool(live(), 1, {9, 0, 9, 0}).side == CutSide::Outside;
    }));
    EXPECT_EQ(cuttingTool(live(), 1, {9, 0, 9, 0}).hole, 0);
    for (const char* line : {"offset L1 9 geometry R=0", "offset L1 9 geometry T=0"})
        ASSERT_TRUE(set(line));
}

// The legend stands under the picture: the frames of travel end above it.
TEST_F(GraphicsTasks, TheLegendLiesOverNoFrame) {
    Graphics& screen = screenOf<Graphics>();
    window->showScreen(6);
    screen.turnTo(1);
    ASSERT_TRUE(waitFor([&] { return screen.frames().size() >= 2; }));
    for (const QSize size : {QSize(1024, 768), QSize(1280, 800), QSize(1920, 1080)}) {
        window->resize(size);
        frames(*window, 100);
        for (const QRectF& frame : screen.frames())
            EXPECT_LE(frame.bottom(), screen.legend().top()) << size.width();
        for (const QRectF& label : screen.labels())
            EXPECT_FALSE(label.intersects(screen.legend())) << size.width();
    }
    screen.turnTo(0);
}

TEST_F(GraphicsTasks, ADryRunIsPlayedBesideTheMachine) {
    startJob();
    Graphics& screen = screenOf<Graphics>();
    Operator hand(*window);
    window->showScreen(6);
    ASSERT_TRUE(waitFor([&] {
        return screen.scene().stock.any() && !screen.scene().trails.empty();
    })) << "the job names the blank";
    const double blank = screen.scene().stock.outer();
    hand.soft("Simulation");
    ASSERT_TRUE(waitFor([&] { return !screen.busy() && screen.dryTime() > 1; }));
    for (int i = 0; i < 4; ++i) hand.soft("Faster");
    ASSERT_TRUE(waitFor([&] {
        return screen.scene().trails.size() == 2 && screen.scene().trails.at(1).points.size() > 30;
    }));
    ASSERT_TRUE(waitFor([&] {
        for (double z = screen.scene().stock.left(); z < screen.scene().stock.right(); z += 1)
            if (screen.scene().stock.radiusAt(z) < blank - 0.5) return true;
        return false;
    })) << "the part is cut";
    EXPECT_TRUE(waitFor([&] {
        const auto& names = screen.pathNames();
        return names.contains(1) && names.contains(2) && !names.at(1).places().empty() &&
               !names.at(2).places().empty();
    })) << "paths have the names of their channels";
    // The turrets stand where their paths end.
    for (const ShownBody& body : screen.bodies())
        if (body.channel) {
            const auto& trail = screen.scene().trails.at(body.channel);
            EXPECT_TRUE(body.tipKnown);
            EXPECT_NEAR(body.tip.z, trail.points.back().z, 20.0);
        }
    for (Sheet* one : screen.sheets()) EXPECT_TRUE(one->shortened().empty());
    hand.soft("Simulation");
    EXPECT_GT(screen.scene().trails.size(), 0u) << "the machine's own paths are still there";
}

// What is asked to be painted again, over the picture of before, is what is painted anew: bodies,
// tips, labels and paths leave nothing behind.
TEST_F(GraphicsTasks, NoStalePixelIsLeftBehindWhatMoves) {
    Graphics& screen = screenOf<Graphics>();
    window->showScreen(6);
    ASSERT_TRUE(g_controller->press("reference all"));
    startJob();
    ASSERT_TRUE(
        waitFor([&] { return screen.bodies().size() >= 4 && !screen.scene().trails.empty(); }));
    struct Watch : QObject {
        QRegion asked;
        bool eventFilter(QObject*, QEvent* event) override {
            if (event->type() == QEvent::Paint) asked |= static_cast<QPaintEvent*>(event)->region();
            return false;
        }
    } watch;
    const auto picture = [&](QImage& into, const QRegion& region) {
        screen.render(&into, region.boundingRect().topLeft(), region, QWidget::RenderFlags());
    };
    for (const char* view : {"part", "machine"}) {
        screen.restore(view);
        window->frame();
        QCoreApplication::sendPostedEvents();
        QImage shown(screen.size(), QImage::Format_RGB32);
        shown.fill(Qt::black);
        picture(shown, screen.rect());
        screen.installEventFilter(&watch);
        int few = 0, changed = 0;
        for (int step = 0; step < 60; ++step) {
            watch.asked = {};
            ::usleep(40'000);
            // no other frame comes between this picture and that
            window->frame();
            QCoreApplication::sendPostedEvents();
            const QRegion asked = watch.asked;  // rendering is painting too
            QImage anew(screen.size(), QImage::Format_RGB32);
            anew.fill(Qt::black);
            picture(anew, screen.rect());
            changed += anew != shown;
            if (!asked.isEmpty()) picture(shown, asked);
            int area = 0;
            for (const QRect& one : asked) area += one.width() * one.height();
            few += area > 0 && area < screen.width() * screen.height() / 4;
            ASSERT_EQ(shown, anew) << view << ", step " << step;
        }
        screen.removeEventFilter(&watch);
        EXPECT_GT(changed, 20) << view << ": something moves";
        EXPECT_GT(few, 20) << view << ": and only that is painted";
    }
    g_controller->press("reset");
}

// Killed in the middle: nobody says goodbye. Another process shows the paths and the part as they
// were, and they go on.
TEST_F(GraphicsTasks, PathsAndPartAreThereAgainAfterACrash) {
    QTemporaryDir folder;
    Choices choices;
    choices.instance = g_controller->name.toStdString();
    choices.language = "en";
    choices.theme = "dark";
    choices.keptIn = folder.filePath("hmi.ini");
    const auto graphicsOf = [](MainWindow& of) {
        for (Screen* one : of.screens())
            if (auto* found = dynamic_cast<Graphics*>(one)) return found;
        return static_cast<Graphics*>(nullptr);
    };
    ASSERT_TRUE(g_controller->press("reference all"));
    window.reset();
    MainWindow killed(choices);
    killed.show();
    window = std::make_unique<MainWindow>(choices);  // only to be asked for the machine's state
    ASSERT_TRUE(waitFor([&] { return live().connected(); }));
    startJob();
    window.reset();
    KeptPaths kept;
    ASSERT_TRUE(waitFor([&] {
        QFile::remove(folder.filePath("again.ini.paths"));
        QFile::copy(choices.keptIn + ".paths", folder.filePath("again.ini.paths"));
        QFile file(folder.filePath("again.ini.paths"));
        if (file.open(QIODevice::ReadOnly)) kept = KeptPaths::read(qUncompress(file.readAll()));
        return kept.channels.count(1) && kept.channels.at(1).points.size() > 60;
    })) << graphicsOf(killed)->scene().trails.size();
    const std::deque<TrailPoint> was = kept.channels.at(1).points;
    double least = 1e9;
    for (const double radius : kept.radii) least = std::min(least, radius);
    QFile::copy(choices.keptIn, folder.filePath("again.ini"));
    choices.keptIn = folder.filePath("again.ini");
    MainWindow again(choices);
    again.show();
    const CuttingScene& restored = graphicsOf(again)->scene();
    ASSERT_TRUE(waitFor([&] {
        return restored.trails.count(1) && restored.trails.at(1).points.size() >= was.size();
    }));
    for (std::size_t i = 0; i < was.size(); ++i) {
        EXPECT_NEAR(restored.trails.at(1).points[i].z, was[i].z, 1e-3);
        EXPECT_NEAR(restored.trails.at(1).points[i].x, was[i].x, 1e-3);
    }
    ASSERT_TRUE(waitFor([&] { return restored.trails.at(1).points.size() > was.size(); }))
        << "it goes on";
    double now = restored.stock.outer();
    for (const double radius : restored.stock.radii()) now = std::min(now, radius);
    EXPECT_LE(now, least + 0.05) << "what was cut is cut";
    g_controller->press("reset");
}

TEST(KeptPaths, AreReadAsTheyWereWrittenOrNotAtAll) {
    KeptPaths kept;
    kept.machineRun = 0x123456789ABCDEFull;
    kept.program = "/jobs/Вал.nc";
    kept.radii = {30, 29.5, 0};
    kept.channels[2] = {7, 12.5, -150, true, {{-1.25, 20, true, true}, {-3, 18.5, false, false}}};
    const QByteArray bytes = kept.written();
    const KeptPaths read = KeptPaths::read(bytes);
    EXPECT_EQ(read.machineRun, kept.machineRun);
    EXPECT_EQ(read.program, kept.program);
    EXPECT_EQ(read.radii, kept.radii);
    ASSERT_EQ(read.channels.size(), 1u);
    const KeptPaths::Channel& one = read.channels.at(2);
    EXPECT_EQ(one.cycles, 7u);
    EXPECT_DOUBLE_EQ(one.cycle_s, 12.5);
    EXPECT_TRUE(one.zeroKnown);
    ASSERT_EQ(one.points.size(), 2u);
    EXPECT_TRUE(one.points[0].rapid && one.points[0].begins && !one.points[1].rapid &&
                !one.points[1].begins);
    EXPECT_DOUBLE_EQ(one.points[1].x, 18.5);
    for (qsizetype size = 0; size < bytes.size(); ++size)
        EXPECT_EQ(KeptPaths::read(bytes.left(size)).machineRun, 0u) << size;
    EXPECT_EQ(
        KeptPaths::read("something else that is long enough to be read as numbers").machineRun, 0u);
}

// The same screens again, from what the process had told: no second run.
TEST(DryRuns, AreShownAgainAfterARestart) {
    QTemporaryDir folder;
    Choices choices;
    choices.instance = "nobody-runs-this";
    choices.language = "en";
    choices.theme = "dark";
    choices.keptIn = folder.filePath("hmi.ini");
    const auto programsOf = [](MainWindow& of) {
        for (Screen* one : of.screens())
            if (auto* found = dynamic_cast<Programs*>(one)) return found;
        return static_cast<Programs*>(nullptr);
    };
    const auto written = [](Programs& screen) {
        QStringList out;
        for (Sheet* sheet : screen.sheets())
            for (const Item& item : sheet->items())
                out << QString("%1 %2 %3 %4 %5")
                           .arg(item.text)
                           .arg(item.box.x())
                           .arg(item.box.y())
                           .arg(item.box.width())
                           .arg(item.colour.name());
        return out;
    };
    for (const char* page : {"Simulation, timeline", "Check, waits"}) {
        QStringList was;
        {
            MainWindow window(choices);
            window.resize(1280, 800);
            window.show();
            window.showScreen(2);
            Operator hand(window);
            programsOf(window)->turnTo(0);
            programsOf(window)->filesPage().readFolder(
                QString(kSourceFolder) + "/examples/jobs/shaft", "shaft.job.toml");
            ASSERT_TRUE(waitFor([&] { return programsOf(window)->filesPage().isJob(); }));
            hand.soft(page);
            ASSERT_TRUE(waitFor(
                [&] {
                    return !programsOf(window)->busy() &&
                           programsOf(window)->dryRun().channels().size() == 2;
                },
                120))
                << page;
            frames(window, 600);
            was = written(*programsOf(window));
            ASSERT_GT(was.size(), 30);
            ASSERT_TRUE(waitFor([&] { return QFile::exists(choices.keptIn + ".run"); }))
                << "while it runs: a crash says nothing before it";
        }
        MainWindow again(choices);
        again.resize(1280, 800);
        again.show();
        EXPECT_EQ(again.screen(), programsOf(again)) << page;
        ASSERT_TRUE(waitFor([&] {
            return !programsOf(again)->busy() && programsOf(again)->dryRun().channels().size() == 2;
        })) << page;
        frames(again, 600);
        EXPECT_EQ(written(*programsOf(again)), was) << page;
        // the screens are made anew
        again.setDisplayLanguage(DisplayLanguage::Czech);
        EXPECT_TRUE(waitFor([&] { return programsOf(again)->dryRun().channels().size() == 2; }))
            << page;
        again.setDisplayLanguage(DisplayLanguage::English);
    }
}

}  // namespace
}  // namespace polyturn::hmi
