#include "toolmgmt/tools/life_groups.hpp"

#include <cmath>
#include <cstdio>
#include <cstring>
#include <memory>

#include "polyturn/parameter_handles.hpp"
#include "toolmgmt/tools/places.hpp"
#include "toolmgmt/tools/search.hpp"
#include "toolmgmt/tools/tool_requests.hpp"

namespace polyturn::toolmgmt {
namespace {

constexpr std::int32_t kMostGroups = 9999;

Diagnosis group_refused(std::string why) {
    return Diagnosis{Alarm::StoreRequestBad, {}, {}, std::move(why)};
}

// Tools of another unit's channels have groups of their own.
bool of_channel(const StoreValues& values, const ToolRow& row, unsigned channel) {
    return row.unit == 0 || row.unit == static_cast<std::int32_t>(params::get(
                                            values.parameters, params::pt_tool_unit, channel));
}

void forget(StoreValues& values, unsigned channel, std::int32_t group,
            std::vector<Change>& changes) {
    for (std::size_t i = 0; i < kTools; ++i) {
        const ToolRow& row = values.tools.rows[i];
        if (row.used && row.group != 0 && (group == 0 || row.group == group) &&
            of_channel(values, row, channel))
            set_tool_number(values, static_cast<std::int32_t>(i + 1), "group", 0, changes);
    }
}

std::int32_t free_number(const StoreValues& values) {
    const auto rows = static_cast<std::size_t>(
        params::get(values.parameters, params::n2902_tool_management_table_length));
    for (std::size_t i = 0; i < std::min(rows, kTools); ++i)
        if (!values.tools.rows[i].used) return static_cast<std::int32_t>(i + 1);
    return 0;
}

}  // namespace

Result<Applied> apply_life_group(const StoreRequest& request, StoreValues& values) {
    Applied applied;
    const unsigned channel = request.channel;
    const auto step = static_cast<LifeGroupStep>(request.field % 16);
    const std::int32_t kind = request.field / 16, group = request.number;
    if (channel < 1 || channel > kMaxChannels)
        return group_refused("tool life groups of no channel");
    if (step == LifeGroupStep::ForgetAll) {
        forget(values, channel, 0, applied.changes);
        return applied;
    }
    if (group < 1 || group > kMostGroups)
        return group_refused("tool life group " + std::to_string(group));
    if (step == LifeGroupStep::Forget || step == LifeGroupStep::Open) {
        forget(values, channel, group, applied.changes);
        return applied;
    }
    int offset = 0, order = 0;
    double life = 0;
    const std::string text(request.name.data(),
                           ::strnlen(request.name.data(), request.name.size()));
    if (step != LifeGroupStep::Tool ||
        std::sscanf(text.c_str(), "%d %d %lf", &offset, &order, &life) != 3 || offset < 0 ||
        order < 1 || !(life >= 0) || !std::isfinite(life) ||
        kind > static_cast<std::int32_t>(LifeKind::Wear) || !std::isfinite(request.value))
        return group_refused("a tool of tool life group " + std::to_string(group));
    const TurretOf turret = turret_of(values.parameters, channel);
    const auto places = std::make_unique<ToolPlaceTable>();
    derive_places(values, *places);
    const auto station = static_cast<std::int32_t>(request.value);
    const ToolPlace* place = nullptr;
    for (std::size_t i = 0, seen = 0; i < places->count && !place; ++i)
        if (places->places[i].magazine == turret.magazine && turret.magazine != 0 &&
            ++seen == static_cast<std::size_t>(station))
            place = &places->places[i];
    if (!place)
        return Diagnosis{
            Alarm::ToolPlaceUnknown,
            {},
            {},
            "station " + std::to_string(station) + " of channel L" + std::to_string(channel)};
    std::int32_t number = place->tool;
    if (number == 0) {
        number = free_number(values);
        if (number == 0)
            return Diagnosis{
                Alarm::ToolTableFull, {}, {}, "tool life group " + std::to_string(group)};
        set_tool_number(values, number, "exists", 1, applied.changes);
        set_tool_text(values, number, "name", "T" + std::to_string(station), applied.changes);
        set_tool_number(values, number, "unit",
                        params::get(values.parameters, params::pt_tool_unit, channel),
                        applied.changes);
        set_tool_number(values, number, "magazine", place->magazine, applied.changes);
        set_tool_number(values, number, "pot", place->pot, applied.changes);
    }
    const auto put = [&](const char* field, double value) {
        set_tool_number(values, number, field, value, applied.changes);
    };
    put("group", group);
    put("duplo", order);
    put("h", offset);
    put("life_kind", kind);
    put("life", life);
    put("counter", 0);
    put("worn", 0);
    put("warned", 0);
    return applied;
}

}  // namespace polyturn::toolmgmt
