// The language mefi: dimension words, group 5 and its table. Every row follows from spec
// mefi_cnc8x6, section in brackets.
#include <gtest/gtest.h>

#include "../play.hpp"
#include "ipc/model/machine/store/work_zeros.hpp"

namespace polyturn::channels::testing {
namespace {

Play mefi(std::vector<std::string> sets = {}) {
    Play how;
    how.language = "mefi";
    how.sets = {"N0106 A1=0"};  // X in radii, so that machine X is the word plus the shift
    for (std::string& set : sets) how.sets.push_back(std::move(set));
    return how;
}

void fill_shifts(MachineView& view) {
    const auto put = [&](const char* name, double x, double z) {
        const std::size_t row = *work_zero_row(name);
        view.store->zeros[row * kChannelAxes] = x;
        view.store->zeros[row * kChannelAxes + 1] = z;
    };
    put("G53", 40, -30);
    put("G54", 5, -50);
    put("G56", -2, 12.5);
    put("G57", 20, 7);
    put("G58", 1, 300);
    put("G59", 3, -80);
}

// Machine points "X,Z" of all moves, with a blank between them.
std::string points(const Played& played) {
    std::string all;
    for (const std::string& line : played.lines()) {
        const std::size_t x = line.find("\"machine\":{\"X\":");
        if (line.find("\"ev\":\"move\"") == std::string::npos || x == std::string::npos) continue;
        const std::size_t from = x + 15, comma = line.find(',', from),
                          z = line.find("\"Z\":", comma) + 4;
        if (!all.empty()) all += ' ';
        all +=
            line.substr(from, comma - from) + "," + line.substr(z, line.find_first_of(",}", z) - z);
    }
    return all;
}

struct Row {
    std::string_view program, points;
};

TEST(MefiShift, MovesWhereTheTableSays) {
    const Row rows[] = {
        // [3] whole millimetres; [5.5] G53 in force at program start
        {"G00 X100", "140,0"},
        // [3] leading zero left out, trailing point
        {"G00 X.5 Z 200.", "40.5,170"},
        {"G00 X - 5 Z + 3\nZ-  .5", "35,-27 35,-30.5"},  // blanks behind the sign
        {"G54 G00 X0 Z0", "5,-50"},                      // [4.3] not added to G53
        // [5.1] blocks with a shift alone move nothing
        {"G54\nG57\nG53\nG00 X0 Z0", "40,-30"},
        {"G00 G56 X0 Z0\nG58 X0 Z0\nX1 Z1", "-2,12.5 1,300 -1,13.5"},  // [5.3]
        {"G00 G58 X0 Z0\nX0 Z0", "1,300 40,-30"},
        {"G00 G56 X0 Z0\nG59\nX1", "-2,12.5 -1,12.5"},
        {"G00 X0 Z0\nG91 G58 X1\nZ1", "40,-30 41,-30 41,-29"},  // [5.2] increments know no shift
        {"G54 G92 X12\nG00 X0 Z0\nG53 X0 Z0\nG54 X0", "12,-50 40,-30 12,-30"},  // [6.1]
        {"G54 G92 X1 Z2\nG55 G92 Z3\nG00 X0 Z0\nG54 X0 Z0", "0,3 1,2"},
        {"G00 G56 X0 Z0\nG58 G92 X7\nX0 Z1\nG58 X0 Z0", "-2,12.5 -2,13.5 7,300"},
        // [6.2] its own example: offset 310
        {"G00 G53 X310 Z30\nG56 G93 X40\nX40 Z0", "350,0 350,12.5"},
        {"G00 G53 X310 Z30\nG56 G93 X0 Z0\nX0 Z0\nX1 Z1", "350,0 351,1"},
        // a table word is a position in G91 too
        {"G00 G53 X10 Z0\nG91 G57 G93 X5\nX1\nG90 X5", "50,-30 51,-30 50,-30"},
        {"G00 X10 Z0\nG58 G93 X0 Z0\nX11\nG58 X0 Z0", "50,-30 51,-30 50,-30"},
        {"G92 X1\nG00 X0 Z0", "1,-30"},  // without G5x: the row in force
        {"G94 G01 F100 G58 X0 Z0", "1,300"},
    };
    for (const Row& row : rows) {
        SCOPED_TRACE(std::string(row.program));
        const Played played = play(row.program, mefi(), fill_shifts);
        EXPECT_EQ(played.errors, 0u) << played.events;
        EXPECT_EQ(points(played), row.points) << played.events;
    }
}

TEST(MefiShift, WritesOnlyTheProgrammedAxesOfItsRow) {
    const Played played = play("G54 G92 X33.3 C90\nM30\n", mefi(), fill_shifts);
    EXPECT_TRUE(played.has({R"("ev":"offset")", R"("axis":"X")", R"("value":33.3)"}))
        << played.events;
    EXPECT_TRUE(played.has({R"("ev":"offset")", R"("axis":"C")", R"("value":90)"}))
        << played.events;
    EXPECT_FALSE(played.has({R"("ev":"offset")", R"("axis":"Z")"})) << played.events;
    EXPECT_FALSE(played.has({R"("ev":"move")"})) << played.events;
}

TEST(MefiShift, CountsOffsetsOfADiameterAxisInDiameters) {
    const Played played = play("G00 G54 X100\nG54 G93 X0\nX20", mefi({"N0106 A1=1"}));
    EXPECT_EQ(points(played), "50,0 60,0") << played.events;
    EXPECT_TRUE(played.has({R"("ev":"offset")", R"("axis":"X")", R"("value":100)"}))
        << played.events;
}

TEST(MefiShift, BeginsWithThePriorityFunctionOfItsParameter) {
    const Played played = play("G00 X0 Z0", mefi({"PT_MEFI_PRIORITY=54"}), fill_shifts);
    EXPECT_EQ(points(played), "5,-50") << played.events;
}

TEST(MefiBlock, RefusesWhatIsNotItsLanguage) {
    const Row rows[] = {{"G00 U5", "\"column\":5"},
                        {"G00 X#1", "expressions in mefi"},
                        {"#1=5", "macro statements in mefi"},
                        {"G20", "G20"},
                        {"G10 P1 X5", "G10"},
                        {"G71 P1 Q2", "G71"},
                        {"G92", "G92"},
                        {"G54 G93", "G93"},
                        {"G65 P9010", "G65"},
                        {"G00 X1 Z2 X3", "\"column\":11"},
                        {"G57 G55 X1", "G57 G55"},
                        {"G59 G58 X1", "G59 G58"},
                        {"G54 G92 G93 X1", "G92 G93"},
                        {"G90 G91 X1", "G90 G91"}};
    for (const Row& row : rows) {
        SCOPED_TRACE(std::string(row.program));
        const Played played = play(row.program, mefi());
        EXPECT_EQ(played.errors, 1u) << played.events;
        EXPECT_TRUE(played.has({"\"ev\":\"alarm\"", std::string(row.points)})) << played.events;
    }
}

}  // namespace
}  // namespace polyturn::channels::testing
