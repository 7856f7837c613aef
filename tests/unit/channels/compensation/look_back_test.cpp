// N1404 (nct_parameters_part1 15.3): a hollow whose neck is narrower than the nose, though its
// inside is not.
//
//        Z20 ------- N20 ------> Z1.5 .   . Z-1.5 ------- N40 ----->       X40, the nose above it
//                                    (  N30  )                              a hole of radius 2.5
//                                                                           about X36 Z0, its neck
//                                                                           is 3 wide
#include <gtest/gtest.h>

#include "../play.hpp"

namespace polyturn::channels::testing {
namespace {

constexpr const char* kKeyhole =
    "G18 G40 G90 G95 G97 S800 M3 F0.2\nT0101\n"
    "N10 G42 G1 X40 Z20\nN20 Z1.5\nN30 G2 X40 Z-1.5 I-2 K-1.5\n"
    "N40 G1 Z-20\nN50 G40 X60\nM30\n";

Played run(double radius, const char* check, int blocks, const char* program = kKeyhole) {
    Play how;
    how.language = "nct";
    how.sets = {std::string("N1403=") + check, "N1404=" + std::to_string(blocks)};
    return play(program, how, [&](MachineView& view) {
        view.store->offsets[1].geometry_r = radius;
        view.start[static_cast<std::size_t>(view.axis_by_name("X"))] = 30;
        view.start[static_cast<std::size_t>(view.axis_by_name("Z"))] = 25;
    });
}

constexpr const char *kCorrects = "00000001", *const kAlarms = "00000011";

TEST(LookBack, ANoseThatPassesTheNeckIsLeftAlone) {
    for (const char* check : {kCorrects, kAlarms}) {
        const Played near = run(1.0, check, 0), far = run(1.0, check, 8);
        EXPECT_EQ(near.errors, 0u) << near.events;
        EXPECT_TRUE(near.has({"\"n\":30", "\"kind\":\"cw\""})) << near.events;
        EXPECT_EQ(near.events, far.events);
    }
}

TEST(LookBack, NeighboursAloneDoNotShowTheNarrowNeck) {
    const Played near = run(1.8, kAlarms, 0);
    EXPECT_EQ(near.errors, 0u) << near.events;
    EXPECT_TRUE(near.has({"\"n\":40"})) << near.events;
}

// N30 as it is driven crosses itself between the lips; N20 is driven to its end. Automatic
// correction does not help here.
TEST(LookBack, AlarmsBeforeTheBlockThatCannotBeDriven) {
    for (const char* check : {kCorrects, kAlarms}) {
        const Played far = run(1.8, check, 1);
        EXPECT_EQ(far.errors, 1u) << far.events;
        EXPECT_TRUE(far.has({"Interference error", "\"line\":5"})) << far.events;
        EXPECT_TRUE(far.has({"\"ev\":\"move\"", "\"n\":20"})) << far.events;
        EXPECT_FALSE(far.has({"\"ev\":\"move\"", "\"n\":30"})) << far.events;
    }
}

// Rounded lips, and a hollow of straight lines between them: the nose's path round one lip (N30)
// crosses the one round the other (N90), six blocks later. A nose of radius 1 fits through the neck
// of 3 mm.
constexpr const char* kUndercut =
    "G18 G40 G90 G95 G97 S800 M3 F0.2\nT0101\n"
    "N10 G42 G1 X40 Z20\nN20 Z2\nN30 G3 X39 Z1.5 I-.5 K0\n"
    "N40 G1 X30 Z6\nN50 X20\nN60 Z-6\nN70 X30\n"
    "N80 X39 Z-1.5\nN90 G3 X40 Z-2 I0 K-.5\nN100 G1 Z-20\n"
    "N110 G40 X60\nM30\n";

TEST(LookBack, SeesAsFarAsItIsTold) {
    EXPECT_EQ(run(1.0, kAlarms, 8, kUndercut).errors, 0u) << run(1.0, kAlarms, 8, kUndercut).events;
    EXPECT_EQ(run(1.8, kAlarms, 1, kUndercut).errors, 0u) << run(1.8, kAlarms, 1, kUndercut).events;
    const Played far = run(1.8, kAlarms, 8, kUndercut);
    EXPECT_EQ(far.errors, 1u) << far.events;
    EXPECT_TRUE(far.has({"Interference error"})) << far.events;
    EXPECT_FALSE(far.has({"\"ev\":\"move\"", "\"n\":50"})) << far.events;
}

// A contour that crosses itself as it is programmed is meant so.
TEST(LookBack, ACrossingThatIsProgrammedIsNoFault) {
    const char* loop =
        "G18 G40 G90 G95 G97 S800 M3 F0.2\nT0101\n"
        "N10 G42 G1 X40 Z20\nN20 Z-20\nN30 X80\nN40 Z0\n"
        "N50 X20\nN60 G40 X10\nM30\n";
    const Played far = run(1.0, kAlarms, 4, loop);
    EXPECT_EQ(far.errors, 0u) << far.events;
    EXPECT_EQ(far.events, run(1.0, kAlarms, 0, loop).events);
}

// Functions between held blocks keep their place; a drained one lets out what is before it.
TEST(LookBack, CallsKeepTheirPlace) {
    const char* calls =
        "G18 G40 G90 G95 G97 S800 M3 F0.2\nT0101\n"
        "N10 G42 G1 X40 Z20\nN20 Z10\nN25 M80\nN30 Z5\n"
        "#100=7\nN35 Z0\nN40 M0\nN50 Z-20\nN60 G40 X60\n"
        "M30\n";
    EXPECT_EQ(run(1.0, kAlarms, 8, calls).events, run(1.0, kAlarms, 0, calls).events);
}

}  // namespace
}  // namespace polyturn::channels::testing
