#include "kernel/supervisor/store/store_tables.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <nlohmann/json.hpp>
#include <vector>

#include "kernel/supervisor/press/phrases.hpp"

namespace polyturn::supervisor {

using Json = nlohmann::json;

namespace {

std::size_t width_of(const std::string& text) {  // in characters
    return static_cast<std::size_t>(std::count_if(text.begin(), text.end(), [](char c) {
        return (static_cast<unsigned char>(c) & 0xC0) != 0x80;
    }));
}

// Columns as wide as their widest cell; numbers to the right.
class Table {
public:
    explicit Table(std::vector<const char*> heading) {
        std::vector<std::string> row;
        for (const char* one : heading) row.emplace_back(say(one));
        add(std::move(row));
    }
    void add(std::vector<std::string> row) { rows_.push_back(std::move(row)); }
    bool empty() const { return rows_.size() < 2; }
    std::string text() const {
        std::vector<std::size_t> width;
        std::vector<bool> right;
        for (std::size_t c = 0; c < rows_[0].size(); ++c) {
            std::size_t most = 0;
            bool numbers = true;
            for (std::size_t r = 0; r < rows_.size(); ++r) {
                if (c >= rows_[r].size()) continue;
                most = std::max(most, width_of(rows_[r][c]));
                if (r > 0 && !rows_[r][c].empty() &&
                    rows_[r][c].find_first_not_of("0123456789.-+ ") != std::string::npos)
                    numbers = false;
            }
            width.push_back(most);
            right.push_back(numbers);
        }
        std::string out;
        for (const auto& row : rows_) {
            std::string line;
            for (std::size_t c = 0; c < row.size() && c < width.size(); ++c) {
                const std::string pad(width[c] - width_of(row[c]), ' ');
                line += (c ? "  " : "") + (right[c] ? pad + row[c] : row[c] + pad);
            }
            line.erase(line.find_last_not_of(' ') + 1);
            out += line + "\n";
        }
        return out;
    }

private:
    std::vector<std::vector<std::string>> rows_;
};

std::string cell(const Json& row, const char* key) {
    const auto at = row.find(key);
    if (at == row.end() || at->is_null()) return {};
    if (at->is_string()) return at->get<std::string>();
    if (at->is_boolean()) return at->get<bool>() ? "yes" : "";
    if (at->is_number_integer()) return std::to_string(at->get<std::int64_t>());
    if (at->is_number()) return fmt::format("{}", at->get<double>());
    return at->dump();
}

// "37.5 of 60 min": the unit always follows a life.
std::string life(const Json& tool) {
    // in the table "unit" is the tool unit, a number
    const std::string unit =
        tool.contains("life_unit") ? cell(tool, "life_unit") : cell(tool, "unit");
    if (unit.empty() || tool.value("life", 0.0) == 0.0) return {};
    return fmt::format("{:.6g} of {:.6g} {}", tool.value("counter", 0.0), tool.value("life", 0.0),
                       unit);
}

std::string state(const Json& tool) {
    std::string out;
    for (const char* one : {"broken", "locked", "worn", "warned", "active"})
        if (tool.value(one, false)) out += (out.empty() ? "" : " ") + std::string(say(one));
    if (tool.contains("enabled") && !tool.value("enabled", true))
        out += (out.empty() ? "" : " ") + std::string(say("not enabled"));
    return out;
}

std::string tools(const Json& answer) {
    Table table({"tool", "type", "duplo", "name", "offset", "place", "life", "state", "works in"});
    for (const auto& one : answer["tools"]) {
        std::string works;
        for (const auto& l : one.value("works_in", Json::array()))
            works += (works.empty() ? "" : " ") + l.get<std::string>();
        table.add({cell(one, "tool"), cell(one, "type"), cell(one, "duplo"), cell(one, "name"),
                   cell(one, "h"), cell(one, "place"), life(one), state(one), works});
    }
    return table.empty() ? std::string(say("There are no tools.\n")) : table.text();
}

std::string one_tool(const Json& answer) {
    std::string out;
    for (const auto& [name, value] : answer.items())
        if (name != "ok" && name != "edges" && name != "works_in" &&
            !(value.is_string() && value.get<std::string>().empty()))
            out += fmt::format("{:<14} {}\n", name, cell(answer, name.c_str()));
    for (const auto& edge : answer.value("edges", Json::array())) {
        out += fmt::format("D{}", edge.value("edge", 0));
        for (const auto& [name, value] : edge.items())
            if (name != "edge") out += fmt::format("  {}={}", name, cell(edge, name.c_str()));
        out += "\n";
    }
    return out;
}

std::string plain(const Json& list, std::vector<const char*> keys) {
    Table table(keys);
    for (const auto& one : list) {
        std::vector<std::string> row;
        for (const char* key : keys) row.push_back(cell(one, key));
        table.add(std::move(row));
    }
    return table.text();
}

std::string life_report(const Json& answer) {
    Table table({"group", "tool", "name", "used up", "left", "unit", "state", "parts left",
                 "minutes left"});
    for (const auto& group : answer["groups"]) {
        for (const auto& one : group["tools"])
            table.add({cell(group, "group"),
                       cell(one, "tool"),
                       cell(one, "name"),
                       one.contains("left") ? life(one) : std::string(),
                       cell(one, "left"),
                       cell(one, "unit"),
                       state(one),
                       {},
                       {}});
        if (group.contains("unit"))
            table.add({cell(group, "group"),
                       std::string(say("all")),
                       {},
                       {},
                       cell(group, "left"),
                       cell(group, "unit"),
                       {},
                       cell(group, "parts_left"),
                       group.contains("minutes_left")
                           ? fmt::format("{:.1f}", group.value("minutes_left", 0.0))
                           : std::string()});
    }
    std::string out = table.text();
    if (const auto first = answer.find("stops_first"); first != answer.end()) {
        // the tool that is the last of its group to be used up
        const std::string group = first->value("group", ""), tool = first->value("tool", "");
        out += fmt::format(
            fmt::runtime(say("First to stop the machine: {} after {:.0f} more parts.\n")),
            tool.empty() ? group : fmt::format("{} ({} {})", group, say("tool"), tool),
            first->value("parts_left", 0.0));
    }
    return out;
}

std::string offsets(const Json& answer) {
    Table table({"number", "X", "Y", "Z", "R", "T", "wear X", "wear Y", "wear Z", "wear R"});
    for (const auto& one : answer["offsets"]) {
        const Json &g = one["geometry"], &w = one["wear"];
        table.add({cell(one, "number"), cell(g, "X"), cell(g, "Y"), cell(g, "Z"), cell(g, "R"),
                   cell(g, "T"), cell(w, "X"), cell(w, "Y"), cell(w, "Z"), cell(w, "R")});
    }
    return table.text();
}

std::string zeros(const Json& answer) {
    std::vector<const char*> keys = {"zero"};
    static constexpr const char* kOrder[] = {"X", "Y", "Z", "U", "V", "W", "A", "B", "C"};
    const Json& rows = answer["zeros"];
    for (const char* axis : kOrder)
        if (!rows.empty() && rows[0].contains(axis)) keys.push_back(axis);
    Table table(keys);
    for (const auto& one : rows) {
        std::vector<std::string> row;
        for (const char* key : keys) row.push_back(cell(one, key));
        table.add(std::move(row));
    }
    return table.text();
}

std::string dimension(const Json& one) {
    std::string out = fmt::format("{} {}: {} {} +{} {}", say("dimension"), cell(one, "dimension"),
                                  cell(one, "name"), cell(one, "nominal"), cell(one, "upper"),
                                  cell(one, "lower"));
    if (one.contains("last"))
        out += fmt::format(
            "\n  {} {} ({:+.4f}), {}; {} {:+.4f} mm{}; {} {:+.5f} mm", say("measured"),
            cell(one, "last"), one.value("deviation", 0.0), say(one.value("verdict", "")),
            say("proposed correction"), one.value("proposal", 0.0),
            one.value("limited", false) ? std::string(say(" (limited)")) : std::string(),
            say("trend a part"), one.value("trend", 0.0));
    if (one.contains("parts_to_limit"))
        out +=
            fmt::format("; {} {:.0f}", say("parts to the limit"), one.value("parts_to_limit", 0.0));
    return out + "\n";
}

std::string restore(const Json& answer, bool done) {
    std::string out = fmt::format(fmt::runtime(say("Backup {}\n")), cell(answer, "file"));
    for (const auto& [name, count] : answer["sections"].items())
        out += fmt::format("  {}: {}\n", name, count.dump());
    std::size_t shown = 0;
    for (const auto& one : answer["changes"]) {
        if (++shown > 200) break;
        out += fmt::format("    {}: {} -> {}\n", cell(one, "what"), cell(one, "old"),
                           cell(one, "new"));
    }
    if (answer["changes"].size() > 200)
        out += fmt::format(fmt::runtime(say("    ... and {} more\n")),
                           answer.value("total", 0u) - 200u);
    for (const auto& one : answer["files"])
        out += fmt::format(fmt::runtime(say("  file {}\n")), one.get<std::string>());
    for (const auto& one : answer["warnings"]) out += fmt::format("  {}\n", one.get<std::string>());
    if (answer.value("total", 0u) == 0 && answer["files"].empty())
        return out + std::string(say("Nothing would change.\n"));
    return out + std::string(
                     say(done ? "Restored.\n" : "Nothing was changed yet: say --yes to do it.\n"));
}

}  // namespace

std::string store_table(const std::string& what, const Json& answer, bool done) {
    if (what == "tools.list") return tools(answer);
    if (what == "tools.show" || what == "tools.set") return one_tool(answer);
    if (what == "tools.fields")
        return plain(answer["fields"], {"name", "unit", "least", "most", "meaning"});
    if (what == "tools.places")
        return plain(answer["places"], {"magazine", "pot", "kind", "tool", "tool_name", "half",
                                        "locked", "place_type"});
    if (what == "life.report") return life_report(answer);
    if (what == "offsets.list") return offsets(answer);
    if (what == "zeros.list") return zeros(answer);
    if (what == "parts.list") {
        std::string out;
        for (const auto& one : answer["dimensions"]) out += dimension(one);
        return out.empty() ? std::string(say("There are no dimensions.\n")) : out;
    }
    if (what == "parts.add" || what == "parts.set" || what == "parts.measure")
        return dimension(answer);
    if (what == "pallets.list")
        return plain(answer["pallets"], {"row", "station", "pallet", "program", "custom1",
                                         "custom2", "custom3", "custom4"});
    if (what == "users.list")
        return plain(answer["users"], {"user", "name", "level", "uid", "locked"});
    if (what == "history.list" || what == "offsets.history")
        return plain(answer["history"], {"utc", "who", "what", "old", "new"});
    if (what == "stops.list")
        return plain(answer["stops"],
                     {"utc", "channel", "seconds", "cause", "number", "detail", "program", "line"});
    if (what == "restore.from") return restore(answer, done);
    if (what == "tools.load" || what == "tools.move")
        return fmt::format(fmt::runtime(say("tool {} stands in {}\n")), cell(answer, "tool"),
                           cell(answer, "place"));
    if (what == "tools.import")
        return fmt::format(fmt::runtime(say("{} tools, {} of them new, {} values changed\n")),
                           cell(answer, "tools"), cell(answer, "added"), cell(answer, "changes"));
    if (what == "backup.to")
        return fmt::format(fmt::runtime(say("{}: {} bytes, with {} files\n")), cell(answer, "file"),
                           cell(answer, "bytes"), answer["files"].size());
    if (answer.contains("old") && answer.contains("new")) {
        std::string out = fmt::format("{}: {} -> {}", cell(answer, "what"), cell(answer, "old"),
                                      cell(answer, "new"));
        if (answer.contains("difference"))
            out += fmt::format(" ({:+})", answer.value("difference", 0.0));
        if (answer.contains("contact"))
            out +=
                fmt::format(fmt::runtime(say("\n  touched at {} mm, the setter stands at {} mm\n")),
                            cell(answer, "machine"), cell(answer, "contact"));
        if (answer.contains("surface"))
            out +=
                fmt::format(fmt::runtime(say("\n  touched at {} mm; the surface is to be {} mm\n")),
                            cell(answer, "machine"), cell(answer, "surface"));
        if (what == "offsets.touch" || what == "zeros.touch")
            return out + std::string(say(done ? "Written.\n"
                                              : "Nothing was changed yet: say --yes to do it.\n"));
        return out + "\n";
    }
    std::string out;
    for (const auto& [name, value] : answer.items())
        if (name != "ok") out += fmt::format("{} {}\n", name, cell(answer, name.c_str()));
    return out;
}

}  // namespace polyturn::supervisor
