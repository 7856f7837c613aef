// Life of tools: report with forecast, reset after a new insert, correction of a count.
#include <algorithm>
#include <cmath>
#include <map>
#include <nlohmann/json.hpp>

#include "ipc/requests/counters.hpp"
#include "ipc/model/machine/store/edge_lengths.hpp"
#include "ipc/model/machine/store/tool_fields.hpp"
#include "polyturn/parameter_handles.hpp"
#include "toolmgmt/operations/offset_rules.hpp"
#include "toolmgmt/operations/operation.hpp"
#include "toolmgmt/operations/tool_json.hpp"
#include "toolmgmt/tools/search.hpp"
#include "toolmgmt/tools/tool_requests.hpp"

namespace polyturn::toolmgmt {
namespace {

std::string name_of(const ToolRow& row) { return tool_text(row, tool_field("name")); }

// Tools that are each other's sisters, by what calls them.
using Groups = std::map<std::string, std::vector<std::int32_t>>;
Groups groups_of(const StoreValues& values) {
    Groups out;
    for (std::size_t i = 0; i < kTools; ++i) {
        const ToolRow& row = values.tools.rows[i];
        if (!row.used) continue;
        const std::string key = row.type_number         ? "T" + std::to_string(row.type_number)
                                : !name_of(row).empty() ? name_of(row)
                                                        : "tool " + std::to_string(i + 1);
        out[key].push_back(static_cast<std::int32_t>(i + 1));
    }
    return out;
}

// What one part takes of the life of a group on the average: what all its sisters have used since
// the oldest of their counts began, over the parts made since then. A reset goes on counting: what
// the old insert had used stays in the sum. 0: not known.
double per_part(const StoreValues& values, const std::vector<std::int32_t>& tools, double parts) {
    double used = 0, begin = parts;
    bool known = false;
    for (const std::int32_t tool : tools) {
        const Cell* since = values.cell({Kind::Setting, 0, tool, 0, "parts at reset"});
        const Cell* count = values.cell({Kind::Setting, 0, tool, 0, "counter at reset"});
        const Cell* before = values.cell({Kind::Setting, 0, tool, 0, "used before"});
        if (!since && !count) continue;  // not known since when it counts
        known = true;
        begin = std::min(begin, since ? since->number : 0.0);
        used += values.tool(tool)->counter - (count ? count->number : 0.0) +
                (before ? before->number : 0.0);
    }
    return known && parts - begin >= 1 && used > 0 ? used / (parts - begin) : 0.0;
}

double parts_made(const StoreValues& values) {
    double most = 0;
    for (unsigned l = 1; l <= kMaxChannels; ++l)
        if (const double parts =
                values.counters[static_cast<std::size_t>(counter_number(Counter::TotalParts, l))];
            !std::isnan(parts))
            most = std::max(most, parts);
    return most;
}

double minutes_per_part(const StoreValues& values) {
    double most = 0;
    for (unsigned l = 1; l <= kMaxChannels; ++l) {
        const double parts =
            values.counters[static_cast<std::size_t>(counter_number(Counter::TotalParts, l))];
        const double ms =
            values.counters[static_cast<std::size_t>(counter_number(Counter::OperationTime, l))];
        if (parts >= 1 && ms > 0) most = std::max(most, ms / 60'000.0 / parts);
    }
    return most;
}

Json report(Work& work) {
    const StoreValues& values = work.values;
    const double parts = parts_made(values), minutes = minutes_per_part(values);
    Json out = Json::array();
    double first = std::numeric_limits<double>::infinity();
    std::string stops, stops_tool;
    for (const auto& [name, tools] : groups_of(values)) {
        Json one = {{"group", name}}, list = Json::array();
        struct Kind {
            std::vector<std::int32_t> tools;
            double left = 0;
        };
        // sisters may be watched in different units: those are never added
        std::map<std::uint32_t, Kind> kinds;
        bool endless = false;
        std::int32_t last = 0;
        for (const std::int32_t number : tools) {
            const ToolRow& row = *values.tool(number);
            const double rest = life_left(row);
            Json tool = {{"tool", number},
                         {"name", name_of(row)},
                         {"duplo", row.duplo},
                         {"usable", usable(row)},
                         {"worn", (row.state & kToolWorn) != 0},
                         {"warned", (row.state & kToolWarned) != 0},
                         {"life_kind", tool_text(row, tool_field("life_kind"))},
                         {"unit", kLifeUnits[std::min<std::size_t>(row.life_kind, 5)]},
                         {"life", row.life},
                         {"counter", row.counter}};
            if (std::isfinite(rest)) {
                tool["left"] = rounded(rest);
                kinds[row.life_kind].tools.push_back(number);
                if (usable(row)) {
                    kinds[row.life_kind].left += rest;
                    last = number;
                }
            } else if (usable(row)) {
                endless = true;
            }
            list.push_back(std::move(tool));
        }
        one["tools"] = std::move(list);
        if (!kinds.empty() && !endless) {
            const bool mixed = kinds.size() > 1;
            if (!mixed) one["left"] = rounded(kinds.begin()->second.left);
            one["unit"] =
                mixed ? "mixed" : kLifeUnits[std::min<std::size_t>(kinds.begin()->first, 5)];
            double left_parts = 0;
            bool known = true;
            for (const auto& [kind, of] : kinds) {
                double rate = per_part(values, of.tools, parts);
                // those that take turns with others say no rate of their own
                if (static_cast<LifeKind>(kind) == LifeKind::Pieces && (rate <= 0 || mixed))
                    rate = 1;
                known = known && (rate > 0 || of.left <= 0);
                if (rate > 0) left_parts += of.left / rate;
            }
            left_parts = std::floor(left_parts + 1e-9);
            if (known) {
                one["parts_left"] = left_parts;
                if (minutes > 0) one["minutes_left"] = left_parts * minutes;
                if (left_parts < first) {
                    first = left_parts;
                    stops = name;
                    stops_tool = last ? std::to_string(last) : std::string();
                }
            }
        }
        out.push_back(std::move(one));
    }
    Json answer = {{"groups", std::move(out)}};
    if (minutes > 0) answer["minutes_per_part"] = minutes;
    if (!stops.empty())
        answer["stops_first"] = {{"group", stops}, {"tool", stops_tool}, {"parts_left", first}};
    return answer;
}

// A new insert: what the old one has used stays in the rate of its group.
void go_on_life(Work& work, std::int32_t tool, double used) {
    const Key parts{Kind::Setting, 0, tool, 0, "parts at reset"},
        before{Kind::Setting, 0, tool, 0, "used before"};
    const Cell* kept = work.values.cell(before);
    const double sum = (kept ? kept->number : 0.0) + std::max(used, 0.0);
    if (!work.values.cell(parts))
        set_value(work.values, parts, parts_made(work.values), work.changes);
    set_value(work.values, {Kind::Setting, 0, tool, 0, "counter at reset"},
              work.values.tool(tool)->counter, work.changes);
    set_value(work.values, before, sum, work.changes);
}

Json reset(const Json& request, Work& work) {
    Json tools = Json::array();
    std::int64_t number = 0;
    if (const auto list = request.find("tools"); list != request.end() && list->is_array())
        tools = *list;
    else if (read_whole(request, "tool", number, work))
        tools.push_back(number);
    for (const auto& one : tools) {
        const std::int64_t tool = one.is_number_integer() ? one.get<std::int64_t>() : 0;
        const ToolRow* row = work.values.tool(tool);
        if (!row || !row->used) {
            work.fault(Alarm::ToolMissing, one.dump());
            continue;
        }
        const auto n = static_cast<std::int32_t>(tool);
        double counter = 0;
        read_real(request, "counter", counter, work, false);
        if (counter < 0) work.fault(Alarm::ToolValueBad, "counter: not below 0");
        const Cell* mark = work.values.cell({Kind::Setting, 0, n, 0, "counter at reset"});
        const double used = mark ? row->counter - mark->number : 0.0;
        set_tool_number(work.values, n, "counter", counter, work.changes);
        set_tool_number(work.values, n, "worn", 0, work.changes);
        set_tool_number(work.values, n, "warned", 0, work.changes);
        set_tool_number(work.values, n, "broken", 0, work.changes);
        go_on_life(work, n, used);
        // A new insert has no wear: the offset cell and the edges say so unless it is asked to
        // stay.
        std::int64_t channel = 0;
        if (!read_whole(request, "channel", channel, work, false)) continue;
        // an edge of wear alone goes with it
        for (std::size_t i = work.values.edges.count; i-- > 0;) {
            const ToolEdge edge = work.values.edges.edges[i];
            for (int dp = kDpWear; edge.tool == n && dp <= kDpWearRadius; ++dp)
                if (edge.dp[static_cast<std::size_t>(dp)] != 0)
                    set_value(work.values, {Kind::Edge, n, edge.number, dp, {}}, 0, work.changes);
        }
        if (row->h_cell > 0 && channel >= 1 && channel <= static_cast<std::int64_t>(kMaxChannels))
            for (int field = 0; field < 4; ++field)
                set_value(work.values, offset_key(work, channel, row->h_cell, 1, field), 0,
                          work.changes);
    }
    return {{"reset", tools.size()}};
}

}  // namespace

void mark_life(Work& work, std::int32_t tool) {
    set_value(work.values, {Kind::Setting, 0, tool, 0, "parts at reset"}, parts_made(work.values),
              work.changes);
    set_value(work.values, {Kind::Setting, 0, tool, 0, "counter at reset"},
              work.values.tool(tool)->counter, work.changes);
    if (work.values.cell({Kind::Setting, 0, tool, 0, "used before"}))
        set_value(work.values, {Kind::Setting, 0, tool, 0, "used before"}, std::nan(""),
                  work.changes);
}

void forget_life(Work& work, std::int32_t tool) {
    for (const char* mark : {"parts at reset", "counter at reset", "used before"})
        if (work.values.cell({Kind::Setting, 0, tool, 0, mark}))
            set_value(work.values, {Kind::Setting, 0, tool, 0, mark}, std::nan(""), work.changes);
}

Json life_operation(std::string_view what, const Json& request, Work& work) {
    if (what == "report") return report(work);
    if (what == "reset") return reset(request, work);
    work.fault(Alarm::StoreRequestBad, "life." + std::string(what));
    return Json();
}

}  // namespace polyturn::toolmgmt
