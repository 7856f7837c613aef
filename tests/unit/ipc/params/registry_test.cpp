// The table itself: complete, without gaps, and found by name.
#include "ipc/params/registry.hpp"

#include <gtest/gtest.h>

#include <cctype>
#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <map>
#include <set>
#include <string>

#include "ipc/params/table.hpp"
#include "ipc/params/translations.hpp"

namespace polyturn::params {
namespace {

struct Range {
    int first, last;
};
// Which numbers the machine parameters have; gaps are gaps in the numbering, such as N0517 and
// N1208.
constexpr Range kMachineNumbers[] = {
    {0, 5},       {100, 110},   {200, 217},   {300, 335},   {400, 423},   {500, 516},
    {518, 540},   {600, 691},   {701, 823},   {900, 909},   {1000, 1009}, {1101, 1196},
    {1200, 1207}, {1209, 1274}, {1300, 1372}, {1400, 1416}, {1500, 1539}, {1600, 1614},
    {1700, 1761}, {1800, 1806}, {1900, 1914}, {2000, 2003}, {2100, 2108}, {2200, 2202},
    {2300, 2308}, {2400, 2400}, {2500, 2510}, {2600, 2642}, {2700, 2711}, {2800, 2808},
    {2900, 2924}, {3000, 3019}, {3100, 3112}, {3200, 3226}, {3300, 3302}, {5000, 5000},
    {5100, 5111},
};

TEST(ParameterRows, HoldEveryMachineParameterOnce) {
    std::set<std::string> wanted, found;
    for (const Range& range : kMachineNumbers)
        for (int number = range.first; number <= range.last; ++number) {
            char text[8];
            std::snprintf(text, sizeof text, "N%04d", number);
            wanted.insert(text);
        }
    for (const Row& row : rows())
        if (row.number[0] == 'N') {
            EXPECT_TRUE(found.insert(std::string(row.number)).second)
                << row.number << " stands twice";
        }
    EXPECT_EQ(wanted.size(), 971U);
    EXPECT_EQ(found, wanted);
}

TEST(ParameterRows, HaveWordsForEverything) {
    for (const Row& row : rows()) {
        SCOPED_TRACE(row.number);
        EXPECT_FALSE(row.name.empty());
        EXPECT_FALSE(row.group.empty());
        EXPECT_GE(row.meaning.size(), 8U);
        EXPECT_TRUE(row.acts == "yes" || row.acts.starts_with("never: ") ||
                    row.acts.starts_with("not yet: "))
            << row.acts;
        for (const Bit& bit : row.bits) EXPECT_FALSE(bit.meaning.empty());
    }
}

TEST(ParameterRows, ReachToTheCapacityOfTheImageNotOfTheLanguage) {
    for (const char* number : {"N0533", "N0534", "N0687", "N1101", "N1132", "N1802", "N2101",
                               "N2104", "N2107", "N2601", "N2612", "N2700", "N3204"})
        EXPECT_EQ(find(number)->max, static_cast<double>(kMaxAxes)) << number;
    for (const char* number : {"N0604", "N1801"})
        EXPECT_EQ(find(number)->max, static_cast<double>(kMaxSpindles)) << number;
    EXPECT_GE(find("N0002")->max, static_cast<double>(kMaxChannels));
    EXPECT_EQ(find("N0000")->max, static_cast<double>(kMaxGroups));
}

TEST(ParameterRows, OccupySlotsOfTheirOwn) {
    std::set<std::uint32_t> numbers, texts;
    for (const Row& row : rows())
        for (unsigned slot = 0; slot < instances(row.scope) * row.array; ++slot)
            EXPECT_TRUE(
                (row.type == Type::Text ? texts : numbers).insert(row.first_slot + slot).second)
                << row.number;
    EXPECT_EQ(numbers.size(), kNumberSlots);
    EXPECT_EQ(texts.size(), kTextSlots);
    EXPECT_EQ(*numbers.rbegin(), kNumberSlots - 1);
}

TEST(ParameterRows, HaveDefaultsThatTheyThemselvesAllow) {
    for (const Row& row : rows()) {
        SCOPED_TRACE(row.number);
        if (row.type == Type::Text) {
            EXPECT_TRUE(row.default_numbers.empty());
            continue;
        }
        for (unsigned element = 0; element < row.array; ++element) {
            EXPECT_TRUE(std::isfinite(row.default_number(element)));
            EXPECT_GE(row.default_number(element), row.min);
            EXPECT_LE(row.default_number(element), row.max);
        }
    }
}

TEST(FindParameter, KnowsEachRowInAnyCase) {
    for (const Row& row : rows()) {
        EXPECT_EQ(find(row.number), &row);
        std::string small(row.number);
        for (char& c : small) c = static_cast<char>(std::tolower(static_cast<unsigned char>(c)));
        EXPECT_EQ(find(small), &row);
    }
}

TEST(FindParameter, KnowsNothingElse) {
    for (const char* name : {"", "N", "N304", "N0517", "N1208", "N99999", "PT_", "PT_HORIZO",
                             "PT_HORIZONS", "F5002#1", "MEFI.79"})
        EXPECT_EQ(find(name), nullptr) << name;
    EXPECT_EQ(find(std::string(100'000, 'N')), nullptr);
}

TEST(NearestParameters, ProposeWhatWasProbablyMeant) {
    const auto first = [](std::string_view name) { return nearest(name).at(0); };
    EXPECT_EQ(first("N304"), "N0304");  // leading zero left out
    EXPECT_EQ(first("F1"), "F0001");
    EXPECT_EQ(first("n00304"), "N0304");
    EXPECT_EQ(first("PT_HORIZN"), "PT_HORIZON");
    EXPECT_EQ(first("PT_PATH_TOLERANCE"), "PT_PATH_TOL");
    EXPECT_EQ(first("N0340").substr(0, 2), "N0");
    EXPECT_EQ(first("NO304"), "N0304");  // letter O
    // nothing of another family, however alike the digits
    for (const auto& name : nearest("MD11411")) EXPECT_EQ(name.substr(0, 2), "MD");
    EXPECT_TRUE(nearest("????????").empty());
    EXPECT_LE(nearest("N0305").size(), 3U);
}

TEST(Descriptions, NameScopeLimitsUnitEffectAndBits) {
    const std::string text = describe(*find("N0106"));
    for (const char* part : {"N0106", "Axis Properties", "#0 DIA", "#7 HYP", "A1 to A96",
                             "0 to 255", "default 0", "acts: yes"})
        EXPECT_NE(text.find(part), std::string::npos) << part << " in\n" << text;
    for (const Row& row : rows()) EXPECT_NE(describe(row).find(row.number), std::string::npos);
}

TEST(Descriptions, AreToldInTheLanguageOfTheReader) {
    const char* before = std::getenv("POLYTURN_LANG");
    const std::string kept = before ? before : "";
    setenv("POLYTURN_LANG", "cs", 1);
    const Row& row = *find("N0106");
    const std::string text = describe(row);
    EXPECT_NE(text.find(words_of(row, DisplayLanguage::Czech).name), std::string::npos) << text;
    for (const char* part :
         {"jednou na osu, A1 až A96", "osm bitů, 0 až 255", "výchozí 0", "mění: ", "působí: ano"})
        EXPECT_NE(text.find(part), std::string::npos) << part << " in\n" << text;
    for (const char* word : {"ru", "cs", "hu"}) {
        setenv("POLYTURN_LANG", word, 1);
        for (const Row& one : rows()) {
            const std::string own = describe(one);
            for (const char* english :
                 {"once per", "changed by:", "takes effect", "; default ", "  acts:"})
                EXPECT_EQ(own.find(english), std::string::npos) << own;
        }
    }
    if (before)
        setenv("POLYTURN_LANG", kept.c_str(), 1);
    else
        unsetenv("POLYTURN_LANG");
}

}  // namespace
}  // namespace polyturn::params
