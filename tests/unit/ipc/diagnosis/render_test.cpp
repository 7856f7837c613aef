// What a diagnosis prints under its text: the line with a mark under the word.
#include <gtest/gtest.h>

#include "ipc/diagnosis/diagnosis.hpp"
#include "ipc/diagnosis/display_language.hpp"

namespace polyturn {
namespace {

// The second and third line of what is printed: the source line behind "| ", and the column of the
// mark in it.
struct Printed {
    std::string line;
    std::size_t mark;
};
Printed printed(std::uint32_t column, std::uint32_t length, std::string_view source) {
    const std::string text = render({Alarm::AddressIllegal, {"a.nc", 3, column, length}, {}, "X"},
                                    Dialect::Fanuc, source);
    const std::size_t first = text.find('\n') + 1, second = text.find('\n', first) + 1;
    return {text.substr(first + 8, second - first - 9), text.find('^', second) - second - 8};
}

TEST(Diagnosis, MarksTheWordUnderItsLine) {
    const Printed short_line = printed(5, 3, "G1 XX40. Z2.");
    EXPECT_EQ(short_line.line, "G1 XX40. Z2.");
    EXPECT_EQ(short_line.mark, 4u);
}

TEST(Diagnosis, OfALineThatFillsScreensShowsWhatStandsAroundTheWord) {
    const std::string_view e_acute = "\xC3\xA9";
    std::string line(20'000, 'a');
    line.replace(10'000, 3, "G99");
    for (std::size_t at = 9'900; at < 9'990; at += 2) line.replace(at, 2, e_acute);
    const Printed there = printed(10'001, 3, line);
    EXPECT_LE(there.line.size(), 240u);
    ASSERT_LT(there.mark, there.line.size());
    EXPECT_EQ(there.line.substr(there.mark, 3), "G99");
    EXPECT_EQ(there.line.substr(0, 2), e_acute);  // no half letters
    EXPECT_LE(printed(0, 0, line).line.size(), 240u);
}

TEST(Diagnosis, WritesItsFiguresAsPeopleDo) {
    const auto says = [](double value) {
        return text_in({Alarm::GotoNumberIllegal, {}, {value, 0}, {}}, DisplayLanguage::English);
    };
    EXPECT_EQ(says(9000001), "block number 9000001 cannot be a jump target");
    EXPECT_EQ(says(-123456789012), "block number -123456789012 cannot be a jump target");
    EXPECT_EQ(says(-0.0), "block number 0 cannot be a jump target");
    EXPECT_EQ(says(2.5), "block number 2.5 cannot be a jump target");
    EXPECT_EQ(says(1.0 / 3), "block number 0.333333 cannot be a jump target");
}

}  // namespace
}  // namespace polyturn
