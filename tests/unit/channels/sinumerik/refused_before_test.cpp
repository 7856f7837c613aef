// Forms of the manual that were refused or did nothing: arguments behind L numbers, parameters of
// cycles that are 0, the cutting speed of another spindle, DIAMCHANA, the answers of ADDFRAME,
// cycles of the control that are not here.
#include <gtest/gtest.h>
#include <unistd.h>

#include <filesystem>
#include <fstream>

#include "../play.hpp"

namespace polyturn::channels::testing {
namespace {

Played run(const std::string& program, std::vector<std::string> sets = {},
           const text::ChannelSetup& setup = {}) {
    Play how;
    how.language = "sinumerik";
    how.sets = std::move(sets);
    how.setup = setup;
    return play(program, how);
}

TEST(SinumerikCalls, OfANumberTakeArguments) {
    const std::filesystem::path folder =
        std::filesystem::temp_directory_path() / ("l_number_" + std::to_string(::getpid()));
    std::filesystem::create_directory(folder);
    std::ofstream(folder / "L140.SPF") << "PROC L140(REAL LEN, INT MANY=3)\nR1=LEN R2=MANY\nM17\n";
    text::ChannelSetup setup;
    setup.subprograms.push_back((folder / "L140.SPF").string());
    const Played played = run("L140(2)\nL140 (5,4)\nM30\n", {}, setup);
    std::filesystem::remove_all(folder);
    EXPECT_EQ(played.errors, 0u) << played.events;
    for (const char* part : {R"("name":"R1","value":2})", R"("name":"R2","value":3})",
                             R"("name":"R1","value":5})", R"("name":"R2","value":4})"})
        EXPECT_TRUE(played.has({part})) << part << played.events;
}

// What a parameter of 0 cannot mean it does not say: DPR, DTB, FFR, RFF.
TEST(SinumerikCycles, TakeZeroAsNotGiven) {
    const std::string head = "G17 G90 G94 DIAMON F100\nG0 X20 Z110\n";
    for (const char* cycle :
         {"CYCLE81(110,100,2,80,0)", "CYCLE82(110,100,2,80,0,0)", "CYCLE82(110,100,2,80,,0)",
          "CYCLE85(110,100,2,80,0,0,0,0)", "CYCLE85(110,100,2,80,0,0)"}) {
        const Played played = run(head + cycle + "\nM30\n");
        EXPECT_EQ(played.errors, 0u) << cycle << played.events;
        EXPECT_TRUE(played.has({R"("kind":"linear")", R"("Z":80,)", R"("value":100})"}))
            << cycle << played.events;
        EXPECT_FALSE(played.has({R"("ev":"dwell")"})) << cycle << played.events;
    }
    EXPECT_TRUE(
        run(head + "CYCLE81(110,100,2,0,15)\nM30\n").has({R"("kind":"linear")", R"("Z":85,)"}))
        << "DPR";
    EXPECT_TRUE(run(head + "CYCLE81(10,0,2,0,0)\nM30\n").has({R"("ev":"alarm")"}))
        << "a hole without depth";
    EXPECT_EQ(run(head + "CYCLE81(110,100,2,,0)\nM30\n").errors, 1u) << "neither DP nor DPR";
}

// part 1, 7.2: each spindle has its own SVC, and the block needs nothing else that names it.
TEST(SinumerikSpindles, CuttingSpeedOfAnotherSpindleActsAlone) {
    const std::vector<std::string> two = {"N0607 S2=7", "N0604 L1=1", "N0600 S2=1"};
    const std::string head = "$TC_DP6[1,1]=5\nT1 D1\n";
    Played played = run(head + "M2=3 S2=100\nSVC[2]=100\nM30\n", two);
    EXPECT_EQ(played.errors, 0u) << played.events;
    // 100000 / (2 pi 5)
    EXPECT_TRUE(played.has({R"("ev":"spindle")", R"("line":4)", R"("spindle":2)", "3183.09"}))
        << played.events;
    EXPECT_FALSE(played.has({R"("ev":"spindle")", R"("line":4)", R"("spindle":1)"}))
        << played.events;
    played = run(head + "S1000 M3\nSVC[2]=100 M2=4\nM30\n", two);
    EXPECT_EQ(played.errors, 0u) << played.events;
    EXPECT_TRUE(played.has(
        {R"("ev":"spindle")", R"("line":4)", R"("spindle":2)", "3183.09", R"("direction":"ccw")"}))
        << played.events;
    EXPECT_FALSE(played.has({R"("ev":"spindle")", R"("line":4)", R"("spindle":1)"}))
        << played.events;
}

// part 1, 9.3.7: "takes the channel status and follows it from now on". X is the transverse axis of
// the channel, Z another one.
TEST(SinumerikDiameters, AnAxisMayFollowTheChannel) {
    const std::vector<std::string> released = {"MD30460 A1=4", "MD30460 A2=4"};
    const Played played =
        run("G90 DIAMON\nDIAMCHANA[Z]\nG0 X10 Z10\nDIAMOF\n"
            "Z12\nDIAMON\nZ14\nDIAMOFA[Z]\nZ15\nDIAMOF\n"
            "DIAMCHAN\nDIAMON\nZ16\nDIAMONA[Z]\nDIAMOF\n"
            "Z18\nDIAMCHANA[Z]\nZ19\nM30\n",
            released);
    EXPECT_EQ(played.errors, 0u) << played.events;
    const std::pair<int, const char*> rows[] = {
        {3, R"("Z":5,)"},  {5, R"("Z":12,)"}, {7, R"("Z":7,)"},  {9, R"("Z":15,)"},
        {13, R"("Z":8,)"}, {16, R"("Z":9,)"}, {18, R"("Z":19,)"}};
    for (const auto& [line, machine] : rows) {
        const std::string move =
            played.find({"\"ev\":\"move\"", "\"line\":" + std::to_string(line) + ","});
        const auto at = move.find("\"machine\":");
        EXPECT_TRUE(at != std::string::npos && move.find(machine, at) != std::string::npos)
            << line << ' ' << machine << move;
    }
}

// part 3, ADDFRAME: 1 the target text is wrong, 2 the target frame is not configured.
TEST(SinumerikFrames, AWrongTargetIsNoMissingOne) {
    const std::pair<const char*, const char*> rows[] = {{"$P_PFRAME", "0"},
                                                        {"$P_UIFR[1]", "0"},
                                                        {"NIX", "1"},
                                                        {"$P_NIX", "1"},
                                                        {"$P_UIFR", "1"},
                                                        {"$P_UIFR[A]", "1"},
                                                        {"", "1"},
                                                        {"$P_SETFRXX", "1"},
                                                        {"$P_UIFR[200]", "2"},
                                                        {"$P_SETFRAME", "2"},
                                                        {"$P_CHBFR[0]", "2"},
                                                        {"$P_TRAFRAME", "2"}};
    for (const auto& [target, answer] : rows) {
        const Played played =
            run("R1=9\nR1=ADDFRAME(CTRANS(X,5),\"" + std::string(target) + "\")\nM30\n");
        EXPECT_EQ(played.errors, 0u) << target << played.events;
        EXPECT_TRUE(
            played.has({R"("line":2)", R"("name":"R1","value":)" + std::string(answer) + "}"}))
            << target << played.events;
    }
}

// part 2, 13.11: the manual's example. The axis goes where the overlay says, the programmed numbers
// do not know of it until CORROF.
TEST(SinumerikOverlays, LieOverThePathUntilTheyAreTakenOver) {
    const Played played =
        run("G18 G90 DIAMOF\nG0 X20 Z5\nWHEN TRUE DO $AA_OFF[X]=10 G4 F5\n"
            "R1=$AA_OFF_VAL[X] R2=$AA_IM[X] R3=$AA_IW[X]\n"
            "G0 X30\nCORROF(X,\"AA_OFF\")\nR4=$AA_OFF[X] R5=$AA_IM[X] R6=$AA_IW[X]\n"
            "G0 X50\nM30\n");
    EXPECT_EQ(played.errors, 0u) << played.events;
    EXPECT_TRUE(played.has({R"("ev":"dwell")", R"("line":3)"})) << played.events;
    EXPECT_TRUE(played.has({R"("ev":"move")", R"("line":3,)", R"("machine":{"X":30,"Z":5)"}))
        << played.events;
    EXPECT_TRUE(played.has({R"("line":5,)", R"("pos":{"X":30,)", R"("machine":{"X":40,)"}))
        << played.events;
    EXPECT_TRUE(played.has({R"("line":8,)", R"("pos":{"X":50,)", R"("machine":{"X":50,)"}))
        << "CORROF moves nothing, the next block comes to its own point" << played.events;
    for (const char* part :
         {R"("name":"R1","value":10})", R"("name":"R2","value":30})", R"("name":"R4","value":0})",
          R"("name":"R5","value":40})", R"("name":"R6","value":40})"})
        EXPECT_TRUE(played.has({part})) << part << played.events;
    EXPECT_FALSE(played.has({R"("ev":"move")", R"("line":6,)"})) << played.events;
    EXPECT_EQ(run("$AA_OFF[Q]=1\nM30\n").errors, 1u);
    EXPECT_EQ(run("WHEN TRUE DO M8 G4 X5\nM30\n").errors, 1u) << "the dwell is read as any";
}

// Nobody has forgotten to declare them.
TEST(SinumerikCycles, ThatAreNotHereAreRefusedByTheirName) {
    const std::string refused(alarm_number(Alarm::NotBuilt, Dialect::Sinumerik));
    EXPECT_EQ(refused, "12140") << "the reference page names it";
    for (const char* cycle : {"CYCLE93(1,2,3)", "CYCLE95(1,2,3)", "CYCLE97", "POCKET1(1)",
                              "LONGHOLE(1)", "MCALL CYCLE96(1)", "HOLES5(1)"}) {
        const Played played = run(std::string(cycle) + "\nM30\n");
        const std::string name = std::string(cycle).substr(0, std::string(cycle).find('('));
        EXPECT_TRUE(played.has({"\"number\":" + refused, name})) << cycle << played.events;
        EXPECT_EQ(played.errors, 1u) << cycle;
    }
    EXPECT_TRUE(run("CYCLIST(1)\nM30\n").has({"12550"}));
}

}  // namespace
}  // namespace polyturn::channels::testing
