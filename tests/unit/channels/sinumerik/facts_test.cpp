// What stands in one sentence of the specification each: facts about variables and files, limits of
// a block, feeds of a corner.
#include <gtest/gtest.h>

#include "../play.hpp"

namespace polyturn::channels::testing {
namespace {

Played run(const std::string& program, std::vector<std::string> sets = {}) {
    Play how;
    how.language = "sinumerik";
    how.sets = std::move(sets);
    return play(program, how);
}

bool sets(const Played& played, const std::string& name, const std::string& value) {
    return played.has({"\"name\":\"" + name + "\",\"value\":" + value + "}"});
}

TEST(SinumerikFacts, OfVariables) {  // part 3, 9.9
    const Played played =
        run("DEF INT LLI -10 ULI 20 II=7\nDEF REAL PHU 12 AZZ[2]=SET(1.5,2.5)\nDEF REAL LL\nII=8\n"
            "R1=GETVARLIM(\"II\",\"L\",LL)\nR2=LL\nR3=GETVARLIM(\"II\",\"U\",LL)\n"
            "R4=LL\nR5=GETVARDFT(\"II\",LL)\nR6=LL\nR7=GETVARDFT(\"AZZ\",LL,1)\n"
            "R8=LL\n"
            "R9=GETVARPHU(\"AZZ\")\nR10=GETVARTYP(\"NOTHING\")\n"
            "R11=GETVARLIM(\"NOTHING\",\"L\",LL)\nR12=GETVARAP(\"II\",\"WP\")\n"
            "M30\n");
    EXPECT_EQ(played.errors, 0u) << played.events;
    const std::pair<const char*, const char*> rows[] = {
        {"R1", "1"},   {"R2", "-10"}, {"R3", "1"},   {"R4", "20"},  {"R5", "1"}, {"R6", "7"},
        {"R8", "2.5"}, {"R9", "12"},  {"R10", "-1"}, {"R11", "-1"}, {"R12", "7"}};
    for (const auto& [name, value] : rows)
        EXPECT_TRUE(sets(played, name, value)) << name << '\n' << played.events;
}

TEST(SinumerikFacts, OfFiles) {  // part 3, 7.16
    const Played played =
        run("DEF INT ERR\nDEF STRING[32] TT\nDEF STRING[3] SHORT\n"
            "WRITE(ERR,\"LOG\",\"ABC\")\nFILEDATE(ERR,\"LOG\",TT)\n"
            "R4=STRLEN(TT) R5=INDEX(TT,\".\") R6=RINDEX(TT,\".\")\n"
            "FILETIME(ERR,\"LOG\",TT)\nR7=STRLEN(TT) R8=INDEX(TT,\".\") R9=RINDEX(TT,\".\")\n"
            "FILEINFO(ERR,\"LOG\",TT)\nMSG(TT)\nR1=STRLEN(TT)\n"
            "FILESTAT(ERR,\"NOFILE\",TT)\nR2=ERR\nFILEDATE(ERR,\"LOG\",SHORT)\n"
            "R3=ERR\nM30\n");
    EXPECT_EQ(played.errors, 0u) << played.events;
    EXPECT_TRUE(played.has({"message", "77777        4 "})) << played.events;
    const std::pair<const char*, const char*> rows[] = {{"R1", "32"}, {"R2", "3"}, {"R3", "22"},
                                                        {"R4", "8"},  {"R5", "2"}, {"R6", "5"},
                                                        {"R7", "8"},  {"R8", "2"}, {"R9", "5"}};
    for (const auto& [name, value] : rows)
        EXPECT_TRUE(sets(played, name, value)) << name << '\n' << played.events;
}

TEST(SinumerikFacts, OfToolEnvironments) {  // part 3, 9.5
    Play how;
    how.language = "sinumerik";
    how.sets = {"MD22550=0"};
    for (const int tool : {1, 2})
        how.setup.tools[tool] = {
            "T" + std::to_string(tool),
            {{1, {{"DP1", 500.0}, {"DP2", 9.0}}}, {2, {{"DP1", 500.0}, {"DP2", 9.0}}}}};
    const Played played = play(
        "DEF INT TT[3]\nT2 D2\nR1=TOOLENV(\"ROUGH\")\n"
        "T1 D1\nR2=GETTENV(\"ROUGH\",TT)\nR3=TT[0] R4=TT[1] R5=TT[2]\n"
        "R6=DELTOOLENV(\"ROUGH\")\nR7=GETTENV(\"ROUGH\",TT)\n"
        "R8=DELTOOLENV()\nM30\n",
        how);
    EXPECT_EQ(played.errors, 0u) << played.events;
    const std::pair<const char*, const char*> rows[] = {{"R1", "0"},  {"R2", "0"}, {"R3", "2"},
                                                        {"R4", "2"},  {"R5", "0"}, {"R6", "0"},
                                                        {"R7", "-1"}, {"R8", "0"}};
    for (const auto& [name, value] : rows)
        EXPECT_TRUE(sets(played, name, value)) << name << '\n' << played.events;
}

// Part 3, 9.1, worked out by hand: measured = shift + turn about Z by 90 degrees of the wanted
// points.
TEST(SinumerikFacts, AFrameFromThreeMeasuredPoints) {
    const std::string head =
        "DEF REAL MM1[3,3]\nDEF REAL WW1[3,3]\nDEF REAL QQ\n"
        "DEF FRAME FF\nWW1[0,0]=SET(0,0,0,10,0,0,0,0,30)\n";
    const Played shifted = run(head +
                               "MM1[0,0]=SET(5,0,7,15,0,7,5,0,37.3)\nFF=MEAFRAME(MM1,WW1,QQ)\n"
                               "R1=FF[X,TR] R2=FF[Z,TR] R3=FF[X,SC] R4=QQ\n"
                               "M30\n");
    EXPECT_EQ(shifted.errors, 0u) << shifted.events;
    // the third point 0.3 too far: 0.2 of it left there
    EXPECT_TRUE(sets(shifted, "R1", "5") && sets(shifted, "R2", "7.1") &&
                sets(shifted, "R3", "1") && sets(shifted, "R4", "0.2"))
        << shifted.events;
    Play mill;
    mill.language = "sinumerik";
    mill.sets = {"N0002 A6=1", "N0100 A6=89", "N0103 A6=2"};
    const Played turned =
        play(head +
                 "WW1[2,1]=20 WW1[2,2]=0\nMM1[0,0]=SET(5,6,7,5,16,7,-15,6,7)\n"
                 "FF=MEAFRAME(MM1,WW1,QQ)\nR1=FF[X,TR] R2=FF[Y,TR] R3=FF[Z,TR] R4=FF[Z,RT] "
                 "R5=ROUND(QQ*1000000)\n"
                 "M30\n",
             mill);
    EXPECT_EQ(turned.errors, 0u) << turned.events;
    for (const auto& [name, value] :
         {std::pair{"R1", "5"}, {"R2", "6"}, {"R3", "7"}, {"R4", "90"}, {"R5", "0"}})
        EXPECT_TRUE(sets(turned, name, value)) << name << '\n' << turned.events;
    // on one line
    EXPECT_GT(
        run(head + "MM1[0,0]=SET(0,0,0,10,0,0,20,0,0)\nFF=MEAFRAME(MM1,WW1,QQ)\nM30\n").errors, 0u);
}

Play with_sisters() {  // T1 and T2 are ROUGH/1 and /2, T3 is alone
    Play how;
    how.language = "sinumerik";
    how.sets = {"MD22550=0"};
    for (const int tool : {1, 2, 3})
        how.setup.tools[tool] = {tool < 3 ? "ROUGH" : "DRILL",
                                 {{1, {{"DP1", 500.0}, {"DP3", 10.0 * tool}}},
                                  {2, {{"DP1", 500.0}, {"DP3", 10.0 * tool + 1}}}}};
    return how;
}

TEST(SinumerikFacts, AnEdgeIsCalledByItsDNumber) {  // part 1, 6.6; part 3, 7.17, 9.5
    const Played played = play(
        "DEF INT TN\nR1=SETDNO(1,2,20) R2=GETDNO(1,2) R3=GETDNO(1,1)\n"
        "R4=SETDNO(1,1,20) R5=SETDNO(9,1,5) R6=SETDNO(1,3,5)\n"
        "R7=GETACTTD(TN,20)\nR8=TN\nR9=GETACTTD(TN,2)\n"
        "R10=TN\nR11=GETACTTD(TN,77)\n"
        "R12=CHKDNO(1,2) R13=CHKDNO(1,2,20) R14=CHKDNO(1,2,1)\n"
        "SETDNO(2,1,30)\nSETDNO(2,2,31)\nR15=CHKDNO(1,2) R16=CHKDNO() R17=CHKDNO(1,9)\n"
        "T1 D20\nR18=$P_TOOL R19=$P_TOOLL[1]\nM30\n",
        with_sisters());
    EXPECT_EQ(played.errors, 0u) << played.events;
    const std::pair<const char*, const char*> rows[] = {
        {"R1", "1"},   {"R2", "20"}, {"R3", "1"},   {"R4", "0"},  {"R5", "0"},
        {"R6", "0"},   {"R7", "0"},  {"R8", "1"},   {"R9", "-2"}, {"R10", "2"},
        {"R11", "-1"}, {"R12", "0"}, {"R13", "1"},  {"R14", "0"}, {"R15", "1"},
        {"R16", "0"},  {"R17", "0"}, {"R18", "20"}, {"R19", "11"}};
    for (const auto& [name, value] : rows)
        EXPECT_TRUE(sets(played, name, value)) << name << '\n' << played.events;
    EXPECT_TRUE(play("SETDNO(1,2,20)\nT1 D2\nM30\n", with_sisters()).has({"\"number\":17180"}));
    EXPECT_TRUE(play("DZERO\nT1 D1\nM30\n", with_sisters()).has({"\"number\":17180"}));
    EXPECT_EQ(play("DZERO\nSETDNO(1,1,1)\nT1 D1\nM30\n", with_sisters()).errors, 0u);
}

TEST(SinumerikFacts, ToolsOfOneNameAreAGroup) {  // part 3, 7.17, 9.5
    const Played played = play(
        "DEF INT TN\nR1=TOOLGNT(\"ROUGH\") R2=TOOLGNT(\"rough\") R3=TOOLGT(\"ROUGH\",2) "
        "R4=TOOLGT(\"ROUGH\",3)\n"
        "R5=GETT(\"ROUGH\",2) R6=GETT(\"ROUGH\",3)\n"
        "R7=GETACTT(TN,\"ROUGH\")\nR8=TN\nTCA(\"ROUGH\",2)\n"
        "R9=$P_TOOLNO\nR10=GETACTT(TN,\"ROUGH\")\n"
        "R11=TN\nR12=GETACTT(TN,\"NONE\")\nTML(3)\n"
        "R13=$P_TOOLNO\n"
        "R14=NEWT(\"DRILL\")\nR15=TOOLGNT(\"DRILL\") R16=GETT(\"DRILL\",2)\n"
        "DELT(\"DRILL\",2)\nR17=TOOLGNT(\"DRILL\")\n"
        "$TC_SCP13[1,1]=5 $TC_ECP13[1,2]=6\nR18=DELDL(1,1)\n"
        "R19=$TC_SCP13[1,1] R20=$TC_ECP13[1,2]\nR21=DELDL(1) R22=$TC_ECP13[1,2] R23=DELDL(1,7)\n"
        "M30\n",
        with_sisters());
    EXPECT_EQ(played.errors, 0u) << played.events;
    const std::pair<const char*, const char*> rows[] = {
        {"R1", "2"},  {"R2", "0"},  {"R3", "2"},  {"R4", "0"},  {"R5", "2"},  {"R6", "-1"},
        {"R7", "0"},  {"R8", "1"},  {"R9", "2"},  {"R10", "0"}, {"R11", "2"}, {"R12", "-1"},
        {"R13", "3"}, {"R14", "4"}, {"R15", "2"}, {"R16", "4"}, {"R17", "1"}, {"R18", "0"},
        {"R19", "0"}, {"R20", "6"}, {"R21", "0"}, {"R22", "0"}, {"R23", "-1"}};
    for (const auto& [name, value] : rows)
        EXPECT_TRUE(sets(played, name, value)) << name << '\n' << played.events;
    EXPECT_TRUE(play("TCA(\"ROUGH\",3)\nM30\n", with_sisters()).has({"\"number\":17190"}));
}

TEST(SinumerikFacts, ABlockHasTenAuxiliaryFunctionsAtTheMost) {  // part 2, 14
    EXPECT_EQ(run("M10 M11 M12 M13 M14 H1 H2 H3 S1=100 D0\nM30\n").errors, 0u);
    EXPECT_TRUE(
        run("M10 M11 M12 M13 M14 H1 H2 H3 S1=100 S2=100 D0\nM30\n").has({"\"number\":14750"}))
        << run("M10 M11 M12 M13 M14 H1 H2 H3 S1=100 S2=100 D0\nM30\n").events;
}

TEST(SinumerikFacts, FbHoldsForTheCornerOfItsBlock) {  // part 1, 8.11
    const std::string program = "G18 G90 G94 DIAMOF G0 X0 Z0\nF100\nG1 X5 FB=20 CHR=1\nZ5\nM30\n";
    for (const char* const mask : {"MD20201=0", "MD20201=1"})
        EXPECT_TRUE(run(program, {mask}).has({"\"pos\":{\"X\":5,\"Z\":1", "\"value\":20}"}))
            << mask << run(program, {mask}).events;
    EXPECT_TRUE(run("G18 G90 G94 DIAMOF G0 X0 Z0\nF100 FRCM=7\nG1 X5 FB=20 CHR=1\nZ5\nM30\n")
                    .has({"\"pos\":{\"X\":5,\"Z\":1", "\"value\":7}"}));
}

TEST(SinumerikFacts, ASecondLineOfNoLengthMovesPerpendicularlyOnly) {  // part 2, 10.9.5
    const Played played =
        run("G18 G90 G94 DIAMOF G0 X10 Z20\nF100\nG1 ANG=30\nANG=60 C45\nX12\nM30\n");
    EXPECT_EQ(played.errors, 0u) << played.events;
    EXPECT_TRUE(played.has({"\"pos\":{\"X\":10,\"Z\":20,\"C\":45}"})) << played.events;
}

TEST(SinumerikFacts, AddframeAddsCoarsely) {  // part 3, 9.1
    const Played played =
        run("$P_PFRAME=CTRANS(X,5)\nR1=ADDFRAME(CTRANS(X,3),\"$P_PFRAME\")\n"
            "R2=$P_PFRAME[X,TR]\nR3=$P_PFRAME[X,FI]\n"
            "M30\n");
    EXPECT_TRUE(sets(played, "R1", "0") && sets(played, "R2", "8") && sets(played, "R3", "0"))
        << played.events;
}

// Two factors make an ellipse of a circle (part 2, 13.7); without a radius it is neither.
TEST(SinumerikFacts, AnArcWithoutRadiusIsRefusedInEveryFrame) {
    for (const char* frame : {"", "SCALE X2 Y1\n"})
        for (const char* words : {"G2 X10 Y0 I0 J0", "G3 I0 J0"}) {
            const Played played = run("G17 G90 G94 G0 X0 Y0 Z0 F1000\n" + std::string(frame) +
                                          "G0 X10 Y0\n" + words + "\nM30\n",
                                      {"N0002 A6=1", "N0100 A6=89", "N0103 A6=2"});
            EXPECT_EQ(played.errors, 1u) << frame << words << played.events;
            EXPECT_TRUE(played.has({"\"number\":14040"})) << frame << words << played.events;
        }
}

// part 2, 11.4.1: tool radius 4, left of a contour towards -X
TEST(SinumerikFacts, TheApproachTellsItsPointsOnTheCompensatedPath) {
    Play how;
    how.language = "sinumerik";
    how.sets = {"MD22550=0", "N0002 A16=1", "N0100 A16=89", "N0103 A16=2"};
    how.setup.tools[1] = {"MILL", {{1, {{"DP1", 120.0}, {"DP6", 4.0}}}}};
    const std::string approach =
        "G17 G90 G94 DIAMOF G0 X60 Y40 Z10 T1 D1\nG41 F100 G341 DISR=6 DISCL=2 X50 Y0 Z-3 ";
    const Played semicircle =
        play(approach +
                 "G347\nG1 X10\nR1=$P_APR[X] R2=$P_APR[Y] R3=$P_AEP[X] R4=$P_AEP[Y]\nG40 X0\nM30\n",
             how);
    EXPECT_TRUE(sets(semicircle, "R1", "50") && sets(semicircle, "R2", "-16") &&
                sets(semicircle, "R3", "50") && sets(semicircle, "R4", "-4"))
        << semicircle.events;
    const Played line =
        play(approach + "G147\nG1 X10\nR1=$P_APR[X] R2=$P_APR[Y]\nG40 X0\nM30\n", how);
    EXPECT_TRUE(sets(line, "R1", "60") && sets(line, "R2", "-4")) << line.events;
}

TEST(SinumerikFacts, MeasIsAMoveThatTheProbeEnds) {  // part 3, 5.3
    const Played played =
        run("G18 G90 G94 DIAMOF G0 X50 Z20\nG1 F150 MEAS=1 X20\n"
            "R1=$AA_MW[X] R2=$AC_MEA[1]\nZ10\nMEAS=3 X5\n"
            "M30\n");
    EXPECT_TRUE(played.has({"\"kind\":\"skip\"", "\"pos\":{\"X\":20,", "\"value\":150}"}))
        << played.events;
    // no signal: it came to its end
    EXPECT_TRUE(sets(played, "R1", "20") && sets(played, "R2", "0")) << played.events;
    EXPECT_TRUE(played.has({"alarm", "MEAS"})) << played.events;
}

}  // namespace
}  // namespace polyturn::channels::testing
