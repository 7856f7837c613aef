// What people read of parameters: every row stands in every language, and says there what it says
// in English of the same bits.
#include "ipc/params/translations.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cctype>
#include <set>
#include <string>
#include <vector>

#include "tests/unit/ipc/left_english.hpp"

namespace polyturn::params {
namespace {

constexpr DisplayLanguage kOthers[] = {DisplayLanguage::Russian, DisplayLanguage::Czech,
                                       DisplayLanguage::Hungarian};

TEST(ParameterTranslations, EveryRowIsTranslatedWithItsBits) {
    for (const DisplayLanguage display_language : kOthers)
        for (const Row& row : rows()) {
            SCOPED_TRACE(testing::Message()
                         << static_cast<int>(display_language) << ' ' << row.number);
            const RowWords words = words_of(row, display_language);
            EXPECT_FALSE(left_english(row.name, words.name, display_language)) << words.name;
            EXPECT_FALSE(left_english(row.meaning, words.meaning, display_language))
                << words.meaning;
            EXPECT_FALSE(row.acts != "yes" && left_english(row.acts, words.acts, display_language))
                << words.acts;
            for (const Bit& bit : row.bits)
                EXPECT_FALSE(left_english(bit.meaning, words.bits[bit.number], display_language))
                    << bit.name << ": " << words.bits[bit.number];
        }
}

// A number that a text names (N0108, 99, #4) is a fact: no language may have another.
TEST(ParameterTranslations, ATranslationNamesTheSameParametersAsTheEnglishRow) {
    const auto named = [](std::string_view text) {
        std::vector<std::string> out;
        for (std::size_t i = 0; i + 4 < text.size(); ++i) {
            if ((text[i] != 'N' && text[i] != 'F') ||
                (i && std::isalnum(static_cast<unsigned char>(text[i - 1]))))
                continue;
            if (!std::all_of(text.begin() + i + 1, text.begin() + i + 5,
                             [](char c) { return c >= '0' && c <= '9'; }))
                continue;
            if (i + 5 < text.size() && std::isdigit(static_cast<unsigned char>(text[i + 5])))
                continue;
            out.emplace_back(text.substr(i, 5));
        }
        std::sort(out.begin(), out.end());
        out.erase(std::unique(out.begin(), out.end()), out.end());
        return out;
    };
    for (const DisplayLanguage display_language : kOthers)
        for (const Row& row : rows())
            EXPECT_EQ(named(words_of(row, display_language).meaning), named(row.meaning))
                << static_cast<int>(display_language) << ' ' << row.number;
}

// The states of a bit (0 and 1), counts and limits are facts too: a translation that forgets the 0
// tells of one state only.
TEST(ParameterTranslations, ATranslationTellsTheSameNumbersAsTheEnglishRow) {
    const auto numbers = [](std::string_view text) {
        const auto digit = [&](std::size_t i) {
            return i < text.size() && std::isdigit(static_cast<unsigned char>(text[i]));
        };
        std::set<std::string> out;
        for (std::size_t i = 0; i < text.size(); ++i) {
            std::string number;
            while (digit(i)) number += text[i++];
            if (!number.empty()) out.insert(number);
        }
        return out;
    };
    for (const DisplayLanguage display_language : kOthers)
        for (const Row& row : rows()) {
            SCOPED_TRACE(testing::Message()
                         << static_cast<int>(display_language) << ' ' << row.number);
            const RowWords words = words_of(row, display_language);
            EXPECT_EQ(numbers(words.meaning), numbers(row.meaning));
            for (const Bit& bit : row.bits)
                EXPECT_EQ(numbers(words.bits[bit.number]), numbers(bit.meaning)) << bit.name;
        }
}

TEST(ParameterTranslations, EnglishIsTheTableItself) {
    const Row& row = *find("N0106");
    const RowWords words = words_of(row, DisplayLanguage::English);
    EXPECT_EQ(words.name, row.name);
    EXPECT_EQ(words.meaning, row.meaning);
    EXPECT_EQ(words.acts, row.acts);
    EXPECT_EQ(words.bits[3], row.bits[3].meaning);
    EXPECT_TRUE(words_of(*find("N0104"), DisplayLanguage::Czech).bits[1].empty())
        << "N0104 has no bit #1";
}

}  // namespace
}  // namespace polyturn::params
