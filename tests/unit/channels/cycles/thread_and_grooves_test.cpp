// G73 to G76 and G70 in tables of moves worked out by hand.
#include <gtest/gtest.h>

#include "../compensation/lathe_program.hpp"

namespace polyturn::channels {
namespace {

using testing::Nose;
using testing::NoseRun;
using testing::run_lathe;

struct Row {
    double x, z;
};

void expect_moves(const NoseRun& run, const std::vector<Row>& rows) {
    ASSERT_EQ(run.played.errors, 0u) << run.played.events;
    ASSERT_EQ(run.points.size(), rows.size()) << run.played.events;
    for (std::size_t i = 0; i < rows.size(); ++i) {
        EXPECT_NEAR(run.points[i].x, rows[i].x, 1e-3) << i;
        EXPECT_NEAR(run.points[i].z, rows[i].z, 1e-3) << i;
    }
}

TEST(ThreadPasses, GoDownByTheRootAndNeverLessThanTheLeast) {
    // Height 1, first 0.5: depths 0.5, 0.5 * sqrt 2 = 0.7071; the next step would be 0.1589, so
    // 0.2; 0.95 (less the allowance), 1 at the end.
    const NoseRun run =
        run_lathe("G76 P010000 Q200 R0.05\nG76 X24. Z-20. P1000 Q500 F1.5", Nose{0.0, 0}, 30, 5);
    std::vector<Row> rows;
    for (const double depth : {0.5, 0.70711, 0.90711, 0.95, 1.0}) {
        const double x = 26 - 2 * depth;
        rows.insert(rows.end(), {{x, 5}, {x, -20}, {30, -20}, {30, 5}});
    }
    expect_moves(run, rows);
    EXPECT_NE(run.points[1].line.find("\"kind\":\"thread\""), std::string::npos);
    EXPECT_NE(run.points[1].line.find("\"lead\":1.5"), std::string::npos);
    EXPECT_NE(run.points[1].line.find("\"cycle\":\"G76\""), std::string::npos);
}

TEST(ThreadPasses, FollowTheFlankAndRunOutAtFortyFiveDegrees) {
    // One pass at the full height 1 with a 60 degree tool: start moves by tan 30 = 0.5774; run-out
    // 10 tenths of 1.5 mm.
    const NoseRun run =
        run_lathe("G76 P011060 Q100 R1.\nG76 X24. Z-20. P1000 Q500 F1.5", Nose{0.0, 0}, 30, 5);
    expect_moves(run, {{30, 4.42265}, {24, 4.42265}, {24, -18.5}, {27, -20}, {30, -20}, {30, 5}});
}

TEST(ThreadPasses, TakeTheirDataFromTheParametersWhenTheFirstBlockIsMissing) {
    const NoseRun run =
        run_lathe("G76 X24. Z-20. P1000 Q1000 F1.5", Nose{0.0, 0}, 30, 5,
                  {"N1606 L1=0", "N1608 L1=2", "N1609 L1=0.1", "N1610 L1=0", "N1612 L1=0"});
    std::vector<Row> rows;
    for (int k = 0; k < 3; ++k) rows.insert(rows.end(), {{24, 5}, {24, -20}, {30, -20}, {30, 5}});
    expect_moves(run, rows);
}

TEST(ThreadPasses, RefuseWhatWouldNotEndOrDriveThroughTheWork) {
    for (const char* blocks : {"G76 X24. Z-20. P1000 F1.5", "G76 X24. Z-20. Q1000 F1.5",
                               "G76 X24. Z-20. P4000 Q1000 F1.5", "G76 X24. Z5. P1000 Q1000 F1.5",
                               "G76 P010060 Q0 R0\nG76 X24. Z-20. P1000 Q1 F1.5"}) {
        SCOPED_TRACE(blocks);
        const NoseRun run = run_lathe(blocks, Nose{0.0, 0}, 30, 5);
        EXPECT_TRUE(run.alarm(62)) << run.played.events;
        EXPECT_TRUE(run.points.empty());
    }
}

TEST(Grooving, PecksAlongXInRowsAlongZ) {
    const NoseRun run =
        run_lathe("G75 R0.5\nG75 X55. Z-14. P2000 Q3000 F0.1", Nose{0.0, 0}, 62, -10);
    std::vector<Row> rows;
    for (const double z : {-10.0, -13.0, -14.0}) {
        if (z < -10) rows.push_back({62, z});
        rows.insert(rows.end(), {{58, z}, {59, z}, {55, z}, {62, z}});
    }
    rows.push_back({62, -10});
    expect_moves(run, rows);
}

TEST(Grooving, PecksAlongZWithReliefAtTheBottom) {
    const NoseRun run =
        run_lathe("G74 R0.5\nG74 X34. Z-3. P4000 Q3000 R0.2 F0.1", Nose{0.0, 0}, 42, 2);
    expect_moves(run, {{42, -1},
                       {42, -0.5},
                       {42, -3},
                       {42.4, -3},
                       {42.4, 2},
                       {34, 2},
                       {34, -1},
                       {34, -0.5},
                       {34, -3},
                       {34.4, -3},
                       {34.4, 2},
                       {42, 2}});
}

TEST(Grooving, TheOneBlockFormatHasItsOwnWords) {
    expect_moves(run_lathe("G75 X58. Z-10. I2. F0.1", Nose{0.0, 0}, 62, -10, {"F0001#1=1"}),
                 {{58, -10}, {62, -10}});
    EXPECT_TRUE(run_lathe("G75 X58. P2000 F0.1", Nose{0.0, 0}, 62, -10, {"F0001#1=1"}).alarm(9));
}

TEST(Pattern, DividesTheReliefAsTheControlDoes) {
    // Relief 2 in X (radius), 1 in Z; fanuc leaves all of it at the first pass and nothing at the
    // last.
    const NoseRun run = run_lathe(
        "G73 U2. W1. R2\nG73 P1 Q2 U0. W0. F0.2\nN1 G0 X20. Z0.\nN2 G1 Z-10.", Nose{0.0, 0}, 60, 5);
    expect_moves(run, {{64, 6},
                       {24, 1},
                       {24, -9},
                       {64, -9},
                       {64, 6},
                       {60, 5},
                       {20, 0},
                       {20, -10},
                       {60, -10},
                       {60, 5}});
}

TEST(Finishing, DrivesTheContourAndComesBack) {
    const NoseRun run = run_lathe("G70 P1 Q2\nG0 X80.\nM30\nN1 G0 X20.\nG1 Z-10. F0.1\nN2 X60.",
                                  Nose{0.0, 0}, 60, 5);
    expect_moves(run, {{20, 5}, {20, -10}, {60, -10}, {60, 5}, {80, 5}});
    EXPECT_NE(run.points[1].line.find("\"cycle\":\"G70\""), std::string::npos);
    EXPECT_EQ(run.points[4].line.find("\"cycle\""), std::string::npos);
}

TEST(InterruptMacro, IsNotPassedOnAsAPlainFunction) {
    EXPECT_TRUE(run_lathe("M96 P8000", Nose{}, 60, 5).played.has({"\"number\":78", "O8000"}));
    EXPECT_TRUE(run_lathe("M96", Nose{}, 60, 5).played.has({"\"number\":76"}));
    EXPECT_TRUE(run_lathe("M41", Nose{}, 60, 5, {"F6003#4=1", "F6033 L1=41", "F6034 L1=42"})
                    .played.has({"\"number\":76"}));
    EXPECT_EQ(
        run_lathe("M96", Nose{}, 60, 5, {"F6003#4=1", "F6033 L1=41", "F6034 L1=42"}).played.errors,
        0u);
}

}  // namespace
}  // namespace polyturn::channels
