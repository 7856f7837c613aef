// Details of words and calls that the specification asks for: short control words, ROUND in an
// address, whole codes, calls by name, counts of calls, offset variables in inches, threads that
// are picked up again, lengths that turn with the workpiece.
#include <gtest/gtest.h>

#include <filesystem>
#include <fstream>

#include "../play.hpp"
#include "../quiet_sink.hpp"

namespace polyturn::channels::testing {
namespace {

TEST(MacroWords, MayBeCutDownToTwoLetters) {  // fanuc_lathe 6.4
    const Played played = play(
        "#100=0\nWH[#100 LT 3]DO1\n#100=#100+1\nEN1\n"
        "IF[#100 EQ 3]TH #101=7\nGO 5\n#102=1\nN5 #103=12 AN 10\n"
        "PO\nDP[X#100[2]]\nPC\nM30\n");
    EXPECT_EQ(played.errors, 0u) << played.events;
    EXPECT_TRUE(played.has({R"("name":"#101","value":7)"}));
    EXPECT_TRUE(played.has({R"("name":"#103","value":8)"}));
    EXPECT_FALSE(played.has({R"("name":"#102")"}));
    EXPECT_EQ(play("W[1 EQ 1]DO1\nM30\n").errors, 1u);  // one letter is none
    EXPECT_EQ(play("WHEN[1 EQ 1]DO1\nM30\n").errors, 1u);
}

TEST(MacroRound, KeepsTheIncrementOfAnAddress) {  // fanuc_lathe 6.4
    const Played played = play(
        "#1=10.12349\nG0 X[ROUND[#1]]\n#100=#5001\n"
        "#101=ROUND[#1]\n#2=0.4\n#3=3.4\nG#2 X20. M#3\n"
        "#102=#4001\nM30\n");
    EXPECT_EQ(played.errors, 0u) << played.events;
    EXPECT_TRUE(played.has({R"("name":"#100","value":10.123)"})) << played.events;
    EXPECT_TRUE(played.has({R"("name":"#101","value":10})"}));
    EXPECT_TRUE(played.has({R"("name":"#102","value":0})"}));
    EXPECT_TRUE(played.has({R"("code":"M3")"}));  // whole codes (fanuc_lathe 6.1)
}

TEST(MacroCalls, CountToNineThousand) {  // fanuc_lathe 6.9.2
    EXPECT_TRUE(play("G65 P1 L10000\nM30\n").has({R"("number":3)"}));
    EXPECT_TRUE(play("M98 P1 L10000\nM30\n").has({R"("number":3)"}));
    // from 1 on
    for (const char* none : {"G65 P1 L0\nM30\n", "M98 P1 L0\nM30\n"})
        EXPECT_TRUE(play(none).has({R"("number":"PT1508")", R"("column":8)"})) << play(none).events;
}

// nct part 2 18.2: G66.1 calls for every block; what stops or waits, and what calls a subprogram
// itself, does so there as well.
TEST(MacroCalls, OfG661LeaveStopsWaitsAndSubprogramsAlone) {
    Play how;
    how.sets = {"F6071=56"};
    const std::string macro = "O8001\n#500=#500+1\n#501=#13\nM99\n";
    const auto between = [&](const char* block) {
        return "#500=0\nG66.1 P8001\n" + std::string(block) + "\nG67\nM30\n" + macro +
               "O9001\n#502=1\nM99\n";
    };
    const Played stop = play(between("M0"), how);
    EXPECT_TRUE(stop.has({R"("ev":"stop")", R"("line":3,)", R"("reason":"M00")"})) << stop.events;
    EXPECT_TRUE(stop.has({R"("name":"#500","value":1)"})) << stop.events;
    EXPECT_TRUE(stop.has({R"("name":"#501","value":0)"})) << stop.events;
    EXPECT_TRUE(stop.has({R"("reason":"M30")"})) << stop.events;
    const Played wait = play(between("M510 P12"), how);
    EXPECT_TRUE(wait.has({R"("ev":"wait")", R"("code":510,"channels":[1,2])"})) << wait.events;
    EXPECT_TRUE(wait.has({R"("name":"#501","value":510)"})) << wait.events;
    const Played function = play(between("M8"), how);  // an argument only
    EXPECT_FALSE(function.has({R"("code":"M8")"})) << function.events;
    EXPECT_TRUE(function.has({R"("name":"#501","value":8)"})) << function.events;
    for (const char* call : {"M56", "M98 P9001"}) {
        const Played sub = play(between(call), how);
        EXPECT_EQ(sub.errors, 0u) << sub.events;
        EXPECT_TRUE(sub.has({R"("name":"#502","value":1)"})) << sub.events;
        // the macro is not called as well
        EXPECT_FALSE(sub.has({R"("name":"#501")"})) << sub.events;
    }
    const Played both = play(between("M0 X50."), how);
    EXPECT_TRUE(both.has({R"("number":"PT1040")", R"("column":4)"})) << both.events;
}

// fanuc_lathe 6.2, 6.9.1: the later one counts, n of a set is the order of appearance
TEST(MacroCalls, TakeEmptyArgumentsAsSuch) {
    const Played played = play(
        "G65 P8000 I1. J#1 J2. I#1 K3. D#1 A5. A#1\n"
        "M30\nO8000\n#501=#4\n#502=#5\n#503=#8\n#504=#7\n"
        "#505=#9\n#506=#12\n#507=#1\nM99\n");
    EXPECT_EQ(played.errors, 0u) << played.events;
    EXPECT_TRUE(played.has({R"("name":"#501","value":1)"}));
    EXPECT_TRUE(played.has({R"("name":"#502","value":null)"}));
    // J of the second set
    EXPECT_TRUE(played.has({R"("name":"#503","value":2)"})) << played.events;
    EXPECT_TRUE(played.has({R"("name":"#504","value":null)"}));
    EXPECT_TRUE(played.has({R"("name":"#505","value":null)"}));
    EXPECT_TRUE(played.has({R"("name":"#506","value":3)"}));  // K of the third
    EXPECT_TRUE(played.has({R"("name":"#507","value":null)"}));
}

// fanuc_lathe 6.9.4: "arguments of both types as in G65", which stand behind it (6.9.1); nct part 2
// 18.2: all words of the block.
TEST(MacroCalls, ByACodeLoseNoWordOfTheirBlock) {
    Play fanuc;
    fanuc.sets = {"F6050=200"};
    const std::string macro = "\nM30\nO9010\n#500=#24\n#501=#25\nM99\n";
    const Played behind = play("N5 G200 X10. Y5." + macro, fanuc);
    EXPECT_TRUE(behind.has({R"("name":"#500","value":10)"})) << behind.events;
    EXPECT_TRUE(behind.has({R"("name":"#501","value":5)"}));
    for (const auto& [block, column] : {std::pair{"N5 X10. G200 Y5.", R"("column":4)"},
                                        std::pair{"G4 G200 X1.", R"("column":1)"}}) {
        const Played before = play(block + macro, fanuc);
        EXPECT_TRUE(before.has({R"("number":129)", column})) << before.events;
    }
    Play nct;
    nct.language = "nct";
    nct.sets = {"N1704=200"};
    const Played all = play("X10. G200 Y5." + macro, nct);
    EXPECT_TRUE(all.has({R"("name":"#500","value":10)"})) << all.events;
    EXPECT_TRUE(all.has({R"("name":"#501","value":5)"}));
}

// fanuc_lathe 6.9.1: without a point the least increment of the address; D and H are numbers, an
// angle does not know inches.
TEST(MacroCalls, CountArgumentsWithoutAPointInTheirOwnUnit) {
    const std::string call =
        "G65 P1 D5 H3 X20000 C90000 A1000 M4\nM30\n"
        "O1\n#500=#7\n#501=#11\n#502=#24\n#503=#3\n"
        "#504=#1\n#505=#13\nM99\n";
    for (const auto& [unit, x] : {std::pair{"G20\n", R"("name":"#502","value":2})"},
                                  std::pair{"G21\n", R"("name":"#502","value":20})"}}) {
        const Played played = play(unit + call);
        EXPECT_TRUE(played.has({R"("name":"#500","value":5})"})) << played.events;
        EXPECT_TRUE(played.has({R"("name":"#501","value":3})"}));
        EXPECT_TRUE(played.has({x})) << played.events;
        EXPECT_TRUE(played.has({R"("name":"#503","value":90})"})) << played.events;
        EXPECT_TRUE(played.has({R"("name":"#504","value":1})"})) << played.events;
        EXPECT_TRUE(played.has({R"("name":"#505","value":4})"}));
    }
}

// G80, or a code of the group of moves, ends all that a drilling cycle was told: the next one says
// its bottom anew (the field's standard).
TEST(Drilling, ForgetsItsHoleWithG80) {
    for (const char* end : {"G80", "G0 X0"}) {
        const Played fanuc = play("G98 G0 X0 Z10.\nG83 Z-20. R-5. F100\n" + std::string(end) +
                                  "\nG83 X10. R-5. F100\nM30\n");
        EXPECT_TRUE(fanuc.has({R"("ev":"alarm")", R"("line":4,)", R"("severity":"error")"}))
            << fanuc.events;
        EXPECT_FALSE(fanuc.has({R"("line":4,)", R"("kind":"linear")"})) << fanuc.events;
    }
    // another cycle goes on with it
    const Played another = play("G98 G0 X0 Z10.\nG83 Z-20. R-5. F100\nG85 C90.\nM30\n");
    EXPECT_TRUE(another.has({R"("line":3,)", R"("kind":"linear")", R"("Z":-20,)"}))
        << another.events;
    // nct part 1 16.1: N1501 if there is no E. Down to 0, back to R 5, then 1 above.
    Play nct;
    nct.language = "nct";
    nct.sets = {"N1501 L1=1"};
    const Played clearance = play(
        "G17 G94 G0 X0 Z10.\nG83 Z-20. R5. Q5. E2. F100\n"
        "G80\nG0 Z10.\nG83 Z-20. R5. Q5. F100\nM30\n",
        nct);
    EXPECT_TRUE(clearance.has({R"("line":2,)", R"("kind":"rapid")", R"("Z":2,)"}))
        << clearance.events;
    EXPECT_TRUE(clearance.has({R"("line":5,)", R"("kind":"rapid")", R"("Z":1,)"}))
        << clearance.events;
}

// fanuc_lathe 6.9.3: arguments are given once, in the block of G66
TEST(MacroCalls, OfG66GoOnWithTheirVariables) {
    const Played played = play(
        "#100=0\nG66 P8100 A1.\nG0 X90.\nX80.\nX70.\n"
        "G67\n#101=#1\nM30\nO8100\n#100=#100*10+#1\n"
        "#1=#1+1\nM99\n");
    EXPECT_EQ(played.errors, 0u) << played.events;
    EXPECT_TRUE(played.has({R"("name":"#100","value":123})"})) << played.events;
    // the caller's own
    EXPECT_TRUE(played.has({R"("name":"#101","value":null})"})) << played.events;
}

TEST(ParameterInput, TakesBitsAsBinaryDigits) {  // fanuc_lathe 7
    for (const char* wrong : {"R2", "R00000102", "R111111111", "R-1"})
        EXPECT_EQ(play("G10 L50\nN5002 " + std::string(wrong) + "\nG11\nM30\n").errors, 1u)
            << wrong;
    for (const char* right : {"R10", "R00010010", "R0", "R11111111"})
        EXPECT_EQ(play("G10 L50\nN5002 " + std::string(right) + "\nG11\nM30\n").errors, 0u)
            << right;
}

// fanuc_lathe 7: 1024 points, N10000 and on
TEST(ParameterInput, GivesCellsOfTheCompensationTablesTheirValue) {
    Play how;
    EXPECT_TRUE(
        play("G10 L50\nN6004 R1\nG11\n#100=ASIN[-1]\nM30\n").has({R"("name":"#100","value":-90)"}))
        << "expressions too use it at once";
    EXPECT_EQ(play("G10 L50\nN10005 R-12\nN11023 R3\nG11\nM30\n").errors, 0u)
        << play("G10 L50\nN10005 R-12\nN11023 R3\nG11\nM30\n").events;
    EXPECT_TRUE(play("G10 L50\nN11024 R3\nG11\nM30\n").has({R"("number":"PT1064")"}));
    EXPECT_TRUE(play("G10 L50\nN10005 R1.5\nG11\nM30\n").has({R"("number":7,)"}));
    how.language = "nct";
    EXPECT_EQ(play("G10 L50\nN29999 R0.0125\nG11\nM30\n", how).errors, 0u);
    EXPECT_TRUE(play("G10 L50\nN30000 R0.0125\nG11\nM30\n", how).has({R"("number":"PT1064")"}));
}

TEST(Series15, FeedsAndLeadsHaveTheirRanges) {  // fanuc_lathe 8.1
    Play how;
    how.sets = {"F0001#1=1"};
    struct Row {
        const char* blocks;
        bool good;
    };
    for (const Row& row : {Row{"G32 Z-20. F0.0001", true},
                           {"G32 Z-20. F0.00009", false},
                           {"G32 Z-20. E0.0001", true},
                           {"G32 Z-20. E500.1", false},
                           {"G32 Z-20. F50001", false},
                           {"G32 Z-20. E1", true},
                           {"G99 G1 Z-1. F0.01", true},
                           {"G99 G1 Z-1. F0.009", false},
                           {"G99 G1 Z-1. F500.5", false},
                           {"G98 G1 Z-1. F1", true},
                           {"G98 G1 Z-1. F0.5", false},
                           {"G98 G1 Z-1. F240001", false},
                           {"G20 G98 G1 Z-1. F0.02", true},
                           {"G20 G98 G1 Z-1. F0.005", false},
                           {"G20 G32 Z-1. F9.9999", true},
                           {"G20 G32 Z-1. F10.", false},
                           {"G20 G32 Z-1. E0.0000005", false}}) {
        const Played played = play("G97 S10 M3\n" + std::string(row.blocks) + "\nM30\n", how);
        EXPECT_EQ(played.has({R"("number":"PT1508")"}), !row.good) << row.blocks << "\n"
                                                                   << played.events;
    }
    // the native format has no such ranges here
    EXPECT_FALSE(play("G98 G1 Z-1. F0.5\nM30\n").has({R"("number":"PT1508")"}));
}

TEST(Series15, EIsAnotherNameOfF) {  // 8.1; without a point it counts 0.01 mm, in inches 0.0001
    Play how;
    how.sets = {"F0001#1=1"};
    EXPECT_TRUE(play("G97 S100 M3\nG32 Z-20. E150\nM30\n", how).has({R"("lead":1.5)"}));
    EXPECT_TRUE(play("G97 S100 M3\nG20\nG32 Z-1. E500\nM30\n", how).has({R"("lead":1.27)"}));
    EXPECT_TRUE(play("G97 S100 M3\n#1=2\nG32 Z-20. E#1\nM30\n", how).has({R"("lead":2)"}));
}

// fanuc_lathe 10.2: without F1008#0 positions run on, whatever the nct control's N0107 says
TEST(RollOver, IsFanucsOwn) {
    Play how;
    how.sets = {"N0107 A5=1", "F1008 A5=0"};
    EXPECT_TRUE(play("G0 C-350.\nM30\n", how).has({R"("machine":{"X":)", R"("C":-350)"}))
        << play("G0 C-350.\nM30\n", how).events;
    how.sets = {"N0107 A5=1", "F1008 A5=1"};
    EXPECT_TRUE(
        play("G0 C20.\nN2 C-350.\nM30\n", how).has({R"("n":2,)", R"("pos":{"X":)", R"("C":10)"}))
        << play("G0 C20.\nN2 C-350.\nM30\n", how).events;
}

// How much of the path (its linear axes) one unit of the feed is, move by move.
struct FeedScales final : QuietSink {
    std::vector<double> scales;
    void move(const Move& m, const BlockContext&) override { scales.push_back(m.feed_scale); }
};

// the field's standard: 30 mm and 40 degrees are a way of 50
TEST(Feed, OfLinearAndRotaryAxesCountsADegreeAsAMillimetre) {
    const auto table = lathe({});
    MachineView view = make_machine_view(*table, 1);
    ProgramFiles files;
    FeedScales told;
    const text::Setup setup;
    CheckPort port(setup, 1, true);
    const auto main = files.open_text(
        "G98 F100\nG1 W30. H40.\nW5.\nH90.\nG20\nW1. H25.4\nG21 G2 U20. W-10. R10.\nM30\n",
        "test.nc");
    ASSERT_TRUE(main);
    const auto interpreter = make_language("fanuc", view, told, port, files);
    ASSERT_TRUE(interpreter->start(*main).ok());
    interpreter->core().start_at_machine(view.start);
    for (int n = 0; n < 100 && interpreter->step() == Step::Continue; ++n) {}
    ASSERT_EQ(told.scales.size(), 5u);
    EXPECT_NEAR(told.scales[0], 0.6, 1e-9);
    EXPECT_EQ(told.scales[1], 1.0);
    EXPECT_EQ(told.scales[2], 1.0);  // alone it is degrees per minute
    EXPECT_NEAR(told.scales[3], 1 / std::hypot(1, 25.4), 1e-9);
    EXPECT_EQ(told.scales[4], 1.0);
}

// Where the C axis goes, whole turns included.
struct Turns final : QuietSink {
    std::vector<double> ends;
    void move(const Move& m, const BlockContext&) override {
        ends.push_back(m.machine[2] - m.machine_start[2]);
    }
};

std::vector<double> turns_of(std::string_view program, const std::vector<std::string>& sets,
                             const char* name = "nct") {
    const auto table = lathe(sets);
    MachineView view = make_machine_view(*table, 1);
    ProgramFiles files;
    Turns turns;
    const text::Setup setup;
    CheckPort port(setup, 1, true);
    const auto main = files.open_text(program, "test.nc");
    if (!main) return {};
    const auto interpreter = make_language(name, view, turns, port, files);
    (void)interpreter->start(*main).ok();
    interpreter->core().start_at_machine(view.start);
    for (int n = 0; n < 100 && interpreter->step() == Step::Continue; ++n) {}
    return turns.ends;
}

// nct part 1 3.5: the sign of a position; of a direction it is the sign that is written
TEST(RollOver, TakesZeroAsPositive) {
    EXPECT_EQ(turns_of("G0 C330.\nC-0.\n", {"N0107 A5=1"}), (std::vector<double>{330, 30}));
    EXPECT_EQ(turns_of("G0 C330.\nC-0.\n", {"N0107 A5=5"}), (std::vector<double>{330, -330}));
    EXPECT_EQ(turns_of("G0 C330.\nC-10.\n", {"N0107 A5=1"}), (std::vector<double>{330, -340}));
}

TEST(RollOver, OfFanucBySignGoesToTheWordModuloItsPeriod) {  // fanuc_lathe 10.2, F1008#1 RAB = 1
    EXPECT_EQ(turns_of("G0 C10.\nC-20.\nC350.\n", {"F1008 A5=3"}, "fanuc"),
              (std::vector<double>{10, -30, 10}));
}

TEST(Compensation, NeedsRoomInAnInnerChamfer) {  // fanuc_lathe 3.16
    const auto nose = [](MachineView& view) { view.store->offsets[1].geometry_r = 0.5; };
    const auto shoulder = [&](const std::string& words, const std::string& next) {
        return play(
            "G98 F100 T0101\nG42 G1 X40. Z2.\nZ-20. " + words + "\n" + next + "\nZ-30.\nM30\n",
            Play{}, nose);
    };
    for (const char* small : {",C.3", "I.3", ",R.4"})
        EXPECT_TRUE(shoulder(small, "X50.").has({R"("line":3)", R"("number":39)"}))
            << small << shoulder(small, "X50.").events;
    for (const char* room : {",C2.", "I2.", ",C.5", ",R.6"})
        EXPECT_EQ(shoulder(room, "X50.").errors, 0u) << room << shoulder(room, "X50.").events;
    // an outer one
    EXPECT_EQ(shoulder(",C.3", "X30.").errors, 0u) << shoulder(",C.3", "X30.").events;
}

TEST(Compensation, TakesCornerElementsBetweenLinesAtRightAnglesOnly) {  // fanuc_lathe 3.16
    const auto nose = [](MachineView& view) { view.store->offsets[1].geometry_r = 0.5; };
    const auto corner = [&](const std::string& first, const std::string& next, const char* side) {
        return play(std::string("G98 F100 T0101\n") + side + " G1 X40. Z2.\nZ-5.\n" + first + "\n" +
                        next + "\nW-9.\nM30\n",
                    Play{}, nose);
    };
    for (const char* element : {",C2.", ",R2."}) {
        EXPECT_TRUE(corner(std::string("Z-20. ") + element, "X60. Z-30.", "G42")
                        .has({R"("line":5)", R"("number":52)"}))
            << element;
        EXPECT_TRUE(corner(std::string("X44. Z-20. ") + element, "X60.", "G42")
                        .has({R"("line":4)", R"("number":54)"}))
            << element;
        EXPECT_EQ(corner(std::string("Z-20. ") + element, "X60. Z-20.15", "G42").errors, 0u)
            << element << ": less than a degree";
        EXPECT_EQ(corner(std::string("X44. Z-20. ") + element, "X60. Z-30.", "G40").errors, 0u)
            << element;
    }
}

// fanuc_lathe 1.4 and 3.12: T alone travels the change of the wear at the block's end; no piece of
// the contour, as any block without movement.
TEST(Compensation, AnotherWearIsNoPieceOfTheContour) {
    const auto two = [](MachineView& view) {
        for (const std::size_t n : {1u, 2u}) {
            view.store->offsets[n].geometry_r = 0.4;
            view.store->offsets[n].tip = 3;
        }
        view.store->offsets[2].wear[0] = 1.0;
        view.store->offsets[2].wear[2] = 0.5;
    };
    const Played played = play(
        "G98 F100\nT0101\nG42 G0 X40. Z2.\nG1 Z-10.\nT0102\nZ-20.\nX50.\nZ-30.\nG40 G0 X60.\nM30\n",
        Play{}, two);
    EXPECT_EQ(played.errors, 0u) << played.events;
    EXPECT_TRUE(played.has({R"("line":4)", R"("pos":{"X":40,"Z":-10.4)"})) << played.events;
    EXPECT_TRUE(played.has(
        {R"("line":5)", R"("pos":{"X":40,"Z":-10.4)", R"("machine":{"X":20.5,"Z":-9.9)"}))
        << played.events;
    EXPECT_TRUE(
        played.has({R"("line":6)", R"("pos":{"X":40,"Z":-20)", R"("machine":{"X":20.5,"Z":-19.5)"}))
        << played.events;
}

TEST(Jump, FindsItsBlockBehindAComment) {
    for (const char* language : {"fanuc", "nct"}) {
        Play how;
        how.language = language;
        const Played played =
            play("GOTO20\nN10 M8\n(A) / (B) N20 M9\nM98 P30\nM30\n(SUB) O30\nM7\nM99\n", how);
        EXPECT_TRUE(played.has({R"("code":"M9")"}) && played.has({R"("code":"M7")"}) &&
                    !played.has({R"("code":"M8")"}))
            << played.events;
    }
}

TEST(Variables, OfLetterCallsAreNotWritten) {  // nct_parameters_part2 38
    Play how;
    how.language = "nct";
    for (const char* bad : {"#191=1", "#199=1"})
        EXPECT_EQ(play(std::string(bad) + "\nM30\n", how).errors, 1u) << bad;
    for (const char* good : {"#190=1", "#200=1"})
        EXPECT_EQ(play(std::string(good) + "\nM30\n", how).errors, 0u) << good;
    EXPECT_EQ(play("#191=1\nM30\n").errors, 0u);
}

TEST(Compensation, GoesOnOnItsSideRightBehindItsBeginning) {  // fanuc_lathe 3.9
    Play how;
    const auto nose = [](MachineView& view) { view.store->offsets[1].geometry_r = 0.4; };
    const Played refused =
        play("G98 F100 T0101\nG41 G1 X40. Z2.\nG42 Z-10.\nX50.\nM30\n", how, nose);
    EXPECT_TRUE(refused.has({R"("line":3)", R"("number":9)", R"("column":1)"})) << refused.events;
    const Played later =
        play("G98 F100 T0101\nG41 G1 X40. Z2.\nZ-10.\nG42 X50. Z-20.\nX60.\nM30\n", how, nose);
    EXPECT_EQ(later.errors, 0u) << later.events;
}

TEST(OffsetVariables, CountInTheUnitOfTheProgram) {
    const Played played = play(
        "G20\nG10 P3 X0.5 R0.02 Q3\n#100=#2003\n#101=#2203\n"
        "#102=#2303\n#2103=0.25\nG21\n#103=#2103\n"
        "M30\n");
    EXPECT_EQ(played.errors, 0u) << played.events;
    EXPECT_TRUE(played.has({R"("name":"#100","value":0.5})"})) << played.events;
    EXPECT_TRUE(played.has({R"("name":"#101","value":0.02})"}));
    EXPECT_TRUE(played.has({R"("name":"#102","value":3})"}));
    EXPECT_TRUE(played.has({R"("name":"#103","value":6.35})"}));
}

TEST(CallsByName, FindTheFileOrTellWhichIsMissing) {
    const auto file = std::filesystem::temp_directory_path() / "polyturn_call_by_name_PROFILE.NC";
    std::ofstream(file) << "O77\n#100=#100+1\n#101=#1\nM99\n";
    Play how;
    how.setup.subprograms.push_back(file.string());
    const std::string name = file.stem().string();
    const Played played = play(
        "#100=0\nM98 <" + name + "> L2\nG65 <" + file.filename().string() + "> A4.\nM30\n", how);
    EXPECT_EQ(played.errors, 0u) << played.events;
    EXPECT_TRUE(played.has({R"("name":"#100","value":3})"})) << played.events;
    EXPECT_TRUE(played.has({R"("name":"#101","value":4})"}));
    EXPECT_TRUE(play("M98 <NOWHERE>\nM30\n").has({R"("number":78)", "<NOWHERE>"}));
    for (const char* wrong : {"<NAME>\nM30\n", "G0 X5. <NAME>\nM30\n", "M98 <NAME\nM30\n",
                              "M98 <>\nM30\n", "M98 P5 <NAME>\nM30\n"})
        EXPECT_EQ(play(wrong).errors, 1u) << wrong;
    std::filesystem::remove(file);
}

// Taught: the spindle at 90 degrees, the tool in the groove at Z -10. A thread of lead 2 that
// begins at Z 5 has 7.5 turns to there: it begins at 90 - 7.5 * 360 = 270 degrees (mod 360). With
// M4 the angles run back: 90 + 7.5 * 360 = 270. From Z 4.5: 90.
TEST(ThreadPickup, BeginsWhereItMeetsTheTaughtGroove) {
    Play how;
    how.sets = {"PT_THREAD_PICKUP L1=1", "PT_THREAD_ANGLE L1=90", "PT_THREAD_AT L1=-10", "N1000=0"};
    EXPECT_TRUE(
        play("G97 S300 M3\nG0 X40. Z5.\nG32 Z-30. F2.\nM30\n", how).has({R"("start_angle":270)"}));
    EXPECT_TRUE(
        play("G97 S300 M4\nG0 X40. Z5.\nG32 Z-30. F2.\nM30\n", how).has({R"("start_angle":270)"}));
    EXPECT_TRUE(
        play("G97 S300 M3\nG0 X40. Z4.5\nG32 Z-30. F2.\nM30\n", how).has({R"("start_angle":0})"}) ||
        play("G97 S300 M3\nG0 X40. Z4.5\nG32 Z-30. F2.\nM30\n", how).has({R"("start_angle":0,)"}));
    // the second of three starts
    EXPECT_TRUE(play("G97 S300 M3\nG0 X40. Z5.\nG32 Z-30. F2. Q120000\nM30\n", how)
                    .has({R"("start_angle":30)"}));
    // upwards: 5 turns
    EXPECT_TRUE(
        play("G97 S300 M3\nG0 X40. Z-20.\nG32 Z5. F2.\nM30\n", how).has({R"("start_angle":90)"}));
    how.sets[0] = "PT_THREAD_PICKUP L1=0";
    EXPECT_TRUE(
        play("G97 S300 M3\nG0 X40. Z5.\nG32 Z-30. F2.\nM30\n", how).has({R"("start_angle":0)"}));
}

// N1414#7 = 0: offsets X 10 (diameter), Z 3 turn with G68 by 90 degrees: from Z to X, so Z' = -5,
// X' = 3 (radius).
TEST(RotatedSystem, TurnsTheLengthsOfTheTool) {
    Play how;
    how.language = "nct";
    how.sets = {"N1413 L1=2", "N1414 L1=0", "N1000=0"};
    const std::string program =
        "G10 L10 P1 X10. Z3.\nT0101\nG0 X0 Z0\nG68 X0 Z0 R90.\n"
        "G0 X20. Z7.\nG69\nG0 X20. Z7.\nM30\n";
    const Played turned = play(program, how);
    EXPECT_EQ(turned.errors, 0u) << turned.events;
    // The point Z7 X10 (radius) turns to Z -10, X 7; with the turned lengths Z -15, X 10.
    EXPECT_TRUE(turned.has({R"("machine":{"X":10,"Z":-15)"})) << turned.events;
    EXPECT_TRUE(turned.has({R"("machine":{"X":15,"Z":10)"})) << turned.events;  // behind G69
    how.sets[1] = "N1414 L1=128";
    EXPECT_TRUE(play(program, how).has({R"("machine":{"X":12,"Z":-7)"}));
}

// Q20 is not there: reading the contour comes to a cycle with the same contour.
TEST(ContourCycles, DoNotReadThemselves) {
    for (const char* cycle :
         {"G70 P10 Q20", "G71 P10 Q20 U0 W0", "G72 P10 Q20 U0 W0", "G73 P10 Q20 U0 W0"}) {
        const Played played =
            play(std::string("G98 F100\nG0 X60. Z2.\nG71 U4. R0.5\nG71 P10 Q20 U0.4 W0.1\n"
                             "N10 G0 X40.\nG1 Z-10.\nX50. Z-15.\n") +
                 cycle + "\nM30\n");
        EXPECT_EQ(played.errors, 1u) << played.events;
        EXPECT_FALSE(played.has({R"("cycle":)"})) << played.events;
    }
}

}  // namespace
}  // namespace polyturn::channels::testing
