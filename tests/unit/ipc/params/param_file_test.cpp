// Whole files, and taking them over.
#include "ipc/params/param_file.hpp"

#include <gtest/gtest.h>

#include <limits>
#include <memory>

namespace polyturn::params {
namespace {

std::unique_ptr<Table> fresh() {
    auto table = std::make_unique<Table>();
    set_defaults(*table);
    return table;
}

TEST(ParameterFile, IsReadWithAnyLineEnd) {
    for (const char* text :
         {"; two axes\n\nN0304 A1=1\nN0304 A2=2\n",
          "; two axes\r\n\r\nN0304 A1=1\r\nN0304 A2=2\r\n", "; two axes\r\rN0304 A1=1\rN0304 A2=2",
          "\xef\xbb\xbf; two axes\n \t \nN0304 A1=1\nN0304 A2=2   ; last"}) {
        SCOPED_TRACE(text);
        const ParsedFile file = parse_param_file(text, "machine.params");
        EXPECT_TRUE(file.ok());
        ASSERT_EQ(file.assignments.size(), 2U);
        EXPECT_EQ(file.assignments[0].place.line, 3U);
        EXPECT_EQ(file.assignments[1].place.line, 4U);
        EXPECT_EQ(file.assignments[1].place.file, "machine.params");
        EXPECT_DOUBLE_EQ(file.assignments[1].number, 2.0);
    }
}

TEST(ParameterFile, GivesEveryBadLineWithItsPlace) {
    const ParsedFile file =
        parse_param_file("N0304 A1=1\nN0304 L1=1\n\nN9999=1\nN0304 A2=2\nN0304 A3=-2\n", "m");
    EXPECT_FALSE(file.ok());
    EXPECT_EQ(file.assignments.size(), 2U);
    ASSERT_EQ(file.diagnoses.size(), 3U);
    EXPECT_EQ(file.diagnoses[0].place.line, 2U);
    EXPECT_EQ(file.diagnoses[0].place.column, 7U);
    EXPECT_EQ(file.diagnoses[1].place.line, 4U);
    EXPECT_EQ(file.diagnoses[1].alarm, Alarm::ParamUnknown);
    EXPECT_EQ(file.diagnoses[2].place.line, 6U);
    EXPECT_EQ(file.diagnoses[2].alarm, Alarm::ParamRange);
    EXPECT_EQ(file.diagnoses[2].place.file, "m");
}

TEST(ParameterFile, OfAnotherKindIsRefusedWhole) {
    EXPECT_EQ(parse_param_file(std::string_view("\xff\xfeN\0", 4), "m").diagnoses.at(0).alarm,
              Alarm::FileUtf16);
    EXPECT_EQ(parse_param_file(std::string_view("N0304\0=1", 8), "m").diagnoses.at(0).alarm,
              Alarm::FileBinary);
    EXPECT_TRUE(parse_param_file("", "m").ok());
    EXPECT_TRUE(parse_param_file("\n\r\n;\n", "m").ok());
}

TEST(ParameterFile, StopsAfterTooManyBadLines) {
    std::string text;
    for (std::size_t line = 0; line < kMostDiagnoses + 500; ++line) text += "rubbish\n";
    EXPECT_EQ(parse_param_file(text, "m").diagnoses.size(), kMostDiagnoses + 1);
}

TEST(ParameterFile, IsAppliedInItsOrder) {
    auto table = fresh();
    const auto file = parse_param_file(
        "N0304=5000\nN0304 A2=6000\nN0106#0=1\nN0106#2 A3=1\n"
        "N0106#0 A3=0\nN0003 L2=Lower\nF5002=00000010\n",
        "m");
    ASSERT_TRUE(apply(*table, file).ok());
    EXPECT_DOUBLE_EQ(get(*table, n0304_rapid, 1), 5000.0);
    EXPECT_DOUBLE_EQ(get(*table, n0304_rapid, 2), 6000.0);
    EXPECT_DOUBLE_EQ(get(*table, n0304_rapid, 96), 5000.0);
    EXPECT_EQ(get(*table, n0106_axis_properties, 1), 1U);
    EXPECT_EQ(get(*table, n0106_axis_properties, 3), 4U);
    EXPECT_EQ(get_text(*table, n0003_channel_name, 2), "Lower");
    EXPECT_TRUE(bit(*table, f5002, 16, 1));
    EXPECT_FALSE(bit(*table, f5002, 16, 0));
}

TEST(ParameterFile, WithOneErrorChangesNothing) {
    auto table = fresh();
    const auto result = apply(*table, parse_param_file("N0304=5000\nN0304 A2=fast\n", "m"));
    ASSERT_FALSE(result.ok());
    EXPECT_EQ(result.diagnosis().place.line, 2U);
    EXPECT_TRUE(same(*table, *fresh()));
}

TEST(ParameterFile, WarnsWhereALineSetsTheSameAgain) {
    const auto file =
        parse_param_file("N0304=1\nN0304 A1=2\nN0106#0 A1=1\nN0106#1 A1=1\nN0304 A1=3\n", "m");
    EXPECT_TRUE(file.ok());
    ASSERT_EQ(file.diagnoses.size(), 1U);
    EXPECT_EQ(file.diagnoses[0].alarm, Alarm::ParamTwice);
    EXPECT_EQ(file.diagnoses[0].place.line, 5U);
    EXPECT_EQ(file.diagnoses[0].text(), "set twice: N0304 A1, already on line 2");
    auto table = fresh();
    ASSERT_TRUE(apply(*table, file).ok());
    EXPECT_DOUBLE_EQ(get(*table, n0304_rapid, 1), 3.0);
}

// Assignments can be made without a line (HMI, store): the same limits hold.
TEST(Assignments, AreCheckedAgainBeforeTheFirstIsWritten) {
    const Assignment good = *parse_assignment("N0304 A1=1");
    std::vector<Assignment> bad(7, good);
    bad[0].number = -1.0;
    bad[1].number = std::numeric_limits<double>::quiet_NaN();
    bad[2].instance = kMaxAxes + 1;
    bad[3].bit = 0;
    bad[4].element = 1;
    bad[5].row = nullptr;
    bad[6] = *parse_assignment("PT_LANGUAGE=nct");
    bad[6].text = "klingon";
    for (const Assignment& one : bad) {
        auto table = fresh();
        const std::vector<Assignment> both{good, one};
        EXPECT_FALSE(params::apply(*table, both).ok());
        EXPECT_TRUE(same(*table, *fresh()));
    }
}

}  // namespace
}  // namespace polyturn::params
