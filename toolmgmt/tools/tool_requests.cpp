#include "toolmgmt/tools/tool_requests.hpp"

#include <algorithm>
#include <cmath>
#include <cstring>
#include <memory>

#include "ipc/model/machine/store/edge_lengths.hpp"
#include "ipc/model/machine/store/tool_fields.hpp"
#include "ipc/params/registry.hpp"
#include "polyturn/parameter_handles.hpp"
#include "toolmgmt/tools/life_groups.hpp"
#include "toolmgmt/tools/places.hpp"
#include "toolmgmt/tools/search.hpp"

namespace polyturn::toolmgmt {
namespace {

constexpr std::int32_t kIntoSpindle = 2;
constexpr std::int32_t kPutAway = -1;  // T0 was called: the spindle becomes empty

Diagnosis refused(std::string why) {
    return Diagnosis{Alarm::StoreRequestBad, {}, {}, std::move(why)};
}

std::string_view name_of(const StoreRequest& request) {
    return {request.name.data(), ::strnlen(request.name.data(), request.name.size())};
}

void stand(StoreValues& values, std::int32_t tool, std::int32_t magazine, std::int32_t pot,
           std::vector<Change>& changes) {
    set_tool_number(values, tool, "magazine", magazine, changes);
    set_tool_number(values, tool, "pot", pot, changes);
}

// The tool goes into the spindle; what was there goes to its own place, to the pot that is free
// now, or to the nearest.
void into_spindle(StoreValues& values, std::int32_t spindle, std::int32_t tool,
                  std::vector<Change>& changes) {
    const auto places = std::make_unique<ToolPlaceTable>();
    derive_places(values, *places);
    const ToolPlace* seat = find_place(*places, 10 * spindle, 1);
    if (!seat) return;  // N2922: the spindle is no place
    const std::int32_t before = seat->tool;
    if (before == tool) return;
    std::int32_t from_magazine = 0, from_pot = 0;
    if (ToolRow* row = values.tool(tool); row && row->used) {
        from_magazine = row->magazine;
        from_pot = row->pot;
        if (row->home_magazine == 0) {
            set_tool_number(values, tool, "home_magazine", from_magazine, changes);
            set_tool_number(values, tool, "home_pot", from_pot, changes);
        }
        stand(values, tool, 0, 0, changes);
    }
    if (before != 0) {
        const ToolRow& old = *values.tool(before);
        std::int32_t magazine = old.home_magazine, pot = old.home_pot;
        stand(values, before, 0, 0, changes);
        derive_places(values, *places);
        const ToolPlace* back = find_place(*places, magazine, pot);
        if (!back || !place_fits(values, *places, before, *back))
            back = old.state & kToolFixedPlace ? nullptr
                                               : find_place(*places, from_magazine, from_pot);
        if (!back || !place_fits(values, *places, before, *back))
            back = nearest_free(values, *places, before, from_magazine ? from_magazine : magazine,
                                from_pot);
        if (back) stand(values, before, back->magazine, back->pot, changes);
    }
    if (tool != 0) stand(values, tool, 10 * spindle, 1, changes);
}

void works_now(StoreValues& values, unsigned channel, std::int32_t tool,
               std::vector<Change>& changes) {
    const auto number = static_cast<std::int32_t>(channel);
    set_value(values, {Kind::Work, number, 0, 0, "tool"}, tool, changes);
    set_value(values, {Kind::Work, number, 0, 0, "next tool"}, 0, changes);
    ToolRow* row = values.tool(tool);
    if (!row || !row->used) return;
    set_tool_number(values, tool, "was_used", 1, changes);
    for (std::size_t i = 0; i < kTools; ++i) {
        const ToolRow& other = values.tools.rows[i];
        if (&other != row && other.state & kToolActive && sisters(*row, other) &&
            other.magazine == row->magazine)
            set_tool_number(values, static_cast<std::int32_t>(i + 1), "active", 0, changes);
    }
    set_tool_number(values, tool, "active", 1, changes);
    use_up(values, tool, LifeKind::Uses, 1.0, changes);
}

}  // namespace

bool set_value(StoreValues& values, const Key& key, double value, std::vector<Change>& changes) {
    Change change;
    if (!change_to(values, key, value, {}, false, change)) return false;
    if (!write_value(values, key, value, {}, false)) return false;
    changes.push_back(std::move(change));
    return true;
}

bool set_text(StoreValues& values, const Key& key, std::string_view text,
              std::vector<Change>& changes) {
    Change change;
    if (!change_to(values, key, 0, text, true, change)) return false;
    if (!write_value(values, key, 0, std::string(text), true)) return false;
    changes.push_back(std::move(change));
    return true;
}

bool set_tool_number(StoreValues& values, std::int32_t tool, std::string_view field, double value,
                     std::vector<Change>& changes) {
    return set_value(values, {Kind::Tool, 0, tool, 0, std::string(field)}, value, changes);
}
bool set_tool_text(StoreValues& values, std::int32_t tool, std::string_view field,
                   std::string_view text, std::vector<Change>& changes) {
    return set_text(values, {Kind::Tool, 0, tool, 0, std::string(field)}, text, changes);
}

void use_up(StoreValues& values, std::int32_t tool, LifeKind kind, double amount,
            std::vector<Change>& changes) {
    ToolRow* row = values.tool(tool);
    if (!row || !row->used || static_cast<LifeKind>(row->life_kind) != kind ||
        kind == LifeKind::None || amount == 0.0)
        return;
    set_tool_number(values, tool, "counter", std::max(row->counter + amount, 0.0), changes);
    const double left = life_left(*row);
    set_tool_number(values, tool, "warned", left < row->warning ? 1 : 0, changes);
    if (left <= 0) set_tool_number(values, tool, "worn", 1, changes);
}

void look_at_wear(StoreValues& values, unsigned channel, std::int32_t cell,
                  std::vector<Change>& changes) {
    // A common cell is that of tools of all channels.
    const bool common =
        cell <= static_cast<std::int32_t>(std::max(
                    params::get(values.parameters, params::n1401_no_of_common_tool_offsets_m),
                    params::get(values.parameters, params::n1412_no_of_common_tool_offsets_t)));
    for (std::size_t i = 0; i < kTools; ++i) {
        const ToolRow& row = values.tools.rows[i];
        if (!row.used || row.h_cell != cell ||
            static_cast<LifeKind>(row.life_kind) != LifeKind::Wear ||
            !(common || reaches(values.parameters, channel, row)))
            continue;
        const auto& wear =
            values.channels[channel - 1].offsets[static_cast<std::size_t>(cell)].wear;
        double most = 0;
        for (const double one : wear) most = std::max(most, std::fabs(one));
        use_up(values, static_cast<std::int32_t>(i + 1), LifeKind::Wear, most - row.counter,
               changes);
    }
}

void check_edge_wear(StoreValues& values, std::int32_t tool, std::vector<Change>& changes) {
    const ToolRow* row = values.tool(tool);
    if (!row || !row->used || row->h_cell != 0 ||
        static_cast<LifeKind>(row->life_kind) != LifeKind::Wear)
        return;
    double most = 0;
    for (std::size_t i = 0; i < values.edges.count; ++i) {
        const ToolEdge& edge = values.edges.edges[i];
        for (int dp = kDpWear; edge.tool == tool && dp < kDpWearRadius; ++dp)
            most = std::max(most, std::fabs(edge.dp[static_cast<std::size_t>(dp)]));
    }
    use_up(values, tool, LifeKind::Wear, most - row->counter, changes);
}

bool is_tool_request(const StoreRequest& request) {
    const auto kind = static_cast<StoreRequestKind>(request.kind);
    return kind >= StoreRequestKind::ToolCall && kind <= StoreRequestKind::LifeGroup;
}

ToolAnswer answer_tool_call(const StoreRequest& request, const StoreValues& values,
                            const ToolPlaceTable& places) {
    ToolAnswer out = find_tool(
        values, places,
        {request.channel, static_cast<ToolCallBy>(request.field), request.value, name_of(request)});
    out.id = request.id;
    out.channel = request.channel;
    return out;
}

std::vector<ToolAnswer> changes_of_tools_in_work(const StoreValues& values,
                                                 const ToolPlaceTable& places,
                                                 const std::vector<Change>& changes) {
    std::vector<ToolAnswer> out;
    for (unsigned l = 1; l <= kMaxChannels; ++l) {
        const std::int32_t tool = values.tools.in_channel[l - 1];
        const ToolRow* row = values.tool(tool);
        if (!row || !row->used) continue;
        const bool touched = std::any_of(changes.begin(), changes.end(), [&](const Change& c) {
            return c.key.kind == Kind::Tool && values.tool(c.key.number) &&
                   sisters(*row, *values.tool(c.key.number));
        });
        const bool own = std::any_of(changes.begin(), changes.end(), [&](const Change& c) {
            return c.key.kind == Kind::Tool && c.key.number == tool;
        });
        if (!touched && !own) continue;
        ToolAnswer answer =
            find_tool(values, places, {l, ToolCallBy::Forced, static_cast<double>(tool), {}});
        answer.channel = l;
        if (answer.alarm < 0) answer.alarm = kToolChanges;
        if (answer.alarm < 0) out.push_back(answer);
    }
    return out;
}

Result<Applied> apply_tool_request(const StoreRequest& request, StoreValues& values) {
    Applied applied;
    const auto kind = static_cast<StoreRequestKind>(request.kind);
    const bool of_channel = request.channel >= 1 && request.channel <= kMaxChannels;
    switch (kind) {
        case StoreRequestKind::ToolInPlace: {
            if (!of_channel) return refused("a tool of no channel");
            // In a turret it works now (field 1); for a spindle it waits for the tool change code
            // (0), unless T changes it (2).
            if (request.field == 0) {
                set_value(
                    values,
                    {Kind::Work, static_cast<std::int32_t>(request.channel), 0, 0, "next tool"},
                    request.number != 0 ? request.number : kPutAway, applied.changes);
                return applied;
            }
            if (request.field == kIntoSpindle)
                into_spindle(values, tool_spindle(values.parameters, request.channel),
                             request.number, applied.changes);
            works_now(values, request.channel, request.number, applied.changes);
            return applied;
        }
        case StoreRequestKind::ToolChanged: {
            if (!of_channel) return refused("a tool of no channel");
            const std::int32_t next = values.tools.next[request.channel - 1];
            if (next == 0) return applied;
            const std::int32_t tool = next == kPutAway ? 0 : next;
            into_spindle(values, tool_spindle(values.parameters, request.channel), tool,
                         applied.changes);
            works_now(values, request.channel, tool, applied.changes);
            return applied;
        }
        case StoreRequestKind::ToolLife:
            if (!std::isfinite(request.value)) return refused("life of a tool: not a number");
            use_up(values, request.number, static_cast<LifeKind>(request.field), request.value,
                   applied.changes);
            return applied;
        case StoreRequestKind::ToolValue: {
            ToolRow* row = values.tool(request.number);
            if (!row || request.field < 0 ||
                static_cast<std::size_t>(request.field) >= tool_fields().size())
                return refused("a value of a tool that cannot exist");
            const ToolField& field = tool_fields()[static_cast<std::size_t>(request.field)];
            if (field.name == "magazine" || field.name == "pot")
                return refused("programs do not load tools");
            const auto read =
                read_tool_value(field, field.is_text() ? std::string(name_of(request))
                                                       : std::to_string(request.value));
            if (!field.is_text() && (!std::isfinite(request.value) || request.value < field.least ||
                                     request.value > field.most))
                return refused("tool " + std::to_string(request.number) + " " +
                               std::string(field.name));
            if (field.is_text() && !read) return read.diagnosis();
            if (!row->used) set_tool_number(values, request.number, "exists", 1, applied.changes);
            if (field.is_text())
                set_tool_text(values, request.number, field.name, read->text, applied.changes);
            else
                set_tool_number(values, request.number, field.name, request.value, applied.changes);
            return applied;
        }
        case StoreRequestKind::EdgeValue: {
            const ToolRow* row = values.tool(request.number);
            const std::int32_t edge = request.field / 100, dp = request.field % 100;
            if (!row || edge < 1 || edge > 12 || dp < 1 || dp > 35 || !std::isfinite(request.value))
                return refused("a value of an edge that cannot exist");
            if (!row->used) set_tool_number(values, request.number, "exists", 1, applied.changes);
            set_value(values, {Kind::Edge, request.number, edge, dp, {}}, request.value,
                      applied.changes);
            if (is_edge_wear(dp)) check_edge_wear(values, request.number, applied.changes);
            return applied;
        }
        case StoreRequestKind::LifeGroup:
            return apply_life_group(request, values);
        default:
            break;
    }
    return refused("unknown kind " + std::to_string(request.kind));
}

}  // namespace polyturn::toolmgmt
