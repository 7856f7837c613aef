// What interrupts compensation, changes the nose, or reads it: figures by hand as in rules_test.cpp
// (r = 1, tip 0, corner at Z0 X40, reached along -Z with the nose above it, n1 = (0, 1)).
#include <gtest/gtest.h>

#include "lathe_program.hpp"

namespace polyturn::channels::testing {
namespace {

void expect_points(const NoseRun& run, const std::vector<Point>& points) {
    EXPECT_EQ(run.played.errors, 0u) << run.played.events;
    ASSERT_EQ(run.points.size(), points.size()) << run.played.events;
    for (std::size_t i = 0; i < points.size(); ++i) {
        EXPECT_NEAR(run.points[i].x, points[i].x, 1.01e-4) << "point " << i << "\n"
                                                           << run.played.events;
        EXPECT_NEAR(run.points[i].z, points[i].z, 1.01e-4) << "point " << i << "\n"
                                                           << run.played.events;
    }
}

constexpr const char* kBegin = "N10 G42 G0 Z20\nN20 G1 Z0\n";
NoseRun after_begin(const std::string& blocks, const Nose& nose = {},
                    std::vector<std::string> sets = {}) {
    return run_lathe(kBegin + blocks, nose, 40, 30, std::move(sets));
}

// N20 ends at its normal, G53 leaves the vector behind. N40 (down, d = (0,-1)) begins anew: inner
// before N50 (d = (-1, 0), right turn), P + n2 = (50, 21). As series 15 it ends at the intersection
// (-1, 1) of both: (49, 21).
TEST(NoseCompensation, IsLeftByG53) {
    const char* blocks = "N30 G53 X100 Z50\nN40 G1 X40\nN50 Z20\nN60 G40 G0 X60";
    expect_points(after_begin(blocks),
                  {{42, 20}, {42, 0}, {100, 50}, {42, 50}, {42, 20}, {60, 20}});
    expect_points(after_begin(blocks, {}, {"F5003=00000101"}),
                  {{42, 20}, {42, 0}, {100, 50}, {42, 49}, {42, 20}, {60, 20}});
}

// A word of C that moves nothing is a block without movement like any other: one of them changes
// nothing (3.12). U0 is the zero-distance kind: N20 ends at its normal.
TEST(NoseCompensation, TakesAWordOfAnotherAxisThatStaysForABlockWithoutMovement) {
    expect_points(after_begin("N30 C0\nN40 X60"), {{42, 20}, {42, 1}, {60, 1}});
    expect_points(after_begin("N30 H0\nN40 X60"), {{42, 20}, {42, 1}, {60, 1}});
    expect_points(after_begin("N30 U0\nN40 X60"), {{42, 20}, {42, 0}, {60, 1}});
    expect_points(after_begin("N30 C0 U0\nN40 X60"), {{42, 20}, {42, 0}, {60, 1}});
}

// To where the tool is programmed already: only the vector goes. N40 begins anew and ends the
// program at its normal (1, 30).
TEST(NoseCompensation, IsLeftByG53WithoutWay) {
    expect_points(after_begin("N30 G53 X40 Z0\nN40 G1 X60"), {{42, 20}, {42, 0}, {40, 0}, {60, 1}});
}

// G28 X60: the way to the intermediate point is a block of the contour, inner corner (1, 1), its
// end the normal (1, 30). The reference point of X is 0; Z is not named and gives its vector back
// too.
TEST(NoseCompensation, IsLeftAtTheReferencePoint) {
    expect_points(after_begin("N30 G28 X60\nN40 G40"), {{42, 20}, {42, 1}, {60, 1}, {0, 0}});
}

// G50: N20 ends without a vector, N40 (up, in the new system from Z50 X100 to X140) at the vector
// at its end, before N50 (d = (1, 0), right turn, inner): n1 + n2 = (1, -1): X138 Z51.
TEST(NoseCompensation, IsDroppedByACoordinateSetting) {
    expect_points(after_begin("N30 G50 X100 Z50\nN40 G1 X140\nN50 Z70\nN60 G40 G0 X100"),
                  {{42, 20}, {40, 0}, {138, 51}, {138, 70}, {100, 70}});
}

// r = -1: G41 runs right of the path, as G42 with r = 1, but the imaginary tip stays: tip 3 at (-1,
// -1) of the centre.
TEST(NoseCompensation, ChangesSidesWithANegativeRadius) {
    const char* blocks = "N10 G41 G0 Z20\nN20 G1 Z0\nN30 X60\nN40 G40 G0 Z20";
    expect_points(run_lathe(blocks, {-1.0, 0, 0}, 40, 30), {{42, 20}, {42, 1}, {60, 1}, {60, 20}});
    expect_points(run_lathe(blocks, {-1.0, 3, 0}, 40, 30), {{40, 19}, {40, 0}, {58, 0}, {60, 20}});
}

// Each tip: the axes end at centre + e. The centre goes (20, 21), (1, 21), (1, 30).
TEST(NoseCompensation, LeadsTheImaginaryTip) {
    // Z, X
    constexpr double kE[10][2] = {{0, 0}, {1, 1}, {-1, 1}, {-1, -1}, {1, -1},
                                  {1, 0}, {0, 1}, {-1, 0}, {0, -1},  {0, 0}};
    for (int tip = 0; tip <= 9; ++tip) {
        SCOPED_TRACE(tip);
        const double z = kE[tip][0], x = 2 * kE[tip][1];
        expect_points(after_begin("N30 X60\nN40 G40 G0 Z20", {1.0, tip, 0}),
                      {{42 + x, 20 + z}, {42 + x, 1 + z}, {60 + x, 1 + z}, {60, 20}});
    }
}

TEST(NoseCompensation, RefusesATipOutsideItsPlane) {
    const NoseRun run = run_lathe("G17\nN10 G42 G0 X50", {1.0, 3, 0}, 40, 30,
                                  {"N0002 A6=1", "N0100 A6=89", "N0103 A6=2"});
    EXPECT_TRUE(run.played.has({"\"alarm\"", "PT1306", "\"n\":10"})) << run.played.events;
}

// The vector at the end of a block is made with the radius that holds in it: N20 with 1, N30 and
// behind it with .5. Corner: 1*(n1 + n2) = (1, 1). N30 ends before N40 (right turn to d = (1, 0), n
// = (0, -1)): .5*(1, -1): X59 Z.5.
TEST(NoseCompensation, TakesAChangedRadiusFromTheNextCorner) {
    expect_points(after_begin("N30 T0102 X60\nN40 Z20\nN50 G40 G0 X40"),
                  {{42, 20}, {42, 1}, {59, .5}, {59, 20}, {40, 20}});
    expect_points(after_begin("N25 G10 P10001 R0.5\nN30 X60\nN40 Z20\nN50 G40 G0 X40"),
                  {{42, 20}, {42, 1}, {59, .5}, {59, 20}, {40, 20}});
}

TEST(NoseCompensation, WaitsForAnOffsetNumber) {
    expect_points(
        run_lathe("T0100\nN10 G42 G0 X50\nN20 Z20\nT0101\nN30 G1 Z0\nN40 X60\nN50 G40 G0 Z20", {},
                  40, 30),
        {{50, 30}, {50, 20}, {50, 1}, {60, 1}, {60, 20}});
}

// Where the axes are is known when they are there: the block before it ends at its normal, with a
// warning.
TEST(NoseCompensation, EndsTheHeldBlockBeforeALivePosition) {
    for (const char* reads :
         {"#100=#5041", "#100=#5021", "#100=#1000+#5041", "IF[#5042GT90]GOTO30"}) {
        SCOPED_TRACE(reads);
        const NoseRun run = after_begin(std::string(reads) + "\nN30 X60\nN40 G40 G0 Z20");
        EXPECT_TRUE(run.played.has({"PT1307", "\"severity\":\"warning\""}));
        expect_points(run, {{42, 20}, {42, 0}, {60, 1}, {60, 20}});
    }
}

// Inputs, clocks, the place of the last skip: read ahead as any macro statement is, and the corner
// stays (fanuc_lathe 6.13, 3.12).
TEST(NoseCompensation, ReadsInputsAheadOfTheCorner) {
    for (const char* reads : {"#100=#1000", "#100=#1032", "#100=#3001", "#100=#3011", "#100=#5061",
                              "IF[#1000EQ1]GOTO99", "#3001=0", "#100=#1000\n#101=#1001"}) {
        SCOPED_TRACE(reads);
        const NoseRun run = after_begin(std::string(reads) + "\nN30 X60\nN40 G40 G0 Z20");
        EXPECT_FALSE(run.played.has({"PT1307"})) << run.played.events;
        expect_points(run, {{42, 20}, {42, 1}, {60, 1}, {60, 20}});
    }
    expect_points(after_begin("N30 X[60+#1000]\nN40 G40 G0 Z20"),
                  {{42, 20}, {42, 1}, {60, 1}, {60, 20}});
}

// A wait, a stop and functions between two blocks leave the corner alone; the program goes on
// behind the stop.
TEST(NoseCompensation, ReadsOnOverAProgramStop) {
    const NoseRun run = after_begin("M0\nN30 X60\nM0\nN40 Z20\nN50 G40 G0 X40");
    expect_points(run, {{42, 20}, {42, 1}, {58, 1}, {58, 20}, {40, 20}});
    std::string order;
    for (const std::string& line : run.played.lines()) {
        if (line.find("\"move\"") != std::string::npos) order += 'm';
        if (line.find("\"M00\"") != std::string::npos) order += 's';
    }
    EXPECT_EQ(order, "mmsmsmm");
}

// The end of the program leaves the tool one vector away.
TEST(NoseCompensation, DeliversTheLastBlock) {
    expect_points(after_begin(""), {{42, 20}, {42, 0}});
    expect_points(after_begin("M99"), {{42, 20}, {42, 0}});
}

// Another error: the block before it has no known end and is not begun.
TEST(NoseCompensation, DoesNotBeginABlockBeforeAnError) {
    const NoseRun run = after_begin("N30 X60 Y1");
    EXPECT_EQ(run.played.errors, 1u);
    ASSERT_EQ(run.points.size(), 1u) << run.played.events;
}

// G90 straight: the imaginary tip runs on the legs, whatever came before; compensation begins again
// behind it.
TEST(NoseCompensation, LeavesStraightCycleLegsToTheTip) {
    const NoseRun run = after_begin("N30 G0 X60\nN40 G90 X30 Z-20 F.2\nN50 G0 X70", {1.0, 3, 0});
    // N30 inner corner: centre (1, 21), tip (0, 20); its end at the normal: centre (1, 30), tip (0,
    // 29). N50 begins anew and ends at its normal: centre (1, 35), tip (0, 34)
    expect_points(run,
                  {{40, 19}, {40, 0}, {58, 0}, {30, 0}, {30, -20}, {60, -20}, {60, 0}, {68, 0}});
}

// G90 with a cone: from X20 at Z0 to X30 at Z-20: along (-20, 5), n = (5, 20)/sqrt(425) =
// (.242536, .970143). Tip 3: shift = (1 + (-.242536 - .970143))/.970143 = -.219226 on the radius:
// X19.5615 and X29.5615.
TEST(NoseCompensation, ShiftsObliqueCycleLegs) {
    const NoseRun run = run_lathe("G42\nN40 G90 X30 Z-20 R-5 F.2", {1.0, 3, 0}, 60, 0);
    expect_points(run, {{19.561548, 0}, {29.561548, -20}, {60, -20}, {60, 0}});
}

}  // namespace
}  // namespace polyturn::channels::testing
