#include "toolmgmt/operations/table_readers.hpp"

#include <charconv>
#include <cmath>
#include <map>
#include <optional>
#include <set>

#include "ipc/model/machine/shortest_text.hpp"

namespace polyturn::toolmgmt {
namespace {

std::string_view trimmed(std::string_view text) {
    while (!text.empty() && (text.front() == ' ' || text.front() == '\t' || text.front() == '\r'))
        text.remove_prefix(1);
    while (!text.empty() && (text.back() == ' ' || text.back() == '\t' || text.back() == '\r'))
        text.remove_suffix(1);
    return text;
}

std::vector<std::string_view> lines_of(std::string_view text) {
    std::vector<std::string_view> out;
    if (text.rfind("\xEF\xBB\xBF", 0) == 0) text.remove_prefix(3);
    while (!text.empty()) {
        const std::size_t end = std::min(text.find('\n'), text.size());
        out.push_back(text.substr(0, end));
        text.remove_prefix(std::min(end + 1, text.size()));
    }
    return out;
}

std::optional<double> number_of(std::string_view text) {
    text = trimmed(text);
    if (!text.empty() && text[0] == '+') text.remove_prefix(1);
    double value = 0;
    const auto end = std::from_chars(text.data(), text.data() + text.size(), value);
    if (end.ec != std::errc() || end.ptr != text.data() + text.size() || !std::isfinite(value))
        return {};
    return value;
}

// The fields of one line of CSV; a quote inside quotes is doubled. False: a quote is open.
bool split_csv(std::string_view line, char separator, std::vector<std::string>& out) {
    out.clear();
    std::string field;
    bool quoted = false;
    for (std::size_t i = 0; i < line.size(); ++i) {
        const char c = line[i];
        if (quoted && c == '"' && i + 1 < line.size() && line[i + 1] == '"') {
            field += '"';
            ++i;
        } else if (c == '"')
            quoted = !quoted;
        else if (c == separator && !quoted) {
            out.push_back(std::string(trimmed(field)));
            field.clear();
        } else
            field += c;
    }
    out.push_back(std::string(trimmed(field)));
    return !quoted;
}

// Words of a line of a Fanuc program: a letter and its number; comments are left out.
struct Word {
    char letter;
    double value;
    std::string text;
};
bool words_of(std::string_view line, std::vector<Word>& out, std::string& wrong) {
    out.clear();
    for (std::size_t i = 0; i < line.size();) {
        const char c = line[i];
        if (c == ' ' || c == '\t' || c == '\r' || c == ';') {
            ++i;
            continue;
        }
        if (c == '(') {
            const std::size_t end = line.find(')', i);
            if (end == std::string_view::npos) {
                wrong = "(";
                return false;
            }
            i = end + 1;
            continue;
        }
        std::size_t end = i + 1;
        while (end < line.size() && (std::isdigit(static_cast<unsigned char>(line[end])) ||
                                     line[end] == '.' || line[end] == '-' || line[end] == '+'))
            ++end;
        const std::string text(line.substr(i, end - i));
        const auto value = number_of(std::string_view(text).substr(1));
        if (!std::isupper(static_cast<unsigned char>(c)) || !value) {
            wrong = text;
            return false;
        }
        out.push_back({c, *value, text});
        i = end;
    }
    return true;
}

}  // namespace

ReadTable read_csv_table(std::string_view text) {
    ReadTable out;
    const auto lines = lines_of(text);
    if (lines.empty() || trimmed(lines[0]).empty()) {
        out.faults.push_back({1, "", "the heading is missing"});
        return out;
    }
    const char separator =
        lines[0].find(';') != std::string_view::npos && lines[0].find(',') == std::string_view::npos
            ? ';'
            : ',';
    std::vector<std::string> heading, fields;
    split_csv(lines[0], separator, heading);
    std::size_t key = heading.size();
    std::set<std::string> names;
    for (std::size_t i = 0; i < heading.size(); ++i) {
        if (heading[i] == "tool") key = i;
        if (!names.insert(heading[i]).second)
            out.faults.push_back({1, heading[i], "the column stands twice"});
    }
    if (key == heading.size()) {
        out.faults.push_back({1, "tool", "there is no column tool"});
        return out;
    }
    std::map<std::int64_t, int> seen;
    for (std::size_t i = 1; i < lines.size(); ++i) {
        const int row = static_cast<int>(i + 1);
        if (trimmed(lines[i]).empty()) continue;
        if (!split_csv(lines[i], separator, fields)) {
            out.faults.push_back({row, "", "a quote is not closed"});
            continue;
        }
        if (fields.size() != heading.size()) {
            out.faults.push_back({row, "",
                                  std::to_string(fields.size()) + " fields, the heading has " +
                                      std::to_string(heading.size())});
            continue;
        }
        const auto number = number_of(fields[key]);
        if (!number || *number < 1 || *number > 1e6 || *number != std::trunc(*number)) {
            out.faults.push_back({row, "tool", "\"" + fields[key] + "\" is no data number"});
            continue;
        }
        const auto tool = static_cast<std::int64_t>(*number);
        if (const auto [at, fresh] = seen.emplace(tool, row); !fresh) {
            out.faults.push_back({row, "tool",
                                  "tool " + std::to_string(tool) + " stands in row " +
                                      std::to_string(at->second) + " already"});
            continue;
        }
        out.entries.push_back({row, "tool", tool, "exists", "1", 0});
        for (std::size_t k = 0; k < heading.size(); ++k)
            if (k != key && !fields[k].empty())
                out.entries.push_back({row, heading[k], tool, heading[k], fields[k], 0});
    }
    return out;
}

ReadTable read_fanuc_table(std::string_view text) {
    ReadTable out;
    std::vector<Word> words;
    std::string wrong;
    bool life = false;
    std::int64_t group = 0, order = 0;
    double amount = 0, kind = 1;
    const auto lines = lines_of(text);
    for (std::size_t i = 0; i < lines.size(); ++i) {
        const int row = static_cast<int>(i + 1);
        const std::string_view line = trimmed(lines[i]);
        if (line.empty() || line == "%" || line.front() == 'O') continue;
        if (!words_of(line, words, wrong)) {
            out.faults.push_back({row, wrong, "not a word of a tool data program"});
            continue;
        }
        std::map<char, double> all;
        for (const Word& word : words)
            if (word.letter != 'N') all[word.letter] = word.value;
        if (all.contains('M')) continue;  // M30
        if (all.contains('G')) {
            if (all['G'] == 11) {
                life = false;
                continue;
            }
            if (all['G'] != 10) {
                out.faults.push_back({row, "G" + shortest_text(all['G']),
                                      "only G10 and G11 belong into a tool data program"});
                continue;
            }
            if (all.contains('L') && all['L'] == 3) {
                life = true;
                continue;
            }
        }
        if (life) {
            if (all.contains('P')) {
                group = static_cast<std::int64_t>(all['P']);
                amount = all.contains('L') ? all['L'] : 0;
                kind = all.contains('Q') ? all['Q'] : 1;
                order = 0;
                if (group < 1 || group > 9999)
                    out.faults.push_back({row, "P", "groups are 1 to 9999"});
                if (kind != 1 && kind != 2)
                    out.faults.push_back({row, "Q", "1 counts uses, 2 minutes"});
                continue;
            }
            if (!all.contains('T') || group == 0) {
                out.faults.push_back({row, words.empty() ? "" : words[0].text,
                                      "P opens a group, T names its tools"});
                continue;
            }
            const auto code = static_cast<std::int64_t>(all['T']);
            const std::int64_t tool = code / 100 ? code / 100 : code, cell = code % 100;
            const auto put = [&](const char* field, const std::string& value) {
                out.entries.push_back({row, "T", tool, field, value, 0});
            };
            put("exists", "1");
            put("group", std::to_string(group));
            put("duplo", std::to_string(++order));
            put("type", std::to_string(tool));
            put("h", std::to_string(cell));
            put("d", std::to_string(cell));
            put("life_kind", kind == 2 ? "minutes" : "uses");
            put("life", shortest_text(amount));
            continue;
        }
        if (!all.contains('P')) {
            out.faults.push_back(
                {row, words.empty() ? "" : words[0].text, "P with the offset number is missing"});
            continue;
        }
        const auto p = static_cast<std::int64_t>(all['P']);
        const bool geometry = p >= 10'000;
        const std::int64_t cell = geometry ? p - 10'000 : p;
        if (cell < 1 || cell > 999) {
            out.faults.push_back({row, "P", "offset numbers are 1 to 999, geometry from 10001"});
            continue;
        }
        // order of OffsetField, Q is the tip
        static constexpr std::string_view kLetters = "XYZRQ";
        for (const auto& [letter, value] : all) {
            if (letter == 'G' || letter == 'P') continue;
            const std::size_t field = kLetters.find(letter);
            if (field == std::string_view::npos) {
                out.faults.push_back(
                    {row, std::string(1, letter), "X Y Z R and Q belong to an offset"});
                continue;
            }
            out.entries.push_back(
                {row, std::string(1, letter), 0,
                 std::to_string((geometry || field == 4 ? 0 : 256) + static_cast<int>(field)),
                 shortest_text(value), cell});
        }
    }
    return out;
}

namespace {

// Which column a variable is; DPx and the like are found by name.
struct Variable {
    std::string_view name, field;
};
constexpr Variable kVariables[] = {
    {"TP1", "duplo"},    {"TP2", "name"},          {"TP3", "size_left"},  {"TP4", "size_right"},
    {"TP5", "size_up"},  {"TP6", "size_down"},     {"TP7", "place_type"}, {"MOP11", "life"},
    {"MOP1", "warning"}, {"MOP13", "life"},        {"MOP3", "warning"},   {"MOP15", "life"},
    {"MOP5", "warning"}, {"TP_MAX_VELO", "speed"},
};
struct Bit {
    int bit;
    std::string_view field;
};
constexpr Bit kStates[] = {{0, "active"}, {1, "enabled"}, {2, "locked"},  {3, "measured"},
                           {4, "warned"}, {6, "fixed"},   {7, "was_used"}};

bool whole(std::string_view text, std::int64_t& out) {
    const auto value = number_of(text);
    if (!value || *value < 0 || *value > 1e8 || *value != std::trunc(*value)) return false;
    out = static_cast<std::int64_t>(*value);
    return true;
}

}  // namespace

ReadTable read_sinumerik_table(std::string_view text) {
    ReadTable out;
    const auto lines = lines_of(text);
    std::set<std::int64_t> known;
    // A rest of life counts from what the life is, which may stand behind it.
    struct Rest {
        int row;
        std::string column;
        double rest;
    };
    std::map<std::int64_t, Rest> rests;
    std::map<std::int64_t, double> lives;
    for (std::size_t i = 0; i < lines.size(); ++i) {
        const int row = static_cast<int>(i + 1);
        std::string_view line = lines[i].substr(0, std::min(lines[i].find(" ;"), lines[i].size()));
        line = trimmed(line.substr(0, line.find('\t') == 0 ? 0 : line.size()));
        if (line.empty() || line.front() == ';' || line.front() == '%' || line == "M30" ||
            line == "M17" || line == "RET")
            continue;
        while (!line.empty()) {
            const std::size_t begin = line.find("$TC_");
            const auto refuse = [&](std::string column, std::string why) {
                out.faults.push_back({row, std::move(column), std::move(why)});
            };
            if (begin != 0) {
                refuse(std::string(line.substr(0, std::min<std::size_t>(begin, 20))),
                       "not a tool variable $TC_...");
                break;
            }
            const std::size_t open = line.find('['), close = line.find(']'),
                              equals = line.find('=');
            if (open == std::string_view::npos || close == std::string_view::npos ||
                equals == std::string_view::npos || close < open || equals < close) {
                refuse(std::string(line.substr(0, 20)), "write $TC_DP3[5,1]=12.5");
                break;
            }
            const std::string name(line.substr(4, open - 4)),
                shown = "$TC_" + name + std::string(line.substr(open, close - open + 1));
            const std::string_view index = line.substr(open + 1, close - open - 1);
            const std::size_t comma = index.find(',');
            std::int64_t first = 0, second = 0;
            if (!whole(index.substr(0, comma), first) ||
                (comma != std::string_view::npos && !whole(index.substr(comma + 1), second))) {
                refuse(shown, "the index is no number");
                break;
            }
            std::string_view rest = trimmed(line.substr(equals + 1));
            std::string value;
            if (!rest.empty() && rest.front() == '"') {
                const std::size_t end = rest.find('"', 1);
                if (end == std::string_view::npos) {
                    refuse(shown, "a quote is not closed");
                    break;
                }
                value = rest.substr(1, end - 1);
                rest.remove_prefix(end + 1);
            } else {
                const std::size_t end = std::min(rest.find_first_of(" \t"), rest.size());
                value = rest.substr(0, end);
                rest.remove_prefix(end);
            }
            line = trimmed(rest);
            const bool place = name == "MPP6";
            const std::int64_t tool = place ? 0 : first;
            if (place) {
                std::int64_t there = 0;
                if (!whole(value, there)) {
                    refuse(shown, value + ": no tool number");
                    continue;
                }
                if (there == 0) continue;
                out.entries.push_back({row, shown, there, "magazine", std::to_string(first), 0});
                out.entries.push_back({row, shown, there, "pot", std::to_string(second), 0});
                continue;
            }
            if (known.insert(tool).second)
                out.entries.push_back({row, shown, tool, "exists", "1", 0});
            const auto put = [&](std::string_view field, std::string words) {
                out.entries.push_back({row, shown, tool, std::string(field), std::move(words), 0});
            };
            std::int64_t number = 0;
            if (name.rfind("DP", 0) == 0 && whole(name.substr(2), number)) {
                put("D" + std::to_string(second ? second : 1) + ".DP" + std::to_string(number),
                    value);
                continue;
            }
            if (name == "TP8") {
                if (!whole(value, number)) {
                    refuse(shown, value + ": no state");
                    continue;
                }
                for (const auto& [bit, field] : kStates) put(field, number >> bit & 1 ? "1" : "0");
                continue;
            }
            if (name == "TP9") {
                if (!whole(value, number)) {
                    refuse(shown, value + ": no kind of monitoring");
                    continue;
                }
                put("life_kind", number & 1    ? "minutes"
                                 : number & 2  ? "pieces"
                                 : number & 12 ? "wear"
                                               : "none");
                continue;
            }
            if (name == "MOP2" || name == "MOP4" || name == "MOP6") {
                if (const auto left = number_of(value))
                    rests[tool] = {row, shown, *left};
                else
                    refuse(shown, value + ": not a number");
                continue;
            }
            const Variable* found = nullptr;
            for (const Variable& variable : kVariables)
                if (variable.name == name) found = &variable;
            if (!found) {
                refuse(shown, "this variable is not taken over");
                continue;
            }
            if (found->field == "life")
                if (const auto life = number_of(value)) lives[tool] = *life;
            put(found->field, value);
        }
    }
    for (const auto& [tool, rest] : rests) {
        const double counter = lives.contains(tool) ? std::max(lives[tool] - rest.rest, 0.0) : 0.0;
        out.entries.push_back({rest.row, rest.column, tool, "counter", shortest_text(counter), 0});
    }
    return out;
}

}  // namespace polyturn::toolmgmt
