// The manual's lists of codes and words are what the interpreters' tables say.
#include <gtest/gtest.h>

#include <cstdlib>
#include <fstream>
#include <sstream>

#include "channels/fagor/reference.hpp"
#include "channels/fanuc/g_codes.hpp"
#include "channels/fanuc/reference.hpp"
#include "channels/sinumerik/reference.hpp"

namespace polyturn::channels::testing {
namespace {

struct Page {
    const char* language;
    std::string (*print)();
};

class LanguageReference : public ::testing::TestWithParam<Page> {};

TEST_P(LanguageReference, IsCurrent) {
    const std::string path = std::string(POLYTURN_SOURCE_DIR) + "/docs/reference_" + GetParam().language + ".md";
    if (std::getenv("POLYTURN_BLESS")) {
        std::ofstream(path) << GetParam().print();
        GTEST_SKIP() << "written: read the diff";
    }
    std::ifstream file(path);
    std::stringstream text;
    text << file.rdbuf();
    EXPECT_EQ(text.str(), GetParam().print()) << "run tools/update_references.sh";
}

INSTANTIATE_TEST_SUITE_P(All, LanguageReference, ::testing::Values(Page{"fanuc", fanuc::reference_page}, Page{"fagor", fagor::reference_page},
                                                                   Page{"sinumerik", sinumerik::reference_page}),
                         [](const auto& test) { return std::string(test.param.language); });

TEST(FanucReference, NamesEveryCodeByItsNumber) {
    for (const fanuc::GCode& row : fanuc::g_codes()) {
        const std::string number = std::to_string(row.tenths / 10) + (row.tenths % 10 ? "." + std::to_string(row.tenths % 10) : "");
        EXPECT_EQ(row.name, "G" + number);
        EXPECT_FALSE(row.text.empty());
    }
}

}  // namespace
}  // namespace polyturn::channels::testing
