// Each rule of compensation as a program with the nose's way worked out by hand. r = 1, tip 0
// unless said, so that the points are those of the nose centre. Z, X (radius) in the derivations;
// expectations show X as a diameter.
//
// The corner of most rows: P at Z0 X40 (radius 20), reached along -Z, d1 = (-1, 0). With G42 the
// nose is on the right, n = (dX, -dZ), so n1 = (0, 1): above the line.
//     d2 = (0, 1)      right turn: inner, 270 degrees       n2 = (1, 0)
//     d2 = (0, -1)     left turn: outer, 90 degrees         n2 = (-1, 0)
//     d2 = (.6, -.8)   left turn: outer, acute 53 degrees   n2 = (-.8, -.6)
#include <gtest/gtest.h>

#include "lathe_program.hpp"

namespace polyturn::channels::testing {
namespace {

struct Row {
    const char* rule;
    const char* blocks;
    std::vector<Point> points;  // all of them
    std::vector<std::string> sets = {};
};

void expect_points(const Row& row, const Nose& nose = {}, double start_x = 40,
                   double start_z = 30) {
    SCOPED_TRACE(row.rule);
    const NoseRun run = run_lathe(row.blocks, nose, start_x, start_z, row.sets);
    EXPECT_EQ(run.played.errors, 0u) << run.played.events;
    ASSERT_EQ(run.points.size(), row.points.size()) << run.played.events;
    for (std::size_t i = 0; i < row.points.size(); ++i) {
        EXPECT_NEAR(run.points[i].x, row.points[i].x, 1.01e-4) << "point " << i << "\n"
                                                               << run.played.events;
        EXPECT_NEAR(run.points[i].z, row.points[i].z, 1.01e-4) << "point " << i << "\n"
                                                               << run.played.events;
        if (row.points[i].n >= 0) { EXPECT_EQ(run.points[i].n, row.points[i].n) << "point " << i; }
    }
}

// Start-up: the block before the corner begins compensation. What follows ends inner: G40 along a
// right turn.
const Row kStartUp[] = {
    // inner: P + r*n2 = (1, 20). N20 ends at (0,30) + n2 = (1, 30), G40 turns right (d = (1, 0)).
    {"inner",
     "N10 G42 G0 X40 Z0\nN20 G1 X60\nN30 G40 G0 Z20",
     {{40, 1, 10, ""}, {60, 1, 20, ""}, {60, 20, 30, ""}}},
    // outer 90: P + n1 = (0, 21), then on to the intersection (n1 + n2)/(1 + 0) = (-1, 1); both
    // belong to N10. N20 to X20: (-1, 10). G40 with d = (-1, 0): cross((0,-1), (-1,0)) = 0*0 -
    // (-1)(-1) = -1, right: inner.
    {"outer, obtuse",
     "N10 G42 G0 X40 Z0\nN20 G1 X20\nN30 G40 G0 Z-20",
     {{42, 0, 10, ""}, {42, -1, 10, ""}, {20, -1, 20, ""}, {20, -20, 30, ""}}},
    // type A: straight to P + n2
    {"outer, obtuse, type A",
     "N10 G42 G0 X40 Z0\nN20 G1 X20\nN30 G40 G0 Z-20",
     {{40, -1, 10, ""}, {20, -1, 20, ""}, {20, -20, 30, ""}},
     {"F5003#0=0"}},
    // acute: Q1 = n1 + d1 = (-1, 1), Q2 = n2 - d2 = (-1.4, .2), both at N20's feed. N20 ends at (6,
    // 12) + n2 = (5.2, 11.4). G40 with d = (0, -1): cross((.6,-.8), (0,-1)) = -.6, right: inner.
    {"outer, acute",
     "N10 G42 G0 X40 Z0\nN20 G1 X24 Z6\nN30 G40 G0 X10",
     {{42, 0, 10, ""},
      {42, -1, 20, ""},
      {40.4, -1.4, 20, ""},
      {22.8, 5.2, 20, ""},
      {10, 6, 30, ""}}},
    {"outer, acute, type A",
     "N10 G42 G0 X40 Z0\nN20 G1 X24 Z6\nN30 G40 G0 X10",
     {{38.8, -.8, 10, ""}, {22.8, 5.2, 20, ""}, {10, 6, 30, ""}},
     {"F5003#0=0"}},
    // straight back: one vector, P + n2 = (0, -1) of d2 = (1, 0)
    {"near reversal",
     "N10 G42 G0 X40 Z0\nN20 G1 Z10\nN30 G40 G0 X20",
     {{38, 0, 10, ""}, {38, 10, 20, ""}, {20, 10, 30, ""}}},
    // the block of G42 does not move: the next one begins
    {"G42 alone",
     "G0 X40 Z20\nG42\nN10 G1 Z0\nN20 X60\nN30 G40 G0 Z20",
     {{40, 20, -1, ""}, {40, 1, 10, ""}, {60, 1, 20, ""}, {60, 20, 30, ""}}},
};

TEST(NoseCompensation, BeginsByTheKindOfCorner) {
    for (const Row& row : kStartUp) expect_points(row);
}

// N10 begins with an inner corner at (20, 20): N20 runs along -Z above X20, so each row is about
// the corner P only.
//     start: (30, 10) to (20, 20): d = (-.7071, .7071); N20 d1 = (-1, 0): cross = .7071, left turn:
//     outer with G42.
// To keep the beginning out of the way it is driven from straight behind: tangential, P0 + n = (20,
// 21).
const Row kCorners[] = {
    // inner: (n1 + n2)/(1 + 0) = (1, 1)
    {"inner, lines",
     "N10 G42 G0 Z20\nN20 G1 Z0\nN30 X60\nN40 G40 G0 Z20",
     {{42, 20, 10, ""}, {42, 1, 20, ""}, {60, 1, 30, ""}, {60, 20, 40, ""}}},
    {"outer 90, lines",
     "N10 G42 G0 Z20\nN20 G1 Z0\nN30 X20\nN40 G40 G0 Z-20",
     {{42, 20, 10, ""}, {42, -1, 20, ""}, {20, -1, 30, ""}, {20, -20, 40, ""}}},
    {"acute, lines",
     "N10 G42 G0 Z20\nN20 G1 Z0\nN30 X24 Z6\nN40 G40 G0 X10",
     {{42, 20, 10, ""},
      {42, -1, 20, ""},
      {40.4, -1.4, 30, ""},
      {22.8, 5.2, 30, ""},
      {10, 6, 40, ""}}},
    // inner, line and arc: G2 from P upwards turns right about (5, 20), R5; the nose runs on 5 - 1
    // = 4 about it. Line X21 meets it at (Z-5)^2 + 1 = 16: Z = 5 - sqrt(15) = 1.127017. End (5, 25)
    // + n, n = (0,-1): (5, 24); tangential to N40.
    {"inner, line to arc",
     "N10 G42 G0 Z20\nN20 G1 Z0\nN30 G2 X50 Z5 R5\nN40 G1 Z15\nN50 G40 G0 X10",
     {{42, 20, 10, ""},
      {42, 1.127017, 20, ""},
      {48, 5, 30, ""},
      {48, 15, 40, ""},
      {10, 15, 50, ""}}},
    // outer 90, line and arc: G3 from P downwards turns left about (5, 20) [right of (0,-1) is -Z,
    // left +Z], R5: nose on the outside, 6. Line X21: (Z-5)^2 = 35, the nearest is Z = 5 - 5.916080
    // = -.916080. End (5, 15), n = (0, -1): (5, 14). N50: d = (0,-1) is a right turn from (1, 0):
    // inner.
    {"outer 90, line to arc",
     "N10 G42 G0 Z20\nN20 G1 Z0\nN30 G3 X30 Z5 R5\nN40 G1 Z15\nN50 G40 G0 X10",
     {{42, 20, 10, ""},
      {42, -.916080, 20, ""},
      {28, 5, 30, ""},
      {28, 15, 40, ""},
      {10, 15, 50, ""}}},
    // acute, line and arc: the arc begins along d2 = (.6, -.8) and turns left: centre P + 5*(.8,
    // .6) = (4, 23). It ends at (4, 18) with d = (1, 0), n = (0, -1). Q1 = (-1, 21), Q2 = (-1.4,
    // 20.2), P + n2 = (-.8, 19.4).
    {"acute, line to arc",
     "N10 G42 G0 Z20\nN20 G1 Z0\nN30 G3 X36 Z4 R5\nN40 G1 Z15\nN50 G40 G0 X10",
     {{42, 20, 10, ""},
      {42, -1, 20, ""},
      {40.4, -1.4, 30, ""},
      {38.8, -.8, 30, ""},
      {34, 4, 30, ""},
      {34, 15, 40, ""},
      {10, 15, 50, ""}}},
    // acute, arc and line, the same mirrored in time: N30 G3 about (4, 23) ends at P' = (4+4, 20) =
    // (8, 20) going up, d = (.6, .8), n1 = (.8, -.6). N40 goes back along -Z: cross((.6,.8),(-1,0))
    // = .8 left, outer; n2 = (0, 1). arc ends P' + n1 = (8.8, 19.4); Q1 = n1 + d1 = (1.4, .2); Q2 =
    // n2 - d2 = (1, 1). Begin: along +Z below X18, n = (0, -1).
    {"acute, arc to line",
     "G0 X36 Z-30\nN10 G42 Z-10\nN20 G1 Z4\nN30 G3 X40 Z8 R5\nN40 G1 Z-10\nN50 G40 G0 X60",
     {{36, -30, -1, ""},
      {34, -10, 10, ""},
      {34, 4, 20, ""},
      {38.8, 8.8, 30, ""},
      {40.4, 9.4, 40, ""},
      {42, 9, 40, ""},
      {42, -10, 40, ""},
      {60, -10, 50, ""}}},
    // fanuc_lathe 3.8: the end (7, 25) is not on the arc about (5, 20), R5: the circle through it,
    // R sqrt(29), counts there, and no alarm comes. N30 ends on it, 1 inside, and on X24: Z = 5 +
    // sqrt((sqrt(29) - 1)^2 - 16) = 6.797128. N20 ends as at an arc without fault.
    {"an arc that ends beside itself",
     "N10 G42 G0 Z20\nN20 G1 Z0\nN30 G2 X50 Z7 K5\nN40 G1 Z15\nN50 G40 G0 X10",
     {{42, 20, 10, ""},
      {42, 1.127017, 20, ""},
      {48, 6.797128, 30, ""},
      {48, 15, 40, ""},
      {10, 15, 50, ""}}},
    // side change: old side X21, new side left of (0, 1): n = (-1, 0), Z-1. N30 ends with its own
    // left normal. G40 along -Z: cross((0,1),(-1,0)) = 1, left turn, nose left: inner.
    {"side change",
     "N10 G42 G0 Z20\nN20 G1 Z0\nN30 G41 X60\nN40 G40 G0 Z-20",
     {{42, 20, 10, ""}, {42, -1, 20, ""}, {60, -1, 30, ""}, {60, -20, 40, ""}}},
    // straight on there is no intersection: normal of the new block, n = (0, -1)
    {"side change, straight on",
     "N10 G42 G0 Z20\nN20 G1 Z0\nN30 G41 Z-10\nN40 G40 G0 X20",
     {{42, 20, 10, ""}, {38, 0, 20, ""}, {38, -10, 30, ""}, {20, -10, 40, ""}}},
    // G42 again: N20 ends at its normal although the corner is inner
    {"the same side again",
     "N10 G42 G0 Z20\nN20 G1 Z0\nN30 G42 X60\nN40 G40 G0 Z20",
     {{42, 20, 10, ""}, {42, 0, 20, ""}, {60, 1, 30, ""}, {60, 20, 40, ""}}},
};

TEST(NoseCompensation, GoesRoundCornersByTheirKind) {
    for (const Row& row : kCorners) expect_points(row);
}

const Row kCancel[] = {
    {"inner",
     "N10 G42 G0 Z20\nN20 G1 Z0\nN30 G40 G0 X60",
     {{42, 20, 10, ""}, {42, 0, 20, ""}, {60, 0, 30, ""}}},
    // outer 90: intersection (-1, 1), P + n2 = (-1, 0), end
    {"outer, obtuse",
     "N10 G42 G0 Z20\nN20 G1 Z0\nN30 G40 G0 X20",
     {{42, 20, 10, ""}, {42, -1, 20, ""}, {40, -1, 30, ""}, {20, 0, 30, ""}}},
    {"outer, type A",
     "N10 G42 G0 Z20\nN20 G1 Z0\nN30 G40 G0 X20",
     {{42, 20, 10, ""}, {42, 0, 20, ""}, {20, 0, 30, ""}},
     {"F5003#0=0"}},
    {"outer, acute",
     "N10 G42 G0 Z20\nN20 G1 Z0\nN30 G40 G0 X24 Z6",
     {{42, 20, 10, ""},
      {42, -1, 20, ""},
      {40.4, -1.4, 30, ""},
      {38.8, -.8, 30, ""},
      {24, 6, 30, ""}}},
    {"near reversal",
     "N10 G42 G0 Z20\nN20 G1 Z0\nN30 G40 G0 Z20",
     {{42, 20, 10, ""}, {42, 0, 20, ""}, {40, 20, 30, ""}}},
    // no movement: normal there, taken back by the next block
    {"G40 alone",
     "N10 G42 G0 Z20\nN20 G1 Z0\nN30 G40\nN40 X60",
     {{42, 20, 10, ""}, {42, 0, 20, ""}, {60, 0, 40, ""}}},
    {"G40 alone with I, K",
     "N10 G42 G0 Z20\nN20 G1 Z0\nN30 G40 I5 K0\nN40 X60",
     {{42, 20, 10, ""}, {42, 0, 20, ""}, {60, 0, 40, ""}}},
    {"I, K where nothing is left to end",
     "N10 G1 Z20\nN20 G40 I5 K3\nN30 X60",
     {{40, 20, 10, ""}, {60, 20, 30, ""}}},
    // G40 I K: the contour would go on along (K, I) = (0, 5): as inner corner, (1, 1)
    {"with I, inner",
     "N10 G42 G0 Z20\nN20 G1 Z0\nN30 G40 G0 X60 Z20 I5",
     {{42, 20, 10, ""}, {42, 1, 20, ""}, {60, 20, 30, ""}}},
    // along (0, -5) it is outer: still the intersection, (-1, 1), then straight away
    {"with I, outer",
     "N10 G42 G0 Z20\nN20 G1 Z0\nN30 G40 G0 X60 Z20 I-5",
     {{42, 20, 10, ""}, {42, -1, 20, ""}, {60, 20, 30, ""}}},
    {"with K, parallel",
     "N10 G42 G0 Z20\nN20 G1 Z0\nN30 G40 G0 X60 Z20 K-5",
     {{42, 20, 10, ""}, {42, 0, 20, ""}, {60, 20, 30, ""}}},
};

TEST(NoseCompensation, EndsByTheKindOfCorner) {
    for (const Row& row : kCancel) expect_points(row);
}

// Inner corner (1, 1) when the block is ignored, normal (0, 1) when the corner is cut at the end of
// N20.
TEST(NoseCompensation, CountsBlocksWithoutMovement) {
    struct {
        const char* between;
        bool normal;
    } const rows[] = {
        {"M8", false},
        {"G4 X1.", false},
        {"S900", false},
        {"G99", false},
        {"G10 P3 R0.4", false},
        {"C5.", false},
        {"M0", false},
        {"#100=1", false},
        {"#100=1\nIF[#100EQ2]GOTO9\n#101=2", false},
        {"N99", false},
        {"U0", true},
        {"M8\nG4 X1.", true},
        {"G99\nS900", true},
        {"M8\n#100=1\nM9", true},
        {"C5.\nC6.", true},
    };
    for (const auto& row : rows) {
        const NoseRun run = run_lathe(
            std::string("N10 G42 G0 Z20\nN20 G1 Z0\n") + row.between + "\nN30 X60\nN40 G40 G0 Z20",
            {}, 40, 30);
        SCOPED_TRACE(row.between);
        EXPECT_EQ(run.played.errors, 0u) << run.played.events;
        ASSERT_GE(run.points.size(), 4u) << run.played.events;
        EXPECT_NEAR(run.points[1].x, 42, 1e-6);
        EXPECT_NEAR(run.points[1].z, row.normal ? 0 : 1, 1e-6) << run.played.events;
    }
}

// What stands between two blocks happens at the corner, in order, and a stop holds back what
// follows.
TEST(NoseCompensation, KeepsTheOrderOfFunctions) {
    const NoseRun run = run_lathe(
        "N10 G42 G0 Z20\nN20 G1 Z0\nN25 M8\nN30 X60\nN32 M0\nN40 Z30\nN50 G40 G0 X40", {}, 40, 30);
    std::string order;
    for (const std::string& line : run.played.lines()) {
        const double n = value_after(line, "\"n\":");
        if (n > 0) order += std::to_string(static_cast<int>(n)) + " ";
    }
    EXPECT_EQ(order, "10 20 25 30 32 40 50 ");
    EXPECT_EQ(run.played.errors, 0u) << run.played.events;
}

// Q1 and Q2 of a corner of 89 degrees are 0.0173 apart on each axis: with 5010 = 0.05 the second is
// left out.
TEST(NoseCompensation, LeavesOutSmallCornerVectors) {
    const char* blocks = "N10 G42 G0 Z20\nN20 G1 Z0\nN30 X10 Z.262\nN40 G40 G0 Z-20";
    EXPECT_EQ(run_lathe(blocks, {}, 40, 30).points.size(), 5u);
    EXPECT_EQ(run_lathe(blocks, {}, 40, 30, {"F5010=0.05"}).points.size(), 4u);
}

// The first end vector would turn N30 round, the second does not: straight there, no alarm.
//     d1 = (-.7071, -.7071), d2 = (0, 1): inner, V = (1, 1 + sqrt 2). N30 is 1.2 long, d3 = (-.866,
//     -.5): acute.
//     V5 = n2 + d2 = (1, 1): 1.2 + 1 - 2.4142 < 0 interferes.  V6 = n3 - d3 = (-.5 + .8660, .8660 +
//     .5) = (.3660, 1.3660)
//     1.2 + 1.3660 - 2.4142 > 0. N30 runs from (1, 22.4142) to (.3660, 22.5660).
TEST(NoseCompensation, LeavesOutVectorsThatInterfere) {
    const NoseRun run = run_lathe(
        "N10 G42 G0 X60 Z10\nN20 G1 X40 Z0\nN30 X42.4\nN40 X22.4 Z-17.3205\nN50 G40 G0 Z-40", {},
        80, 20);
    EXPECT_EQ(run.played.errors, 0u) << run.played.events;
    ASSERT_GE(run.points.size(), 4u) << run.played.events;
    EXPECT_NEAR(run.points[1].x, 44.8284, 2e-4);
    EXPECT_NEAR(run.points[1].z, 1, 2e-4);
    EXPECT_EQ(run.points[2].n, 30);
    EXPECT_NEAR(run.points[2].x, 45.1320, 2e-4);
    EXPECT_NEAR(run.points[2].z, .3660, 2e-4);
    EXPECT_EQ(run.points[3].n, 40);
}

// Type B at corners that programs with three or four decimals have nearly tangential: the vectors
// of one corner are millionths of a millimetre apart, and F5010 is 0. What lies between them is
// less than a programmed point can be off: no move of its own.
TEST(NoseCompensation, ANearlyTangentialCornerMakesNoMovesOfMillionths) {
    for (const char* side : {"G41", "G42"}) {
        SCOPED_TRACE(side);
        const bool right = std::string(side) == "G42";
        // Towards the contour and away from it on its outer side: 0.0001 mm in 10 and in 20.
        const std::string x = right ? "49.9998" : "50.0002";
        const NoseRun run = run_lathe(std::string("N10 G0 X") + x + " Z10\nN20 " + side +
                                          " G1 X50 Z0\nN30 Z-20\nN40 G40 X" + x + " Z-40",
                                      {0.8, 0}, 60, 20);
        ASSERT_EQ(run.points.size(), 4u) << run.played.events;
        const double out = right ? 1.6 : -1.6;  // diameter
        const double wanted[][2] = {{right ? 49.9998 : 50.0002, 10},
                                    {50 + out, 0},
                                    {50 + out, -20},
                                    {right ? 49.9998 : 50.0002, -40}};
        for (std::size_t n = 0; n < 4; ++n) {
            EXPECT_NEAR(run.points[n].x, wanted[n][0], 1e-3) << n;
            EXPECT_NEAR(run.points[n].z, wanted[n][1], 1e-3) << n;
        }
    }
}

// A move that can be programmed stays one: at 0.05 degrees the vectors are a micrometre apart.
TEST(NoseCompensation, ACornerOfAMicrometreStays) {
    // atan(0.15/10), r tan(a/2) = 0.006
    const NoseRun run =
        run_lathe("N10 G0 X49.7 Z10\nN20 G42 G1 X50 Z0\nN30 Z-20\nN40 G40 X60", {0.8, 0}, 60, 20);
    EXPECT_EQ(run.points.size(), 5u) << run.played.events;
    const NoseRun dropped = run_lathe("N10 G0 X49.7 Z10\nN20 G42 G1 X50 Z0\nN30 Z-20\nN40 G40 X60",
                                      {0.8, 0}, 60, 20, {"F5010=0.01"});
    EXPECT_EQ(dropped.points.size(), 4u) << dropped.played.events;
}

// G42 before G70: the contour's last block ends at its normal, the way back to where G70 was called
// is straight and plain. As an inner corner of the contour it would turn N20 round (alarm 041).
//     N5 to N10 is an outer corner of 90 degrees: (2, 31), then (1, 31).  N10 to N12 inner: (1,
//     21).  N12 to N14 inner: (-19, 21).
//     N14 to N20 outer: (-19, 26).  N20 ends at (-30, 25) + (0, 1).
TEST(NoseCompensation, LeavesTheContourOfG70AtItsNormal) {
    expect_points({"G70",
                   "N5 G42 G0 X60 Z2\nN6 G70 P10 Q20\nN30 G40 G0 X80 Z10\n"
                   "M30\nN10 G0 X40\nN12 G1 Z-20\nN14 X50\nN20 Z-30",
                   {{62, 2, 5, ""},
                    {62, 1, 5, ""},
                    {42, 1, 10, ""},
                    {42, -19, 12, ""},
                    {52, -19, 14, ""},
                    {52, -30, 20, ""},
                    {60, 2, 20, ""},
                    {80, 10, 30, ""}}},
                  {}, 60, 20);
}

struct AlarmRow {
    const char* why;
    const char* blocks;
    int alarm;
    long n;                 // block of the alarm
    std::size_t moves;      // delivered before it
    double last_x, last_z;  // where the tool rests
};
const AlarmRow kAlarms[] = {
    {"begins with an arc", "N5 G0 X50\nN10 G42 G2 X60 Z20 R10", 34, 10, 1, 50, 30},
    {"ends with an arc: the block before it ends at its normal",
     "N10 G42 G0 Z20\nN20 G1 Z0\nN30 G40 G2 X50 Z5 R5", 34, 30, 2, 42, 0},
    {"plane changed: likewise", "N10 G42 G0 Z20\nN20 G1 Z0\nN30 G17 X50", 37, 30, 2, 42, 0},
    {"arc about its start", "N10 G42 G0 Z20\nN20 G1 Z0\nN30 G2 X50 Z5 I0 K0", 38, 30, 2, 42, 0},
    // G2 R1.5 up from P: nose on a circle of .5, one below the line X21: no intersection, N20 has
    // no end
    {"no intersection: the block that has no end is not begun",
     "N10 G42 G0 Z20\nN20 G1 Z0\nN30 G2 X43 Z1.5 R1.5\nN40 G1 Z9", 33, 20, 1, 42, 20},
    // tangential: along -Z to (0,20), G2 turns up about (0, 20.5), R.5, inside it does not take r =
    // 1
    {"inside arc smaller than the nose",
     "N10 G42 G0 Z20\nN20 G1 Z0\nN30 G2 X41 Z-.5 R.5\nN40 G1 X60\nN50 G40 G0 Z20", 41, 30, 2, 42,
     0},
    // groove of 1.5, r = 1: its bottom is run backwards
    {"groove narrower than the nose",
     "N10 G42 G0 Z20\nN20 G1 Z0\nN30 X30\nN40 Z-1.5\nN50 X40\nN60 Z-20\nN70 G40 G0 X60", 41, 40,
     -1u, 0, 0},
};

TEST(NoseCompensation, StopsWhereItMust) {
    for (const AlarmRow& row : kAlarms) {
        SCOPED_TRACE(row.why);
        const NoseRun run = run_lathe(row.blocks, {}, 40, 30);
        EXPECT_EQ(run.played.errors, 1u) << run.played.events;
        EXPECT_TRUE(run.alarm(row.alarm)) << run.played.events;
        EXPECT_TRUE(run.played.has({"\"alarm\"", "\"n\":" + std::to_string(row.n)}))
            << run.played.events;
        if (row.moves == -1u) continue;
        ASSERT_EQ(run.points.size(), row.moves) << run.played.events;
        EXPECT_NEAR(run.points.back().x, row.last_x, 1e-4) << run.played.events;
        EXPECT_NEAR(run.points.back().z, row.last_z, 1e-4) << run.played.events;
    }
}

}  // namespace
}  // namespace polyturn::channels::testing
