// Chamfers, angles, mirror, scale, rotation; B-axis programs; printing: tables of programs and what
// they give.
#include <gtest/gtest.h>

#include "../play.hpp"

namespace polyturn::channels::testing {
namespace {

struct Row {
    std::string_view program;
    std::vector<std::string> parts;  // of one event
};

void expect_rows(const std::vector<Row>& rows, const Play& how) {
    for (const Row& row : rows) {
        SCOPED_TRACE(std::string(row.program));
        const Played played = play(row.program, how);
        EXPECT_TRUE(played.has(row.parts)) << played.events;
    }
}

TEST(LatheCorner, StandsBetweenTwoBlocks) {
    expect_rows(
        {
            {"G98 F9\nG1 Z-20. I5.\nX50.", {R"("pos":{"X":0,"Z":-15)"}},
            {"G98 F9\nG1 Z-20. I5.\nX50.", {R"("pos":{"X":10,"Z":-20)"}},
            {"G98 F9\nG1 X20. R2.\nZ40.", {R"("kind":"cw")", R"("pos":{"X":20,"Z":2,)"}},
            {"G98 F9\nG1 X20. R-2.\nZ-40.", {R"("kind":"ccw")", R"("pos":{"X":20,"Z":-2,)"}},
            {"G98 F9\nG1 Z-20. ,C3.\nX50.", {R"("pos":{"X":6,"Z":-20)"}},
            {"G98 F9\nG1 Z-20. I5.\nG2 X50. R30.", {R"("number":52,)", R"("line":3)"}},
            {"G98 F9\nG1 Z-20. I5.\nX-5.", {R"("number":52,)"}},  // the sign names the other side
            {"G98 F9\nG1 X5. Z-20. I5.\nX50.", {R"("number":54,)"}},
            {"G98 F9\nG1 X5. I5.\nZ50.", {R"("number":55,)"}},
            {"G98 F9\nG1 Z-20. I5.", {R"("number":51,)"}},
            {"G98 F9\nG1 Z-20. I50.\nX5.", {R"("number":55,)"}},
        },
        {});
}

TEST(AngleOfALine, GivesTheMissingCoordinate) {
    expect_rows(
        {
            {"G98 F9\nG1 X40. A135.", {R"("pos":{"X":40,"Z":-20)"}},
            {"G98 F9\nG1 A180.\nX60. Z-30. A90.\nX70.", {R"("line":2)", R"("pos":{"X":0,"Z":-30)"}},
            // the same line, written the other way round
            {"G98 F9\nG1 X40. A-45.", {R"("pos":{"X":40,"Z":-20)"}},
            {"G98 F9\nG1 A0.\nX60. Z-30. A-90.\nX70.", {R"("line":2)", R"("pos":{"X":0,"Z":-30)"}},
            {"G98 F9\nG1 Z-20. A90.", {R"("number":57,)"}},
            {"G98 F9\nG1 A0.\nX60. Z-30. A180.", {R"("number":57,)"}},
        },
        {});
}

// Two lines by their angles: 45 degrees between them, so R2 begins 2 tan 22.5 = 0.828427 before the
// crossing at X80 Z-20.
TEST(AngleOfALine, TakesACornerAtTheCrossing) {
    const std::string two = "G98 F9 G0 X40. Z0\nG1 A135. ,R2.\nX80. Z-30. A180. ,C1.\nX90. A90.\n";
    expect_rows(
        {
            {two, {R"("line":2)", R"("kind":"linear")", R"("pos":{"X":78.828427,"Z":-19.414214)"}},
            {two,
             {R"("line":2)", R"("kind":"ccw")", R"("pos":{"X":80,"Z":-20.828427)",
              R"("radius":2)"}},
            {two, {R"("line":3)", R"("pos":{"X":80,"Z":-29)"}},
            {two, {R"("line":3)", R"("pos":{"X":82,"Z":-30)"}},
            // the chamfer is that of its own line
            {"G98 F9 G0 X40. Z0\nG1 A135.\nX80. Z-30. A180. ,C1.\nX90. A90.\n",
             {R"("line":2)", R"("pos":{"X":80,"Z":-20)"}},
            // no contour follows
            {"G98 F9\nG1 Z-20. ,R2.\nG28 U0 W0\n", {R"("number":51,)", R"("line":2)"}},
            {"G98 F9\nG1 Z-20. ,R2.\nG90 X9. Z-30.\n", {R"("number":51,)", R"("line":2)"}},
            // the line would be left out
            {"G98 F9\nG1 A135.\nG0 X60. Z-20.\n",
             {R"("number":57,)", R"("line":2,)", R"("column":4)"}},
            {"G98 F9\nG1 A135.\nG28 U0\n", {R"("number":57,)", R"("line":2,)"}},
            {"G98 F9\nG1 A135.\nM30\n", {R"("number":57,)", R"("line":2,)"}},
            {"G98 F9\nG1 Z-20. ,R2. ,C1.\nX9.\n", {R"("number":53,)", R"("column":15)"}},
            {"G98 F9\nG1 A135. R2.\nX80. Z-30. A180.\n", {R"("number":54,)", R"("column":10)"}},
        },
        {});
}

TEST(Frames, MoveWhatIsProgrammed) {
    Play nct;
    nct.language = "nct";
    nct.sets = {"N1300 L1=2"};
    expect_rows(
        {
            {"G94 F9\nG51.1 X10.\nG1 X20. Z5.", {R"("pos":{"X":0,"Z":5)"}},
            {"G94 F9\nG51.1 X10.\nG50.1\nG1 X20. Z5.", {R"("pos":{"X":20,"Z":5)"}},
            {"G94 F9\nG51 X0 Z0 P2.\nG1 X20. Z10.", {R"("pos":{"X":40,"Z":20)"}},
            {"G94 F9\nG68 X0 Z0 R90.\nG1 X0 Z10.", {R"("pos":{"X":20,"Z":0)"}},  // from +Z to +X
            {"G94 F9\nG68 X0 Z0 R90.\nG69\nG1 X0 Z10.", {R"("pos":{"X":0,"Z":10)"}},
            {"G94 F9\nG16\nG1 Z10. X90.", {R"("pos":{"X":20,"Z":0)"}},
        },
        nct);
    expect_rows(
        {
            {"G98 F9\nG68\nG1 X20.", {R"("pos":{"X":-20)"}},
            {"G68\n#100=#3007", {R"("name":"#100","value":1)"}},
        },
        {});
}

TEST(BAxisProgram, RunsWhereItsCodeStartsIt) {
    Play how;
    how.sets = {"N0002 A7=1",  "N0100 A7=66", "N0106 A7=2",
                "F8251 L1=51", "F8240 L1=64", "F8257 L1=20"};
    expect_rows(
        {
            {"G101\nG1 B40. F200\nG100\nM51", {R"("line":4)", R"("B":40})"}},
            {"G110 G1 B60. F150", {R"("B":60})", R"("value":150)"}},
            {"G101\nG81 B5.\nG100", {R"("number":5036)", R"("line":2)"}},
            {"G110 G81 R1. B2.", {R"("number":5034)"}},
            {"G101\nG2 B5.\nG100", {R"("number":10,)"}},
        },
        how);
    EXPECT_FALSE(play("G101\nG1 B40. F200\nG100\nM30", how).has({R"("ev":"move")"}));
}

TEST(Print, WritesSignDigitsAndPoint) {
    expect_rows(
        {
            {"POPEN\n#1=-91.2\nDPRNT[Y#1[53]]", {R"("text":"Y-   91.200")"}},
            {"POPEN\n#1=128.47398\nDPRNT[X#1[53]*T#2[20]]", {R"("text":"X   128.474 T  0")"}},
            {"POPEN\n#1=1234567\nDPRNT[X#1[40]]", {R"("text":"X 4567")"}},
            {"DPRNT[X]", {"PT1079"}},
            {"POPEN\nDPRNT[X#1[63]]", {"PT1080"}},
            {"G65 H91 P2 Q066079 R076084", {R"("text":"pattern 2: BOLT")"}},
        },
        {});
    Play compact;
    compact.sets = {"F6001#1=1"};
    expect_rows({{"POPEN\n#1=12.5\nDPRNT[X#1[53]]", {R"("text":"X12.500")"}}}, compact);
}

TEST(Loops, MustNest) {
    expect_rows(
        {
            {"DO1\nDO2\nEND1\nEND2", {R"("number":124,)", R"("line":3)"}},
            {"DO1\nDO2", {R"("number":124,)", R"("line":1)"}},
            {"#1=0\nWHILE[#1 LT 2]DO1\nDO2\n#1=#1+1\nIF[#1 GT 0]THEN GOTO 5\n"
             "END2\nN5\nEND1\n#100=#1",
             {R"("name":"#100","value":2)"}},
        },
        {});
}

}  // namespace
}  // namespace polyturn::channels::testing
