// One block, one fact: where it takes the axes, or which alarm it is and at which column.
#include <gtest/gtest.h>

#include "../play.hpp"

namespace polyturn::channels::testing {
namespace {

struct MoveRow {
    std::string_view program;  // begins at X0 Z0
    std::string_view last;     // part of the last move's event
};

void expect_last_move(const MoveRow& row, const Play& how = {}) {
    SCOPED_TRACE(std::string(row.program));
    const Played played = play(row.program, how);
    std::string last;
    for (const std::string& line : played.lines())
        if (line.find("\"ev\":\"move\"") != std::string::npos) last = line;
    EXPECT_NE(last.find(row.last), std::string::npos) << played.events;
    EXPECT_EQ(played.errors, 0u) << played.events;
}

TEST(FanucBlock, MovesTheAxesWhereItsWordsSay) {
    const MoveRow rows[] = {
        {"G0 X40.", R"("pos":{"X":40,"Z":0,"C":0},"machine":{"X":20,"Z":0,"C":0})"},
        {"G0 X40", R"("pos":{"X":0.04,)"},  // no point: increments of 0.001
        {"G0 X-.5", R"("machine":{"X":-0.25,)"},
        {"G 0 x 1. z -2.", R"("pos":{"X":1,"Z":-2,)"},  // blanks and small letters
        // the later word of an axis counts, from the start point
        {"G0 X10. U4.", R"("pos":{"X":4,)"},
        {"G0 X10.\nU4. W-3.", R"("pos":{"X":14,"Z":-3,)"},
        {"G0 C30.\nH-45.", R"("C":-15)"},
        {"G20 G0 X1. Z2.", R"("pos":{"X":25.4,"Z":50.8,)"},  // inches in, millimetres out
        {"G20 G0 X10000", R"("pos":{"X":25.4,)"},            // 0.0001 inch
        {"G98 G1 X10. F100", R"("feed":{"mode":"per_min","value":100})"},
        {"S500 M3\nG99 G1 X10. F0.25", R"("feed":{"mode":"per_rev","value":0.25})"},
        {"S500 M3\nG99 G1 X10. F2500", R"("feed":{"mode":"per_rev","value":0.25})"},  // 0.0001 mm
        {"G98 F50\nG2 X20. Z-10. R10.",
         R"("kind":"cw","pos":{"X":20,"Z":-10,"C":0},"machine":{"X":10,"Z":-10,"C":0},)"
         R"("centre":{"Z":0,"X":10},"radius":10)"},
        {"G98 F50\nG3 X20. Z-10. R10.", R"("centre":{"Z":-10,"X":0},"radius":10)"},
        {"G98 F50\nG3 X20. Z-10. I0 K-10.", R"("centre":{"Z":-10,"X":0},"radius":10)"},
        {"G98 F50\nG2 I5.", R"("centre":{"Z":0,"X":5},"radius":5)"},  // a full circle
        {"G50 X100. Z50.\nG0 X90.",
         R"("pos":{"X":90,"Z":50,"C":0},"machine":{"X":-5,"Z":0,"C":0})"},
        {"G50 U10.\nG0 X0", R"("machine":{"X":-5,)"},
        {"G10 L2 P2 X8. Z-20.\nG55 G0 X2. Z1.",
         R"("pos":{"X":2,"Z":1,"C":0},"machine":{"X":5,"Z":-19,"C":0})"},
        {"G10 P0 Z3.\nG0 Z1.", R"("machine":{"X":0,"Z":4,)"},
        {"G52 X10.\nG0 X1.", R"("machine":{"X":5.5,)"},
        {"G50 X9. Z9.\nG53 X30. Z0", R"("machine":{"X":15,"Z":0,)"},
        {"S500 M3\nG32 Z-20. F1.5",
         R"("kind":"thread","pos":{"X":0,"Z":-20,"C":0},"machine":{"X":0,"Z":-20,"C":0},)"
         R"("lead":1.5,"start_angle":0)"},
        {"S500 M3\nG32 Z-20. F1.5 Q90000", R"("start_angle":90)"},
        {"/G0 X5.\nG0 X6.", R"("X":6)"},
        {"G0 X1. (X9.) Z2.", R"("pos":{"X":1,"Z":2,)"},
        {"G0 X1.; Z2.", R"("pos":{"X":1,"Z":2,)"},  // two blocks in a line
        // an increment is travelled by each repetition
        {"G98 G83 U5. Z-4. R-1. F100 K3\nG80", R"("pos":{"X":15,"Z":0,)"},
        {"G98 G83 X5. Z-4. R-1. F100 K3\nG80", R"("pos":{"X":5,"Z":0,)"},
    };
    for (const MoveRow& row : rows) expect_last_move(row);
}

// nct: T is the tool alone with N1414 TCM; the offset of G43.7 comes and goes as a whole.
TEST(NctBlock, AnOffsetByGCodeIsTakenBackByG49) {
    Play how;
    how.language = "nct";
    how.sets = {"N1414 L1=1"};
    const auto last_machine = [&](std::string_view program) {
        const Played played = play(program, how, [](MachineView& view) {
            view.store->offsets[2].geometry = {10, 0, 4};
        });
        std::string last;
        for (const std::string& line : played.lines())
            if (line.find("\"ev\":\"move\"") != std::string::npos) last = line;
        return last;
    };
    EXPECT_NE(last_machine("G43.7 H2\nG0 X20. Z1.\nT5\nG0 X20. Z2.")
                  .find(R"("machine":{"X":15,"Z":6,"C":0})"),
              std::string::npos);
    EXPECT_NE(
        last_machine("G43.7 H2\nG0 X20. Z1.\nG49\nG0 X20. Z1.").find(R"("machine":{"X":10,"Z":1,)"),
        std::string::npos);
}

// N1717 has one decimal.
TEST(NctBlock, CodesWithADecimalCallARunOfPrograms) {
    Play how;
    how.language = "nct";
    how.sets = {"N1717 L1=12.9", "N1718 L1=3000", "N1719 L1=2"};
    const Played played = play("O1\nG13.0 A2.\nM30\nO3001\n#130=#1\nM99\n", how);
    EXPECT_TRUE(played.has({R"("name":"#130","value":2)"})) << played.events;
}

TEST(FanucBlock, TheVariableOfACodeThatCallsIsToldLikeAnyOther) {
    Play how;
    how.sets = {"F6001#5=1"};
    const Played played = play("O1\nT0303\nM30\nO9000\nM99\n", how);
    EXPECT_TRUE(played.has({R"("name":"#149","value":303)"})) << played.events;
}

TEST(FanucBlock, ASkipSignThatIsOnLeavesTheBlockOut) {
    Play how;
    how.setup.keys.block_skip = {1, 3};
    expect_last_move({"G0 X1.\n/X2.\n/2 X3.", R"("X":3)"}, how);
    expect_last_move({"G0 X1. /3 Z5.\n", R"("pos":{"X":1,"Z":0,)"}, how);
    // the block ends at its end, not the line
    expect_last_move({"G0 X1. /3 Z5. (A;B); Z7.\n", R"("pos":{"X":1,"Z":7,)"}, how);
    expect_last_move({"/X2.; X3.\n", R"("X":3)"}, how);
}

TEST(FanucBlock, DpiMakesNumbersWithoutAPointWholeMillimetres) {
    Play how;
    how.sets = {"F3401#0=1"};
    expect_last_move({"G0 X40", R"("X":40)"}, how);
}

struct FaultRow {
    std::string_view program;
    std::string_view number;  // as the event writes it
    unsigned line, column;    // column 0: none
};

void expect_fault(const FaultRow& row, const Play& how = {}) {
    SCOPED_TRACE(std::string(row.program));
    const Played played = play(row.program, how);
    const std::string alarm = played.find({R"("ev":"alarm")", R"("severity":"error")"});
    ASSERT_FALSE(alarm.empty()) << played.events;
    EXPECT_NE(alarm.find("\"number\":" + std::string(row.number) + ","), std::string::npos)
        << alarm;
    EXPECT_NE(alarm.find("\"line\":" + std::to_string(row.line) + ","), std::string::npos) << alarm;
    if (row.column) {
        EXPECT_NE(alarm.find("\"column\":" + std::to_string(row.column) + ","), std::string::npos)
            << alarm;
    } else {
        EXPECT_EQ(alarm.find("\"column\""), std::string::npos) << alarm;
    }
}

TEST(FanucBlock, IsDiagnosedAtItsLineAndColumn) {
    const FaultRow rows[] = {
        {"G0 X4.0.", "7", 1, 8},    // second point
        {"G0 X", "5", 1, 4},        // nothing behind the address
        {"G0 12.", "4", 1, 4},      // number without address
        {"G0 Y5.", "9", 1, 4},      // the channel has no Y
        {"G0 X1. K3.", "9", 1, 8},  // nobody takes K
        {"G7 X1.", "10", 1, 1},
        {"G30.1", R"("PT1041")", 1, 1},  // which axes?
        {"G0 X1. ,C2.", "9", 1, 8},
        {"G0 X1. \xC3\xA4", R"("PT1000")", 1, 8},
        {"(\xC3\xA4) G0 X", "5", 1, 8},  // columns count characters
        {"G0 X1. (open", R"("PT1001")", 1, 8},
        {"G0 X1.\nG98 G1 X5.", "11", 2, 5},  // no feed
        {"G32 Z-5. F1.", R"("PT1016")", 1, 1},
        {"S3000 M3\nG32 Z-5. F4.", R"("PT1017")", 2, 10},  // 12 m/min, the axis does 8
        {"S300 M3\nG32 Z-5.", R"("PT1044")", 2, 1},
        {"G98 F9\nG2 X10. Z-10. R1.", "20", 2, 15},
        {"G98 F9\nG2 X10. Z-10. I5. K1.", "20", 2, 15},
        {"G98 F9\nG2 X10. Z-10.", "22", 2, 1},
        {"G98 F9\nG2 X10. Z-10. R-9.", "23", 2, 15},
        {"G98 F9\nG2 X10. Z-10. J9.", "21", 2, 15},
        {"G98 F9 G17 G2 X1. R5.", "28", 1, 12},  // no Y axis: no plane X Y
        {"M98 P77", "78", 1, 5},
        {"M98", "76", 1, 1},
        {"GOTO 5", "128", 1, 6},
        {"GOTO 0", "128", 1, 6},
        {"T0140", "30", 1, 1},
        {"G28", R"("PT1041")", 1, 1},
        {"G4", R"("PT1065")", 1, 1},
        {"G4 P1.5", "7", 1, 4},
        {"S-5", "6", 1, 1},
        {"N-1 X1.", "6", 1, 1},
        {"N1.5 X1.", "7", 1, 1},
        {"O1.5", "7", 1, 1},
        {"M520 P13", R"("PT1037")", 1, 6},   // no channel 3
        {"M520 P-12", R"("PT1037")", 1, 6},  // nor any of a negative number
        {"#1=-12\nM520 P#1", R"("PT1037")", 2, 6},
        {"M520 P2", R"("PT1038")", 1, 6},
        {"G65 A1.", "76", 1, 1},
        {"%\nO1\nG0 X1.", "5010", 3, 1},  // no closing %
    };
    for (const FaultRow& row : rows) expect_fault(row);
}

TEST(FanucBlock, ATargetOutsideTheStrokeIsRefused) {
    Play how;
    how.sets = {"N1000 A1=1", "N1002 A1=60", "N1003 A1=-10"};
    expect_last_move({"G0 X120.", R"("X":120)"}, how);
    expect_fault({"G0 X120.002", "500", 1, 4}, how);
    expect_fault({"G0 X-20.002", "500", 1, 4}, how);
    // bulges outside
    expect_fault({"G98 F50 G0 X110. Z0\nG3 Z-20. X110. R10.1", "501", 2, 10}, how);
}

TEST(FanucBlock, SubprogramsReturnRepeatAndEndTooDeep) {
    Play how;
    const Played twice = play("G0 X1.\nM98 P20002\nX50.\nM30\nO2\nU1.\nM99\n", how);
    EXPECT_TRUE(twice.has({R"("pos":{"X":3,)"})) << twice.events;
    EXPECT_TRUE(twice.has({R"("pos":{"X":50,)"})) << twice.events;
    EXPECT_TRUE(twice.has({R"("reason":"M30")"})) << twice.events;
    expect_fault({"M98 P2\nM30\nO2\nM98 P2\nM99\n", "77", 4, 5});
    const Played target = play("M98 P2\nG0 X1.\nN9 X2.\nM30\nO2\nM99 P9\n", how);
    EXPECT_FALSE(target.has({R"("pos":{"X":1,)"})) << target.events;
    EXPECT_TRUE(target.has({R"("pos":{"X":2,)"})) << target.events;
}

TEST(FanucBlock, WaitsNameTheirChannels) {
    const Played both = play("M510 P12\nM30\n");
    EXPECT_TRUE(both.has({R"("ev":"wait")", R"("code":510,"channels":[1,2],"kind":"stop")"}))
        << both.events;
    const Played list = play("M510 P=2.1\nM30\n");
    EXPECT_TRUE(list.has({R"("channels":[1,2])"})) << list.events;
    const Played two_channels = play("M510\nM30\n");
    EXPECT_TRUE(two_channels.has({R"("channels":[1,2])"})) << two_channels.events;
}

TEST(FanucBlock, ASpindleThatAnotherChannelOrThePlcMayHaveStartedIsAWarningOnce) {
    for (const bool alone : {false, true}) {
        Play how;
        how.alone = alone;
        const Played played = play("G99 G1 X5. F0.1\nX6.\nM30\n", how);
        EXPECT_EQ(played.errors, 0u) << played.events;
        unsigned warnings = 0;
        for (const std::string& line : played.lines())
            warnings += line.find("\"warning\"") != std::string::npos;
        EXPECT_EQ(warnings, 1u) << played.events;
    }
}

// Where the shorter way to the hole goes over 0, the second hole of L2 is at the same place and no
// turn away from it.
TEST(FanucDrilling, RepeatsStayAtTheirPlaceOfARotaryAxis) {  // fanuc_lathe 8.5, 10.2
    Play how;
    how.sets = {"F0001#1=1", "F5101#0=1", "F1008 A5=1", "F1260 A5=360"};
    const Played played =
        play("G17 G97 S500 M3\nG99 G0 X0. Z5.\nG81 C200. Z-10. R-1. F0.1 L2\nG80\nM30\n", how);
    EXPECT_EQ(played.errors, 0u) << played.events;
    int rapids = 0;
    for (const std::string& line : played.lines())
        rapids += line.find(R"("kind":"rapid")") != std::string::npos;
    // to the start; to the hole, R and back; R and back
    EXPECT_EQ(rapids, 1 + 3 + 2) << played.events;
}

TEST(FanucData, RollOverOfG10L50HoldsForTheNextWord) {  // fanuc_lathe 7, 10.2
    const std::string input = "G98 F1200\nG10 L50\nN1008 P3 R00000001\nN1260 P3 R180000\nG11\n";
    expect_last_move({input + "G1 C-350.\nM30\n", R"("C":10})"});
    expect_last_move({input + "G1 C200.\nH-30.\nM30\n", R"("C":170})"});
    Play how;
    how.sets = {"F1008 A5=1", "F1260 A5=360"};
    expect_last_move(
        {"G98 F1200\nG10 L50\nN1008 P3 R00000000\nG11\nG1 C-350.\nM30\n", R"("C":-350})"}, how);
}

// Another wear in a straight block moves the tool obliquely; the contour and its corners stay as
// they are programmed.
TEST(FanucCompensation, IsNotBentByAnotherWear) {  // fanuc_lathe 1.4, 2.1, 3.18
    Play how;
    how.sets = {"F5002#1=1"};
    const auto offsets = [](MachineView& view) {
        view.store->offsets[1].geometry_r = 0.5;
        view.store->offsets[1].tip = 3;
        view.store->offsets[1].wear = {0.2, 0.0, 0.1};
        view.store->offsets[2].wear = {0.6, 0.0, -0.3};
    };
    const Played played = play(
        "G18 G40 G98 F300\nG0 X60. Z20. T0101\nG0 X40. Z5.\n"
        "G42 G1 Z2.\nN30 Z-10.\nN40 Z-20. T0102\n"
        "N50 X50.\nN60 Z-30. T0101\nN70 X60.\nN80 G40 X70. Z-50. T0102\n"
        "M30\n",
        how, offsets);
    EXPECT_EQ(played.errors, 0u) << played.events;
    EXPECT_TRUE(played.has({R"("n":30,)", R"("pos":{"X":40,"Z":-10.5,)"})) << played.events;
    EXPECT_TRUE(played.has(
        {R"("n":40,)", R"("pos":{"X":40,"Z":-20,"C":0},"machine":{"X":20.3,"Z":-20.3,)"}))
        << played.events;
    EXPECT_TRUE(played.has(
        {R"("n":60,)", R"("pos":{"X":50,"Z":-30,"C":0},"machine":{"X":25.1,"Z":-29.9,)"}))
        << played.events;
    // The way out: V = r (n1 + n2) / (1 + n1 n2) of the programmed lines, still with the old wear,
    // then r n2 with the new one.
    EXPECT_TRUE(
        played.has({R"("n":70,)",
                    R"("pos":{"X":59.780776,"Z":-30,"C":0},"machine":{"X":29.990388,"Z":-29.9,)"}))
        << played.events;
    EXPECT_TRUE(played.has(
        {R"("n":80,)",
         R"("pos":{"X":59.970143,"Z":-30.378732,"C":0},"machine":{"X":30.285071,"Z":-30.678732,)"}))
        << played.events;
}

}  // namespace
}  // namespace polyturn::channels::testing
