// Every G code of the fanuc and nct tables, every alarm number of a fanuc control and every alarm that a program of either language can
// cause has a reviewed program below tests/golden.
#include <gtest/gtest.h>

#include <array>
#include <cctype>
#include <filesystem>
#include <map>
#include <set>
#include <sstream>

#include "channels/fanuc/g_codes.hpp"
#include "ipc/diagnosis/diagnosis.hpp"
#include "tests/unit/channels/file_content.hpp"

namespace polyturn::channels {
namespace {

namespace fs = std::filesystem;

fs::path folder_of(const char* language) { return fs::path(POLYTURN_SOURCE_DIR) / "tests/golden" / language; }

// G codes, in tenths, of a program text; comments do not count.
void collect_codes(const std::string& text, std::set<unsigned>& codes) {
    bool comment = false;
    for (std::size_t i = 0; i < text.size(); ++i) {
        if (text[i] == '(') comment = true;
        if (text[i] == ')' || text[i] == '\n') comment = false;
        if (comment || text[i] != 'G' || i + 1 == text.size() || !std::isdigit(static_cast<unsigned char>(text[i + 1]))) continue;
        unsigned tenths = 0;
        for (++i; i < text.size() && std::isdigit(static_cast<unsigned char>(text[i])); ++i) tenths = tenths * 10 + static_cast<unsigned>(text[i] - '0');
        tenths *= 10;
        if (i + 1 < text.size() && text[i] == '.' && std::isdigit(static_cast<unsigned char>(text[i + 1]))) tenths += static_cast<unsigned>(text[++i] - '0');
        else --i;
        codes.insert(tenths);
    }
}

std::set<unsigned> codes_below(const char* language) {
    std::set<unsigned> codes;
    for (const auto& entry : fs::directory_iterator(folder_of(language)))
        if (entry.is_directory()) collect_codes(content(entry.path() / "program.nc"), codes);
    return codes;
}

TEST(GoldenPrograms, HaveEveryCodeOfTheFanucTables) {
    const std::set<unsigned> fanuc = codes_below("fanuc"), nct = codes_below("nct");
    for (const fanuc::GCode& row : fanuc::g_codes()) {
        if (!row.act) continue;   // refused by name
        EXPECT_TRUE(!(row.systems & fanuc::kFanuc) || fanuc.contains(row.tenths)) << row.name << " has no program in tests/golden/fanuc";
        EXPECT_TRUE(!(row.systems & fanuc::kN) || nct.contains(row.tenths)) << row.name << " has no program in tests/golden/nct";
    }
}

// Numbers of the alarms that golden programs of a language tell; digits as three at least.
void collect_alarms(const char* language, std::set<std::string>& told) {
    for (const auto& entry : fs::directory_iterator(folder_of(language))) {
        std::istringstream events(content(entry.path() / "expected.jsonl"));
        for (std::string line; std::getline(events, line);) {
            if (line.find("\"ev\":\"alarm\"") == std::string::npos) continue;
            const std::size_t at = line.find("\"number\":");
            if (at == std::string::npos) continue;
            std::string number;
            for (std::size_t i = line[at + 9] == '"' ? at + 10 : at + 9; i < line.size() && std::isalnum(static_cast<unsigned char>(line[i])); ++i) number += line[i];
            told.insert(std::string(3 - std::min<std::size_t>(3, number.size()), '0') + number);
        }
    }
}

TEST(GoldenPrograms, HaveEveryAlarmOfAFanucControl) {
    std::set<std::string> told;
    collect_alarms("fanuc", told);
    for (std::uint16_t id = 0; id < kAlarmCount; ++id) {
        const AlarmRow& row = alarm_row(static_cast<Alarm>(id));
        const std::string number(row.number[static_cast<std::size_t>(Dialect::Fanuc)]);
        if (number.empty()) continue;
        EXPECT_TRUE(told.contains(number)) << "alarm " << number << " has no program in tests/golden/fanuc";
    }
}

// What the sources of both languages and of all that they use can tell. Left out, each for its reason:
struct LeftOut { std::string_view alarm, why; };
constexpr auto kLeftOut = std::to_array<LeftOut>({
    {"FileUnreadable", "a disk that fails while it is read"},
    {"StoreRowIgnored", "a damaged store"},
    {"ProgramNumberMissing", "check of a channel that the machine does not have"},
    {"CompIdleBlocks", "fagor and sinumerik: here any number of blocks may stand between two moves (fanuc_lathe 3.12)"},
    {"CompNoOffsetMeeting", "sinumerik: elements that are too short for the nose"},
    {"CurveUnderCompensation", "sinumerik: splines and polynomials"},
    {"FagorTangential", "fagor: G37 to G39"},
    {"FagorZoneEntered", "fagor: G122"},
    {"FagorZoneLeft", "fagor: G122"},
    {"SubframeRotates", "sinumerik: corners and compensation in a plane that a frame inclines"},
});

TEST(GoldenPrograms, HaveEveryAlarmThatAProgramCanCause) {
    std::set<std::string> told;
    collect_alarms("fanuc", told), collect_alarms("nct", told);
    std::map<std::string_view, const AlarmRow*> rows;
    for (std::uint16_t id = 0; id < kAlarmCount; ++id) rows[alarm_row(static_cast<Alarm>(id)).key] = &alarm_row(static_cast<Alarm>(id));
    std::set<std::string> used;
    for (const char* folder : {"fanuc", "nct", "cycles", "compensation", "corners", "state", "text", "path", "check"})
        for (const auto& entry : fs::directory_iterator(fs::path(POLYTURN_SOURCE_DIR) / "channels" / folder)) {
            if (!entry.is_regular_file()) continue;
            const std::string text = content(entry.path());
            for (std::size_t at = 0; (at = text.find("Alarm::", at)) != std::string::npos;) {
                std::string key;
                for (at += 7; at < text.size() && std::isalnum(static_cast<unsigned char>(text[at])); ++at) key += text[at];
                if (rows.contains(key)) used.insert(key);
            }
        }
    EXPECT_GT(used.size(), 100u);
    for (const LeftOut& one : kLeftOut) EXPECT_TRUE(used.erase(std::string(one.alarm))) << one.alarm << " is not told any more: " << one.why;
    for (const std::string& key : used) {
        if (key == "MacroAlarm") {   // #3000 = n: alarm 3000 + n
            EXPECT_TRUE(told.lower_bound("3000") != told.end() && *told.lower_bound("3000") <= "3200");
            continue;
        }
        const auto number = [&](Dialect dialect) { return std::string(alarm_number(rows[key]->id, dialect)); };
        EXPECT_TRUE(told.contains(number(Dialect::Fanuc)) || told.contains(number(Dialect::Nct))) << key << " has no program in tests/golden/fanuc or nct";
    }
}

}  // namespace
}  // namespace polyturn::channels
