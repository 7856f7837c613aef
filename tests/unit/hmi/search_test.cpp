// What is typed by a finger has no accents.
#include "hmi/text/search.hpp"

#include <gtest/gtest.h>

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

}  // namespace
}  // namespace polyturn::hmi
