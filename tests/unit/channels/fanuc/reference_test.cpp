// The manual's list of codes is what the table says.
#include <gtest/gtest.h>

#include <cstdlib>
#include <fstream>
#include <sstream>

#include "channels/fanuc/g_codes.hpp"
#include "channels/fanuc/reference.hpp"

namespace polyturn::channels::testing {
namespace {

TEST(LanguageReference, OfTheFanucFamilyIsCurrent) {
    const std::string path = std::string(POLYTURN_SOURCE_DIR) + "/docs/reference_fanuc.md";
    if (std::getenv("POLYTURN_BLESS")) {
        std::ofstream(path) << fanuc::reference_page();
        GTEST_SKIP() << "written: read the diff";
    }
    std::ifstream file(path);
    std::stringstream text;
    text << file.rdbuf();
    EXPECT_EQ(text.str(), fanuc::reference_page()) << "run tools/update_references.sh";
}

TEST(LanguageReference, NamesEveryCodeByItsNumber) {
    for (const fanuc::GCode& row : fanuc::g_codes()) {
        const std::string number = std::to_string(row.tenths / 10) + (row.tenths % 10 ? "." + std::to_string(row.tenths % 10) : "");
        EXPECT_EQ(row.name, "G" + number);
        EXPECT_FALSE(row.text.empty());
    }
}

}  // namespace
}  // namespace polyturn::channels::testing
