// What fanuc programs leave on the disk: registered B programs (fanuc_lathe 10.4.6) and names of
// variables.
#include <gtest/gtest.h>

#include "channels/fanuc/macro/variable_names.hpp"
#include "channels/fanuc/b_axis/b_memory.hpp"

namespace polyturn::channels::fanuc {
namespace {

BProgramTexts some() {
    BProgramTexts programs;
    BStep line;
    line.motion = 2;
    line.absolute = line.has_b = true;
    line.b = 40.1;
    line.feed = 200;
    line.feed_turn = 0.02;
    BStep code;
    code.letter = 'M';
    code.code = 55;
    BStep hole;
    hole.drilling = 830;
    hole.has_b = hole.has_r = hole.has_p = true;
    hole.b = -20;
    hole.r = -2;
    hole.q = 5;
    hole.p = 0.5;
    hole.feed_mode = 2;
    programs[0] = {line, code};
    programs[2] = {hole};
    return programs;
}

TEST(BMemory, GivesBackWhatItWasGiven) {
    const auto back = b_programs(b_text(some()));
    ASSERT_TRUE(back.has_value());
    EXPECT_EQ(b_text(*back), b_text(some()));
    ASSERT_EQ((*back)[0].size(), 2u);
    EXPECT_TRUE((*back)[1].empty());
    EXPECT_EQ((*back)[0][0].b, 40.1);
    EXPECT_TRUE((*back)[0][0].absolute);
    EXPECT_EQ((*back)[0][1].letter, 'M');
    EXPECT_EQ((*back)[2][0].q, 5);
    EXPECT_FALSE((*back)[2][0].absolute);
    EXPECT_TRUE(b_programs(b_text({})).has_value());
}

TEST(BMemory, ATextThatIsNotWholeIsNone) {
    const std::string whole = b_text(some());
    for (std::size_t length = 0; length < whole.size(); ++length)
        EXPECT_FALSE(b_programs(whole.substr(0, length)).has_value()) << length;
    EXPECT_FALSE(b_programs(whole + " ").has_value());
    // spoilt anywhere: another value or nothing, never a crash
    for (std::size_t at = 0; at < whole.size(); ++at) {
        std::string spoilt = whole;
        spoilt[at] = '~';
        EXPECT_FALSE(b_programs(spoilt).has_value()) << at;
    }
    EXPECT_FALSE(b_programs("b-axis programs 1\nprogram 1 4000000000\n").has_value());
}

TEST(VariableNames, ANameBelongsToOneVariable) {
    VariableNames names;
    names.name(510, "Tool_No");
    names.name(511, "COUNT");
    EXPECT_EQ(names.find("TOOL_NO"), 510);
    names.name(512, "count");
    EXPECT_EQ(names.find("COUNT"), 512);
    names.name(510, "OTHER");
    EXPECT_EQ(names.find("TOOL_NO"), std::nullopt);
    VariableNames back;
    ASSERT_TRUE(back.take(names.text()));
    EXPECT_EQ(back.find("other"), 510);
    EXPECT_EQ(back.text(), names.text());
    for (const char* bad :
         {"510", "510 A", "510  A\n", "510 1A\n", "A\n", "510 LONGERNAME\n", "510 A-B\n"})
        EXPECT_FALSE(back.take(bad)) << bad;
    EXPECT_EQ(back.find("other"), 510) << "nothing was taken";
}

}  // namespace
}  // namespace polyturn::channels::fanuc
