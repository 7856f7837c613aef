#include "toolmgmt/start_values.hpp"

#include <bit>
#include <cmath>
#include <limits>
#include <memory>

#include "ipc/image/segments.hpp"
#include "ipc/model/machine/check/config_check.hpp"
#include "ipc/model/machine/machine_config.hpp"
#include "ipc/model/machine/store/apply_setup.hpp"
#include "ipc/requests/counters.hpp"
#include "ipc/model/machine/store/tool_fields.hpp"
#include "ipc/memory/segment.hpp"
#include "ipc/model/files/read_file.hpp"
#include "ipc/model/files/setup.hpp"

namespace polyturn::toolmgmt {
namespace {

void append(std::vector<Diagnosis>& to, std::vector<Diagnosis> from) {
    std::move(from.begin(), from.end(), std::back_inserter(to));
}

// Every cell of a channel in which the two stores differ.
void add_differences(std::int32_t channel, const ChannelStore& before, StoreValues& values,
                     std::vector<Change>& changes) {
    auto older = std::make_unique<StoreValues>();
    older->channels[static_cast<std::size_t>(channel - 1)] = before;
    const auto compare = [&](const Key& key) {
        const double* was = number_at(*older, key);
        const double* is = number_at(values, key);
        if (was && is && std::bit_cast<std::uint64_t>(*was) != std::bit_cast<std::uint64_t>(*is))
            changes.push_back({key, *was, *is, {}, {}, false});
    };
    for (int number = 1; number < static_cast<int>(kOffsets); ++number)
        for (int table = 0; table < 3; ++table)
            for (int field = 0; field < 5; ++field)
                if (table == 0 || field < 4)
                    compare({Kind::Offset, channel, number, table * 256 + field, {}});
    for (int row = 0; row < static_cast<int>(kWorkZeros); ++row)
        for (int place = 0; place < static_cast<int>(kChannelAxes); ++place)
            compare({Kind::WorkZero, channel, row, place, {}});
    for (int index = 0; index < static_cast<int>(kPersistentVariables); ++index)
        compare({Kind::Variable, channel, index, 0, {}});
}

Result<void> enter_setup(const std::string& path, Database* disk, StoreValues& values,
                         std::vector<Diagnosis>& diagnoses) {
    const Result<std::string> content = text::read_text_file(path);
    if (!content) {
        diagnoses.push_back(content.diagnosis());
        return {};
    }
    const text::Setup setup = text::parse_setup(*content, path, diagnoses);
    const MachineConfig machine = derive_machine_config(values.parameters);
    std::vector<Change> changes;
    for (const auto& [number, channel] : setup.channels) {
        if (number < 1 || number > kMaxChannels || !machine.channel(number).exists()) {
            diagnoses.push_back({Alarm::SetupEntry,
                                 {path, 0, 0, 0},
                                 {},
                                 "channel " + std::to_string(number) + " does not exist"});
            continue;
        }
        const auto before = std::make_unique<ChannelStore>(values.channels[number - 1]);
        apply_setup(setup, machine, number, values.channels[number - 1], diagnoses);
        if (disk) add_differences(static_cast<std::int32_t>(number), *before, values, changes);
    }
    if (disk && !changes.empty() && !any_error(diagnoses)) return disk->commit(changes, "setup");
    return {};
}

// The tools of a running controller, their edges and the state of its places, in place of one's
// own.
Result<void> take_tools(const std::string& instance, Database* disk, StoreValues& values) {
    const auto peer = PeerSegment<StoreSegment>::attach(instance);
    if (!peer) return peer.diagnosis();
    const auto tools = std::make_unique<ToolTable>();
    const auto edges = std::make_unique<ToolEdgeTable>();
    const auto places = std::make_unique<ToolPlaceTable>();
    if (!(*peer)->tools.read(*tools) || !(*peer)->edges.read(*edges) ||
        !(*peer)->places.read(*places))
        return Diagnosis{Alarm::SegmentNotReady, {}, {}, instance};
    std::vector<Change> changes;
    const auto put = [&](const Key& key, double number, const std::string& text = {},
                         bool is_text = false) {
        Change change;
        if (change_to(values, key, number, text, is_text, change) &&
            write_value(values, key, number, text, is_text))
            changes.push_back(std::move(change));
    };
    const auto own_edges = std::make_unique<ToolEdgeTable>(values.edges);
    for (std::size_t i = 0; i < own_edges->count; ++i)
        for (int dp = 0; dp < 36; ++dp)
            put({Kind::Edge, own_edges->edges[i].tool, own_edges->edges[i].number, dp, {}}, 0.0);
    for (std::size_t i = 0; i < kTools; ++i) {
        const ToolRow& row = tools->rows[i];
        const auto number = static_cast<std::int32_t>(i + 1);
        put({Kind::Tool, 0, number, 0, "exists"}, row.used ? 1.0 : 0.0);
        if (!row.used) continue;
        for (const ToolField& field : tool_fields()) {
            const Key key{Kind::Tool, 0, number, 0, std::string(field.name)};
            if (field.is_text())
                put(key, std::numeric_limits<double>::quiet_NaN(), tool_text(row, field), true);
            else
                put(key, tool_number(row, field));
        }
    }
    for (std::size_t i = 0; i < edges->count; ++i)
        for (int dp = 0; dp < 36; ++dp)
            put({Kind::Edge, edges->edges[i].tool, edges->edges[i].number, dp, {}},
                edges->edges[i].dp[static_cast<std::size_t>(dp)]);
    const auto or_none = [](double value) {
        return value == 0.0 ? std::numeric_limits<double>::quiet_NaN() : value;
    };
    for (std::size_t i = 0; i < places->count; ++i) {
        const ToolPlace& place = places->places[i];
        put({Kind::Place, place.magazine, place.pot, 0, "locked"},
            or_none((place.state & kPlaceLocked) ? 1.0 : 0.0));
        put({Kind::Place, place.magazine, place.pot, 0, "place_type"}, or_none(place.place_type));
    }
    for (std::size_t l = 0; l < kMaxChannels; ++l) {
        put({Kind::Work, static_cast<std::int32_t>(l + 1), 0, 0, "tool"}, tools->in_channel[l]);
        put({Kind::Work, static_cast<std::int32_t>(l + 1), 0, 0, "next tool"}, tools->next[l]);
    }
    if (disk && !changes.empty()) return disk->commit(changes, "setup");
    return {};
}

}  // namespace

Result<void> load_start_values(const Options& options, Database* disk, StoreValues& values,
                               std::vector<Diagnosis>& diagnoses) {
    clear(values);
    LoadedMachine loaded = load_machine_file(options.machine.machine);
    append(diagnoses, std::move(loaded.diagnoses));
    values.parameters = *loaded.table;
    if (disk)
        if (Result<void> done = disk->read_into(values, diagnoses); !done) return done;
    for (std::int32_t number = 0; number < kCounters; ++number)
        if (const std::int64_t slot = counter_slot(number);
            slot >= 0 && !std::isnan(values.counters[static_cast<std::size_t>(number)]))
            values.parameters.numbers[static_cast<std::size_t>(slot)] =
                values.counters[static_cast<std::size_t>(number)];
    apply_overrides(options.machine, values.parameters, diagnoses);
    if (any_error(diagnoses)) return {};
    append(diagnoses, check_machine_config(values.parameters));
    if (any_error(diagnoses)) return {};
    if (!options.like.empty())
        if (Result<void> done = take_tools(options.like, disk, values); !done) return done;
    if (options.setup.empty()) return {};
    return enter_setup(options.setup, disk, values, diagnoses);
}

}  // namespace polyturn::toolmgmt
