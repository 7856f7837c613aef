// Spindles that are closed by the PLC, released axes, lines from texts, interrupts: what golden
// logs cannot show.
#include <gtest/gtest.h>

#include <algorithm>

#include "../play.hpp"
#include "../quiet_sink.hpp"

namespace polyturn::channels::testing {
namespace {

Played run(const std::string& program) {
    Play how;
    how.language = "sinumerik";
    return play(program, how);
}

std::size_t count(const Played& played, const std::string& part) {
    std::size_t found = 0;
    for (const std::string& line : played.lines()) found += line.find(part) != std::string::npos;
    return found;
}

TEST(SinumerikSpindles, PositioningTellsThePlcButNotTheOperator) {
    const Played played = run("SPOS=90\nSPOS=IC(20)\nM3 S100\nM30\n");
    EXPECT_EQ(played.errors, 0u) << played.events;
    EXPECT_EQ(count(played, "\"mode\":\"position\""), 2u) << played.events;
    EXPECT_EQ(count(played, "M19"), 0u) << played.events;
}

TEST(SinumerikSpindles, CuttingSpeedOfAToolFollowsTheTool) {
    const Played played =
        run("$TC_DP6[1,1]=5\n$TC_DP6[2,1]=10\nT1 D1\n"
            "SVC=100 M3\nT2 D1\nR1=$P_SVC[1]\nS500\nR2=$P_S_TYPE[1]\n"
            "M30\n");
    EXPECT_EQ(played.errors, 0u) << played.events;
    EXPECT_EQ(count(played, "\"value\":3183.098862"), 1u) << played.events;  // 100000 / (2 pi 5)
    EXPECT_EQ(count(played, "\"value\":1591.549431"), 1u) << played.events;
    EXPECT_EQ(count(played, "\"name\":\"R1\",\"value\":100"), 1u) << played.events;
    EXPECT_EQ(count(played, "\"name\":\"R2\",\"value\":1"), 1u) << played.events;
}

// What the specification gives a range: MSG and WRTPR in the next block or in their own (part 2,
// 15.1), the distance of DILF (10.10.4).
TEST(SinumerikSpindles, ValuesOutOfRangeAreRefused) {
    EXPECT_EQ(run("MSG(\"A\",0)\nMSG(\"B\",1)\nWRTPR(\"C\",1)\nDILF=2\nM30\n").errors, 0u);
    for (const char* bad : {"MSG(\"A\",2)", "WRTPR(\"A\",-1)", "DILF=-1"})
        EXPECT_EQ(run(std::string(bad) + "\nM30\n").errors, 1u) << bad;
}

// A spindle turns one way in a block; a tool has at most 12 edges (part 1, 6.6); G58 and G59 shift
// geometry axes (part 2, 13.4); markers are 0 to 99 (part 2, 17.1b).
TEST(SinumerikSpindles, WhatContradictsItselfIsRefused) {
    for (const char* bad :
         {"M3 M4 S100", "S100 M3 M5", "M1=4 M3 S100", "$TC_DP1[1,13]=500", "R1=$TC_DP1[1,13]",
          "G58 C5", "G59 C5", "SETM(100)", "CLEARM(-1)", "SETM(1.5)"})
        EXPECT_EQ(run(std::string(bad) + "\nM30\n").errors, 1u) << bad;
    for (const char* good :
         {"M3 M3 S100", "$TC_DP1[1,12]=500", "G58 X5", "G59 Z5", "SETM(0,10,99)", "CLEARM(99)"}) {
        const Played played = run(std::string(good) + "\nM30\n");
        EXPECT_EQ(played.errors, 0u) << good << played.events;
    }
}

// What the machine is told of its spindles, that no event shows.
struct ToldSpindles final : QuietSink {
    std::vector<double> feeds;  // of positions, 1/min
    std::vector<std::string> functions;
    void spindle(const Spindle& s, const BlockContext&) override {
        if (s.mode == SpindleModeCode::Position && !s.silent) feeds.push_back(s.feed_rpm);
    }
    void aux(const Aux& a, const BlockContext&) override { functions.emplace_back(a.text); }
};

ToldSpindles told_of(std::string_view program) {
    const auto table = lathe({"N0607 S2=7"});
    MachineView view = make_machine_view(*table, 1);
    ProgramFiles files;
    ToldSpindles told;
    const text::Setup setup;
    CheckPort port(setup, 1, true);
    const auto main = files.open_text(program, "test.nc");
    const auto language = make_language("sinumerik", view, told, port, files);
    EXPECT_TRUE(language->start(*main).ok());
    language->core().start_at_machine(view.start);
    run_to_end(*language);
    return told;
}

// FA[Sn], FA[SPI(n)] (part 1, 8.4 and 8.5): modal, of the spindle that is named, also where the
// position stands before it in the block.
TEST(SinumerikSpindles, ArePositionedWithTheirFeed) {
    EXPECT_EQ(
        told_of(
            "SPOS=10\nFA[S1]=3600\nSPOS=20\nSPOSA=30 FA[SPI(1)]=720\nWAITS\nM19\nSPOS[2]=5\nM30\n")
            .feeds,
        (std::vector<double>{0, 10, 2, 2, 0}));
    EXPECT_EQ(run("FA[S9]=100\nM30\n").errors, 1u);
}

TEST(SinumerikSpindles, HaveFourLimitsInABlock) {  // part 1, 7.3
    Play how;
    how.language = "sinumerik";
    how.sets = {"N0607 S2=7", "N0607 S3=7", "N0607 S4=7", "N0607 S5=7"};
    EXPECT_EQ(play("LIMS=100 LIMS[2]=3 LIMS[3]=4 LIMS[4]=5\nM30\n", how).errors, 0u);
    EXPECT_EQ(count(play("LIMS=100 LIMS[2]=3 LIMS[3]=4 LIMS[4]=5 LIMS[5]=6\nM30\n", how),
                    "\"number\":14750"),
              1u);
}

// part 3, 7.18: the PLC's direction goes with it
TEST(SinumerikSpindles, StopsWhatIsUncoupledWithStop) {
    const auto told =
        told_of("S2=300 M2=3\nCOUPDEF(S2,S1,1,1)\nCOUPON(S2,S1)\nCOUPOFS(S2,S1)\nM30\n").functions;
    EXPECT_EQ(std::count(told.begin(), told.end(), "M5"), 1);
}

// Without tool management T0 deselects the tool at once, also where M6 changes tools (part 1, 5.1).
TEST(SinumerikTools, AreDeselectedByT0WhereM6ChangesThem) {
    Play how;
    how.language = "sinumerik";
    how.sets = {"MD22550=1"};
    const Played played = play(
        "G18\n$TC_DP1[1,1]=500\n$TC_DP4[1,1]=10\n"
        "T1\nM6\nG0 X0 Z0\nT0\nG0 Z1\nM6\nG0 Z2\n"
        "T1\nG0 Z3\nM6\nG0 Z4\nM30\n",
        how);
    EXPECT_EQ(played.errors, 0u) << played.events;
    const auto at = [&](int z, int machine) {
        return played.has({"\"pos\":{\"X\":0,\"Z\":" + std::to_string(z) + ",",
                           "\"machine\":{\"X\":0,\"Z\":" + std::to_string(machine)});
    };
    EXPECT_TRUE(at(0, 10) && at(1, 1) && at(2, 2) && at(3, 3) && at(4, 14)) << played.events;
}

// MD21020: the radius counts, in the area of the workpiece as in the basic one (part 2, 15.3.1 and
// 15.3.2).
TEST(SinumerikAreas, CountTheRadiusWhereTheMachineDataSaySo) {
    const std::string tool = "$TC_DP1[1,1]=500 $TC_DP2[1,1]=3 $TC_DP6[1,1]=0.8\nT1 D1\n";
    const std::string area =
        "$P_WORKAREA_CS_COORD_SYSTEM[0]=1\n$P_WORKAREA_CS_MINUS_ENABLE[0,Z]=TRUE\n"
        "$P_WORKAREA_CS_LIMIT_MINUS[0,Z]=-10\nWALCS1\n";
    Play how;
    how.language = "sinumerik";
    EXPECT_EQ(play(tool + area + "G0 Z-9.5\nM30\n", how).errors, 0u);
    how.sets = {"MD21020=1"};
    EXPECT_EQ(play(tool + area + "G0 Z-9.5\nM30\n", how).errors, 1u);
    EXPECT_EQ(play(tool + area + "G0 Z-9.1\nM30\n", how).errors, 0u);
}

// The machine and setting data of the specification (part 2, 18.1) and the variables of overlaid
// motions (13.11).
TEST(SinumerikVariables, NameTheConfiguration) {
    const std::pair<const char*, const char*> numbers[] = {
        {"$MN_IPO_CYCLE_TIME*0", "0"},
        {"$MN_MM_MAX_CUTTING_EDGE_PERTOOL", "12"},
        {"$MC_AXCONF_MACHAX_USED[1]", "2"},
        {"$MC_AXCONF_MACHAX_USED[2]", "5"},
        {"$MC_AXCONF_MACHAX_USED[9]", "0"},
        {"$MC_AXCONF_GEOAX_ASSIGN_TAB[0]", "1"},
        {"$MC_AXCONF_GEOAX_ASSIGN_TAB[1]", "0"},
        {"$MC_AXCONF_GEOAX_ASSIGN_TAB[2]", "2"},
        {"$MA_AUTO_GET_TYPE[Z]", "0"},
        {"$AA_OFF[X]", "0"},
        {"$AA_OFF_VAL[Z]", "0"},
        {"$MC_INVOLUTE_RADIUS_DELTA>0", "1"},
        {"$MC_MM_SYSTEM_FRAME_MASK>=0", "1"}};
    for (const auto& [name, value] : numbers) {
        const Played played = run("R1=" + std::string(name) + "\nM30\n");
        EXPECT_EQ(count(played, "\"name\":\"R1\",\"value\":" + std::string(value) + "}"), 1u)
            << name << played.events;
    }
    const std::pair<const char*, const char*> texts[] = {
        {"$MN_AXCONF_MACHAX_NAME_TAB[0]", "X1"}, {"$MN_AXCONF_MACHAX_NAME_TAB[2]", "AX3"},
        {"$MC_AXCONF_CHANAX_NAME_TAB[1]", "Z"},  {"$MC_AXCONF_GEOAX_NAME_TAB[2]", "Z"},
        {"$MC_AXCONF_GEOAX_NAME_TAB[1]", ""},    {"$MN_CONTOUR_DEF_ANGLE_NAME", "ANG"}};
    for (const auto& [name, text] : texts) {
        const Played played = run("MSG(\"\"<<" + std::string(name) + "<<\"!\")\nM30\n");
        EXPECT_EQ(count(played, "\"text\":\"" + std::string(text) + "!\""), 1u)
            << name << played.events;
    }
    for (const char* bad : {"$MN_IPO_CYCLE_TIME=1", "$MC_AXCONF_MACHAX_USED[0]=1"})
        EXPECT_EQ(count(run(std::string(bad) + "\nM30\n"), "\"number\":12490"), 1u) << bad;
    EXPECT_EQ(count(run("R1=$AA_LEAD_SP[Z]\nM30\n"), "\"number\":12140"), 1u)
        << "named by the specification, not built";
}

TEST(SinumerikVariables, WholeNumbersHave32Bits) {
    for (const char* bad : {"DEF INT AA=2147483648", "DEF INT AA=2147483647\nAA=AA+1",
                            "DEF INT AA=-2147483648\nAA=AA-1"}) {
        const Played played = run(std::string(bad) + "\nM30\n");
        EXPECT_EQ(count(played, "\"number\":12240"), 1u) << bad << played.events;
    }
    EXPECT_EQ(run("DEF INT AA=2147483647\nDEF INT BB=-2147483648\nM30\n").errors, 0u);
}

TEST(SinumerikAxes, AReleasedAxisMovesAfterGetOnly) {
    EXPECT_EQ(run("RELEASE(Z)\nG0 X5\nGET(Z)\nG0 Z5\nM30\n").errors, 0u);
    const Played refused = run("RELEASE(Z)\nG0 Z5\nM30\n");
    EXPECT_EQ(count(refused, "is released"), 1u) << refused.events;
}

// MD30552 (sinumerik_part3 7.14): the axis comes back by being named.
TEST(SinumerikAxes, AReleasedAxisMayComeBackByItself) {
    Play how;
    how.language = "sinumerik";
    how.sets = {"MD30552 A2=1"};
    const Played played = play("RELEASE(Z)\nG0 Z5\nRELEASE(Z)\nPOS[Z]=7\nM30\n", how);
    EXPECT_EQ(played.errors, 0u) << played.events;
    EXPECT_EQ(count(played, "\"ev\":\"move\""), 2u) << played.events;
    EXPECT_EQ(count(play("RELEASE(X)\nG0 X5\nM30\n", how), "is released"), 1u);
}

// PRESETON (7.1): where the axis stands is called by that value from now on, also by $AA_IM, and
// also when it is called again.
TEST(SinumerikAxes, APresetAxisIsWhereTheProgramSays) {
    const Played played =
        run("G0 Z10\nPRESETON(Z,100)\nPRESETON(Z,100)\n"
            "R1=$AA_IM[Z] R2=$AA_IW[Z]\nG0 Z=IC(5)\nR3=$AA_IM[Z]\n"
            "M30\n");
    EXPECT_EQ(played.errors, 0u) << played.events;
    EXPECT_EQ(count(played, "\"name\":\"R1\",\"value\":100}"), 1u) << played.events;
    EXPECT_EQ(count(played, "\"name\":\"R2\",\"value\":100}"), 1u) << played.events;
    EXPECT_EQ(count(played, "\"name\":\"R3\",\"value\":105}"), 1u) << played.events;
}

// A lathe has no second geometry axis: to take it away changes nothing (7.2).
TEST(SinumerikAxes, GeometryAxesAreThoseOfTheMachine) {
    EXPECT_EQ(run("GEOAX()\nGEOAX(1,X,3,Z)\nGEOAX(2,0)\nM30\n").errors, 0u);
    for (const char* bad : {"GEOAX(1,0)", "GEOAX(1,Z)", "GEOAX(4,X)", "GEOAX(1)"})
        EXPECT_EQ(run(std::string(bad) + "\nM30\n").errors, 1u) << bad;
}

// IP[axis] is I, J or K (3, 5.2).
TEST(SinumerikAxes, InterpolationParametersByAVariable) {
    const Played played =
        run("DEF AXIS WHICH=Z\nG18 G90 DIAMOF\nG0 X20 Z0\n"
            "G3 X30 Z-10 IP[X]=0 IP[WHICH]=-10 F100\n"
            "M30\n");
    EXPECT_EQ(played.errors, 0u) << played.events;
    EXPECT_EQ(count(played, "\"radius\":10"), 1u) << played.events;
}

TEST(SinumerikAxes, NoAxisLeadsItself) {
    EXPECT_EQ(run("TRAILON(C,Z)\nTRAILOF(C)\nTRAILON(Z,C)\nM30\n").errors, 0u);
    EXPECT_EQ(run("TRAILON(C,Z)\nTRAILON(Z,C)\nM30\n").errors, 1u);
}

// sinumerik_part3 5.2, 5.3: a modifier that an address does not take is a mistake of syntax.
TEST(SinumerikText, ModifiersStandWhereTheyBelongOnly) {
    for (const char* good : {"X=AC(5)", "C=DC(5)", "X=RIC(1)", "AP=IC(5) RP=AC(3)", "M=QU(8)",
                             "FA[X]=QU(5)", "SPOS=ACP(5)"})
        EXPECT_EQ(run("G18 G111 X0 Z0\nG0 X5 Z5\nG0 " + std::string(good) + "\nM30\n").errors, 0u)
            << good;
    for (const char* bad : {"X=QU(5)", "F=IC(5)", "RND=IC(1)", "CR=AC(5)", "OVR=IC(50)", "FB=AC(1)",
                            "LIMS=AC(100)", "X=PM(5)", "RP=DC(5)"})
        EXPECT_EQ(count(run("G1 " + std::string(bad) + "\nM30\n"), "\"number\":12080"), 1u) << bad;
}

TEST(SinumerikText, ALabelIsNoVariable) {
    EXPECT_EQ(run("DEF INT LAB1\nLAB1: R1=1\nM30\n").errors, 1u);
}

TEST(SinumerikText, ALineFromATextIsReadInThePlaceOfItsBlock) {
    const Played played =
        run("DEF STRING[20] WHAT\nLOOP1: R1=R1+1\nWHAT=\"R2=R2+10\"\n"
            "EXECSTRING(WHAT)\nEXECSTRING(\"IF R1<3 GOTOB LOOP1\")\n"
            "M30\n");
    EXPECT_EQ(played.errors, 0u) << played.events;
    EXPECT_EQ(count(played, "\"name\":\"R2\",\"value\":30"), 1u) << played.events;
}

// Part 2, 13.5: before the plane changes the rotations are taken back by ROT or by ROT X0 Y0 Z0, on
// a lathe without Y too.
TEST(SinumerikFrames, ZeroAnglesAreNoRotation) {
    const Played played = run("G18 DIAMOF\nROT RPL=90\nG0 X5 Z0\nROT X0 Y0 Z0\nG0 X5 Z1\nM30\n");
    EXPECT_EQ(played.errors, 0u) << played.events;
    EXPECT_TRUE(played.has({"\"line\":5", "\"machine\":{\"X\":5,\"Z\":1"})) << played.events;
    EXPECT_EQ(run("G18\nROT X10 Y20\nM30\n").errors, 1u);
}

TEST(SinumerikFrames, PartsOfAFrameVariableAreReadAndWritten) {
    const Played played =
        run("DEF FRAME FRA\nFRA=CTRANS(X,3,Z,12):CMIRROR(X)\n"
            "FRA[Z,TR]=7\nR1=FRA[Z,TR]\nR2=FRA[X,MI]\n"
            "$P_UIFR[2]=FRA\nR3=$P_UIFR[2,X,TR]\nM30\n");
    EXPECT_EQ(played.errors, 0u) << played.events;
    EXPECT_EQ(count(played, "\"name\":\"R1\",\"value\":7"), 1u) << played.events;
    EXPECT_EQ(count(played, "\"name\":\"R2\",\"value\":1"), 1u) << played.events;
    EXPECT_EQ(count(played, "\"name\":\"R3\",\"value\":3"), 1u) << played.events;
}

TEST(SinumerikInterrupts, AnInputNeedsARoutineThatIsThere) {
    EXPECT_EQ(count(run("SETINT(1) PRIO=1 NOWHERE\nM30\n"), "\"severity\":\"error\""), 1u);
    EXPECT_EQ(count(run("SETINT(33) NOWHERE\nM30\n"), "there is no interrupt input 33"), 1u);
}

}  // namespace
}  // namespace polyturn::channels::testing
