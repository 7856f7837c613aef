// What is typed by a finger has no accents.
#include "hmi/text/search.hpp"

#include <gtest/gtest.h>

#include "hmi/machine/programs/setup_sheet.hpp"

namespace polyturn::hmi {
namespace {

TEST(Search, FindsWordsWithAccentsByTheirPlainLetters) {
    EXPECT_TRUE(holds(QString::fromUtf8("Nejvyšší otáčky vřetena"), "OTACKY"));
    EXPECT_TRUE(holds(QString::fromUtf8("Nejvyšší otáčky vřetena"), QString::fromUtf8("otáčky")));
    EXPECT_TRUE(holds(QString::fromUtf8("Főorsó gyorsulása"), "foorso"));
    EXPECT_FALSE(holds("Rapid traverse", "rapidly"));
}

TEST(Search, LeavesTheLettersOfOtherScripts) {
    EXPECT_EQ(withoutAccents(QString::fromUtf8("йё")), QString::fromUtf8("йё"));
    EXPECT_TRUE(holds(QString::fromUtf8("Ускорение оси"), QString::fromUtf8("ускорение")));
}

// The setup sheet: the same tool in another way of writing is none that stands there by mistake.
TEST(Search, ToolsThatAreWrittenInAnotherWay) {
    for (const auto& [wanted, mounted] : {std::pair{"roughing 80°", "ROUGH_80"},
                                          {"grooving 3 mm", "GROOVE_3"},
                                          {"finishing 35°", "FINISH_35"},
                                          {"thread 60°", "THREAD_60"},
                                          {"drill", "DRILL_8"}})
        EXPECT_TRUE(alikeNames(QString::fromUtf8(wanted), mounted)) << wanted;
    for (const auto& [wanted, mounted] : {std::pair{"grooving 3 mm", "FINISH_35"},
                                          {"roughing 80°", "ROUGH_55"},
                                          {"T1", "T2"},
                                          {"finishing 3", "GROOVE_3"}})
        EXPECT_FALSE(alikeNames(QString::fromUtf8(wanted), mounted)) << wanted;
}

}  // namespace
}  // namespace polyturn::hmi
