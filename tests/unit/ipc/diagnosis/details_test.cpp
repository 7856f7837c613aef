// What diagnoses say of the very case: complete in every language, and no refusal of the store, the
// kernel or the supervisor without a row.
#include "ipc/diagnosis/details.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <filesystem>
#include <fstream>
#include <regex>
#include <set>
#include <sstream>

#include "tests/places.hpp"
#include "tests/unit/ipc/left_english.hpp"

namespace polyturn {
namespace {

std::multiset<char> quoted_parts(std::string_view text) {
    std::multiset<char> out;
    for (std::size_t i = 0; i + 2 < text.size(); ++i)
        if (text[i] == '{' && text[i + 2] == '}') out.insert(text[i + 1]);
    return out;
}

// A row with its parts filled in.
std::string filled(std::string_view pattern) {
    std::string out(pattern);
    for (const char part : {'0', '1', '2', '3'})
        for (std::size_t at; (at = out.find(std::string("{") + part + "}")) != std::string::npos;)
            out.replace(at, 3, std::to_string(part - '0' + 7));
    return out;
}

TEST(Details, AreCompleteInEveryLanguage) {
    for (const DetailRow& row : detail_rows())
        for (const DisplayLanguage display_language : kDisplayLanguages) {
            const std::string_view told = row.in[static_cast<std::size_t>(display_language)];
            EXPECT_EQ(quoted_parts(told), quoted_parts(row.in[0])) << told;
            EXPECT_FALSE(left_english(row.in[0], told, display_language)) << told;
            for (std::size_t i = 0; i < told.size(); ++i)
                if (told[i] == '{') {
                    EXPECT_TRUE(i + 2 < told.size() && told[i + 1] >= '0' && told[i + 1] <= '3' &&
                                told[i + 2] == '}')
                        << told;
                }
        }
}

TEST(Details, AreReadInEveryLanguageFromEveryOther) {
    for (const DetailRow& row : detail_rows())
        for (const DisplayLanguage to : kDisplayLanguages) {
            // From English the row itself is found; from the others at least one that reads the
            // same in English.
            EXPECT_EQ(detail_in(filled(row.in[0]), to),
                      filled(row.in[static_cast<std::size_t>(to)]));
            EXPECT_EQ(
                detail_in(filled(row.in[static_cast<std::size_t>(to)]), DisplayLanguage::English),
                filled(row.in[0]));
        }
    EXPECT_EQ(detail_in("O1001.nc", DisplayLanguage::Russian), "O1001.nc");
    EXPECT_EQ(detail_in("channel L2 has no axis Q", DisplayLanguage::Russian),
              "в канале L2 нет оси Q");
}

TEST(Details, StandInTheTextOfTheirAlarm) {
    const Diagnosis refused{Alarm::StoreRequestBad, {}, {}, "there is nothing to take back"};
    EXPECT_NE(text_in(refused, DisplayLanguage::Russian).find("нечего отменять"), std::string::npos)
        << text_in(refused, DisplayLanguage::Russian);
    EXPECT_NE(text_in(refused, DisplayLanguage::English).find("nothing to take back"),
              std::string::npos);
    const auto told = retell(alarm_number(Alarm::NotReady, Dialect::Polyturn), Dialect::Polyturn,
                             Diagnosis{Alarm::NotReady, {}, {}, "the axis still moves"}.text(),
                             DisplayLanguage::Czech);
    ASSERT_TRUE(told);
    EXPECT_NE(told->text.find("osa se ještě pohybuje"), std::string::npos) << told->text;
}

// The statements of a source file, each on one line and without comments.
std::vector<std::string> statements_of(const std::filesystem::path& path) {
    std::ifstream file(path);
    std::vector<std::string> out(1);
    for (std::string line; std::getline(file, line);) {
        line.erase(0, line.find_first_not_of(' '));
        if (line.starts_with("//") || line.starts_with('#')) continue;
        out.back() += ' ' + line;
        if (line.ends_with(';') || line.find(";  //") != std::string::npos) out.emplace_back();
    }
    return out;
}

bool has_row(const std::string& written) {
    if (detail_in(written, DisplayLanguage::Russian) != written) return true;
    return std::ranges::any_of(detail_rows(), [&](const DetailRow& row) {
        return row.in[0].find(written) != std::string_view::npos;
    });
}

// Folders whose refusals people read in their language: the store, and the cyclic process.
constexpr const char* kTranslatedFolders[] = {
    "toolmgmt",        "kernel/axes",     "kernel/by_hand", "kernel/channel",
    "kernel/gate",     "kernel/plc/link", "kernel/records", "kernel/protection",
    "kernel/spindles", "kernel/tick",     "kernel/tools",   "kernel/waits"};

// Every text of two words and more that the sources give to a diagnosis of the store and the
// cyclic process stands in a row.
TEST(Details, NoRefusalIsWithoutARow) {
    const std::regex call(R"((?:fault|alarm|raise|refuse)\(\s*Alarm::\w+,[^;{}]*\)|)"
                          R"(\{\s*Alarm::\w+,\s*\{\},\s*\{\},[^;{}]*\})");
    const std::regex literal(R"re("((?:[^"\\]|\\.)*)")re"), words("[a-z]{3,} [a-z]{2,}");
    std::size_t seen = 0;
    for (const char* folder : kTranslatedFolders)
        for (const auto& entry : std::filesystem::recursive_directory_iterator(
                 std::string(kSourceFolder) + "/" + folder)) {
            if (entry.path().extension() != ".cpp") continue;
            for (const std::string& statement : statements_of(entry.path()))
                for (std::sregex_iterator found(statement.begin(), statement.end(), call), end;
                     found != end; ++found) {
                    const std::string text = found->str();
                    for (std::sregex_iterator piece(text.begin(), text.end(), literal);
                         piece != end; ++piece) {
                        const std::string written = (*piece)[1].str();
                        if (!std::regex_search(written, words)) continue;
                        ++seen;
                        EXPECT_TRUE(has_row(written)) << entry.path().filename() << ": " << written;
                    }
                }
        }
    EXPECT_GT(seen, 80u);
}

}  // namespace
}  // namespace polyturn
