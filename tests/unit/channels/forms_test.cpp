// The forms say what the interpreters do: every cycle that a language has is a form, with the words
// that the code takes and no others, and the values that a new form proposes make blocks without a
// fault.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstring>

#include "channels/fagor/grammar/g_codes.hpp"
#include "channels/fanuc/g_codes.hpp"
#include "channels/sinumerik/grammar/tables.hpp"
#include "channels/sinumerik/geometry/geo_threads.hpp"
#include "ipc/model/languages/cycle_block.hpp"
#include "tests/unit/channels/play.hpp"

namespace polyturn::channels {
namespace {

using forms::Form;

std::string letters_of(const Form& form) {
    std::string out;
    for (const forms::Field& field : form.fields) {
        for (const std::string_view letter : {field.address, field.increment})
            if (!letter.empty() && out.find(letter) == std::string::npos) out += letter;
    }
    return out;
}

TEST(Forms, OfTheFanucFamilyTakeWhatTheCodesTake) {
    using namespace fanuc;
    const std::pair<forms::Speaks, GSystem> kSystems[] = {
        {forms::kFanucA, kA},    {forms::kFanucB, kB},    {forms::kFanucC, kC},
        {forms::kSeries15A, kA}, {forms::kSeries15B, kB}, {forms::kSeries15C, kC},
        {forms::kNct, kN}};
    for (const Form& form : forms::fanuc_forms())
        for (const auto& [speaks, system] : kSystems) {
            if (!(form.speaks & speaks)) continue;
            const GCode* row = GTable(system).find(static_cast<std::uint32_t>(
                std::lround(std::stod(std::string(form.code.substr(1))) * 10)));
            ASSERT_TRUE(row && row->act) << form.code;
            EXPECT_EQ(row->name, form.code);
            for (const char letter : letters_of(form))
                EXPECT_TRUE(std::strchr("FXZUWCH", letter) ||
                            row->takes.find(letter) != std::string_view::npos)
                    << form.code << ' ' << letter;
        }
}

// G70 to G79 and the drilling cycles of each system: none is without a form.
TEST(Forms, OfTheFanucFamilyLeaveNoCycleOut) {
    using namespace fanuc;
    const auto is_cycle = [](const GCode& row, bool nct) {
        const unsigned n = row.tenths;
        // fine boring, back boring: no turning work
        if (row.group == GGroup::Drilling && n != 800)
            return n != 861 && !(nct && (n == 870 || n == 880));
        return (n >= 700 && n <= 790 && row.group != GGroup::Zero && row.group != GGroup::Units) ||
               (row.systems == kA && (n == 900 || n == 920 || n == 940)) ||
               (row.systems == kC && (n == 200 || n == 210 || n == 240));
    };
    for (const GCode& row : g_codes()) {
        for (const auto& [system, speaks] : {std::pair{kA, forms::kFanucA | forms::kSeries15A},
                                             {kB, forms::kFanucB | forms::kSeries15B},
                                             {kC, forms::kFanucC | forms::kSeries15C},
                                             {kN, int{forms::kNct}}}) {
            if (!(row.systems & system) || !row.act || !is_cycle(row, system == kN)) continue;
            if (system != kN && row.tenths == 860) continue;  // fanuc lathes have none
            bool found = false;
            for (const Form& form : forms::fanuc_forms())
                found = found || (form.code == row.name && (form.speaks & speaks));
            EXPECT_TRUE(found) << row.name << " of system " << static_cast<int>(system);
        }
    }
}

TEST(Forms, OfFagorTakeWhatTheCodesTake) {
    for (const fagor::GCode& row : fagor::g_codes()) {
        if (row.group != fagor::GGroup::Cycle) continue;
        const Form* found = nullptr;
        for (const Form& form : forms::fagor_forms())
            if (form.code == "G" + std::to_string(row.number)) found = &form;
        ASSERT_TRUE(found) << row.number;
        std::string takes(row.takes), has = letters_of(*found);
        std::sort(takes.begin(), takes.end());
        std::sort(has.begin(), has.end());
        EXPECT_EQ(has, takes) << row.number;
    }
}

// Threads and taps (sinumerik_part2 10.10, 10.11): every code has a form, in the face and along Z,
// of words that it or any block takes (axes, S, F).
TEST(Forms, OfSinumerikTakeWhatTheCodesTake) {
    using namespace sinumerik;
    unsigned seen = 0;
    for (const GCode& row : g_codes()) {
        const bool cycle =
            row.act == &geo_thread || row.act == &geo_barrel ||
            row.act == &geo_tap || row.act == &geo_tap_chuck;
        if (!cycle) continue;
        bool found = false;
        for (const Form& form : forms::sinumerik_forms()) {
            if (form.code != row.name) continue;
            found = true;
            ++seen;
            const std::string takes = " " + std::string(row.takes) + " ";
            for (const forms::Field& field : form.fields) {
                const bool any = field.address == "X" || field.address == "Z" ||
                                 field.address == "S" || field.address == "F",
                           own = takes.find(" " + std::string(field.address) + " ") !=
                                 std::string::npos;
                const Symbol symbol = find_symbol(field.address);
                const bool always = symbol.kind == Symbol::Kind::Address &&
                                    symbol.address().use == Address::Use::Setting;
                EXPECT_TRUE(any || own || always) << form.code << ' ' << field.address;
            }
        }
        EXPECT_TRUE(found) << row.name;
    }
    const auto all = forms::sinumerik_forms();
    EXPECT_EQ(seen, static_cast<unsigned>(std::count_if(
                        all.begin(), all.end(), [](const Form& form) { return !form.is_call(); })));
}

// Calls: a field for each argument that the command takes, and what must be told is at least what
// it needs; what MCALL takes has a form with it too.
TEST(Forms, OfSinumerikCallsTakeWhatTheCommandsTake) {
    using namespace sinumerik;
    std::size_t seen = 0;
    for (const Command& command : program_commands()) {
        const bool hole = command.name.starts_with("CYCLE") && command.name != "CYCLE800";
        if (!hole && !command.name.starts_with("HOLES")) continue;
        for (const std::string& code :
             hole ? std::vector<std::string>{std::string(command.name),
                                             "MCALL " + std::string(command.name)}
                  : std::vector<std::string>{std::string(command.name)}) {
            const Form* found = nullptr;
            for (const Form& form : forms::sinumerik_forms())
                if (form.code == code) found = &form;
            ASSERT_TRUE(found) << code;
            ++seen;
            EXPECT_EQ(found->fields.size(), command.most) << code;
            std::size_t told = 0;
            for (std::size_t i = 0; i < found->fields.size(); ++i)
                if (found->fields[i].needed) told = i + 1;
            EXPECT_GE(told, command.least) << code;
        }
    }
    const auto all = forms::sinumerik_forms();
    EXPECT_EQ(seen, static_cast<std::size_t>(std::count_if(
                        all.begin(), all.end(), [](const Form& form) { return form.is_call(); })));
}

// The proposals, as one would write them: a start beside the part, a contour where the cycle wants
// one. How many forms were played.
int play_proposals(const forms::Dialect& dialect, const std::string& language,
                   const std::vector<std::string>& sets) {
    int played_forms = 0;
    forms::each_form(dialect, [&](const Form& form) {
        ++played_forms;
        const bool fagor = language == "fagor", sinumerik = language == "sinumerik";
        using forms::Picture;
        const bool side = form.picture == Picture::Groove || form.picture == Picture::DrillSide ||
                          form.picture == Picture::TapSide || form.picture == Picture::BoreSide;
        const std::string x = form.picture == Picture::Pattern ? "60." : "46.",
                          z = side ? "-10." : "3.";
        const bool by_revolution_g95 =
            language == "nct" || (dialect.speaks & (forms::kFanucB | forms::kSeries15B |
                                                    forms::kFanucC | forms::kSeries15C)) != 0;
        std::vector<std::string> lines{
            form.is_call() ? "G17 G95 S1000 M3 F0.2"
            : sinumerik    ? "G18 G95 S1000 M3 F0.2"
            : fagor        ? "G95 G97 S1000 M3 F0.2"
                           : std::string(by_revolution_g95 ? "G95 G98" : "G99") + " G97 S1000 M3",
            "G0 X" + x + " Z" + z};
        if (fagor) lines.insert(lines.begin(), {"%1", "T1 D1"});
        const int at = static_cast<int>(lines.size());
        lines.push_back(fagor ? "G0 X80 Z20" : "G0 X80. Z20.");
        const bool contour = form.picture == forms::Picture::Roughing ||
                             form.picture == forms::Picture::FaceRoughing ||
                             form.picture == forms::Picture::Pattern ||
                             form.picture == forms::Picture::Finishing;
        const bool facing = form.picture == forms::Picture::FaceRoughing;
        const std::vector<std::string> kContour =
            fagor ? std::vector<std::string>{"N100 G1 X20 Z-10", "G1 X40 Z-20", "N200 G1 X44 Z-30"}
            : facing ? std::vector<std::string>{"N100 G0 Z-20.", "G1 X40. F0.1", "Z-10.",
                                                "N200 X20. Z0."}
                     : std::vector<std::string>{"N100 G0 X20.", "G1 Z-10. F0.1", "X40. Z-20.",
                                                "N200 Z-30."};
        if (fagor) lines.push_back("M30");
        if (contour) lines.insert(lines.end() - (fagor ? 0 : 1), kContour.begin(), kContour.end());
        if (!fagor) lines.push_back("M30");
        forms::CycleBlock cycle = forms::new_cycle(form);
        EXPECT_TRUE(forms::is_good(forms::check_cycle(cycle))) << form.code;
        forms::apply_changes(
            lines,
            forms::write_cycle(lines, forms::CycleBlock{&form, {}, {-1, -1}}, cycle, at, dialect));
        std::string text;
        for (const std::string& line : lines) text += line + "\n";
        testing::Play how;
        how.language = language;
        how.sets = sets;
        // the spindle can tap rigidly
        how.sets.insert(how.sets.end(), {"N0608 S1=4096", "N0823 S1=29"});
        const testing::Played played = testing::play(text, how);
        EXPECT_EQ(played.errors, 0u) << language << ' ' << form.code << "\n"
                                     << text << played.find({"\"alarm\""});
        // moves as any other: HolesAreDrilledWhereTheFormSays
        if (form.code.starts_with("HOLES")) return;
        EXPECT_TRUE(sinumerik && !form.is_call() ? played.has({"\"move\"", "\"thread\""}) ||
                                                       played.has({"\"move\"", "\"linear\""})
                                                 : played.has({"\"move\"", "\"cycle\""}))
            << language << ' ' << form.code << "\n"
            << text;
    });
    return played_forms;
}

TEST(Forms, WhatFanucProposesRuns) {
    EXPECT_GT(play_proposals({forms::kFanucA, true, 0.001}, "fanuc", {}), 10);
    EXPECT_GT(play_proposals({forms::kFanucB, true, 0.001}, "fanuc", {"F3401#6=1"}), 10);
    EXPECT_GT(play_proposals({forms::kFanucC, true, 0.001}, "fanuc", {"F3401#7=1"}), 10);
    EXPECT_GT(play_proposals({forms::kSeries15C, true, 0.001}, "fanuc", {"F0001#1=1", "F3401#7=1"}),
              10);
    EXPECT_GT(play_proposals({forms::kSeries15A, true, 0.001}, "fanuc", {"F0001#1=1"}), 10);
}
TEST(Forms, WhatNctProposesRuns) {
    EXPECT_GT(play_proposals({forms::kNct, true, 0.001}, "nct", {}), 10);
}
TEST(Forms, WhatFagorProposesRuns) {
    EXPECT_GT(play_proposals({forms::kFagor, false, 0.001}, "fagor", {}), 10);
}
// G17 has a second axis
const std::vector<std::string> kWithY{"N0002 A6=1", "N0100 A6=89", "N0103 A6=2"};
TEST(Forms, WhatSinumerikProposesRuns) {
    EXPECT_GT(play_proposals({forms::kSinumerik, false, 0.001}, "sinumerik", kWithY), 10);
}

// The proposals together: a hole of the modal cycle at each place.
TEST(Forms, HolesAreDrilledWhereTheFormSays) {
    const forms::Dialect dialect{forms::kSinumerik, false, 0.001};
    const auto proposal = [&](std::string_view code) {
        std::vector<std::string> lines;
        forms::each_form(dialect, [&](const Form& form) {
            if (form.code == code)
                forms::apply_changes(
                    lines, forms::write_cycle(lines, forms::CycleBlock{&form, {}, {-1, -1}},
                                              forms::new_cycle(form), 0, dialect));
        });
        return lines.empty() ? std::string() : lines.front() + "\n";
    };
    const auto bottoms = [&](const std::string& pattern) {
        testing::Play how;
        how.language = "sinumerik";
        how.sets = kWithY;
        const testing::Played played =
            testing::play("G17 G95 DIAMOF S1000 M3 F0.2\nG0 X0 Y0 Z20\n" +
                              proposal("MCALL CYCLE81") + pattern + "MCALL\nM30\n",
                          how);
        EXPECT_EQ(played.errors, 0u) << played.events;
        std::vector<std::pair<double, double>> out;
        for (const std::string& line : played.lines()) {
            const auto at = [&](const char* key) {
                return std::stod(line.substr(line.find(key, line.find("\"pos\":")) + 4));
            };
            if (line.find("\"cycle\":\"CYCLE81\"") != std::string::npos &&
                line.find("\"move\"") != std::string::npos && at("\"Z\":") == -15)
                out.emplace_back(at("\"X\":"), at("\"Y\":"));
        }
        return out;
    };
    const auto row = bottoms(proposal("HOLES1"));
    ASSERT_EQ(row.size(), 3u);
    for (std::size_t i = 0; i < 3; ++i) {
        EXPECT_NEAR(row[i].first, 10.0 + 8.0 * static_cast<double>(i), 0.001);
        EXPECT_NEAR(row[i].second, 0.0, 0.001);
    }
    const auto circle = bottoms(proposal("HOLES2"));
    ASSERT_EQ(circle.size(), 6u);
    for (std::size_t i = 0; i < 6; ++i) {
        const double turned = static_cast<double>(i) * 60.0 / 180.0 * std::acos(-1.0);
        EXPECT_NEAR(circle[i].first, 20 * std::cos(turned), 0.001);
        EXPECT_NEAR(circle[i].second, 20 * std::sin(turned), 0.001);
    }
}

}  // namespace
}  // namespace polyturn::channels
