// Import and export of tool data: all rows or none, every fault with row and column.
#include <cmath>
#include <map>
#include <nlohmann/json.hpp>
#include <set>

#include "ipc/model/machine/shortest_text.hpp"
#include "ipc/model/machine/store/tool_fields.hpp"
#include "ipc/params/registry.hpp"
#include "polyturn/parameter_handles.hpp"
#include "toolmgmt/apply_request.hpp"
#include "toolmgmt/operations/operation.hpp"
#include "toolmgmt/operations/table_readers.hpp"
#include "toolmgmt/operations/tool_json.hpp"
#include "toolmgmt/tools/tool_requests.hpp"

namespace polyturn::toolmgmt {
namespace {

// Values that differ afterwards: a tool that leaves its place and comes back has not changed.
std::size_t differing(const std::vector<Change>& changes) {
    std::map<Key, std::pair<const Change*, const Change*>> ends;
    for (const Change& one : changes)
        if (one.key.kind != Kind::Setting)
            ends.try_emplace(one.key, &one, &one).first->second.second = &one;
    std::size_t out = 0;
    for (const auto& [key, both] : ends) {
        const double was = std::isnan(both.first->before) ? 0.0 : both.first->before,
                     is = std::isnan(both.second->after) ? 0.0 : both.second->after;
        if (was != is || both.first->text_before != both.second->text_after) ++out;
    }
    return out;
}

constexpr std::size_t kMostFaults = 200;

void enter_cell(Work& work, std::int64_t channel, const TableEntry& entry) {
    if (channel < 1 || channel > static_cast<std::int64_t>(kMaxChannels) ||
        !work.machine.channel(static_cast<std::size_t>(channel)).exists())
        return work.fault(Alarm::ImportFault, "offsets need a channel that exists", entry.row,
                          entry.column);
    const int most = work.machine.channel(static_cast<std::size_t>(channel)).offset_count;
    if (entry.cell > most)
        return work.fault(Alarm::ImportFault,
                          "offset " + std::to_string(entry.cell) + ": channel L" +
                              std::to_string(channel) + " has " + std::to_string(most) + " (N1400)",
                          entry.row, entry.column);
    const double value = std::stod(entry.text);
    const int code = std::stoi(entry.field);
    if (code % 256 == 4 && (value < 0 || value > 9 || value != std::trunc(value)))
        return work.fault(Alarm::ImportFault, "tip directions are 0 to 9", entry.row, entry.column);
    set_value(work.values,
              {Kind::Offset,
               offset_owner(work.values.parameters, work.machine, channel, entry.cell),
               static_cast<std::int32_t>(entry.cell),
               code,
               {}},
              value, work.changes);
}

Json import_table(const Json& request, Work& work) {
    const std::string format = request.contains("format") ? read_text(request, "format") : "csv";
    const std::string text = read_text(request, "text");
    ReadTable table;
    if (format == "csv")
        table = read_csv_table(text);
    else if (format == "fanuc")
        table = read_fanuc_table(text);
    else if (format == "sinumerik")
        table = read_sinumerik_table(text);
    else {
        work.fault(Alarm::StoreRequestBad, "format " + format + ": csv, fanuc or sinumerik");
        return Json();
    }
    for (const TableFault& fault : table.faults)
        work.fault(Alarm::ImportFault, fault.text, fault.row, fault.column);
    std::int64_t channel = 0;
    read_whole(request, "channel", channel, work, false);
    const std::int64_t most = table_length(work.values);
    struct Stand {
        int row = 0;
        std::string column;
        double magazine = 0, pot = 0;
    };
    std::map<std::int32_t, Stand> stands;
    std::set<std::int64_t> tools;
    std::size_t added = 0;
    for (const TableEntry& entry : table.entries) {
        if (entry.cell != 0) {
            enter_cell(work, channel, entry);
            continue;
        }
        if (entry.tool < 1 || entry.tool > most) {
            if (entry.field == "exists")
                work.fault(Alarm::ToolTableFull,
                           "tool " + std::to_string(entry.tool) + ": the table has " +
                               std::to_string(most) + " rows (N2902)",
                           entry.row, entry.column);
            continue;
        }
        const auto tool = static_cast<std::int32_t>(entry.tool);
        tools.insert(tool);
        if (entry.field == "exists") {
            if (set_tool_number(work.values, tool, "exists", 1, work.changes)) {
                ++added;
                mark_life(work, tool);
            }
        } else if (entry.field == "magazine" || entry.field == "pot") {
            const auto value = read_tool_value(tool_field(entry.field), entry.text);
            if (!value)
                work.fault(value.diagnosis(), entry.row, entry.column);
            else {
                Stand& stand = stands[tool];
                stand.row = entry.row;
                stand.column = entry.column;
                (entry.field == "pot" ? stand.pot : stand.magazine) = value->number;
            }
        } else if (!work.values.tool(tool)->used) {
            work.fault(Alarm::ToolMissing, std::to_string(tool), entry.row, entry.column);
        } else {
            const std::size_t before = work.faults.size();
            set_field(work, tool, entry.field, entry.text, entry.row);
            for (std::size_t i = before; i < work.faults.size(); ++i)
                work.faults[i].column = entry.column;
        }
        if (work.faults.size() > kMostFaults) break;
    }
    // All of them leave their places first: the file may exchange tools.
    for (const auto& [tool, stand] : stands) {
        set_tool_number(work.values, tool, "magazine", 0, work.changes);
        set_tool_number(work.values, tool, "pot", 0, work.changes);
    }
    for (const auto& [tool, stand] : stands) {
        if (stand.magazine == 0 && stand.pot == 0) continue;
        if (!work.values.tool(tool)->used) {
            work.fault(Alarm::ToolMissing, std::to_string(tool), stand.row, stand.column);
            continue;
        }
        const std::size_t before = work.faults.size();
        stand_at(work, tool, static_cast<std::int32_t>(stand.magazine),
                 static_cast<std::int32_t>(stand.pot), stand.row);
        if (stand.column.rfind("$TC_", 0) == 0)
            for (std::size_t i = before; i < work.faults.size(); ++i)
                work.faults[i].column = stand.column;
    }
    return {{"tools", tools.size()}, {"added", added}, {"changes", differing(work.changes)}};
}

std::string quoted(const std::string& text) {
    if (text.find_first_of(",\"\n;") == std::string::npos) return text;
    std::string out = "\"";
    for (const char c : text) out += c == '"' ? std::string("\"\"") : std::string(1, c);
    return out + "\"";
}

std::string csv(const StoreValues& values) {
    std::set<std::pair<int, int>> edge_columns;
    for (std::size_t i = 0; i < values.edges.count; ++i)
        for (int k = 1; k < 36; ++k)
            if (values.edges.edges[i].dp[static_cast<std::size_t>(k)] != 0)
                edge_columns.insert({values.edges.edges[i].number, k});
    std::string out = "tool";
    std::vector<const ToolField*> columns;
    for (const ToolField& field : tool_fields()) {
        bool wanted = field.name.rfind("custom", 0) != 0;
        for (const ToolRow& row : values.tools.rows)
            wanted = wanted || (row.used && tool_number(row, field) != 0);
        if (wanted && column_exists(values, field)) {
            columns.push_back(&field);
            out += "," + std::string(field.name);
        }
    }
    for (const auto& [edge, dp] : edge_columns)
        out += ",D" + std::to_string(edge) + ".DP" + std::to_string(dp);
    out += "\n";
    for (std::size_t i = 0; i < kTools; ++i) {
        const ToolRow& row = values.tools.rows[i];
        if (!row.used) continue;
        out += std::to_string(i + 1);
        for (const ToolField* field : columns) out += "," + quoted(tool_text(row, *field));
        for (const auto& [number, dp] : edge_columns) {
            const ToolEdge* edge = find_edge(values, static_cast<std::int32_t>(i + 1), number);
            out += "," +
                   (edge ? shortest_text(edge->dp[static_cast<std::size_t>(dp)]) : std::string());
        }
        out += "\n";
    }
    return out;
}

std::string with_point(double value) {
    const std::string text = shortest_text(value);
    return text.find_first_of(".e") == std::string::npos ? text + "." : text;
}

std::string fanuc(const StoreValues& values, std::int64_t channel, int cells) {
    std::string out = "%\nO9000 (TOOL DATA OF L" + std::to_string(channel) + ")\n";
    const auto& offsets = values.channels[static_cast<std::size_t>(channel - 1)].offsets;
    for (int n = 1; n <= cells; ++n) {
        const OffsetCell& cell = offsets[static_cast<std::size_t>(n)];
        const auto line = [&](int p, const std::array<double, 3>& lengths, double radius,
                              bool tip) {
            std::string words;
            for (int k : {0, 1, 2})
                if (lengths[static_cast<std::size_t>(k)] != 0)
                    words += std::string(" ") + "XYZ"[k] +
                             with_point(lengths[static_cast<std::size_t>(k)]);
            if (radius != 0) words += " R" + with_point(radius);
            if (tip && cell.tip != 0) words += " Q" + shortest_text(cell.tip);
            if (!words.empty()) out += "G10 P" + std::to_string(p) + words + "\n";
        };
        line(10'000 + n, cell.geometry, cell.geometry_r, true);
        line(n, cell.wear, cell.wear_r, false);
    }
    std::map<int, std::map<int, std::int32_t>> groups;
    for (std::size_t i = 0; i < kTools; ++i)
        if (const ToolRow& row = values.tools.rows[i]; row.used && row.group)
            groups[row.group][row.duplo * 1000 + static_cast<int>(i)] =
                static_cast<std::int32_t>(i + 1);
    if (!groups.empty()) {
        out += "G10 L3\n";
        for (const auto& [group, tools] : groups) {
            const ToolRow& first = *values.tool(tools.begin()->second);
            out += "P" + std::to_string(group) + " L" + shortest_text(first.life) + " Q" +
                   (static_cast<LifeKind>(first.life_kind) == LifeKind::Minutes ? "2" : "1") + "\n";
            for (const auto& [order, tool] : tools) {
                char text[32];
                const ToolRow& row = *values.tool(tool);
                std::snprintf(text, sizeof text, "T%02d%02d\n",
                              row.type_number ? row.type_number : tool, row.h_cell % 100);
                out += text;
            }
        }
        out += "G11\n";
    }
    return out + "M30\n%\n";
}

std::string sinumerik(const StoreValues& values) {
    std::string out = ";tool data of Polyturn\n";
    for (std::size_t i = 0; i < kTools; ++i) {
        const ToolRow& row = values.tools.rows[i];
        if (!row.used) continue;
        const std::string n = std::to_string(i + 1);
        const auto put = [&](const char* name, double value) {
            out += std::string("$TC_") + name + "[" + n + "]=" + shortest_text(value) + "\n";
        };
        put("TP1", row.duplo);
        out += "$TC_TP2[" + n + "]=\"" + tool_text(row, tool_field("name")) + "\"\n";
        for (int k = 0; k < 4; ++k)
            put(("TP" + std::to_string(3 + k)).c_str(), row.size[static_cast<std::size_t>(k)]);
        put("TP7", row.place_type);
        int state = 0;
        for (const auto& [bit, mask] : {std::pair{0, kToolActive},
                                        {1, kToolEnabled},
                                        {2, kToolLocked},
                                        {3, kToolMeasured},
                                        {4, kToolWarned},
                                        {6, kToolFixedPlace},
                                        {7, kToolUsed}})
            if (row.state & mask) state |= 1 << bit;
        put("TP8", state);
        const auto kind = static_cast<LifeKind>(row.life_kind);
        put("TP9", kind == LifeKind::Minutes  ? 1
                   : kind == LifeKind::Pieces ? 2
                   : kind == LifeKind::Wear   ? 4
                                              : 0);
        if (row.speed != 0) put("TP_MAX_VELO", row.speed);
        for (std::size_t e = 0; e < values.edges.count; ++e) {
            const ToolEdge& edge = values.edges.edges[e];
            if (edge.tool != static_cast<std::int32_t>(i + 1)) continue;
            for (std::size_t k = 1; k < edge.dp.size(); ++k)
                if (edge.dp[k] != 0)
                    out += "$TC_DP" + std::to_string(k) + "[" + n + "," +
                           std::to_string(edge.number) + "]=" + shortest_text(edge.dp[k]) + "\n";
        }
        const int base = kind == LifeKind::Minutes  ? 1
                         : kind == LifeKind::Pieces ? 3
                         : kind == LifeKind::Wear   ? 5
                                                    : 0;
        if (base) {
            const auto mop = [&](int number, double value) {
                out += "$TC_MOP" + std::to_string(number) + "[" + n +
                       ",1]=" + shortest_text(value) + "\n";
            };
            mop(base, row.warning);
            mop(base + 1, row.life - row.counter);
            mop(base + 10, row.life);
        }
        if (row.magazine)
            out += "$TC_MPP6[" + std::to_string(row.magazine) + "," + std::to_string(row.pot) +
                   "]=" + n + "\n";
    }
    return out + "M17\n";
}

Json export_table(const Json& request, Work& work) {
    const std::string format = request.contains("format") ? read_text(request, "format") : "csv";
    if (format == "csv") return {{"text", csv(work.values)}};
    if (format == "sinumerik") return {{"text", sinumerik(work.values)}};
    if (format != "fanuc") {
        work.fault(Alarm::StoreRequestBad, "format " + format + ": csv, fanuc or sinumerik");
        return Json();
    }
    std::int64_t channel = 1;
    read_whole(request, "channel", channel, work, false);
    if (channel < 1 || channel > static_cast<std::int64_t>(kMaxChannels) ||
        !work.machine.channel(static_cast<std::size_t>(channel)).exists()) {
        work.fault(Alarm::StoreRequestBad,
                   "channel L" + std::to_string(channel) + " does not exist");
        return Json();
    }
    return {{"text", fanuc(work.values, channel,
                           work.machine.channel(static_cast<std::size_t>(channel)).offset_count)}};
}

}  // namespace

Json table_operation(std::string_view what, const Json& request, Work& work) {
    return what == "import" ? import_table(request, work) : export_table(request, work);
}

}  // namespace polyturn::toolmgmt
