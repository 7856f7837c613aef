// Descriptions in a program: read back as they were written, in each language; the blocks end where
// the contour ends.
#include "hmi/contour/contour_text.hpp"

#include <gtest/gtest.h>

#include <cmath>

namespace polyturn::contour {
namespace {

using Language = Writing::Language;

Description shaft() {
    Description out;
    out.contour.start = {0, 10};
    out.first = 100;
    out.last = 200;
    Element line, arc, rise;
    line.angle = 180;
    line.chamfer = 0;
    arc.kind = Kind::ArcCw;
    arc.tangent = true;
    arc.radius = 8;
    arc.z = -30;
    arc.x = 16;
    rise.x = 30.125;
    rise.angle = 120;
    rise.z = -30 - (30.125 - 16) / std::tan(60 * M_PI / 180);
    out.contour.elements = {line, arc, rise};
    return out;
}

TEST(ContourText, IsReadBackInEachLanguage) {
    for (const Language language : {Language::Family, Language::Fagor, Language::Sinumerik})
        for (const bool diameter : {true, false}) {
            const Writing writing{language, diameter, language != Language::Family, false, 3};
            const Description told = shaft();
            const Solved solved = solve(told.contour);
            ASSERT_TRUE(solved.complete());
            std::vector<std::string> lines{"before", "N5 G0"};
            for (const std::string& line : write_contour(told, solved, writing))
                lines.push_back(line);
            lines.push_back("after");
            for (int at = 2; at < static_cast<int>(lines.size()) - 1; ++at) {
                const Place place = find_contour(lines, at);
                ASSERT_EQ(place.from, 2) << at;
                EXPECT_EQ(place.to, static_cast<int>(lines.size()) - 2);
                EXPECT_TRUE(place.complete);
                const auto read = read_contour(lines, place, writing);
                ASSERT_TRUE(read);
                EXPECT_EQ(write_contour(*read, solve(read->contour), writing),
                          write_contour(told, solved, writing));
            }
            EXPECT_LT(find_contour(lines, 1).to, find_contour(lines, 1).from);
            EXPECT_LT(find_contour(lines, static_cast<int>(lines.size()) - 1).to, 0);
        }
}

TEST(ContourText, BlocksAreThoseOfTheLanguage) {
    const Description told = shaft();
    const Solved solved = solve(told.contour);
    const auto family = blocks_of(told, solved, {Language::Family, true, false, false, 3});
    ASSERT_EQ(family.size(), 4u);
    EXPECT_EQ(family[0], "N100 G1 X20. Z0.");
    EXPECT_EQ(family[2].substr(0, 16), "G2 X32. Z-30. R8");
    EXPECT_EQ(family[3].substr(0, 15), "N200 G1 X60.25 ");
    const auto siemens = blocks_of(told, solved, {Language::Sinumerik, false, true, false, 3});
    EXPECT_EQ(siemens[0], "N100 G90 G1 X10 Z0");
    EXPECT_NE(siemens[2].find("CR=8"), std::string::npos);
    const auto fagor = blocks_of(told, solved, {Language::Fagor, true, true, false, 3});
    EXPECT_EQ(fagor[2].substr(0, 14), "G2 X32 Z-30 R8");
}

// An arc of 300 degrees is two blocks; their radius is the arc's and the last ends where it ends.
TEST(ContourText, LargeArcsAreCutInParts) {
    Description told;
    told.contour.start = {0, 10};
    Element arc;
    arc.kind = Kind::ArcCcw;
    arc.radius = 10;
    arc.angle = 90;
    arc.sweep = 300;
    told.contour.elements = {arc};
    const Solved solved = solve(told.contour);
    ASSERT_TRUE(solved.complete());
    const auto blocks = blocks_of(told, solved, {Language::Family, true, false, false, 3});
    EXPECT_EQ(blocks.size(), 3u);
    for (std::size_t i = 1; i < blocks.size(); ++i) EXPECT_EQ(blocks[i].substr(0, 2), "G3");
}

TEST(ContourText, WhatSomebodyHasBrokenIsNamed) {
    std::vector<std::string> lines{"(CONTOUR DIA Z0 X20)", "(LINE A180 Q)", "(BLOCKS)",
                                   "(CONTOUR END)"};
    int fault = -1;
    EXPECT_FALSE(read_contour(lines, find_contour(lines, 0), {}, &fault));
    EXPECT_EQ(fault, 1);
    lines[1] = "(LINE A18O)";
    EXPECT_FALSE(read_contour(lines, find_contour(lines, 0), {}, &fault));
    lines[1] = "(PARABOLA A18)";
    EXPECT_FALSE(read_contour(lines, find_contour(lines, 0), {}, &fault));
    EXPECT_FALSE(find_contour({"(CONTOUR END)", "G1"}, 1).complete);
}

}  // namespace
}  // namespace polyturn::contour
