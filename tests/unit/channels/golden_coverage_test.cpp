// Every G code of the fanuc and nct tables and every alarm number of a fanuc control has a reviewed program below tests/golden.
#include <gtest/gtest.h>

#include <cctype>
#include <filesystem>
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

TEST(GoldenPrograms, HaveEveryAlarmOfAFanucControl) {
    std::set<std::string> told;
    for (const auto& entry : fs::directory_iterator(folder_of("fanuc"))) {
        std::istringstream events(content(entry.path() / "expected.jsonl"));
        for (std::string line; std::getline(events, line);) {
            if (line.find("\"ev\":\"alarm\"") == std::string::npos) continue;
            const std::size_t at = line.find("\"number\":");
            if (at == std::string::npos) continue;
            std::string number;
            for (std::size_t i = at + 9; i < line.size() && std::isdigit(static_cast<unsigned char>(line[i])); ++i) number += line[i];
            told.insert(std::string(3 - std::min<std::size_t>(3, number.size()), '0') + number);
        }
    }
    for (std::uint16_t id = 0; id < kAlarmCount; ++id) {
        const AlarmRow& row = alarm_row(static_cast<Alarm>(id));
        const std::string number(row.number[static_cast<std::size_t>(Dialect::Fanuc)]);
        if (number.empty()) continue;
        EXPECT_TRUE(told.contains(number)) << "alarm " << number << " has no program in tests/golden/fanuc";
    }
}

}  // namespace
}  // namespace polyturn::channels
