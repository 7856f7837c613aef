// Modal calls of every language: a block that names an axis is a block of motion, whether the axis
// stands there already or not (sinumerik MCALL; fanuc_lathe 6.9.3; fagor_8037t part 2, 12.7). A
// block that names none calls nothing.
#include <gtest/gtest.h>

#include "play.hpp"

namespace polyturn::channels::testing {
namespace {

Played run(const std::string& language, const std::string& program) {
    Play how;
    how.language = language;
    return play(program, how);
}

std::string last_value(const Played& played, const std::string& name) {
    std::string value = "none";
    const std::string key = "\"name\":\"" + name + "\",\"value\":";
    for (const std::string& line : played.lines())
        if (const auto at = line.find(key); at != std::string::npos)
            value = line.substr(at + key.size(), line.find('}', at) - at - key.size());
    return value;
}

// End points of the moves in feed, in order: what was drilled.
std::size_t holes_at(const Played& played, const std::string& pos) {
    std::size_t found = 0;
    for (const std::string& line : played.lines())
        found += line.find("\"kind\":\"linear\"") != std::string::npos &&
                 line.find("\"pos\":{" + pos) != std::string::npos;
    return found;
}

TEST(ModalCalls, OfADrillingCycleCountABlockWithoutWay) {
    const Played played = run("sinumerik",
                              "G17 G90 G94 DIAMON F100\nG0 X35 Z2\nMCALL CYCLE81(2,0,2,-10)\n"
                              "X35\nX20\nM8\nG1\nMCALL\nX35\nM30\n");
    EXPECT_EQ(played.errors, 0u) << played.events;
    EXPECT_EQ(holes_at(played, "\"X\":35,\"Z\":-10"), 1u) << played.events;
    EXPECT_EQ(holes_at(played, "\"X\":20,\"Z\":-10"), 1u) << "once, not for M8 and G1\n"
                                                          << played.events;
}

TEST(ModalCalls, OfAProgramCountABlockWithoutWay) {
    for (const char* language : {"fanuc", "nct"}) {
        const Played played = run(language,
                                  "O1\n#500=0\nG0 X35. Z2.\nG66 P8100\nX35.\n"
                                  "G1 X35. F100\nG0 Z2. X35.\nM8\nG0\nT0\nG67\n"
                                  "X35.\nM30\nO8100\n#500=#500+1\nM99\n");
        EXPECT_EQ(played.errors, 0u) << language << played.events;
        EXPECT_EQ(last_value(played, "#500"), "3") << language << played.events;
    }
    const Played played = run("fagor",
                              "G152\nG00 X20 Z0\n(MCALL 73)\nX20\nM8\nG01 Z0 F100\n"
                              "(MDOFF)\nX20\nM30\n(SUB 73)\n(P105=P105+1)\n"
                              "(RET)\n");
    EXPECT_EQ(played.errors, 0u) << played.events;
    EXPECT_EQ(last_value(played, "P105"), "3") << "by the call itself, by two blocks\n"
                                               << played.events;
}

// What a modal call does itself calls it not again, also without a way.
TEST(ModalCalls, DoNotCallThemselves) {
    const Played fanuc = run(
        "fanuc", "O1\n#500=0\nG0 X35.\nG66 P8100\nX35.\nG67\nM30\nO8100\n#500=#500+1\nX35.\nM99\n");
    EXPECT_EQ(last_value(fanuc, "#500"), "1") << fanuc.events;
    const Played fagor =
        run("fagor",
            "G152\nG00 X20\n(MCALL 73)\nX20\n(MDOFF)\nM30\n(SUB 73)\n(P105=P105+1)\nX20\n(RET)\n");
    EXPECT_EQ(last_value(fagor, "P105"), "2") << fagor.events;
}

// A drilling cycle that holds from block to block drills where an axis is named.
TEST(ModalCalls, OfModalDrillingCyclesDrillWhereTheToolStands) {
    const Played played =
        run("nct", "G17 G94\nG0 X35. Z10.\nG81 Z-20. R5. F100\nX35.\nM8\nG80\nM30\n");
    EXPECT_EQ(played.errors, 0u) << played.events;
    EXPECT_EQ(holes_at(played, "\"X\":35,\"Z\":-20"), 2u) << played.events;
}

}  // namespace
}  // namespace polyturn::channels::testing
