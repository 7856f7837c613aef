// Control structures, jumps, subprograms, and coming back to earlier blocks.
#include <gtest/gtest.h>

#include <cstdlib>
#include <filesystem>
#include <fstream>

#include "../resume_rig.hpp"

namespace polyturn::channels::testing {
namespace {

// Subprogram files in a folder of their own.
class Files {
public:
    Files() {
        std::string pattern =
            (std::filesystem::temp_directory_path() / "sinumerik_flow_XXXXXX").string();
        folder_ = ::mkdtemp(pattern.data());
    }
    ~Files() { std::filesystem::remove_all(folder_); }
    void add(const std::string& name, const std::string& text) {
        std::ofstream(folder_ / name) << text;
        setup.subprograms.push_back((folder_ / name).string());
    }
    text::ChannelSetup setup;

private:
    std::filesystem::path folder_;
};

Played run(const std::string& program, const text::ChannelSetup& setup = {}) {
    Play how;
    how.language = "sinumerik";
    how.setup = setup;
    return play(program, how);
}

std::string last_value(const Played& played, const std::string& name) {
    std::string value = "none";
    for (const std::string& line : played.lines()) {
        const std::string key = "\"name\":\"" + name + "\",\"value\":";
        if (const auto at = line.find(key); at != std::string::npos)
            value = line.substr(at + key.size(), line.size() - at - key.size() - 1);
    }
    return value;
}

TEST(SinumerikFlow, StructuresNestAndJumpsLeaveThem) {
    const Played played = run(
        "DEF INT II, KK\nFOR II=1 TO 3\nKK=0\nWHILE TRUE\n"
        "KK=KK+1\nIF KK>II\nGOTOF NEXT\nELSE\nR1=R1+1\n"
        "ENDIF\nENDWHILE\nNEXT: R2=R2+10\nENDFOR\n"
        "REPEAT\nR3=R3+1\nUNTIL R3==4\nLOOP\nR4=R4+1\n"
        "IF R4==5 GOTOF OUT\nENDLOOP\nOUT: CASE R4 OF 4 GOTOF BAD 5 GOTOF GOOD DEFAULT GOTOF BAD\n"
        "BAD: R5=1\nGOOD: R6=1\nGOTOC NOWHERE\nM30\n");
    EXPECT_EQ(played.errors, 0u) << played.events;
    EXPECT_EQ(last_value(played, "R1"), "6");
    EXPECT_EQ(last_value(played, "R2"), "30");
    EXPECT_EQ(last_value(played, "R3"), "4");
    EXPECT_EQ(last_value(played, "R4"), "5");
    EXPECT_EQ(last_value(played, "R5"), "none");
    EXPECT_EQ(last_value(played, "R6"), "1");
}

TEST(SinumerikFlow, SectionsRepeat) {
    const Played played =
        run("AA: R1=R1+1\nBB: R2=R2+1\nENDLABEL:\nREPEAT AA P=2\n"
            "REPEAT AA BB\nREPEATB BB P3\nGOTOF DONE\n"
            "DONE: REPEAT CC\nGOTOF EXX\nCC: R3=R3+1\n"
            "ENDLABEL:\nEXX: CALL BLOCK AA TO BB\nM30\n");
    EXPECT_EQ(played.errors, 0u) << played.events;
    EXPECT_EQ(last_value(played, "R1"), "5");
    EXPECT_EQ(last_value(played, "R2"), "8");
    EXPECT_EQ(last_value(played, "R3"), "1");
}

// part 3, SAVE: modal G commands and the programmable frame are the caller's again; without SAVE
// the frame stays.
TEST(SinumerikFlow, SaveGivesTheCallersFrameBack) {
    for (const bool saved : {false, true}) {
        Files files;
        files.add("MOVED.SPF", std::string("PROC MOVED()") + (saved ? " SAVE" : "") +
                                   "\nATRANS Z10\nG0 Z1\nRET\n");
        const Played played = run("G90\nTRANS Z100\nMOVED\nG0 Z2\nM30\n", files.setup);
        EXPECT_EQ(played.errors, 0u) << played.events;
        EXPECT_TRUE(played.has({R"("machine":{"X":0,"Z":111)"})) << played.events;
        EXPECT_TRUE(played.has({saved ? R"("Z":102)" : R"("Z":112)"})) << played.events;
    }
}

TEST(SinumerikFlow, SubprogramsTakeValuesAndReferencesAndReturnAnywhere) {
    Files files;
    files.add("PARTS.SPF",
              "PROC PARTS(REAL LEN, VAR REAL SUM, INT COUNT=2, STRING[8] KIND) SAVE\n"
              "G91 DIAMOF\nSUM=SUM+LEN*COUNT\nIF KIND==\"BIG\" GOTOF MORE\n"
              "RET\nMORE: SUM=SUM+100\nM17\n");
    files.add("JUMP.SPF", "RET(\"HERE\",1)\n");
    files.add("OUTER.SPF", "INNER\nR7=99\n");
    files.add("INNER.SPF", "RET(,,1)\n");  // past OUTER
    files.add("L020.SPF", "R8=R8+1\nM2\n");
    files.add("TOUCH.SPF", "R9=R9+1\n");
    const Played played =
        run("DEF REAL TOTAL=1\nG90 DIAMON\nPARTS(3,TOTAL)\n"
            "R1=TOTAL\nPARTS(3,TOTAL,,\"BIG\")\nR2=TOTAL R3=$P_GG[14] R4=$P_GG[29]\n"
            "JUMP\nR5=1\nHERE: R5=2\nR6=1\nOUTER\nL020 P3\n"
            "MCALL TOUCH\nG0 X5\nM8\nZ5\nMCALL\nX6\nM30\n",
            files.setup);
    EXPECT_EQ(played.errors, 0u) << played.events;
    EXPECT_EQ(last_value(played, "R1"), "7");
    EXPECT_EQ(last_value(played, "R2"), "113");
    EXPECT_EQ(last_value(played, "R3"), "1");  // SAVE: G90 again
    EXPECT_EQ(last_value(played, "R4"), "2");
    EXPECT_EQ(last_value(played, "R5"), "none");
    EXPECT_EQ(last_value(played, "R6"), "1");
    EXPECT_EQ(last_value(played, "R7"), "none");
    EXPECT_EQ(last_value(played, "R8"), "3");
    EXPECT_EQ(last_value(played, "R9"), "2");
}

// What MCALL calls may move: its own blocks call nothing.
TEST(SinumerikFlow, AModalProgramThatMovesCallsItselfNotAgain) {
    Files files;
    files.add("SUBP.SPF", "G91 G0 Z-1\nG90\nINNER\nM17\n");
    files.add("INNER.SPF", "R1=R1+1\nG0 X30\nM17\n");
    const Played played = run("G0 X10 Z10\nMCALL SUBP\nX20\nX25\nMCALL\nX40\nM30\n", files.setup);
    EXPECT_EQ(played.errors, 0u) << played.events;
    EXPECT_EQ(last_value(played, "R1"), "2");
    EXPECT_TRUE(played.has({R"("line":3)", R"("X":20,"Z":10)"})) << played.events;
    EXPECT_TRUE(played.has({"SUBP.SPF", R"("X":20,"Z":9)"})) << played.events;
    EXPECT_TRUE(played.has({"SUBP.SPF", R"("X":25,"Z":8)"})) << played.events;
    EXPECT_TRUE(played.has({R"("line":6)", R"("X":40,"Z":8)"})) << played.events;
}

// Rows and circles of holes: the program of MCALL runs at each of them.
TEST(SinumerikFlow, AModalProgramRunsAtEachHole) {
    Files files;
    files.add("TOUCH.SPF",
              "R9=R9+1 R8=R8*100+$P_EP[Z]\nR5=0 R6=99\nG91 G0 X1\nG90 X=$P_EP[X]-1\nM17\n");
    files.add("LEAVE.SPF", "R9=R9+1\nRET(\"OUT\")\n");
    files.add("ROW.SPF", "HOLES1(0,0,0,10,20,2)\nM17\n");
    Played played =
        run("G18 G90 DIAMOF\nG0 X0 Z0\nMCALL TOUCH\nR5=10 R6=3\n"
            "HOLES1(0,0,0,R5,20,R6)\nR7=R7+1\nROW\nMCALL\n"
            "HOLES1(0,0,0,70,20,2)\nM30\n",
            files.setup);
    EXPECT_EQ(played.errors, 0u) << played.events;
    EXPECT_EQ(last_value(played, "R9"), "5");
    EXPECT_EQ(last_value(played, "R8"), "1030501030") << "Z 10 30 50, 10 30";
    EXPECT_EQ(last_value(played, "R7"), "1");
    EXPECT_TRUE(played.has({R"("X":0,"Z":90)"})) << played.events;
    played =
        run("G18 G90 DIAMOF\nG0 X0 Z0\nMCALL LEAVE\nHOLES1(0,0,0,10,20,3)\n"
            "R7=1\nOUT: MCALL\nHOLES1(0,0,0,60,20,2)\n"
            "M30\n",
            files.setup);
    EXPECT_EQ(played.errors, 0u) << played.events;
    EXPECT_EQ(last_value(played, "R9"), "1");
    EXPECT_EQ(last_value(played, "R7"), "none");
    EXPECT_TRUE(played.has({R"("Z":60)"})) << played.events;
}

// A main block is named with its colon; of M17 the PLC hears, of RET it does not (sinumerik_part3
// 3, 7.15).
TEST(SinumerikFlow, MainBlocksAreJumpedToAndEndsOfSubprogramsTold) {
    const Played jumped = run("GOTOF :20\nR1=9\n:20 R2=1\nM30\n");
    EXPECT_EQ(jumped.errors, 0u) << jumped.events;
    EXPECT_EQ(last_value(jumped, "R1"), "none");
    EXPECT_EQ(last_value(jumped, "R2"), "1");
    const Played either =
        run("LOOP1: R1=R1+1\nIF R1==1 GOTOB LOOP1 IF R1==2 GOTOF NEXT\n"
            "R2=9\nNEXT: R3=R1\nIF R1==7 GOTOF NEXT IF R1==8 GOTOS\n"
            "R4=1\nM30\n");
    EXPECT_EQ(either.errors, 0u) << either.events;
    EXPECT_EQ(last_value(either, "R2"), "none");
    EXPECT_EQ(last_value(either, "R3"), "2");
    EXPECT_EQ(last_value(either, "R4"), "1");
    Files files;
    files.add("UPM.SPF", "R1=R1+1\nG0 X2 M17\n");
    files.add("UPR.SPF", "R1=R1+1\nRET\n");
    const Played called = run("UPM P2\nUPR\nM30\n", files.setup);
    EXPECT_EQ(called.errors, 0u) << called.events;
    unsigned told = 0;
    for (const std::string& line : called.lines())
        told += line.find("\"code\":\"M17\"") != std::string::npos;
    EXPECT_EQ(told, 2u) << called.events;
}

// A section of another program; variables with their keywords (3: BLOCK, SYNR, INIRE).
TEST(SinumerikFlow, SectionsOfOtherProgramsAreCalled) {
    Files files;
    files.add("PARTS.SPF",
              "PROC PARTS SAVE\nR1=99\nLBA: R2=R2+1\nG91\nLBB: R3=R3+10\nR4=99\nRET\n");
    const Played played =
        run("G90\nDEF CHAN SYNR INT SHARED=4\nDEF INIRE REAL OWN=2\n"
            "FOR R9=1 TO 2\nCALL \"PARTS\" BLOCK LBA TO LBB\n"
            "ENDFOR\nR5=$P_GG[14]\nR6=SHARED+OWN\nM30\n",
            files.setup);
    EXPECT_EQ(played.errors, 0u) << played.events;
    const std::pair<const char*, const char*> rows[] = {{"R1", "none"}, {"R2", "2"}, {"R3", "20"},
                                                        {"R4", "none"}, {"R5", "1"}, {"R6", "6"}};
    for (const auto& [name, value] : rows)
        EXPECT_EQ(last_value(played, name), value) << name << '\n' << played.events;
    EXPECT_EQ(run("CALL \"PARTS\" BLOCK LBB TO LBA\nM30\n", files.setup).errors, 1u);
    EXPECT_EQ(run("CALL \"PARTS\" BLOCK NIX TO LBA\nM30\n", files.setup).errors, 1u);
}

// TEXT[i] is a character; texts and axes are reported as what they are.
TEST(SinumerikFlow, TextsHaveCharactersAndAreReported) {
    const Played played =
        run("DEF STRING[20] TT=\"POLYTURN\"\nDEF STRING[5] UU[2]\n"
            "DEF AXIS AA\nDEF CHAR CC\nTT[0]=\"H\"\nCC=TT[1]\n"
            "UU[1]=\"ABC\"\nUU[1,2]=\"X\"\nR1=TT[7]==\"N\"\n"
            "AA=AXNAME(\"Z\")\nM30\n");
    EXPECT_EQ(played.errors, 0u) << played.events;
    EXPECT_EQ(last_value(played, "TT"), "\"HOLYTURN\"");
    EXPECT_EQ(last_value(played, "UU[1]"), "\"ABX\"");
    EXPECT_EQ(last_value(played, "CC"), "79");
    EXPECT_EQ(last_value(played, "R1"), "1");
    EXPECT_EQ(last_value(played, "AA"), "\"Z\"");
    for (const char* bad : {"R1=TT[8]", "TT[8]=\"A\"", "R1=TT[-1]"})
        EXPECT_EQ(run("DEF STRING[20] TT=\"POLYTURN\"\n" + std::string(bad) + "\nM30\n").errors, 1u)
            << bad;
    EXPECT_EQ(run("DEF STRING[255] TT[3]\nM30\n").errors, 0u) << "READ gives that much back";
}

TEST(SinumerikFlow, ALiveValueStopsTheBlockBeforeItHasDoneAnything) {
    const Played played = run("G0 X10 Z5\nR1=R1+1 R2=$AA_IM[Z]\nM30\n");
    EXPECT_EQ(last_value(played, "R1"), "1");
    EXPECT_EQ(last_value(played, "R2"), "5");
}

TEST(SinumerikResume, LeadsToTheSameEventsFromEveryBlock) {
    Files files;
    files.add("UP.SPF", "PROC UP(VAR REAL VV, REAL DD)\nVV=VV+DD\nG91 G0 X=DD\nG90\nM17\n");
    text::ToolSetup tool;
    tool.name = "A";
    tool.edges[1] = {{"DP1", 500}, {"DP2", 3}, {"DP3", 10}, {"DP4", 20}};
    tool.edges[2] = {{"DP1", 500}, {"DP2", 3}, {"DP3", 11}, {"DP4", 22}};
    files.setup.tools[3] = tool;
    for (
        const char* program : {
            "G18 G90 G94 DIAMON F100\nG0 X10 Z5\nG1 Z-5\nX12\nG2 X20 Z-10 CR=5\nG500 G0 X50\nM30\n",
            "DEF REAL SUM=1\nDEF INT II\nG0 X1\nFOR II=1 TO 3\n"
            "UP(SUM,II)\nENDFOR\nR1=SUM\nZ=SUM\nM30\n",
            "T3\nG0 X10 Z0\nD2\nZ5\n$TC_DP3[3,2]=15\nD2 X11\nTOFFL=2\nX12\nD0\nX12 Z0\nM30\n",
            "G0 X1\nAA: G91 X1\nZ1\nENDLABEL:\nREPEAT AA P=3\nG90 X50\nM30\n",
            "S500 M3\nG95 F0.2 G1 X5\nSETMS(1)\nG96 S100 LIMS=2000\n"
            "X20\nG97 S300\nG94 F50 X30\nM5\nM30\n",
            "DEFINE STEP AS G91 X2\nG0 X1\nSTEP\nSTEP\n"
            "MSG(\"x\"<<R1)\nR1=5\nIF R1==5\nG90 Z9\n"
            "ELSE\nZ8\nENDIF\nM30\n",
        })
        expect_same_events_from_every_block("sinumerik", program, files.setup);
}

// f(x) = 2 + 3x + x^2/2 within -5 and 50; read where an output block begins and ends
// (sinumerik_part3 7.12, 8)
TEST(SinumerikFlow, PolynomialsOfSynchronizedActionsHaveLimits) {
    const auto result = [](const std::string& x) {
        return last_value(
            run("FCTDEF(1,-5,50,2,3,0.5,0)\n$AC_PARAM[0]=" + x +
                "\nID=1 DO SYNFCT(1,$AC_PARAM[1],$AC_PARAM[0]) SYNFCT(1,R7,$AC_PARAM[0])\n"
                "G4 F0.1\nG4 F0.1\nR1=$AC_PARAM[1]\nM30\n"),
            "R1");
    };
    EXPECT_EQ(result("4"), "22");
    EXPECT_EQ(result("20"), "50");
    EXPECT_EQ(result("-3"), "-2.5");
    EXPECT_EQ(
        last_value(run("FCTDEF(2,-5,50,0,1,0,0)\nID=1 DO SYNFCT(2,R7,8)\nG4 F0.1\nM30\n"), "R7"),
        "8");
    EXPECT_NE(run("ID=1 DO SYNFCT(1,R7,8)\nG4 F0.1\nM30\n").errors, 0u) << "nobody has defined it";
    EXPECT_NE(run("FCTDEF(1,5,4,0,1,0,0)\nM30\n").errors, 0u) << "limits the wrong way round";
    EXPECT_NE(run("FCTDEF(1,-5,50,2,3,0.5,0)\nSYNFCT(1,R7,8)\nM30\n").errors, 0u)
        << "in a block of the program";
}

// What INIT and START cannot do is told where they stand; what becomes of them the e2e test shows.
TEST(SinumerikFlow, ProgramsOfOtherChannelsAreChosenByNumberAndName) {
    Files files;
    files.add("PART2.MPF", "M30\n");
    const auto errors = [&](const std::string& block) {
        return run(block + "\nM30\n", files.setup).errors;
    };
    for (const char* good : {"INIT(2,\"PART2\")", "INIT(2,\"/_N_MPF_DIR/_N_PART2_MPF\",\"N\")",
                             "INIT(2,\"part2.mpf\",\"S\")", "START(2)", "START(1,2)"})
        EXPECT_EQ(errors(good), 0u) << good;
    for (const char* bad : {"INIT(1,\"PART2\")", "INIT(2,\"PART3\")", "INIT(2,\"PART2\",\"A\")",
                            "INIT(9,\"PART2\")", "START(9)", "START(2) X1", "INIT(,\"PART2\")"})
        EXPECT_NE(errors(bad), 0u) << bad;
    const Played played = run("INIT(2,\"PART2\")\nSTART(1,2)\nM30\n", files.setup);
    EXPECT_NE(played.events.find("\"channel\":2,\"program\":"), std::string::npos) << played.events;
    EXPECT_NE(played.events.find("\"ev\":\"start\""), std::string::npos) << played.events;
    EXPECT_NE(played.events.find("\"channels\":[2]"), std::string::npos)
        << "the own channel runs already\n"
        << played.events;
}

// Z of the moves that a cycle makes.
std::string cycle_levels(const Played& played) {
    std::string levels;
    for (const std::string& line : played.lines()) {
        if (line.find("\"cycle\":\"CYCLE8") == std::string::npos) continue;
        const auto at = line.find("\"Z\":", line.find("\"pos\":")) + 4;
        levels += line.substr(at, line.find_first_of(",}", at) - at) + " ";
    }
    return levels;
}

// Own figures: retract plane 10, surface 0, safety distance 2, bottom 15 below; in G17 the axis of
// the hole is Z.
TEST(SinumerikFlow, DrillingCyclesGoDownAndBack) {
    const std::string head = "G17 G90 G94 G0 X0 Z20 F120\n";
    Played played = run(head + "CYCLE81(10,0,2,-15)\nM30\n");
    EXPECT_EQ(played.errors, 0u) << played.events;
    EXPECT_EQ(cycle_levels(played), "2 -15 10 ");
    played = run(head + "CYCLE82(10,0,2,,15,1.5)\nM30\n");
    EXPECT_EQ(cycle_levels(played), "2 -15 10 ");
    EXPECT_NE(played.events.find("\"seconds\":1.5"), std::string::npos) << played.events;
    played = run(head + "CYCLE85(10,0,2,-15,,0,80,200)\nG1 Z12\nM30\n");
    EXPECT_EQ(cycle_levels(played), "2 -15 2 10 ");
    for (const char* feed : {"\"value\":80}", "\"value\":200}", "\"value\":120}"})
        EXPECT_NE(played.events.find(feed), std::string::npos) << feed << played.events;
    EXPECT_EQ(cycle_levels(run(head + "MCALL CYCLE81(10,0,2,-15)\nX5\nM8\nX6\nMCALL\nX7\nM30\n")),
              "2 -15 10 2 -15 10 ")
        << "behind each block that moves";
    for (const char* bad : {"CYCLE81(1,0,2,-15)", "CYCLE81(10,0,2,15)", "CYCLE81(10,0,2)",
                            "CYCLE81(10,,2,-15)", "G18\nCYCLE81(10,0,2,-15)", "CYCLE83(10,0,2,-15)",
                            "MCALL CYCLE83(1)", "CYCLE800(1)", "HOLES2(0,0,10,0,0,0)"})
        EXPECT_NE(run(head + bad + "\nM30\n").errors, 0u) << bad;
    EXPECT_EQ(run("CYCLE800()\nTRAFOOF\nM30\n").errors, 0u);
}

// The table of sinumerik_part1 6.5: a turning tool lies with L1 along X and L2 along Z in G18,
// along Y and X in G17.
TEST(SinumerikFlow, LengthsAreToldByAxis) {
    const auto told = [](const std::string& blocks) {
        const Played played =
            run("DEF INT IND[3]\nDEF REAL MAT[3,3]\n$TC_DP1[1,1]=500\n$TC_DP2[1,1]=3\nT1 M6\nD1\n" +
                blocks + "\nR1=IND[0]*100+IND[1]*10+IND[2]\nR2=MAT[0,1]\nM30\n");
        return last_value(played, "R9") + " " + last_value(played, "R1") + " " +
               last_value(played, "R2");
    };
    EXPECT_EQ(told("G18\nR9=LENTOAX(IND,MAT)"), "0 213 1");
    EXPECT_EQ(told("G17\nR9=LENTOAX(IND,MAT,\"BCS\")"), "0 213 1");
    EXPECT_EQ(told("$TC_DP1[1,1]=120\nG17\nD1\nR9=LENTOAX(IND,MAT,\"W\")"), "0 321 0");
    EXPECT_EQ(told("G18\nROT RPL=90\nR9=LENTOAX(IND,MAT,\"WCS\")"), "0 83 0")
        << "abscissa along X, ordinate against Z: 1, -2, 3";
    EXPECT_EQ(told("G18\nROT RPL=30\nR9=LENTOAX(IND,MAT,\"WCS\")").substr(0, 2), "1 ");
    EXPECT_EQ(told("G18\nR9=LENTOAX(IND,MAT,\"QCS\")").substr(0, 2), "-1");
}

TEST(SinumerikFlow, AnAxisIsHandedToAChannel) {  // sinumerik_part3 7.14
    EXPECT_EQ(run("AXTOCHAN(X,2)\nG0 Z5\nM30\n").errors, 0u);
    EXPECT_NE(run("AXTOCHAN(Z,1,X,2)\nG0 X5\nM30\n").errors, 0u) << "it is the other one's";
    EXPECT_EQ(run("AXTOCHAN(X,2)\nAXTOCHAN(X,1)\nG0 X5\nM30\n").errors, 0u);
    for (const char* bad : {"AXTOCHAN(X,9)", "AXTOCHAN(X)", "AXTOCHAN(X,2,Z)", "AXTOCHAN(2,X)"})
        EXPECT_NE(run(std::string(bad) + "\nM30\n").errors, 0u) << bad;
}

TEST(SinumerikFlow, TheLanguageOfTheScreensHasANumber) {  // sinumerik_part3 10
    for (const auto& [display_language, number] : {std::pair{"en", "3"}, std::pair{"hu", "18"},
                                                   std::pair{"cs", "28"}, std::pair{"ru", "57"}}) {
        Play how;
        how.language = "sinumerik";
        how.sets = {std::string("PT_DISPLAY_LANGUAGE=") + display_language};
        EXPECT_EQ(last_value(play("R1=$AN_LANGUAGE_ON_HMI\nM30\n", how), "R1"), number);
    }
}

}  // namespace
}  // namespace polyturn::channels::testing
