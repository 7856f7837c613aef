// System variables #1000 and beyond: offsets, zeros, positions, modal values, clock, interface.
#include <cmath>

#include "channels/fanuc/interpreter.hpp"

namespace polyturn::channels::fanuc {
namespace {

// Ranges of the offset variables: first variable, how many, table, field (fanuc_lathe 6.3.2).
struct OffsetRange {
    std::int64_t first;
    std::int32_t count;
    OffsetTable table;
    OffsetField field;
};
constexpr OffsetRange kOffsetRanges[] = {
    {2001, 64, OffsetTable::Wear, OffsetField::X},       {2101, 64, OffsetTable::Wear, OffsetField::Z},
    {2201, 64, OffsetTable::Wear, OffsetField::R},       {2301, 64, OffsetTable::Wear, OffsetField::T},
    {2401, 49, OffsetTable::Wear, OffsetField::Y},       {2451, 49, OffsetTable::Geometry, OffsetField::Y},
    {2701, 49, OffsetTable::Geometry, OffsetField::X},   {2801, 49, OffsetTable::Geometry, OffsetField::Z},
    {2901, 49, OffsetTable::Geometry, OffsetField::R},   {10001, 99, OffsetTable::Wear, OffsetField::X},
    {11001, 99, OffsetTable::Wear, OffsetField::Z},      {12001, 99, OffsetTable::Wear, OffsetField::R},
    {13001, 99, OffsetTable::Wear, OffsetField::T},      {14001, 99, OffsetTable::Wear, OffsetField::Y},
    {15001, 99, OffsetTable::Geometry, OffsetField::X},  {16001, 99, OffsetTable::Geometry, OffsetField::Z},
    {17001, 99, OffsetTable::Geometry, OffsetField::R},  {19001, 99, OffsetTable::Geometry, OffsetField::Y},
};

const OffsetRange* find_range(std::int64_t number, std::int32_t& offset) {
    for (const OffsetRange& range : kOffsetRanges)
        if (number >= range.first && number < range.first + range.count) {
            offset = static_cast<std::int32_t>(number - range.first + 1);
            return &range;
        }
    return nullptr;
}

double offset_value(const OffsetCell& cell, const OffsetRange& range) {
    const auto k = static_cast<std::size_t>(range.field);
    if (range.field == OffsetField::T) return cell.tip;
    if (range.field == OffsetField::R) return range.table == OffsetTable::Geometry ? cell.geometry_r : cell.wear_r;
    return range.table == OffsetTable::Geometry ? cell.geometry[k] : cell.wear[k];
}

// #4001..#4022: number of the group's row, in GGroup terms.
constexpr GGroup kModalGroups[] = {
    GGroup::Motion, GGroup::Surface, GGroup::Distance, GGroup::Mirror, GGroup::FeedMode, GGroup::Units, GGroup::Comp,
    GGroup::SpindleWatch, GGroup::StrokeArea, GGroup::Drilling, GGroup::ReturnLevel, GGroup::MacroModal, GGroup::Surface,
    GGroup::Zero, GGroup::ExactStop, GGroup::Plane};

}  // namespace

VariableStatus Interpreter::read_system(std::int64_t number, double& value) {
    MachineView& view = core_.view();
    Port& port = core_.port();
    std::int32_t offset = 0;
    if (const OffsetRange* range = find_range(number, offset)) {
        if (offset > view.config().offset_count) return VariableStatus::Unknown;
        value = offset_value(view.store->offsets[offset], *range);
        return VariableStatus::Ok;
    }
    const double programmed_unit = 1.0 / unit_;
    const auto place_of = [&](std::int64_t first) { return static_cast<unsigned>(number - first); };
    const auto shown = [&](unsigned i, double true_value) { return view.to_shown(i, true_value) * (view.axes[i].rotary ? 1.0 : programmed_unit); };
    if (number >= 5001 && number < 5001 + static_cast<std::int64_t>(view.axis_count)) {
        value = shown(place_of(5001), core_.path.programmed[place_of(5001)]);
        return VariableStatus::Ok;
    }
    const bool machine_now = number >= 5021 && number < 5021 + static_cast<std::int64_t>(view.axis_count);
    const bool work_now = number >= 5041 && number < 5041 + static_cast<std::int64_t>(view.axis_count);
    if (machine_now || work_now) {
        if (!fresh_) return VariableStatus::NeedsBarrier;
        const unsigned i = place_of(machine_now ? 5021 : 5041);
        const double machine = port.axis_measured(view.axes[i].machine_axis).value_or(core_.path.machine[i]);
        value = machine_now ? shown(i, machine)
                            : shown(i, machine - core_.path.zero[i] - core_.path.shift[i] - core_.path.turns_deg[i]);
        return VariableStatus::Ok;
    }
    if (number >= 5061 && number < 5061 + static_cast<std::int64_t>(view.axis_count)) {
        if (!fresh_) return VariableStatus::NeedsBarrier;
        const unsigned i = place_of(5061);
        const double machine = port.axis_at_skip(view.axes[i].machine_axis).value_or(core_.path.machine[i]);
        value = shown(i, machine - core_.path.zero[i] - core_.path.shift[i] - core_.path.turns_deg[i]);
        return VariableStatus::Ok;
    }
    if (number >= 5081 && number < 5081 + static_cast<std::int64_t>(view.axis_count)) {
        const unsigned i = place_of(5081);
        value = shown(i, core_.path.shift[i] + core_.path.vector[i]);
        return VariableStatus::Ok;
    }
    if (number >= 5101 && number < 5101 + static_cast<std::int64_t>(view.axis_count)) {
        if (!fresh_) return VariableStatus::NeedsBarrier;
        const unsigned i = place_of(5101);
        const auto command = port.axis_command(view.axes[i].machine_axis), measured = port.axis_measured(view.axes[i].machine_axis);
        value = command && measured ? *command - *measured : 0.0;
        return VariableStatus::Ok;
    }
    if (number >= 5201 && number < 5340) {
        const std::int64_t row = (number - 5201) / 20, i = (number - 5201) % 20;
        if (i >= static_cast<std::int64_t>(view.axis_count)) return VariableStatus::Unknown;
        value = view.store->zeros[static_cast<std::size_t>(row) * kChannelAxes + static_cast<std::size_t>(i)];
        if (!view.axes[static_cast<std::size_t>(i)].rotary) value *= programmed_unit;
        return VariableStatus::Ok;
    }
    if (number >= 4001 && number <= 4016) {
        const GCode* row = active_[static_cast<std::size_t>(kModalGroups[number - 4001])];
        if (number == 4001) row = motion_;
        value = row ? row->tenths / 10.0 : 0.0;
        return VariableStatus::Ok;
    }
    switch (number) {
        case 4109: value = core_.path.feed * programmed_unit; return VariableStatus::Ok;
        case 4113: value = static_cast<double>(last_m_); return VariableStatus::Ok;
        case 4114: value = static_cast<double>(last_n_); return VariableStatus::Ok;
        case 4115: value = static_cast<double>(program_number_); return VariableStatus::Ok;
        case 4119: value = core_.path.spindle.mode == SpindleModeCode::SurfaceSpeed ? core_.path.spindle.surface_m_min : core_.path.spindle.rpm; return VariableStatus::Ok;
        case 4120: value = static_cast<double>(last_t_); return VariableStatus::Ok;
        case 3003: value = single_block_off_ * 1.0 + no_finish_wait_ * 2.0; return VariableStatus::Ok;
        case 3004: value = automatic_control_; return VariableStatus::Ok;
        case 3005: value = (inch_ ? 4 : 0) + (settings_.series15 ? 512 : 0); return VariableStatus::Ok;
        case 3007: value = 0.0; return VariableStatus::Ok;
        case 3901: value = parts_; return VariableStatus::Ok;
        default: break;
    }
    const bool interface_input = (number >= 1000 && number <= 1035) || (number >= 1100 && number <= 1135);
    const bool clock = number == 3001 || number == 3002 || number == 3011 || number == 3012;
    if (!interface_input && !clock) return VariableStatus::Unknown;
    if (!fresh_) return VariableStatus::NeedsBarrier;
    if (interface_input) {
        value = port.interface_value(static_cast<std::int32_t>(number));
        return VariableStatus::Ok;
    }
    const CalendarTime now = port.clock();
    switch (number) {
        case 3001: value = port.running_ms(); break;
        case 3002: value = port.running_ms() / 3'600'000.0; break;
        case 3011: value = now.year * 10000.0 + now.month * 100 + now.day; break;
        default: value = now.hour * 10000.0 + now.minute * 100 + now.second; break;
    }
    return VariableStatus::Ok;
}

VariableStatus Interpreter::write_system(std::int64_t number, double value) {
    MachineView& view = core_.view();
    std::int32_t offset = 0;
    if (const OffsetRange* range = find_range(number, offset)) {
        if (offset > view.config().offset_count) return VariableStatus::Unknown;
        write_offset(range->table, offset, range->field, is_null(value) ? 0.0 : value);
        return VariableStatus::Ok;
    }
    if (number >= 5201 && number < 5340) {
        const std::int64_t row = (number - 5201) / 20, i = (number - 5201) % 20;
        if (i >= static_cast<std::int64_t>(view.axis_count)) return VariableStatus::Unknown;
        const bool rotary = view.axes[static_cast<std::size_t>(i)].rotary;
        write_zero(static_cast<std::int32_t>(row), static_cast<unsigned>(i), (is_null(value) ? 0.0 : value) * (rotary ? 1.0 : unit_));
        return VariableStatus::Ok;
    }
    if ((number >= 1100 && number <= 1115) || (number >= 1132 && number <= 1135)) return VariableStatus::Ok;   // a record, see written()
    switch (number) {
        case 3001:
        case 3002: return VariableStatus::Ok;
        case 3003:
            single_block_off_ = (static_cast<int>(value) & 1) != 0;
            no_finish_wait_ = (static_cast<int>(value) & 2) != 0;
            return VariableStatus::Ok;
        case 3004:
            automatic_control_ = static_cast<int>(value) & 7;
            core_.path.override_locked = (automatic_control_ & 2) != 0;
            return VariableStatus::Ok;
        case 3901: parts_ = value; return VariableStatus::Ok;
        default: break;
    }
    const bool readable = (number >= 1000 && number <= 1035) || (number >= 3001 && number <= 3012) || (number >= 4001 && number <= 4130) || (number >= 5001 && number < 5200);
    return readable ? VariableStatus::ReadOnly : VariableStatus::Unknown;
}

}  // namespace polyturn::channels::fanuc
