// G54.2: the fixture offset goes round with the table. A table B about Y; the vector was measured
// at B0.
#include <gtest/gtest.h>

#include "../play.hpp"

namespace polyturn::channels::testing {
namespace {

Play with_table(std::vector<std::string> more = {}) {
    Play how;
    how.language = "nct";
    how.sets = {"N0106#0 A1=0", "N1300 L1=0", "N0002 A16=1", "N0100 A16=89",
                "N0103 A16=2",  "N0002 A7=1", "N0100 A7=66", "N0106#1 A7=1",
                "N3200 L1=2",   "N3204 L1=7", "N3205 L1=2"};
    how.sets.insert(how.sets.end(), more.begin(), more.end());
    return how;
}

constexpr const char* kMeasured = "G94 G17 F100\nG10 L21 P1 X50. Z20. B0\n";

TEST(FixtureOffset, TurnsWithTheTableAndTakesTheLinearAxesAlong) {
    const Played played = play(std::string(kMeasured) +
                                   "G54.2 P1\nN20 G0 X0 Z0\nN30 B90.\nN40 G1 X10.\n"
                                   "N50 B180. Z5.\nG54.2 P0\nN70 G0 X0 Z0\nM30\n",
                               with_table());
    EXPECT_EQ(played.errors, 0u) << played.events;
    // the code alone moves nothing
    EXPECT_FALSE(played.has({R"("ev":"move")", R"("line":3)"})) << played.events;
    EXPECT_TRUE(played.has({R"("n":20,)", R"("machine":{"X":50,"Z":20)"})) << played.events;
    // about +Y: x to -z, z to x
    EXPECT_TRUE(played.has({R"("n":30,)", R"("pos":{"X":0,"Z":0)", R"("machine":{"X":20,"Z":-50)"}))
        << played.events;
    EXPECT_TRUE(played.has({R"("n":40,)", R"("machine":{"X":30,"Z":-50)"})) << played.events;
    EXPECT_TRUE(played.has({R"("n":50,)", R"("machine":{"X":-40,"Z":-15)"})) << played.events;
    EXPECT_TRUE(played.has({R"("n":70,)", R"("machine":{"X":0,"Z":0)"})) << played.events;
}

TEST(FixtureOffset, LetsTheRotaryAxisMoveAlone) {  // N3212 #7
    const Played played =
        play(std::string(kMeasured) + "G54.2 P1\nN20 G0 X0 Z0\nN30 B90.\nN40 X0\nM30\n",
             with_table({"N3212 L1=128"}));
    EXPECT_EQ(played.errors, 0u) << played.events;
    EXPECT_TRUE(played.has({R"("n":30,)", R"("machine":{"X":50,"Z":20)", R"("B":90)"}))
        << played.events;
    EXPECT_TRUE(played.has({R"("n":40,)", R"("machine":{"X":20,"Z":-50)"})) << played.events;
}

TEST(FixtureOffset, CountsFromTheAngleAtWhichItWasMeasured) {
    const Played played =
        play("G94 G17\nG10 L21 P8 X50. Z20. B30.\nG0 B120.\nG54.2 P8\nN20 G0 X0 Z0\nM30\n",
             with_table());
    // a quarter turn on
    EXPECT_TRUE(played.has({R"("n":20,)", R"("machine":{"X":20,"Z":-50)"})) << played.events;
}

TEST(FixtureOffset, IsRefusedWhereItCannotBe) {
    EXPECT_TRUE(play("G54.2 P9\nM30\n", with_table()).has({R"("column":7)"}));
    EXPECT_TRUE(play("G54.2 P1\nM30\n", with_table({"N3200 L1=0"})).has({"N3200"}));
    EXPECT_TRUE(
        play("G54.2 P1\nM30\n", with_table({"N3200 L1=1"})).has({"head turns no workpiece"}));
    const Played arc = play(
        std::string(kMeasured) + "G54.2 P1\nG0 X0 Y0\nG2 X10. Y10. R10. B90.\nM30\n", with_table());
    EXPECT_TRUE(arc.has({R"("line":5)", "G54.2"})) << arc.events;
    EXPECT_TRUE(
        play(std::string(kMeasured) + "G54.2 P1\nG43.4\nM30\n", with_table()).has({"G54.2 P0"}));
}

}  // namespace
}  // namespace polyturn::channels::testing
