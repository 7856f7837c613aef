// Number fields calculate: a table of good and a table of bad entries.
#include "hmi/text/calculate.hpp"

#include <gtest/gtest.h>

namespace polyturn::hmi {
namespace {

TEST(Calculate, ReadsWhatAnOperatorTypes) {
    struct Row {
        std::string_view text;
        bool added;
        double value;
    };
    constexpr Row kRows[] = {
        {"50/2", false, 25.0},      {"+0.05", true, 0.05},     {"+-0.02", true, -0.02},
        {"-0,02", false, -0.02},    {"2*(3+1.5)", false, 9.0}, {"  12.5 ", false, 12.5},
        {".5", false, 0.5},         {"1-2-3", false, -4.0},    {"8/2/2", false, 2.0},
        {"-(2+3)*2", false, -10.0}, {"+50/2", true, 25.0},     {"--1", false, 1.0},
    };
    for (const Row& row : kRows) {
        SCOPED_TRACE(row.text);
        const auto entry = calculate(row.text);
        ASSERT_TRUE(entry.has_value());
        EXPECT_EQ(entry->added, row.added);
        EXPECT_NEAR(entry->value, row.value, 1e-12);
    }
    EXPECT_NEAR(calculate("+0.05")->over(1.0), 1.05, 1e-12);
    EXPECT_NEAR(calculate("0.05")->over(1.0), 0.05, 1e-12);
}

TEST(Calculate, RefusesWhatIsNoNumber) {
    for (const std::string_view text :
         {"", " ", "+", "1/0", "1/(2-2)", "2*", "(1", "1)", "1 2", "12a", "1e5", "nan", "inf",
          "1..2", "((((((((((((((((((((((((((((((((((((1))))))))))))))))))))))))))))))))))))"})
        EXPECT_FALSE(calculate(text).has_value()) << text;
}

}  // namespace
}  // namespace polyturn::hmi
