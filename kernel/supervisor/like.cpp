#include "kernel/supervisor/like.hpp"

#include <fmt/format.h>

#include <cmath>
#include <memory>

#include "ipc/machine/machine_config.hpp"
#include "ipc/machine/work_zeros.hpp"
#include "ipc/memory/segment.hpp"
#include "ipc/params/export.hpp"

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

}  // namespace

Result<LikeValues> values_of_controller(const std::string& instance) {
    const auto store = PeerSegment<StoreSegment>::attach(instance);
    if (!store) return store.diagnosis();
    if (!process_lives((*store)->header.writer_pid)) return Diagnosis{Alarm::SegmentMissing, {}, {}, instance};
    auto table = std::make_unique<params::Table>();
    auto channel = std::make_unique<ChannelStore>();
    if (!(*store)->parameters.read(*table)) return Diagnosis{Alarm::SegmentNotReady, {}, {}, instance};
    LikeValues out;
    out.parameter_lines = params::export_lines(*table, params::Content::All);
    const MachineConfig machine = derive_machine_config(*table);
    for (unsigned number = 1; number <= kMaxChannels; ++number)
        if (machine.channel(number).exists() && (*store)->channels[number - 1].read(*channel))
            read_channel(*channel, machine, number, out.setup.channels[number]);
    return out;
}

void fill_up(text::Setup& setup, const text::Setup& base) {
    for (const auto& [number, from] : base.channels) {
        text::ChannelSetup& to = setup.channels[number];
        for (const auto& [system, axes] : from.work)
            for (const auto& [axis, value] : axes) to.work[system].try_emplace(axis, value);
        for (const auto& [index, offset] : from.offsets) to.offsets.try_emplace(index, offset);
        for (const auto& variable : from.variables) {
            bool named = false;
            for (const auto& own : to.variables) named = named || own.name == variable.name;
            if (!named) to.variables.push_back(variable);
        }
    }
}

}  // namespace polyturn::supervisor
