#include "kernel/supervisor/like.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <cstring>
#include <filesystem>
#include <memory>

#include "ipc/machine/counters.hpp"
#include "ipc/machine/machine_config.hpp"
#include "ipc/machine/work_zeros.hpp"
#include "ipc/memory/segment.hpp"
#include "ipc/params/export.hpp"
#include "ipc/image/segments.hpp"
#include "ipc/params/registry.hpp"
#include "polyturn/parameter_handles.hpp"

namespace polyturn::supervisor {

namespace {

constexpr std::size_t kFirstKeptVariable = 500;  // ChannelStore::variables[0] is #500; the upper half belongs to other languages
constexpr std::size_t kNumberedVariables = 500;

text::OffsetValues offset_values(const std::array<double, 3>& lengths, double radius) {
    text::OffsetValues out;
    out.x = lengths[0], out.y = lengths[1], out.z = lengths[2], out.r = radius;
    return out;
}

bool is_empty(const OffsetCell& cell) {
    for (const auto* part : {&cell.geometry, &cell.wear})
        for (const double value : *part)
            if (value != 0.0) return false;
    return cell.geometry_r == 0.0 && cell.wear_r == 0.0 && cell.tip == 0.0;
}

void read_channel(const ChannelStore& store, const MachineConfig& machine, unsigned number, text::ChannelSetup& out) {
    for (std::size_t i = 1; i < kOffsets; ++i) {
        const OffsetCell& cell = store.offsets[i];
        if (is_empty(cell)) continue;
        text::OffsetSetup& offset = out.offsets[static_cast<int>(i)];
        offset.geometry = offset_values(cell.geometry, cell.geometry_r);
        offset.geometry.t = cell.tip;
        offset.wear = offset_values(cell.wear, cell.wear_r);
    }
    const ChannelConfig& channel = machine.channel(number);
    for (std::size_t row = 0; row < kWorkZeros; ++row) {
        const std::string name = work_zero_name(row);
        if (name.empty()) continue;
        for (std::size_t place = 0; place < channel.axis_count; ++place) {
            const double value = store.zeros[row * kChannelAxes + place];
            const AxisConfig& axis = machine.axis(channel.axes[place]);
            if (value != 0.0 && !axis.name_text().empty()) out.work[name][std::string(axis.name_text())] = value;
        }
    }
    for (std::size_t i = 0; i < kNumberedVariables; ++i)
        if (!std::isnan(store.variables[i])) out.variables.push_back({fmt::format("#{}", kFirstKeptVariable + i), store.variables[i], {}, false});
}

std::string name_of(const ToolRow& row) { return {row.name.data(), ::strnlen(row.name.data(), row.name.size())}; }

bool usable(const ToolRow& row) {
    if (!(row.state & kToolEnabled) || (row.state & (kToolLocked | kToolBroken | kToolWorn))) return false;
    return row.life <= 0 || static_cast<LifeKind>(row.life_kind) == LifeKind::None || row.counter < row.life;
}

text::ToolSetup setup_of(const ToolTable& tools, const ToolEdgeTable& edges, std::size_t index) {
    text::ToolSetup out;
    out.name = name_of(tools.rows[index]);
    for (std::size_t e = 0; e < edges.count; ++e) {
        const ToolEdge& edge = edges.edges[e];
        if (edge.tool != static_cast<std::int32_t>(index + 1)) continue;
        auto& values = out.edges[edge.number];
        for (std::size_t p = 1; p < edge.dp.size(); ++p)
            if (edge.dp[p] != 0.0) values[fmt::format("DP{}", p)] = edge.dp[p];
    }
    return out;
}

// As the search of tool management answers (toolmgmt/tools/search.hpp): a station means the tool that stands there, or a sister of its name
// when that one is used up; what may not be used is called by no name. An empty station is a tool without name and edges.
std::map<int, text::ToolSetup> tools_of_channel(const params::Table& table, unsigned channel, const ToolTable& tools, const ToolEdgeTable& edges, const ToolPlaceTable& places) {
    const auto magazine = static_cast<std::int32_t>(params::get(table, params::pt_turret_magazine, channel));
    const auto unit = static_cast<std::int32_t>(params::get(table, params::pt_tool_unit, channel));
    const auto of_another_turret = [&](std::int32_t number) {
        for (unsigned l = 1; l <= kMaxChannels; ++l)
            if (l != channel && static_cast<std::int32_t>(params::get(table, params::pt_turret_magazine, l)) == number) return true;
        return false;
    };
    const auto seen = [&](const ToolRow& row) { return row.used && (row.unit == 0 || row.unit == unit) && (row.magazine == magazine || !of_another_turret(row.magazine)); };
    std::map<int, text::ToolSetup> out;
    for (std::size_t i = 0; i < places.count && magazine > 0; ++i)
        if (places.places[i].magazine == magazine && places.places[i].pot >= 1) out[places.places[i].pot] = {};
    int behind = out.empty() ? 0 : out.rbegin()->first;
    for (std::size_t i = 0; i < tools.rows.size(); ++i) {
        const ToolRow& row = tools.rows[i];
        if (!seen(row)) continue;
        const bool stands = magazine > 0 && row.magazine == magazine && row.pot >= 1;
        if (usable(row)) {
            if (row.magazine > 0) out[stands ? row.pot : ++behind] = setup_of(tools, edges, i);
        } else if (stands && !name_of(row).empty()) {
            for (std::size_t s = 0; s < tools.rows.size(); ++s)
                if (const ToolRow& sister = tools.rows[s]; seen(sister) && usable(sister) && sister.magazine > 0 && name_of(sister) == name_of(row)) {
                    out[row.pot] = setup_of(tools, edges, s);
                    break;
                }
        }
    }
    return out;
}

// As --machine names it: the supervisor tells where the tables and the room lie, without the ending (RunOptions::machine_folder).
std::string machine_of(const std::string& instance) {
    const auto supervisor = PeerSegment<SupervisorSegment>::attach(instance);
    if (!supervisor) return {};
    const auto& told = (*supervisor)->options.machine_folder;
    const std::filesystem::path base(std::string(told.data(), ::strnlen(told.data(), told.size())));
    std::error_code none;
    const std::filesystem::path file = base.string() + ".params";
    if (base.empty() || !std::filesystem::is_regular_file(file, none)) return {};
    return base.filename() == "machine" ? base.parent_path().string() : file.string();
}

}  // namespace

Result<LikeValues> values_of_controller(const std::string& instance) {
    const auto store = PeerSegment<StoreSegment>::attach(instance);
    if (!store) return store.diagnosis();
    if (!process_lives((*store)->header.writer_pid)) return Diagnosis{Alarm::SegmentMissing, {}, {}, instance};
    auto table = std::make_unique<params::Table>();
    auto channel = std::make_unique<ChannelStore>();
    if (!(*store)->parameters.read(*table)) return Diagnosis{Alarm::SegmentNotReady, {}, {}, instance};
    LikeValues out;
    out.machine = machine_of(instance);
    // What is made from now on is no part of the controller's.
    for (unsigned number = 1; number <= kMaxChannels; ++number)
        for (const Counter counter : {Counter::TotalParts, Counter::MachinedParts}) table->numbers[static_cast<std::size_t>(counter_slot(counter_number(counter, number)))] = 0.0;
    out.parameter_lines = params::export_lines(*table, params::Content::All);
    const MachineConfig machine = derive_machine_config(*table);
    for (unsigned number = 1; number <= kMaxChannels; ++number)
        if (machine.channel(number).exists() && (*store)->channels[number - 1].read(*channel))
            read_channel(*channel, machine, number, out.setup.channels[number]);
    if (!params::bit(*table, params::n2900_tool_m_config, 0)) return out;
    const auto tools = std::make_unique<ToolTable>();
    const auto edges = std::make_unique<ToolEdgeTable>();
    const auto places = std::make_unique<ToolPlaceTable>();
    if (!(*store)->tools.read(*tools) || !(*store)->edges.read(*edges) || !(*store)->places.read(*places)) return Diagnosis{Alarm::SegmentNotReady, {}, {}, instance};
    for (unsigned number = 1; number <= kMaxChannels; ++number)
        if (machine.channel(number).exists()) out.tools[number] = tools_of_channel(*table, number, *tools, *edges, *places);
    return out;
}

void fill_up(text::Setup& setup, const text::Setup& base) {
    for (const auto& [number, from] : base.channels) {
        text::ChannelSetup& to = setup.channels[number];
        for (const auto& [system, axes] : from.work)
            for (const auto& [axis, value] : axes) to.work[system].try_emplace(axis, value);
        for (const auto& [index, offset] : from.offsets) to.offsets.try_emplace(index, offset);
        for (const auto& [index, tool] : from.tools) to.tools.try_emplace(index, tool);
        for (const auto& variable : from.variables) {
            bool named = false;
            for (const auto& own : to.variables) named = named || own.name == variable.name;
            if (!named) to.variables.push_back(variable);
        }
    }
}

}  // namespace polyturn::supervisor
