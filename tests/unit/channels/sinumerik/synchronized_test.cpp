// What may stand behind the DO of a synchronized action (sinumerik_part3 1.4 and column SA of 3).
#include <gtest/gtest.h>

#include "../play.hpp"

namespace polyturn::channels::testing {
namespace {

// The condition never holds: what is wrong is told where the action stands.
Played told(const std::string& action) {
    Play how;
    how.language = "sinumerik";
    return play(
        "FCTDEF(1,-5,50,0,1,0,0)\nDEF REAL OWN\nID=1 WHEN R90==1 DO " + action + "\nG0 X5\nM30\n",
        how);
}

TEST(SynchronizedActions, DoWhatTheListMarks) {
    for (const char* action : {"$AC_PARAM[0]=SIN(30)",
                               "R1=ABS(-2)+LN(2) MOD ABS(3)",
                               "R1=ATAN2(1,1)",
                               "OWN=POT(2)",
                               "R1=BOUND(1,5,7)",
                               "M8",
                               "M=QU(8)",
                               "H5",
                               "M3=3 S3=100",
                               "SETM(1)",
                               "CLEARM(1)",
                               "ACC[X]=50",
                               "OVRA[C]=50",
                               "POS[C]=AC(10) FA[C]=100",
                               "SPOS=90",
                               "SETAL(65000)",
                               "PRESETON(C,5)",
                               "PRESETONS(C,5)",
                               "AXTOCHAN(C,1)",
                               "RELEASE(C)",
                               "TRAILON(C,Z,2)",
                               "TRAILOF(C,Z)",
                               "LEADOF(C,Z)",
                               "CTABLOCK(1)",
                               "LOCK(2)",
                               "UNLOCK(2)",
                               "RESET(2)",
                               "STOPREOF",
                               "ICYCON",
                               "ICYCOF",
                               "VELOLIMA[C]=50",
                               "ACCLIMA[C]=50",
                               "JERKLIMA[C]=50",
                               "FXS[X]=1 FXST[X]=10",
                               "SYNFCT(1,R5,R6)",
                               "R1=NOT TRUE",
                               "RDISABLE",
                               "DELDTG"})
        EXPECT_EQ(told(action).errors, 0u) << action << '\n' << told(action).events;
}

TEST(SynchronizedActions, RefuseEverythingElseWhereItIsTold) {
    for (const char* action : {"MSG(\"A\")",
                               "DRFOF",
                               "CANCEL(2)",
                               "WAITM(1,2)",
                               "G1 X5",
                               "G01",
                               "G54",
                               "X5",
                               "X=5",
                               "F100",
                               "T1",
                               "D1",
                               "L10",
                               "STOPRE",
                               "SETMS(2)",
                               "TRANSMIT",
                               "NEWCONF",
                               "INIT(2,\"A\")",
                               "TRANS Z5",
                               "POSA[C]=5",
                               "GOTOF LB1",
                               "IF R1==1 GOTOF L1",
                               "RETB",
                               "R1=STRLEN(\"AB\")",
                               "R1=5+ISAXIS(1)",
                               "R1=MODAXVAL(C,400)",
                               "R1=GETVARTYP(\"R1\")",
                               "SETDNO(1,1,1)",
                               "CTABDEF(C,Z,1,0)",
                               "FGROUP(X)",
                               "POS[C]=INDEX(\"AB\",\"B\")"})
        EXPECT_EQ(told(action).errors, 1u) << action;
}

TEST(SynchronizedActions, HaveTheirOwnProcedures) {
    for (const char* block : {"LOCK(1)", "RESET(1)", "ICYCON", "ICYCOF", "STOPREOF"}) {
        Play how;
        how.language = "sinumerik";
        EXPECT_EQ(play(std::string(block) + "\nM30\n", how).errors, 1u) << block;
    }
}

// Where its moves end.
std::string ends_of_moves(const Played& played) {
    std::string ends;
    for (const std::string& line : played.lines())
        if (const auto at = line.find("\"pos\":{"); at != std::string::npos)
            ends += line.substr(at + 6, line.find(",\"C\"", at) - at - 6) + " ";
    return ends;
}

// A straight way ends where the condition begins to hold (8); what is left of it is in $AC_DELT and
// $AA_DELT.
TEST(SynchronizedActions, DeleteTheRestOfAWay) {
    Play how;
    how.language = "sinumerik";
    const std::string head = "G18 G90 G94 DIAMON F100\nG0 X20 Z0\n";
    Played played = play(head +
                             "WHEN $AA_IW[Z]<=-20 DO DELDTG M8\nG1 X60 Z-40\n"
                             "R1=$AC_DELT R2=$AA_DELT[Z] R3=$AA_DELT[X]\n"
                             "G1 Z-50\nM30\n",
                         how);
    EXPECT_EQ(played.errors, 0u) << played.events;
    EXPECT_EQ(ends_of_moves(played), "{\"X\":20,\"Z\":0 {\"X\":40,\"Z\":-20 {\"X\":40,\"Z\":-50 ")
        << "for the next block only";
    // 10 mm of radius, 20 mm
    for (const char* part : {"\"name\":\"R1\",\"value\":22.36068}",
                             "\"name\":\"R2\",\"value\":-20}", "\"name\":\"R3\",\"value\":20}"})
        EXPECT_TRUE(played.has({part})) << part << played.events;
    EXPECT_TRUE(played.has({"\"code\":\"M8\""})) << played.events;
    played = play(head +
                      "R5=-15\nID=1 EVERY $AA_IM[Z]<R5 DO DELDTG\n"
                      "G1 Z-10\nG1 Z-30\nG1 Z-40\nG0 Z0\nG1 Z-20\n"
                      "CANCEL(1)\nG1 Z-25\nM30\n",
                  how);
    EXPECT_EQ(
        ends_of_moves(played),
        "{\"X\":20,\"Z\":0 {\"X\":20,\"Z\":-10 {\"X\":20,\"Z\":-15 {\"X\":20,\"Z\":-40 "
        "{\"X\":20,\"Z\":0 {\"X\":20,\"Z\":-15 {\"X\":20,\"Z\":-25 ")
        << played.events;
    played =
        play(head + "ID=1 WHENEVER $AA_IW[Z]<-10 DO DELDTG\nG1 Z-30\nG1 Z-12\nG1 Z-5\nM30\n", how);
    EXPECT_EQ(ends_of_moves(played), "{\"X\":20,\"Z\":0 {\"X\":20,\"Z\":-10 ")
        << "it holds where it has ended";
    played = play(head + "ID=1 WHENEVER $AA_IW[Z]<-10 DO DELDTG\nLOCK1: G1 Z-5\nM30\n", how);
    EXPECT_EQ(ends_of_moves(played), "{\"X\":20,\"Z\":0 {\"X\":20,\"Z\":-5 ");
    for (const char* bad : {"WHEN TRUE DO DELDTG(Z)\nG1 Z-5", "WHEN $A_IN[1]==1 DO DELDTG\nG1 Z-5",
                            "WHEN $AA_IW[Z]<-3 DO DELDTG\nG2 X30 Z-5 CR=5", "DELDTG"})
        EXPECT_EQ(play(head + bad + "\nM30\n", how).errors, 1u) << bad;
}

// Reading stops where a way is deleted (sinumerik_part3, DELDTG): no next block of the contour is
// known for a corner there.
TEST(SynchronizedActions, AWayThatIsDeletedEndsInNoCorner) {
    Play how;
    how.language = "sinumerik";
    const std::string head = "G18 G90 G94 DIAMON F100\nG0 X20 Z0\n";
    for (const char* corner : {"RND=3", "CHF=3", "CHR=3"}) {
        const Played played =
            play(head + "WHEN $AA_IW[Z]<=-20 DO DELDTG\nG1 X60 Z-40 " + corner + "\nG1 Z-50\nM30\n",
                 how);
        EXPECT_EQ(played.errors, 1u) << played.events;
        EXPECT_TRUE(played.has({"PT1561", "\"line\":4"})) << played.events;
        EXPECT_FALSE(played.has({"PT1307"})) << played.events;
    }
    const Played played =
        play(head + "RNDM=2\nWHEN $AA_IW[Z]<=-20 DO DELDTG\nG1 X60 Z-40\nG1 Z-50\nM30\n", how);
    EXPECT_EQ(ends_of_moves(played), "{\"X\":20,\"Z\":0 {\"X\":40,\"Z\":-20 {\"X\":40,\"Z\":-50 ")
        << played.events;
    EXPECT_FALSE(played.has({"\"ev\":\"alarm\""})) << played.events;
}

double last_of(const Played& played, const std::string& name) {
    double value = -1;
    const std::string key = "\"name\":\"" + name + "\",\"value\":";
    for (const std::string& line : played.lines())
        if (const auto at = line.find(key); at != std::string::npos)
            value = std::stod(line.substr(at + key.size()));
    return value;
}

// Where reading stops the actions are looked at, too: what the block before has brought about is
// there behind STOPRE and CANCEL.
TEST(SynchronizedActions, AreLookedAtWhereReadingStops) {
    Play how;
    how.language = "sinumerik";
    Played played = play(
        "G18 G90 G94\nG0 X10 Z0\nID=1 WHENEVER $AA_IW[Z]<-5 DO $R1=5\n"
        "G1 Z-10 F1000\nSTOPRE\nR3=$R1\nM30\n",
        how);
    EXPECT_EQ(played.errors, 0u) << played.events;
    EXPECT_EQ(last_of(played, "R3"), 5) << played.events;
    played = play(
        "G18 G90 G94\nG0 X10 Z0\nID=1 EVERY $AA_IW[Z]<-5 DO $R1=$R1+1\n"
        "G1 Z-10 F1000\nZ0\nZ-10\nCANCEL(1)\nSTOPRE\n"
        "R3=$R1\nG0 Z0\nZ-10\nSTOPRE\nR4=$R1\nM30\n",
        how);
    EXPECT_EQ(played.errors, 0u) << played.events;
    EXPECT_EQ(last_of(played, "R3"), 2) << played.events;
    EXPECT_EQ(last_of(played, "R4"), 2) << played.events;
    played = play(
        "G18 G90 G94\nG0 X10 Z0\nWHEN $AA_IW[Z]<-5 DO $R1=5\n"
        "STOPRE\nG1 Z-10 F1000\nSTOPRE\nR3=$R1\n$R1=0\n"
        "G1 Z-20\nSTOPRE\nR4=$R1\nM30\n",
        how);
    EXPECT_EQ(played.errors, 0u) << played.events;
    EXPECT_EQ(last_of(played, "R3"), 5)
        << "of the next output block, which STOPRE is not" << played.events;
    EXPECT_EQ(last_of(played, "R4"), 0) << "and of no other" << played.events;
}

// Without a machine nothing would ever end what holds: check says so and reads on.
TEST(SynchronizedActions, HoldNothingWithoutAMachine) {
    Play how;
    how.language = "sinumerik";
    const Played played = play("ID=1 WHENEVER $A_IN[1]==0 DO RDISABLE\nG0 X5\nM30\n", how);
    EXPECT_EQ(played.errors, 0u) << played.events;
    EXPECT_TRUE(played.has({"RDISABLE has no effect"})) << played.events;
    EXPECT_TRUE(played.has({"\"ev\":\"move\""})) << played.events;
    EXPECT_EQ(play("RDISABLE\nM30\n", how).errors, 1u) << "in a block of the program";
}

}  // namespace
}  // namespace polyturn::channels::testing
