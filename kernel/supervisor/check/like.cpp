#include "kernel/supervisor/check/like.hpp"

#include <fmt/format.h>

#include <cmath>
#include <cstring>
#include <filesystem>
#include <memory>
#include <nlohmann/json.hpp>

#include "ipc/image/segments.hpp"
#include "ipc/model/machine/machine_config.hpp"
#include "ipc/requests/counters.hpp"
#include "ipc/model/machine/store/work_zeros.hpp"
#include "ipc/memory/segment.hpp"
#include "ipc/params/export.hpp"
#include "ipc/params/registry.hpp"
#include "kernel/supervisor/status/ask_verbs.hpp"
#include "polyturn/parameter_handles.hpp"

namespace polyturn::supervisor {

namespace {

// ChannelStore::variables[0] is #500; the upper half belongs to other languages
constexpr std::size_t kFirstKeptVariable = 500;
constexpr std::size_t kNumberedVariables = 500;

text::OffsetValues offset_values(const std::array<double, 3>& lengths, double radius) {
    text::OffsetValues out;
    out.x = lengths[0];
    out.y = lengths[1];
    out.z = lengths[2];
    out.r = radius;
    return out;
}

bool is_empty(const OffsetCell& cell) {
    for (const auto* part : {&cell.geometry, &cell.wear})
        for (const double value : *part)
            if (value != 0.0) return false;
    return cell.geometry_r == 0.0 && cell.wear_r == 0.0 && cell.tip == 0.0;
}

void read_channel(const ChannelStore& store, const MachineConfig& machine, unsigned number,
                  text::ChannelSetup& out) {
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
            if (value != 0.0 && !axis.name_text().empty())
                out.work[name][std::string(axis.name_text())] = value;
        }
    }
    for (std::size_t i = 0; i < kNumberedVariables; ++i)
        if (!std::isnan(store.variables[i]))
            out.variables.push_back(
                {fmt::format("#{}", kFirstKeptVariable + i), store.variables[i], {}, false});
}

std::string name_of(const ToolRow& row) {
    return {row.name.data(), ::strnlen(row.name.data(), row.name.size())};
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

// What the channel's T calls find, as the store's own search says it: a station means the tool that
// is there or a sister of its name, an empty or used up one a tool without name and edges; what
// a name alone finds comes behind the stations.
Result<std::map<int, text::ToolSetup>> tools_of_channel(const std::string& instance,
                                                        unsigned channel, const ToolTable& tools,
                                                        const ToolEdgeTable& edges) {
    using Json = nlohmann::json;
    const Json op = {{"do", "tools.answers"}, {"channel", channel}};
    std::string text;
    if (!ask(instance, Json{{"do", "store"}, {"op", op}}.dump(), &text))
        return Diagnosis{Alarm::SegmentNotReady, {}, {}, instance};
    const Json answer = Json::parse(text, nullptr, false);
    if (!answer.is_object()) return Diagnosis{Alarm::SegmentNotReady, {}, {}, instance};
    const auto setup = [&](std::int64_t tool) {
        return tool >= 1 && tool <= static_cast<std::int64_t>(tools.rows.size())
                   ? setup_of(tools, edges, static_cast<std::size_t>(tool - 1))
                   : text::ToolSetup{};
    };
    std::map<int, text::ToolSetup> out;
    for (const Json& one : answer.value("stations", Json::array()))
        out[one.value("pot", 0)] = setup(one.value("tool", 0));
    int behind = out.empty() ? 0 : out.rbegin()->first;
    for (const Json& one : answer.value("others", Json::array()))
        out[++behind] = setup(one.get<std::int64_t>());
    return out;
}

// As --machine names it: the supervisor reports where the tables and the machine model lie, without
// the ending (RunOptions::machine_folder).
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
    if (!process_lives((*store)->header.writer_pid))
        return Diagnosis{Alarm::SegmentMissing, {}, {}, instance};
    auto table = std::make_unique<params::Table>();
    auto channel = std::make_unique<ChannelStore>();
    if (!(*store)->parameters.read(*table))
        return Diagnosis{Alarm::SegmentNotReady, {}, {}, instance};
    LikeValues out;
    out.machine = machine_of(instance);
    // What is made from now on is no part of the controller's.
    for (unsigned number = 1; number <= kMaxChannels; ++number)
        for (const Counter counter : {Counter::TotalParts, Counter::MachinedParts})
            table
                ->numbers[static_cast<std::size_t>(counter_slot(counter_number(counter, number)))] =
                0.0;
    out.parameter_lines = params::export_lines(*table, params::Content::All);
    const MachineConfig machine = derive_machine_config(*table);
    for (unsigned number = 1; number <= kMaxChannels; ++number)
        if (machine.channel(number).exists() && (*store)->channels[number - 1].read(*channel))
            read_channel(*channel, machine, number, out.setup.channels[number]);
    if (!params::bit(*table, params::n2900_tool_m_config, 0)) return out;
    const auto tools = std::make_unique<ToolTable>();
    const auto edges = std::make_unique<ToolEdgeTable>();
    if (!(*store)->tools.read(*tools) || !(*store)->edges.read(*edges))
        return Diagnosis{Alarm::SegmentNotReady, {}, {}, instance};
    for (unsigned number = 1; number <= kMaxChannels; ++number) {
        if (!machine.channel(number).exists()) continue;
        auto found = tools_of_channel(instance, number, *tools, *edges);
        if (!found) return found.diagnosis();
        out.tools[number] = std::move(*found);
    }
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
