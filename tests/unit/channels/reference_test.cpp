// The manual's lists of codes and words are what the interpreters' tables say.
#include "channels/fagor/grammar/reference.hpp"

#include <gtest/gtest.h>

#include <cstdlib>
#include <fstream>
#include <map>
#include <set>
#include <sstream>
#include <vector>

#include "channels/fanuc/g_codes.hpp"
#include "channels/fanuc/reference.hpp"
#include "channels/sinumerik/grammar/reference.hpp"
#include "tests/places.hpp"

namespace polyturn::channels::testing {
namespace {

// A column of channels/reference_words.txt: 0 English, 1 to 3 the others.
class WordsOf : public ReferenceWords {
public:
    explicit WordsOf(std::size_t column) : column_(column) {
        if (!column) return;
        std::ifstream file(std::string(kSourceFolder) + "/channels/reference_words.txt");
        for (std::string line; std::getline(file, line);) {
            if (line.empty() || line[0] == '#') continue;
            std::vector<std::string> cells(1);
            for (const char c : line)
                if (c == '|')
                    cells.emplace_back();
                else
                    cells.back() += c;
            if (cells.size() != 4) {
                ADD_FAILURE() << line;
                continue;
            }
            EXPECT_TRUE(known_.emplace(cells[0], cells[column]).second) << "twice: " << cells[0];
        }
    }
    std::string operator()(std::string_view english) const override {
        if (!column_ || english.empty()) return std::string(english);
        used_.insert(std::string(english));
        const auto found = known_.find(std::string(english));
        EXPECT_TRUE(found != known_.end() && !found->second.empty())
            << "channels/reference_words.txt has no: " << english;
        return found == known_.end() ? std::string(english) : found->second;
    }
    std::set<std::string> unused() const {
        std::set<std::string> out;
        for (const auto& [english, other] : known_)
            if (!used_.count(english)) out.insert(english);
        return out;
    }

private:
    std::size_t column_;
    std::map<std::string, std::string> known_;
    mutable std::set<std::string> used_;
};

struct Page {
    const char* language;
    std::string (*print)(const ReferenceWords&);
};
constexpr Page kPages[] = {{"fanuc", fanuc::reference_page},
                           {"fagor", fagor::reference_page},
                           {"sinumerik", sinumerik::reference_page}};
constexpr const char* kEndings[] = {"", ".ru", ".cs", ".hu"};  // columns of the words

TEST(LanguageReference, IsCurrentInEveryLanguage) {
    for (std::size_t column = 0; column < std::size(kEndings); ++column) {
        const WordsOf words(column);
        for (const Page& page : kPages) {
            SCOPED_TRACE(page.language + std::string(kEndings[column]));
            const std::string path = std::string(kSourceFolder) + "/docs/reference_" +
                                     page.language + kEndings[column] + ".md",
                              printed = page.print(words);
            if (std::getenv("POLYTURN_BLESS")) {
                std::ofstream(path) << printed;
                continue;
            }
            std::ifstream file(path);
            std::stringstream text;
            text << file.rdbuf();
            EXPECT_EQ(text.str(), printed) << "run tools/update_references.sh";
        }
        for (const std::string& one : words.unused()) ADD_FAILURE() << "no page has: " << one;
    }
    if (std::getenv("POLYTURN_BLESS"))
        FAIL() << "written: read the difference, and run again without POLYTURN_BLESS";
}

TEST(FanucReference, NamesEveryCodeByItsNumber) {
    for (const fanuc::GCode& row : fanuc::g_codes()) {
        const std::string number = std::to_string(row.tenths / 10) +
                                   (row.tenths % 10 ? "." + std::to_string(row.tenths % 10) : "");
        EXPECT_EQ(row.name, "G" + number);
        EXPECT_FALSE(row.text.empty());
    }
}

}  // namespace
}  // namespace polyturn::channels::testing
