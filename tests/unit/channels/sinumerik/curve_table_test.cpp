// Curve tables (sinumerik_part3 7.4, 9.3): by hand in programs, and against a slow search in random
// tables.
#include "channels/sinumerik/curve_tables/curve_table.hpp"

#include <gtest/gtest.h>

#include <cmath>

#include "../play.hpp"
#include "tests/property.hpp"

namespace polyturn::channels::testing {
namespace {

using sinumerik::CurveTable;

Played run(const std::string& program) {
    Play how;
    how.language = "sinumerik";
    return play(program, how);
}

void expect(const Played& played,
            std::initializer_list<std::pair<const char*, const char*>> values) {
    EXPECT_EQ(played.errors, 0u) << played.events;
    for (const auto& [name, value] : values) {
        const std::string part = "\"name\":\"" + std::string(name) + "\",\"value\":" + value + "}";
        EXPECT_TRUE(played.has({part})) << name << " should be " << value << '\n' << played.events;
    }
}

// Z leads, X follows: 0 to 20 flat, up to 6 at 100, flat to 150, back to 0 at 180.
const std::string kTable =
    "DEF REAL GG\nG18 G90 DIAMOF\nG0 X50 Z50\n"
    "CTABDEF(X,Z,3,0)\nG1 F100 Z0 X0\nZ20\nZ100 X6\n"
    "G91 Z50\nG90 Z180 X0\nCTABEND\n";

TEST(CurveTables, AreDefinedWithoutMoving) {
    const Played played =
        run(kTable +
            "G1 Z60\nR1=CTAB(60,3,GG) R2=GG\nR3=CTAB(-10,3,GG) R4=GG\n"
            "R5=CTAB(165,3,GG) R6=GG\nR7=CTAB(500,3,GG)\n"
            "R8=CTABTMAX(3) R9=CTABTMIN(3,40,150) R10=CTABTSP(3,GG) R11=CTABTEP(3,GG)\n"
            "R12=CTABSSV(60,3,GG) R13=CTABSEV(60,3,GG) R14=CTABTEV(3,GG) R15=CTABSEGID(3,\"L\")\n"
            "R16=CTABINV(3,10,3,GG) R17=CTABINV(3,170,3,GG)\n"
            "M30\n");
    expect(played, {{"R1", "3"},
                    {"R2", "0.075"},
                    {"R3", "0"},
                    {"R4", "0"},
                    {"R5", "3"},
                    {"R6", "-0.2"},
                    {"R7", "0"},
                    {"R8", "6"},
                    {"R9", "1.5"},
                    {"R10", "0"},
                    {"R11", "180"},
                    {"R12", "0"},
                    {"R13", "6"},
                    {"R14", "0"},
                    {"R15", "4"},
                    {"R16", "60"},
                    {"R17", "165"}});
    unsigned moves = 0;
    for (const std::string& line : played.lines())
        moves += line.find("\"ev\":\"move\"") != std::string::npos;
    EXPECT_EQ(moves, 2u) << played.events;  // G0 before it and G1 Z60 behind it
    EXPECT_TRUE(played.has({"\"ev\":\"move\"", "linear", "\"pos\":{\"X\":50,\"Z\":60"}))
        << played.events;
}

TEST(CurveTables, RepeatThemselves) {
    const std::string rows = "G1 F100 Z0 X10\nZ10 X20\nCTABEND\n";
    expect(
        run("DEF REAL GG\nG18 G90 DIAMOF\nCTABDEF(X,Z,1,1)\n" + rows +
            "CTABDEF(X,Z,2,2,\"DRAM\")\n" + rows +
            "R1=CTAB(25,1,GG) R2=CTAB(25,2,GG) R3=CTAB(-5,2,GG) R4=CTABPERIOD(1) R5=CTABPERIOD(2) "
            "R6=CTABPERIOD(7)\n"
            "R7=CTABMEMTYP(1) R8=CTABMEMTYP(2) R9=CTABNO() R10=CTABNOMEM(\"DRAM\") "
            "R11=CTABID(1,\"DRAM\") R12=CTABEXISTS(2) R13=CTABEXISTS(9) R14=CTABINV(47,0,2,GG) "
            "R15=CTABINV(17,38,1,GG)\n"
            "M30\n"),
        {{"R1", "15"},
         {"R2", "35"},
         {"R3", "5"},
         {"R4", "1"},
         {"R5", "2"},
         {"R6", "-1"},
         {"R7", "0"},
         {"R8", "1"},
         {"R9", "2"},
         {"R10", "1"},
         {"R11", "2"},
         {"R12", "1"},
         {"R13", "0"},
         {"R14", "37"},
         {"R15", "37"}});
}

// The values of a roll-over axis are those that are written, not ways around.
TEST(CurveTables, HaveRolloverAxesAsTheyAreWritten) {
    expect(run("DEF REAL GG\nCTABDEF(C,Z,3,0)\nZ0 C0\nZ10 C20\n"
               "Z20 C10\nZ30 C400\nCTABEND\nR1=CTAB(15,3,GG) R2=CTAB(25,3,GG) R3=CTABTMAX(3)\n"
               "M30\n"),
           {{"R1", "15"}, {"R2", "205"}, {"R3", "400"}});
}

TEST(CurveTables, AreLockedAndDeleted) {
    expect(run(kTable + "CTABLOCK(3)\nR1=CTABISLOCK(3)\nCTABUNLOCK(3)\n"
                        "R2=CTABISLOCK(3)\nR3=CTABFNO(\"SRAM\") R4=CTABSEG(\"SRAM\",\"L\") "
                        "R5=CTABSEG(\"SRAM\",\"P\") R6=CTABSEG(\"XX\")\n"
                        "CTABDEL(3)\nR7=CTABEXISTS(3) R8=CTABFNO(\"SRAM\")\n"
                        "R9=CTABISLOCK(3)\nM30\n"),
           {{"R1", "1"},
            {"R2", "0"},
            {"R3", "99"},
            {"R4", "4"},
            {"R5", "0"},
            {"R6", "-1"},
            {"R7", "0"},
            {"R8", "100"},
            {"R9", "-1"}});
    EXPECT_GT(run(kTable + "CTABLOCK(3)\nCTABDEL(3)\nM30\n").errors, 0u);
    EXPECT_GT(run(kTable + "CTABLOCK(3)\nCTABDEF(X,Z,3,0)\nM30\n").errors, 0u);
}

TEST(CurveTables, RefuseWhatIsNoCurve) {
    const std::string head = "DEF REAL GG\nG18 G90 DIAMOF\nCTABDEF(X,Z,3,0)\nG1 F100 Z0 X0\n";
    for (const char* const rest :
         {"Z10\nZ5\nCTABEND\nM30\n", "CTABEND\nM30\n", "G2 X5 Z5 CR=5\nCTABEND\nM30\n",
          "X5\nCTABEND\nM30\n", "CTABDEF(X,Z,4,0)\nM30\n"})
        EXPECT_GT(run(head + rest).errors, 0u) << rest;
    EXPECT_GT(run("DEF REAL GG\nR1=CTAB(1,9,GG)\nM30\n").errors, 0u);
    EXPECT_GT(run("CTABEND\nM30\n").errors, 0u);
}

PROPERTY(CurveTables, AgreeWithASlowSearch, ()) {
    CurveTable table;
    table.periodic = *rc::gen::inRange(0, 3);
    double lead = *rc::gen::inRange(-50, 50);
    const int count = *rc::gen::inRange(2, 8);
    for (int i = 0; i < count; ++i) {
        table.points.push_back({lead, static_cast<double>(*rc::gen::inRange(-20, 20))});
        lead += *rc::gen::inRange(1, 30);
    }
    const double first = table.points.front().lead, last = table.points.back().lead,
                 span = last - first;
    const double asked = first + span * *rc::gen::inRange(-300, 300) / 100.0;
    double inside = asked, gained = 0;  // round by round
    if (table.periodic == 0) inside = std::fmin(std::fmax(asked, first), last);
    while (table.periodic != 0 && inside >= last) {
        inside -= span;
        gained += 1;
    }
    while (table.periodic != 0 && inside < first) {
        inside += span;
        gained -= 1;
    }
    double expected = 0;
    for (std::size_t i = 0; i + 1 < table.points.size(); ++i)
        if (const auto& a = table.points[i], &b = table.points[i + 1];
            inside >= a.lead && inside <= b.lead)
            expected = a.follow + (b.follow - a.follow) * (inside - a.lead) / (b.lead - a.lead);
    if (table.periodic == 2)
        expected += gained * (table.points.back().follow - table.points.front().follow);
    const bool at_seam = table.periodic != 0 &&
                         (std::fabs(inside - first) < 1e-9 || std::fabs(inside - last) < 1e-9);
    if (!at_seam) RC_ASSERT(std::fabs(table.at(asked).value - expected) < 1e-9);
    // it passes that value there, so nearest is there
    const double back = table.inverse(expected, asked).value;
    if (table.periodic != 0 || (asked >= first && asked <= last))
        RC_ASSERT(std::fabs(back - asked) < 1e-6 || at_seam);
    double lowest = 1e9;
    for (int k = 0; k <= 2000; ++k)
        lowest = std::fmin(lowest, table.at(first + (asked - first) * k / 2000.0).value);
    RC_ASSERT(table.extreme(first, asked, false) <= lowest + 1e-9);
}

}  // namespace
}  // namespace polyturn::channels::testing
