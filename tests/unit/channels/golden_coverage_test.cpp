// Every G code of the fanuc and nct tables with every word that it takes, every alarm number of a
// fanuc control and every alarm that a program of either language can cause has a reviewed program
// below tests/golden.
#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cctype>
#include <filesystem>
#include <map>
#include <regex>
#include <set>
#include <sstream>
#include <vector>

#include "channels/fanuc/g_codes.hpp"
#include "ipc/diagnosis/diagnosis.hpp"
#include "tests/places.hpp"
#include "tests/unit/channels/file_content.hpp"

namespace polyturn::channels {
namespace {

namespace fs = std::filesystem;

fs::path folder_of(const char* language) {
    return fs::path(kSourceFolder) / "tests/golden" / language;
}

// A block of a golden program: in which system it is written, its G codes in tenths and the letters
// of its words. Comments do not count, nor do the letters of ",C", ",R" and ",A", which are words
// of their own.
struct GoldenBlock {
    std::uint8_t system;
    std::set<unsigned> codes;
    std::set<char> letters;
};

GoldenBlock block_of(const std::string& line, std::uint8_t system) {
    GoldenBlock block{system, {}, {}};
    for (std::size_t i = 0; i < line.size() && line[i] != '('; ++i) {
        if (line[i] < 'A' || line[i] > 'Z') continue;
        if (i == 0 || line[i - 1] != ',') block.letters.insert(line[i]);
        if (line[i] != 'G' || i + 1 == line.size() ||
            !std::isdigit(static_cast<unsigned char>(line[i + 1])))
            continue;
        unsigned tenths = 0;
        for (++i; i < line.size() && std::isdigit(static_cast<unsigned char>(line[i])); ++i)
            tenths = tenths * 10 + static_cast<unsigned>(line[i] - '0');
        tenths *= 10;
        if (i + 1 < line.size() && line[i] == '.' &&
            std::isdigit(static_cast<unsigned char>(line[i + 1])))
            tenths += static_cast<unsigned>(line[++i] - '0');
        else
            --i;
        block.codes.insert(tenths);
    }
    return block;
}

std::vector<GoldenBlock> blocks_below(const char* language) {
    std::vector<GoldenBlock> blocks;
    for (const auto& entry : fs::directory_iterator(folder_of(language))) {
        if (!entry.is_directory()) continue;
        const std::string sets = content(entry.path() / "sets");
        const std::uint8_t system = std::string_view(language) == "nct"           ? fanuc::kN
                                    : sets.find("F3401#7=1") != std::string::npos ? fanuc::kC
                                    : sets.find("F3401#6=1") != std::string::npos ? fanuc::kB
                                                                                  : fanuc::kA;
        std::istringstream lines(content(entry.path() / "program.nc"));
        for (std::string line; std::getline(lines, line);) blocks.push_back(block_of(line, system));
    }
    return blocks;
}

TEST(GoldenPrograms, HaveEveryCodeOfTheFanucTables) {
    const std::vector<GoldenBlock> fanuc = blocks_below("fanuc"), nct = blocks_below("nct");
    const auto stands = [](const std::vector<GoldenBlock>& blocks, const fanuc::GCode& row) {
        return std::ranges::any_of(blocks, [&](const GoldenBlock& block) {
            return (block.system & row.systems) && block.codes.contains(row.tenths);
        });
    };
    for (const fanuc::GCode& row : fanuc::g_codes()) {
        if (!row.act) continue;  // refused by name
        EXPECT_TRUE(!(row.systems & fanuc::kFanuc) || stands(fanuc, row))
            << row.name << ", " << row.text << ", has no program in tests/golden/fanuc";
        EXPECT_TRUE(!(row.systems & fanuc::kN) || stands(nct, row))
            << row.name << ", " << row.text << ", has no program in tests/golden/nct";
    }
}

TEST(GoldenPrograms, HaveEveryWordOfEveryCodeOfTheFanucTables) {
    std::vector<GoldenBlock> blocks = blocks_below("fanuc");
    for (GoldenBlock& block : blocks_below("nct")) blocks.push_back(std::move(block));
    for (const fanuc::GCode& row : fanuc::g_codes()) {
        if (!row.act || row.systems == fanuc::kM) continue;
        std::set<char> letters;
        for (const GoldenBlock& block : blocks)
            if ((block.system & row.systems) && block.codes.contains(row.tenths))
                letters.insert(block.letters.begin(), block.letters.end());
        for (const char word : row.takes)
            EXPECT_TRUE(word == 'x' || letters.contains(word))
                << row.name << ", " << row.text << ": no golden program has a block with it and "
                << word;
    }
}

// What golden programs of a language tell: the numbers of their alarms, digits as three at least,
// and the texts.
struct ToldAlarms {
    std::set<std::string> numbers, texts;
};

std::string value_of(const std::string& line, const std::string& key) {
    const std::size_t at = line.find("\"" + key + "\":");
    if (at == std::string::npos) return {};
    std::string value;
    std::size_t i = at + key.size() + 3;
    const bool quoted = line[i] == '"';
    for (i += quoted; i < line.size() &&
                      (quoted ? line[i] != '"' : std::isalnum(static_cast<unsigned char>(line[i])));
         ++i)
        value += line[i];
    return value;
}

void collect_alarms(const char* language, ToldAlarms& told) {
    for (const auto& entry : fs::directory_iterator(folder_of(language))) {
        std::istringstream events(content(entry.path() / "expected.jsonl"));
        for (std::string line; std::getline(events, line);) {
            if (line.find("\"ev\":\"alarm\"") == std::string::npos) continue;
            const std::string number = value_of(line, "number");
            told.numbers.insert(std::string(3 - std::min<std::size_t>(3, number.size()), '0') +
                                number);
            told.texts.insert(value_of(line, "text"));
        }
    }
}

// The row's text, whatever stands for {0}, {1} and {d}.
bool is_told(const AlarmRow& row, const ToldAlarms& told) {
    std::string pattern;
    for (std::size_t i = 0; i < row.text.size(); ++i) {
        if (row.text[i] == '{') {
            pattern += ".*";
            i = row.text.find('}', i);
            continue;
        }
        if (!std::isalnum(static_cast<unsigned char>(row.text[i])) && row.text[i] != ' ')
            pattern += '\\';
        pattern += row.text[i];
    }
    const std::regex text(pattern);
    return std::ranges::any_of(told.texts,
                               [&](const std::string& one) { return std::regex_match(one, text); });
}

TEST(GoldenPrograms, HaveEveryAlarmOfAFanucControl) {
    ToldAlarms told;
    collect_alarms("fanuc", told);
    for (std::uint16_t id = 0; id < kAlarmCount; ++id) {
        const AlarmRow& row = alarm_row(static_cast<Alarm>(id));
        const std::string number(row.number[static_cast<std::size_t>(Dialect::Fanuc)]);
        if (number.empty()) continue;
        EXPECT_TRUE(told.numbers.contains(number))
            << "alarm " << number << " has no program in tests/golden/fanuc";
    }
}

// What the sources of both languages and of all that they use can tell. Left out, each for its
// reason:
struct LeftOut {
    std::string_view alarm, why;
};
constexpr auto kLeftOut = std::to_array<LeftOut>({
    {"FileUnreadable", "a disk that fails while it is read"},
    {"StoreRowIgnored", "a damaged store"},
    {"ProgramNumberMissing", "check of a channel that the machine does not have"},
    {"CompIdleBlocks",
     "fagor and sinumerik: here any number of blocks may stand between two moves "
     "(fanuc_lathe 3.12)"},
    {"CompNoOffsetMeeting", "sinumerik: elements that are too short for the nose"},
    {"CurveUnderCompensation", "sinumerik: splines and polynomials"},
    {"FagorTangential", "fagor: G37 to G39"},
    {"FagorZoneEntered", "fagor: G122"},
    {"FagorZoneLeft", "fagor: G122"},
    {"ProgramAlarmUnsure",
     "several channels whose axes follow each other: examples/jobs/transfer, "
     "tests/e2e/check/check_and_run_e2e.py"},
    {"SubframeRotates", "sinumerik: corners and compensation in a plane that a frame inclines"},
});

TEST(GoldenPrograms, HaveEveryAlarmThatAProgramCanCause) {
    ToldAlarms told;
    collect_alarms("fanuc", told);
    collect_alarms("nct", told);
    std::map<std::string_view, const AlarmRow*> rows;
    for (std::uint16_t id = 0; id < kAlarmCount; ++id)
        rows[alarm_row(static_cast<Alarm>(id)).key] = &alarm_row(static_cast<Alarm>(id));
    std::set<std::string> used;
    for (const char* folder : {"fanuc", "nct", "cycles", "compensation", "corners", "state",
                               "pipeline", "text", "path", "check"})
        for (const auto& entry :
             fs::recursive_directory_iterator(fs::path(kSourceFolder) / "channels" / folder)) {
            if (!entry.is_regular_file()) continue;
            const std::string text = content(entry.path());
            for (std::size_t at = 0; (at = text.find("Alarm::", at)) != std::string::npos;) {
                std::string key;
                for (at += 7;
                     at < text.size() && std::isalnum(static_cast<unsigned char>(text[at])); ++at)
                    key += text[at];
                if (rows.contains(key)) used.insert(key);
            }
        }
    EXPECT_GT(used.size(), 100u);
    for (const LeftOut& one : kLeftOut)
        EXPECT_TRUE(used.erase(std::string(one.alarm)))
            << one.alarm << " is not told any more: " << one.why;
    for (const std::string& key : used) {
        if (key == "MacroAlarm") {  // #3000 = n: alarm 3000 + n with a text of the program's own
            EXPECT_TRUE(told.numbers.lower_bound("3000") != told.numbers.end() &&
                        *told.numbers.lower_bound("3000") <= "3200");
            continue;
        }
        // By its text: several alarms share a number of the control.
        EXPECT_TRUE(is_told(*rows[key], told))
            << key << " has no program in tests/golden/fanuc or nct";
    }
}

}  // namespace
}  // namespace polyturn::channels
