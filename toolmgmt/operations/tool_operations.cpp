// Tools and where they stand: list, show, places, answers, add, set, delete, load, unload, move,
// place.
#include <algorithm>
#include <cmath>
#include <cstring>
#include <memory>
#include <nlohmann/json.hpp>

#include "ipc/model/machine/shortest_text.hpp"
#include "ipc/model/machine/store/edge_lengths.hpp"
#include "ipc/model/machine/store/tool_fields.hpp"
#include "ipc/params/registry.hpp"
#include "polyturn/parameter_handles.hpp"
#include "toolmgmt/operations/operation.hpp"
#include "toolmgmt/operations/tool_json.hpp"
#include "toolmgmt/tools/places.hpp"
#include "toolmgmt/tools/search.hpp"
#include "toolmgmt/tools/tool_requests.hpp"

namespace polyturn::toolmgmt {

bool column_exists(const StoreValues& values, const ToolField& field) {
    int number = 0;
    if (std::sscanf(std::string(field.name).c_str(), "custom%d", &number) != 1) return true;
    return number <=
           static_cast<int>(params::get(values.parameters, params::n2903_no_of_custom_columns));
}

std::int64_t table_length(const StoreValues& values) {
    return std::min<std::int64_t>(
        static_cast<std::int64_t>(
            params::get(values.parameters, params::n2902_tool_management_table_length)),
        static_cast<std::int64_t>(kTools));
}

Json tool_json(const StoreValues& values, std::int32_t number) {
    const ToolRow& row = *values.tool(number);
    Json out;
    out["tool"] = number;
    for (const ToolField& field : tool_fields()) {
        if (field.name.rfind("custom", 0) == 0 && tool_number(row, field) == 0) continue;
        if (field.unit == "bits")
            out[std::string(field.name)] = tool_text(row, field);
        else if (field.is_text() || field.type == ToolFieldType::Life)
            out[std::string(field.name)] = tool_text(row, field);
        else if (field.type == ToolFieldType::Flag)
            out[std::string(field.name)] = tool_number(row, field) != 0;
        else
            out[std::string(field.name)] = tool_number(row, field);
    }
    out["life_unit"] = kLifeUnits[std::min<std::size_t>(row.life_kind, std::size(kLifeUnits) - 1)];
    if (const double left = life_left(row); std::isfinite(left)) out["left"] = rounded(left);
    out["place"] = row.magazine ? place_name(row.magazine, row.pot) : std::string();
    out["usable"] = usable(row);
    Json edges = Json::array();
    for (std::size_t i = 0; i < values.edges.count; ++i) {
        const ToolEdge& edge = values.edges.edges[i];
        if (edge.tool != number) continue;
        Json one = {{"edge", edge.number}};
        for (std::size_t k = 1; k < edge.dp.size(); ++k)
            if (edge.dp[k] != 0) one["DP" + std::to_string(k)] = edge.dp[k];
        edges.push_back(std::move(one));
    }
    out["edges"] = std::move(edges);
    Json works = Json::array();
    for (std::size_t l = 0; l < kMaxChannels; ++l)
        if (values.tools.in_channel[l] == number) works.push_back("L" + std::to_string(l + 1));
    out["works_in"] = std::move(works);
    return out;
}

namespace {

// The number that stands in a column now, or in an edge («D1.DP6»); nothing: it is none.
std::optional<double> number_in(const StoreValues& values, std::int32_t number,
                                const std::string& name) {
    int edge = 0, parameter = 0, used = 0;
    if (std::sscanf(name.c_str(), "D%d.DP%d%n", &edge, &parameter, &used) == 2 &&
        name[static_cast<std::size_t>(used)] == 0) {
        const ToolEdge* const found = find_edge(values, number, edge);
        return parameter < 1 || parameter > 35
                   ? std::nullopt
                   : std::optional(found ? found->dp[static_cast<std::size_t>(parameter)] : 0.0);
    }
    const auto field = find_tool_field(name);
    if (!field) return {};
    const ToolField& column = tool_fields()[*field];
    if (column.type != ToolFieldType::Number && column.type != ToolFieldType::Whole) return {};
    return tool_number(*values.tool(number), column);
}

// {"counter":{"delta":2}}: on top of what stands there, whoever has written it; and told what it
// was and has become.
bool enter_field(Work& work, std::int32_t number, const std::string& name, const Json& entry,
                 int row, Json& told) {
    const auto present = number_in(work.values, number, name);
    if (!present) {
        work.fault(Alarm::ToolValueBad, name + ": nothing is added to it", row, name);
        return false;
    }
    double value = 0;
    if (!read_entry(entry, *present, "tool " + std::to_string(number) + " " + name, value, work))
        return false;
    if (!set_field(work, number, name, shortest_text(value), row)) return false;
    told.push_back({{"field", name}, {"old", *present}, {"new", value}});
    return true;
}

}  // namespace

bool set_fields(Work& work, std::int32_t number, const Json& fields, int row, Json* entries) {
    if (!fields.is_object()) {
        work.fault(Alarm::StoreRequestBad, "fields are missing", row);
        return false;
    }
    bool good = true;
    Json told = Json::array();
    for (const auto& [name, value] : fields.items()) {
        if (value.is_object()) {
            good = enter_field(work, number, name, value, row, told) && good;
            continue;
        }
        const std::string text = value.is_string()    ? value.get<std::string>()
                                 : value.is_boolean() ? (value.get<bool>() ? "1" : "0")
                                 : value.is_number()  ? shortest_text(value.get<double>())
                                                      : value.dump();
        if (!set_field(work, number, name, text, row)) good = false;
    }
    if (entries) *entries = std::move(told);
    return good;
}

// "life", or "D1.DP6" for an edge.
bool set_field(Work& work, std::int32_t number, const std::string& name, const std::string& text,
               int row) {
    int edge = 0, parameter = 0, used = 0;
    if (std::sscanf(name.c_str(), "D%d.DP%d%n", &edge, &parameter, &used) == 2 &&
        name[static_cast<std::size_t>(used)] == 0) {
        char* end = nullptr;
        const double value = std::strtod(text.c_str(), &end);
        if (edge < 1 || edge > kMostEdgesOfTool || parameter < 1 || parameter > 35) {
            work.fault(Alarm::ToolValueBad,
                       name + ": edges are D1 to D" + std::to_string(kMostEdgesOfTool) +
                           ", parameters DP1 to DP35",
                       row, name);
            return false;
        }
        if (text.empty() || *end != 0 || !std::isfinite(value) || std::fabs(value) > 1e6) {
            work.fault(Alarm::ToolValueBad, name + "=" + text + ": not a number", row, name);
            return false;
        }
        if (parameter == 2 && (value < 0 || value > 9 || value != std::trunc(value))) {
            work.fault(Alarm::ToolValueBad, name + "=" + text + ": tip directions are 0 to 9", row,
                       name);
            return false;
        }
        if (value != 0 && !find_edge(work.values, number, edge) &&
            work.values.edges.count == kToolEdges) {
            work.fault(Alarm::ToolTableFull, std::to_string(kToolEdges) + " edges", row, name);
            return false;
        }
        set_value(work.values, {Kind::Edge, number, edge, parameter, {}}, value, work.changes);
        return true;
    }
    const auto field = find_tool_field(name);
    if (!field) {
        work.fault(Alarm::ToolValueBad, "there is no column " + name, row, name);
        return false;
    }
    if (name == "magazine" || name == "pot") {
        work.fault(Alarm::ToolValueBad, name + ": use tools load, unload or move", row, name);
        return false;
    }
    const ToolField& column = tool_fields()[*field];
    if (!column_exists(work.values, column)) {
        work.fault(Alarm::ToolValueBad,
                   "there is no column " + name + ": this machine has " +
                       std::to_string(static_cast<int>(params::get(
                           work.values.parameters, params::n2903_no_of_custom_columns))) +
                       " free ones (N2903)",
                   row, name);
        return false;
    }
    const auto value = read_tool_value(column, text);
    if (!value) {
        work.fault(value.diagnosis(), row, name);
        return false;
    }
    if (column.is_text())
        set_tool_text(work.values, number, name, value->text, work.changes);
    else if (set_tool_number(work.values, number, name, value->number, work.changes) &&
             name == "counter")
        // entered by hand: the rate begins here
        mark_life(work, number);
    return true;
}

bool stand_at(Work& work, std::int32_t number, std::int32_t magazine, std::int32_t pot, int row) {
    const auto places = std::make_unique<ToolPlaceTable>();
    derive_places(work.values, *places);
    const ToolPlace* place = find_place(*places, magazine, pot);
    if (!place) {
        work.fault(Alarm::ToolPlaceUnknown, place_name(magazine, pot), row, row ? "pot" : "");
        return false;
    }
    if (place->tool != 0 && place->tool != number && row > 0) {
        work.fault(Alarm::ToolTwice,
                   place_name(magazine, pot) + " holds tool " + std::to_string(place->tool), row,
                   "pot");
        return false;
    }
    if (const auto fits = place_fits(work.values, *places, number, *place); !fits) {
        work.fault(fits.diagnosis(), row, row ? "pot" : "");
        return false;
    }
    set_tool_number(work.values, number, "magazine", magazine, work.changes);
    set_tool_number(work.values, number, "pot", pot, work.changes);
    return true;
}

void remove_tool(Work& work, std::int32_t number) {
    for (std::size_t i = work.values.edges.count; i-- > 0;) {
        const ToolEdge edge = work.values.edges.edges[i];
        if (edge.tool != number) continue;
        for (int k = 0; k < 36; ++k)
            if (edge.dp[static_cast<std::size_t>(k)] != 0)
                set_value(work.values, {Kind::Edge, number, edge.number, k, {}}, std::nan(""),
                          work.changes);
    }
    for (const ToolField& field : tool_fields()) {
        if (field.is_text())
            set_tool_text(work.values, number, field.name, {}, work.changes);
        else if (tool_number(*work.values.tool(number), field) != field.fallback)
            set_tool_number(work.values, number, field.name, std::nan(""), work.changes);
    }
    forget_life(work, number);
    set_tool_number(work.values, number, "exists", std::nan(""), work.changes);
}

namespace {

bool works(const StoreValues& values, std::int32_t number, Work& work, const char* what) {
    for (std::size_t l = 0; l < kMaxChannels; ++l)
        if (values.tools.in_channel[l] == number) {
            work.fault(Alarm::ToolPlaceTaken, "tool " + std::to_string(number) +
                                                  " works in channel L" + std::to_string(l + 1) +
                                                  ": it cannot be " + what);
            return true;
        }
    return false;
}

// The tool that the request names by its data number or by name; the first fault otherwise.
std::int32_t which(const Json& request, Work& work) {
    const auto at = request.find("tool");
    std::int64_t number = 0;
    if (at != request.end() && at->is_string()) {
        const std::string name = at->get<std::string>();
        std::int32_t found = 0;
        for (std::size_t i = 0; i < kTools; ++i) {
            const ToolRow& row = work.values.tools.rows[i];
            if (!row.used || name.compare(row.name.data()) != 0) continue;
            if (found) {
                work.fault(Alarm::ToolMissing,
                           "several tools are called " + name + ": say the number");
                return 0;
            }
            found = static_cast<std::int32_t>(i + 1);
        }
        if (found) return found;
        if (name.find_first_not_of("0123456789") != std::string::npos || name.empty() ||
            name.size() > 6) {
            work.fault(Alarm::ToolMissing, name);
            return 0;
        }
        number = std::stol(name);
    } else if (!read_whole(request, "tool", number, work)) {
        return 0;
    }
    const ToolRow* row = work.values.tool(number);
    if (!row || !row->used) {
        work.fault(Alarm::ToolMissing, std::to_string(number));
        return 0;
    }
    return static_cast<std::int32_t>(number);
}

Json list(const Json& request, Work& work) {
    Json tools = Json::array();
    std::int64_t magazine = -1, type = -1;
    read_whole(request, "magazine", magazine, work, false);
    read_whole(request, "type", type, work, false);
    for (std::size_t i = 0; i < kTools; ++i) {
        const ToolRow& row = work.values.tools.rows[i];
        if (!row.used || (magazine >= 0 && row.magazine != magazine) ||
            (type >= 0 && row.type_number != type))
            continue;
        tools.push_back(tool_json(work.values, static_cast<std::int32_t>(i + 1)));
    }
    return {{"tools", std::move(tools)}, {"length", table_length(work.values)}};
}

Json places_json(Work& work) {
    const auto places = std::make_unique<ToolPlaceTable>();
    derive_places(work.values, *places);
    static constexpr const char* kKinds[] = {"chain", "matrix", "turret", "spindle", "arm"};
    Json out = Json::array();
    for (std::size_t i = 0; i < places->count; ++i) {
        const ToolPlace& place = places->places[i];
        Json one = {{"magazine", place.magazine},
                    {"pot", place.pot},
                    {"kind", kKinds[place.kind]},
                    {"tool", place.tool},
                    {"name", place_name(place.magazine, place.pot)}};
        if (place.tool)
            one["tool_name"] = tool_text(*work.values.tool(place.tool), tool_field("name"));
        if (place.state & kPlaceLocked) one["locked"] = true;
        if (place.state & kPlaceHalf) one["half"] = true;
        if (place.place_type) one["place_type"] = place.place_type;
        out.push_back(std::move(one));
    }
    return {{"places", std::move(out)}};
}

// What T calls of a channel would find now: for each station of its turret (0: nothing that may be
// used), and besides those the tools that a name finds. One question for all, so that a check of
// programs elsewhere needs no search of its own.
Json answers(const Json& request, Work& work) {
    std::int64_t channel = 0;
    if (!read_whole(request, "channel", channel, work)) return {};
    if (channel < 1 || channel > static_cast<std::int64_t>(kMaxChannels) ||
        !work.machine.channel(static_cast<std::size_t>(channel)).exists()) {
        work.fault(Alarm::StoreRequestBad,
                   "channel L" + std::to_string(channel) + " does not exist", 0, "channel");
        return Json();
    }
    Json stations = Json::array(), others = Json::array();
    const auto l = static_cast<unsigned>(channel);
    const auto places = std::make_unique<ToolPlaceTable>();
    derive_places(work.values, *places);
    const std::int32_t turret = turret_of(work.values.parameters, l).magazine;
    for (std::size_t i = 0; i < places->count && turret > 0; ++i) {
        const ToolPlace& place = places->places[i];
        if (place.magazine != turret) continue;
        const ToolAnswer found = find_tool(
            work.values, *places, {l, ToolCallBy::Location, static_cast<double>(place.pot), {}});
        stations.push_back({{"pot", place.pot}, {"tool", found.alarm < 0 ? found.tool : 0}});
    }
    for (std::size_t i = 0; i < kTools; ++i) {
        const ToolRow& row = work.values.tools.rows[i];
        if (!row.used || row.magazine <= 0 || row.magazine == turret || !usable(row) ||
            !reaches(work.values.parameters, l, row))
            continue;
        const std::string name = tool_text(row, tool_field("name"));
        // a sister is called
        if (!name.empty() &&
            find_tool(work.values, *places, {l, ToolCallBy::Name, 0.0, name}).tool !=
                static_cast<std::int32_t>(i + 1))
            continue;
        others.push_back(i + 1);
    }
    return {{"managed", managed(work.values.parameters)},
            {"stations", std::move(stations)},
            {"others", std::move(others)}};
}

Json add(const Json& request, Work& work) {
    std::int64_t number = 0;
    const std::int64_t most = table_length(work.values);
    if (request.contains("tool")) {
        if (!read_whole(request, "tool", number, work)) return {};
        if (number < 1 || number > most) {
            work.fault(Alarm::ToolTableFull, "tool " + std::to_string(number) + ": the table has " +
                                                 std::to_string(most) + " rows (N2902)");
            return Json();
        }
        if (work.values.tool(number)->used) {
            work.fault(Alarm::ToolValueBad, "tool " + std::to_string(number) + " exists");
            return Json();
        }
    } else {
        for (number = 1; number <= most && work.values.tool(number)->used;) ++number;
        if (number > most) {
            work.fault(Alarm::ToolTableFull, std::to_string(most) + " tools (N2902)");
            return Json();
        }
    }
    const auto tool = static_cast<std::int32_t>(number);
    set_tool_number(work.values, tool, "exists", 1, work.changes);
    mark_life(work, tool);
    if (request.contains("fields")) set_fields(work, tool, request["fields"], 0);
    return {{"tool", number}};
}

// A magazine and a pot, a pot alone (of the only magazine), or neither: the nearest free place.
Json load(const Json& request, Work& work, bool move) {
    const std::int32_t number = which(request, work);
    if (!number) return {};
    const ToolRow& row = *work.values.tool(number);
    if (move != (row.magazine != 0)) {
        work.fault(
            Alarm::ToolPlaceTaken,
            "tool " + std::to_string(number) +
                (move ? " stands nowhere: load it"
                      : " stands in " + place_name(row.magazine, row.pot) + ": move or unload it"));
        return Json();
    }
    if (move && works(work.values, number, work, "moved")) return {};
    std::int64_t magazine = row.home_magazine, pot = 0;
    const bool said_magazine = read_whole(request, "magazine", magazine, work, false);
    if (!work.good()) return {};
    if (!said_magazine && magazine == 0) magazine = 1;
    if (!read_whole(request, "pot", pot, work, false)) {
        if (!work.good()) return {};
        const auto places = std::make_unique<ToolPlaceTable>();
        derive_places(work.values, *places);
        if (row.home_magazine == magazine && row.home_pot != 0)
            pot = row.home_pot;
        else if (const ToolPlace* free = nearest_free(work.values, *places, number,
                                                      static_cast<std::int32_t>(magazine), 0))
            pot = free->pot;
        else {
            work.fault(Alarm::ToolPlaceTaken, "magazine " + std::to_string(magazine) +
                                                  " has no free place for tool " +
                                                  std::to_string(number));
            return Json();
        }
    }
    if (!stand_at(work, number, static_cast<std::int32_t>(magazine), static_cast<std::int32_t>(pot),
                  0))
        return {};
    return {
        {"tool", number},
        {"magazine", magazine},
        {"pot", pot},
        {"place", place_name(static_cast<std::int32_t>(magazine), static_cast<std::int32_t>(pot))}};
}

Json unload(const Json& request, Work& work) {
    const std::int32_t number = which(request, work);
    if (!number || works(work.values, number, work, "unloaded")) return {};
    if (work.values.tool(number)->magazine == 0) {
        work.fault(Alarm::ToolPlaceUnknown, "tool " + std::to_string(number) + " stands nowhere");
        return Json();
    }
    set_tool_number(work.values, number, "magazine", 0, work.changes);
    set_tool_number(work.values, number, "pot", 0, work.changes);
    return {{"tool", number}};
}

Json place(const Json& request, Work& work) {
    std::int64_t magazine = 0, pot = 0, value = 0;
    if (!read_whole(request, "magazine", magazine, work) || !read_whole(request, "pot", pot, work))
        return {};
    const auto places = std::make_unique<ToolPlaceTable>();
    derive_places(work.values, *places);
    const auto m = static_cast<std::int32_t>(magazine), p = static_cast<std::int32_t>(pot);
    if (!find_place(*places, m, p)) {
        work.fault(Alarm::ToolPlaceUnknown, place_name(m, p));
        return Json();
    }
    for (const char* key : {"locked", "place_type"})
        if (read_whole(request, key, value, work, false))
            set_value(work.values, {Kind::Place, m, p, 0, key},
                      value == 0 ? std::nan("") : static_cast<double>(value), work.changes);
    return {{"place", place_name(m, p)}};
}

}  // namespace

Json tool_operation(std::string_view what, const Json& request, Work& work) {
    if (what == "list") return list(request, work);
    if (what == "places") return places_json(work);
    if (what == "answers") return answers(request, work);
    if (what == "add") return add(request, work);
    if (what == "load" || what == "move") return load(request, work, what == "move");
    if (what == "unload") return unload(request, work);
    if (what == "place") return place(request, work);
    if (what == "fields") {
        Json out = Json::array();
        for (const ToolField& field : tool_fields())
            if (column_exists(work.values, field))
                out.push_back({{"name", std::string(field.name)},
                               {"unit", std::string(field.unit)},
                               {"least", field.least},
                               {"most", field.most},
                               {"meaning", std::string(field.meaning)}});
        return {{"fields", std::move(out)}};
    }
    if (what != "show" && what != "set" && what != "delete") {
        work.fault(Alarm::StoreRequestBad, "tools." + std::string(what));
        return Json();
    }
    const std::int32_t number = which(request, work);
    if (!number) return {};
    if (what == "set") {
        Json entries, out;
        set_fields(work, number, request.contains("fields") ? request["fields"] : Json(), 0,
                   &entries);
        out = tool_json(work.values, number);
        if (!entries.empty()) out["entries"] = std::move(entries);
        return out;
    }
    if (what == "delete") {
        if (!works(work.values, number, work, "deleted")) remove_tool(work, number);
        return {{"tool", number}};
    }
    return tool_json(work.values, number);
}

}  // namespace polyturn::toolmgmt
