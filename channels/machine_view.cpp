#include "channels/machine_view.hpp"

#include <cmath>
#include <limits>

namespace polyturn::channels {

void clear_store(ChannelStore& store) {
    std::memset(static_cast<void*>(&store), 0, sizeof store);
    for (double& value : store.variables) value = std::numeric_limits<double>::quiet_NaN();
}

CommonOffsets common_offsets(const MachineView& view) {
    const ChannelKind kind = view.config().kind;
    const auto count = static_cast<unsigned>(
        kind == ChannelKind::Mill
            ? params::get(view.table(), params::n1401_no_of_common_tool_offsets_m)
            : params::get(view.table(), params::n1412_no_of_common_tool_offsets_t));
    if (count == 0) return {};
    for (unsigned channel = 1; channel < view.channel; ++channel)
        if (view.machine.channel(channel).exists() && view.machine.channel(channel).kind == kind)
            return {count, channel};
    return {};  // the first one of its kind owns them
}

void take_common_offsets(ChannelStore& store, const ChannelStore& from,
                         const CommonOffsets& common) {
    for (std::size_t n = 1; n <= common.count && n < store.offsets.size(); ++n)
        store.offsets[n] = from.offsets[n];
}

namespace {

// What belongs to the drive, whatever address it has.
void take_drive(ChannelAxis& to, const AxisConfig& from, const params::Table& table) {
    to.machine_axis = static_cast<std::uint8_t>(from.number - 1);
    to.hypothetical = from.hypothetical;
    to.max_feed_mm_min = from.limits.max_feed_mm_s * 60.0;
    to.rapid_mm_min = from.limits.rapid_mm_s * 60.0;
    to.reference_mm = from.reference_mm;
    to.stroke = from.hypothetical ? AxisStroke{} : read_axis_stroke(table, from.number);
    to.by_plc = !from.rotary && !params::bit(table, params::n0106_axis_properties, from.number, 5);
    to.limited = to.stroke.range1;
    to.limit_max = to.stroke.a.high;
    to.limit_min = to.stroke.a.low;
}

void take_axis(MachineView& view, unsigned place, const AxisConfig& from) {
    ChannelAxis& to = view.axes[place];
    to.name = std::string(from.name_text());
    to.machine_axis = to.home_axis = static_cast<std::uint8_t>(from.number - 1);
    to.role = from.role;
    to.diameter = from.diameter;
    to.offset_diameter = from.offset_diameter;
    to.rotary = from.rotary;
    to.rollover = from.rollover;
    to.rollover_shortest = from.rollover_shortest;
    to.rollover_sign_is_direction = from.rollover_sign_is_direction;
    to.rollover_reduces_increments = from.rollover_reduces_increments;
    to.rollover_deg = from.rollover_deg > 0 ? from.rollover_deg : 360.0;
    to.increment = std::pow(10.0, -static_cast<double>(view.config().decimals()));
    take_drive(to, from, view.table());
}

}  // namespace

bool add_axis(MachineView& view, unsigned number) {
    if (view.axis_count == kChannelAxes) return false;
    take_axis(view, view.axis_count++, view.machine.axis(number));
    return true;
}

bool take_routes(MachineView& view, std::span<const std::uint8_t> route) {
    bool changed = false;
    for (unsigned place = 0; place < view.axis_count; ++place) {
        ChannelAxis& axis = view.axes[place];
        const unsigned now = route[axis.home_axis] ? route[axis.home_axis] - 1u : axis.home_axis;
        if (now == axis.machine_axis) continue;
        take_drive(axis, view.machine.axis(now + 1u), view.table());
        const bool away = now != axis.home_axis;
        axis.negated = away && params::bit(view.table(), params::n2105_composit_config,
                                           axis.home_axis + 1u, 0);
        axis.mirrored = away && params::bit(view.table(), params::n2105_composit_config,
                                            axis.home_axis + 1u, 2);
        changed = true;
    }
    return changed;
}

MachineView make_machine_view(const params::Table& table, unsigned channel) {
    MachineView view;
    view.channel = channel;
    view.machine = derive_machine_config(table);
    view.parameters = std::make_unique<params::Table>(table);
    view.store = std::make_unique<ChannelStore>();
    clear_store(*view.store);
    const ChannelConfig& config = view.config();
    view.axis_count = config.axis_count;
    view.stroke = read_channel_stroke(table, channel);
    view.names = std::make_unique<std::array<std::array<char, 4>, kChannelAxes>>();
    for (unsigned place = 0; place < view.axis_count; ++place)
        take_axis(view, place, view.machine.axis(config.axes[place]));
    view.shared = std::make_unique<std::array<double, 900>>();
    view.shared->fill(std::numeric_limits<double>::quiet_NaN());
    return view;
}

int MachineView::axis_by_role(PlaneRole role) const {
    for (unsigned place = 0; place < axis_count; ++place)
        if (axes[place].role == role) return static_cast<int>(place);
    return -1;
}

int MachineView::axis_by_name(std::string_view name) const {
    for (unsigned place = 0; place < axis_count; ++place)
        if (axes[place].name == name) return static_cast<int>(place);
    return -1;
}

}  // namespace polyturn::channels
