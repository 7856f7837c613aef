// System variables #1000 and beyond: offsets, zeros, positions, modal values, clock, interface.
#include <cmath>

#include "channels/fanuc/interpreter.hpp"
#include "ipc/image/interrupt_inputs.hpp"

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
    {2001, 64, OffsetTable::Wear, OffsetField::X},
    {2101, 64, OffsetTable::Wear, OffsetField::Z},
    {2201, 64, OffsetTable::Wear, OffsetField::R},
    {2301, 64, OffsetTable::Wear, OffsetField::T},
    {2401, 49, OffsetTable::Wear, OffsetField::Y},
    {2451, 49, OffsetTable::Geometry, OffsetField::Y},
    {2701, 49, OffsetTable::Geometry, OffsetField::X},
    {2801, 49, OffsetTable::Geometry, OffsetField::Z},
    {2901, 49, OffsetTable::Geometry, OffsetField::R},
    {10001, 99, OffsetTable::Wear, OffsetField::X},
    {11001, 99, OffsetTable::Wear, OffsetField::Z},
    {12001, 99, OffsetTable::Wear, OffsetField::R},
    {13001, 99, OffsetTable::Wear, OffsetField::T},
    {14001, 99, OffsetTable::Wear, OffsetField::Y},
    {15001, 99, OffsetTable::Geometry, OffsetField::X},
    {16001, 99, OffsetTable::Geometry, OffsetField::Z},
    {17001, 99, OffsetTable::Geometry, OffsetField::R},
    {19001, 99, OffsetTable::Geometry, OffsetField::Y},
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
    if (range.field == OffsetField::R)
        return range.table == OffsetTable::Geometry ? cell.geometry_r : cell.wear_r;
    return range.table == OffsetTable::Geometry ? cell.geometry[k] : cell.wear[k];
}

// #4001..#4022: the groups as the control counts them (fanuc_lathe 6.3.5, nct part 1 14.2); Count:
// none of that number.
constexpr GGroup kNone = GGroup::Count;
constexpr GGroup kModalGroups[] = {GGroup::Motion,
                                   GGroup::Surface,
                                   GGroup::Distance,
                                   GGroup::Rotation,
                                   GGroup::FeedMode,
                                   GGroup::Units,
                                   GGroup::Comp,
                                   GGroup::SpindleWatch,
                                   GGroup::StrokeArea,
                                   GGroup::Drilling,
                                   GGroup::ReturnLevel,
                                   GGroup::MacroModal,
                                   kNone,
                                   GGroup::Zero,
                                   GGroup::ExactStop,
                                   GGroup::Plane,
                                   kNone,
                                   kNone,
                                   kNone,
                                   kNone,
                                   GGroup::Transform,
                                   kNone};
constexpr GGroup kModalGroupsNct[] = {GGroup::Motion,
                                      GGroup::Plane,
                                      GGroup::Distance,
                                      GGroup::StrokeArea,
                                      GGroup::FeedMode,
                                      GGroup::Units,
                                      GGroup::Comp,
                                      GGroup::Length,
                                      GGroup::Drilling,
                                      GGroup::ReturnLevel,
                                      GGroup::Scale,
                                      GGroup::MacroModal,
                                      GGroup::Surface,
                                      GGroup::Zero,
                                      GGroup::ExactStop,
                                      GGroup::Rotation,
                                      GGroup::Polar,
                                      kNone,
                                      kNone,
                                      kNone,
                                      GGroup::Transform,
                                      GGroup::Mirror};

}  // namespace

// #4001 to #4130: what the blocks before have left in force. False: there is no such group.
bool Interpreter::modal_variable(std::int64_t number, double& value) {
    if (number >= 4001 && number <= 4022) {
        const GGroup group = (settings_.nct ? kModalGroupsNct : kModalGroups)[number - 4001];
        const GCode* row = group == kNone            ? nullptr
                           : group == GGroup::Motion ? motion_
                                                     : active_[static_cast<std::size_t>(group)];
        if (group == GGroup::Drilling && !drilling_) {  // a motion code ends the cycle without G80
            value = 80;
            return row != nullptr;
        }
        value = row ? row->tenths / 10.0 : 0.0;
        return row != nullptr;
    }
    switch (number) {
        case 4109:
            value = core_.path.feed / unit_;
            return true;
        case 4113:
            value = static_cast<double>(last_m_);
            return true;
        case 4114:
            value = static_cast<double>(last_n_);
            return true;
        case 4115:
            value = static_cast<double>(program_number_);
            return true;
        case 4119:
            value = core_.path.spindle.mode == SpindleModeCode::SurfaceSpeed
                        ? core_.path.spindle.surface_m_min / (inch_ ? 0.3048 : 1.0)
                        : core_.path.spindle.rpm;
            return true;
        case 4120:
            value = static_cast<double>(last_t_);
            return true;
        default:
            return false;
    }
}

// Screens show the way of moving first, then everything else that holds, in the order of execution.
void Interpreter::active_codes(std::string& out) const {
    if (motion_) out += motion_->name;
    for (std::size_t group = 0; group < active_.size(); ++group) {
        const GCode* row = active_[group];
        if (!row || group == static_cast<std::size_t>(GGroup::Motion) ||
            group == static_cast<std::size_t>(GGroup::OneShot))
            continue;
        if (group == static_cast<std::size_t>(GGroup::Drilling) && !drilling_) continue;
        if (!out.empty()) out += ' ';
        out += row->name;
    }
}

// Local ones of the running macro level, common ones, kept ones: «#101», «#510 TOOL_NO» where SETVN
// has given a name.
void Interpreter::list_variables(const ShowVariable& show) const {
    const auto one = [&](std::size_t number, double value) {
        if (is_null(value)) return;
        const std::string_view name =
            number < kLocals ? std::string_view() : names_.of(static_cast<std::int64_t>(number));
        show("#" + std::to_string(number) + (name.empty() ? "" : " ") + std::string(name), value);
    };
    const LocalSet& locals = variables_.levels().back();
    for (std::size_t n = 1; n < kLocals; ++n) one(n, locals[n]);
    for (std::size_t n = 0; n < variables_.common().size(); ++n)
        one(variables_.common_first() + n, variables_.common()[n]);
    for (std::size_t n = 0; n < 500; ++n) one(500 + n, core_.view().store->variables[n]);
}

VariableStatus Interpreter::read_system(std::int64_t number, double& value) {
    MachineView& view = core_.view();
    Port& port = core_.port();
    std::int32_t offset = 0;
    if (const OffsetRange* range = find_range(number, offset)) {
        if (offset > view.config().offset_count) return VariableStatus::Unknown;
        // in the unit of the program
        value = offset_value(view.store->offsets[offset], *range) /
                (range->field == OffsetField::T ? 1.0 : unit_);
        return VariableStatus::Ok;
    }
    const double programmed_unit = 1.0 / unit_;
    const auto place_of = [&](std::int64_t first) { return static_cast<unsigned>(number - first); };
    // the same values under a second number (nct part 2 38)
    if (number >= 100101 && number < 100151)
        number += 5041 - 100101;
    else if (number >= 100151 && number < 100201)
        number += 5061 - 100151;
    // A position in the workpiece system: with the tool's lengths in it, or, nct TLC, without; nct
    // PCS: as the programmed frame counts.
    const auto work_position = [&](const AxisValues& machine, unsigned i) {
        const PathState& path = core_.path;
        AxisValues point = machine;
        const bool whole = settings_.positions_programmed && path.framed;
        for (unsigned k = whole ? 0 : i; k < (whole ? view.axis_count : i + 1); ++k)
            point[k] = machine[k] - path.zero[k] - path.turns_deg[k] -
                       (settings_.positions_with_length && !whole ? 0.0 : path.shift[k]);
        if (!whole) return point[i];
        const double plain = core_.unframed(point)[i];
        return plain + (settings_.positions_with_length ? path.shift[i] : 0.0);
    };
    // Behind a barrier the path has ended: an axis is where the path has brought it, however
    // much its loop still lags in that tick. Only an interrupt program that runs asynchronously to
    // the path asks while the axes move.
    const auto where = [&](std::uint8_t machine_axis) {
        const auto rests =
            interruption_.running ? std::nullopt : port.axis_taken_over(machine_axis);
        return rests ? rests : port.axis_position(machine_axis);
    };
    const auto shown = [&](unsigned i, double true_value) {
        return view.to_shown(i, true_value) * (view.axes[i].rotary ? 1.0 : programmed_unit);
    };
    if (number >= 5001 && number < 5001 + static_cast<std::int64_t>(view.axis_count)) {
        const AxisValues& end = interruption_.running && interruption_.shows_end
                                    ? interruption_.end
                                    : core_.path.programmed;
        value = shown(place_of(5001), end[place_of(5001)]);
        return VariableStatus::Ok;
    }
    const bool machine_now =
        number >= 5021 && number < 5021 + static_cast<std::int64_t>(view.axis_count);
    const bool work_now =
        number >= 5041 && number < 5041 + static_cast<std::int64_t>(view.axis_count);
    if (machine_now || work_now) {
        if (!fresh_) return VariableStatus::NeedsBarrier;
        const unsigned i = place_of(machine_now ? 5021 : 5041);
        const ChannelAxis& axis = view.axes[i];
        const auto now = where(axis.machine_axis);
        const double machine = now ? axis.from_drive(*now) : core_.path.machine[i];
        if (machine_now) {
            value = shown(i, axis.to_drive(machine) + port.axis_added(axis.machine_axis));
            return VariableStatus::Ok;
        }
        AxisValues all = core_.path.machine;
        for (unsigned k = 0; k < view.axis_count; ++k)
            if (const auto there = where(view.axes[k].machine_axis))
                all[k] = view.axes[k].from_drive(*there);
        value = shown(i, work_position(all, i));
        return VariableStatus::Ok;
    }
    if (number >= 5061 && number < 5061 + static_cast<std::int64_t>(view.axis_count)) {
        if (!fresh_ && !inputs_fresh_) return VariableStatus::NeedsBarrier;
        const unsigned i = place_of(5061);
        AxisValues all = core_.path.machine;
        for (unsigned k = 0; k < view.axis_count; ++k)
            if (const auto there = port.axis_at_skip(view.axes[k].machine_axis))
                all[k] = view.axes[k].from_drive(*there);
        value = shown(i, work_position(all, i));
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
        const auto command = port.axis_command(view.axes[i].machine_axis),
                   measured = port.axis_measured(view.axes[i].machine_axis);
        value = command && measured ? *command - *measured : 0.0;
        return VariableStatus::Ok;
    }
    if (number >= 5201 && number < 5340) {
        const std::int64_t row = (number - 5201) / 20, i = (number - 5201) % 20;
        if (i >= static_cast<std::int64_t>(view.axis_count)) return VariableStatus::Unknown;
        value =
            view.store
                ->zeros[static_cast<std::size_t>(row) * kChannelAxes + static_cast<std::size_t>(i)];
        if (!view.axes[static_cast<std::size_t>(i)].rotary) value *= programmed_unit;
        return VariableStatus::Ok;
    }
    if (number >= 4001 && number <= 4130) {
        if (interruption_.running) {
            value = interruption_.modal_variables[static_cast<std::size_t>(number - 4001)];
            return is_null(value) ? VariableStatus::Unknown : VariableStatus::Ok;
        }
        return modal_variable(number, value) ? VariableStatus::Ok : VariableStatus::Unknown;
    }
    switch (number) {
        case 3003:
            value = single_block_off_ * 1.0 + no_finish_wait_ * 2.0;
            return VariableStatus::Ok;
        case 3004:
            value = automatic_control_;
            return VariableStatus::Ok;
        case 3005:
            value = (settings_tv_ ? 1 : 0) + (settings_iso_ ? 2 : 0) + (inch_ ? 4 : 0) +
                    (settings_sequence_ ? 32 : 0) + (settings_.series15 ? 512 : 0);
            return VariableStatus::Ok;
        case 3007:
            value = mirrored_axes();
            return VariableStatus::Ok;
        case 3901:
            value = parts_;
            return VariableStatus::Ok;
        case 3902:
            value = parts_wanted_;
            return VariableStatus::Ok;
        case 5900:
            value = port.given_variable("#5900").value_or(pattern_);
            return VariableStatus::Ok;
        default:
            break;
    }
    const bool interface_input =
        (number >= 1000 && number <= 1035) || (number >= 1100 && number <= 1135);
    const bool clock = number == 3001 || number == 3002 || number == 3011 || number == 3012;
    if (!interface_input && !clock) return VariableStatus::Unknown;
    if (!fresh_ && !inputs_fresh_ && (number < 1100 || number > 1133))
        return VariableStatus::NeedsBarrier;
    if (number >= 1100 && number <= 1131) {
        value = outputs_ >> (number - 1100) & 1u;
        return VariableStatus::Ok;
    }
    if (number == 1132 || number == 1133) {
        value = number == 1132 ? outputs_ & 0xFFFFu : outputs_wide_;
        return VariableStatus::Ok;
    }
    if (number == 1032) {  // bit k is #1000+k
        double sum = 0.0;
        for (std::int32_t k = 0; k < 16; ++k)
            if (port.interface_value(1000 + k) != 0.0) sum += static_cast<double>(1u << k);
        value = port.given_variable("#1032").value_or(sum);
        return VariableStatus::Ok;
    }
    if (interface_input) {
        value = port.interface_value(static_cast<std::int32_t>(number));
        return VariableStatus::Ok;
    }
    core_.did();  // time goes on by itself
    const CalendarTime now = port.clock();
    switch (number) {
        case 3001:
            value = std::fmod(port.running_ms() + timer_ms_offset_, 2147483648.0);
            break;
        case 3002:
            value = std::fmod(port.lamp_ms() / 3'600'000.0 + timer_h_offset_, 9544.371767);
            break;
        case 3011:
            value = now.year * 10000.0 + now.month * 100 + now.day;
            break;
        default:
            value = now.hour * 10000.0 + now.minute * 100 + now.second;
            break;
    }
    return VariableStatus::Ok;
}

// Bit 0 is the first axis: those that run against what the program says.
double Interpreter::mirrored_axes() const {
    const PathState& path = core_.path;
    if (!path.framed) return 0.0;
    static constexpr PlaneRole kRoles[] = {PlaneRole::BasicX, PlaneRole::BasicY, PlaneRole::BasicZ};
    double bits = 0.0;
    for (std::size_t k = 0; k < 3; ++k) {
        const int place = core_.view().axis_by_role(kRoles[k]);
        if (place >= 0 && place < 8 && path.frame.linear[k][k] < 0)
            bits += static_cast<double>(1u << place);
    }
    return bits;
}

// #3003, #3004: single block, waiting for functions and feed hold are the kernel's, in path order.
// Where G63 taps a hold waits for G64: the spindle would turn on under the stopped tool (the
// field's standard).
std::uint32_t Interpreter::control_bits() const {
    const GCode* mode = active_[static_cast<std::size_t>(GGroup::ExactStop)];
    const bool taps = mode && mode->tenths == 630;
    return (single_block_off_ || hidden_ ? kControlNoSingleBlock : 0u) +
           (no_finish_wait_ ? kControlNoFinish : 0u) +
           ((automatic_control_ & 1) || taps ? kControlNoHold : 0u);
}

void Interpreter::tell_control() { core_.tell_control(control_bits()); }

VariableStatus Interpreter::value_fault(std::int64_t number, double value) {
    core_.fail(Alarm::VariableValue, 0, variable_name(number), value);
    return VariableStatus::Fault;
}

VariableStatus Interpreter::write_system(std::int64_t number, double value) {
    MachineView& view = core_.view();
    std::int32_t offset = 0;
    if (const OffsetRange* range = find_range(number, offset)) {
        if (offset > view.config().offset_count) return VariableStatus::Unknown;
        const bool tip = range->field == OffsetField::T;
        const double given = is_null(value) ? 0.0 : value,
                     cell = tip ? std::nearbyint(given) : given * unit_;
        // as G10 (fanuc_lathe 1.1, 1.8; nct N1415)
        if (!(tip ? cell >= 0 && cell <= 9 : offset_value_good(range->table, cell))) {
            core_.fail(Alarm::OffsetValueIllegal, 0, {}, given);
            return VariableStatus::Fault;
        }
        write_offset(range->table, offset, range->field, cell);
        return VariableStatus::Ok;
    }
    if (number >= 5201 && number < 5340) {
        const std::int64_t row = (number - 5201) / 20, i = (number - 5201) % 20;
        if (i >= static_cast<std::int64_t>(view.axis_count)) return VariableStatus::Unknown;
        const bool rotary = view.axes[static_cast<std::size_t>(i)].rotary;
        write_zero(static_cast<std::int32_t>(row), static_cast<unsigned>(i),
                   (is_null(value) ? 0.0 : value) * (rotary ? 1.0 : unit_));
        return VariableStatus::Ok;
    }
    const double plain = is_null(value) ? 0.0 : value;
    if (number >= 1100 && number <= (settings_.nct ? 1131 : 1115)) {
        const std::uint32_t bit = 1u << (number - 1100);
        outputs_ = plain != 0.0 ? outputs_ | bit : outputs_ & ~bit;
        core_.signal("CN_UOUT", outputs_);
        return VariableStatus::Ok;
    }
    if (number == 1132) {
        if (plain < 0 || plain > 65535) return value_fault(number, plain);
        outputs_ = (outputs_ & ~0xFFFFu) | static_cast<std::uint32_t>(std::llround(plain));
        core_.signal("CN_UOUT", outputs_);
        return VariableStatus::Ok;
    }
    if (number >= 1133 && number <= (settings_.nct ? 1135 : 1133)) {
        if (std::fabs(plain) > 99999999) return value_fault(number, plain);
        outputs_wide_ = plain;
        core_.signal("CN_UOUTW", std::nearbyint(plain));
        return VariableStatus::Ok;
    }
    switch (number) {
        case 3001:
            timer_ms_offset_ = plain - core_.port().running_ms();
            return VariableStatus::Ok;
        case 3002:
            timer_h_offset_ = plain - core_.port().lamp_ms() / 3'600'000.0;
            return VariableStatus::Ok;
        case 3003:
            if (plain < 0 || plain > 3) return value_fault(number, plain);
            single_block_off_ = (static_cast<int>(plain) & 1) != 0;
            no_finish_wait_ = (static_cast<int>(plain) & 2) != 0;
            tell_control();
            return VariableStatus::Ok;
        case 3004:
            if (plain < 0 || plain > 7) return value_fault(number, plain);
            automatic_control_ = static_cast<int>(plain);
            core_.path.override_locked =
                (automatic_control_ & 2) != 0 ||
                (active_[static_cast<std::size_t>(GGroup::ExactStop)] &&
                 active_[static_cast<std::size_t>(GGroup::ExactStop)]->tenths == 630);
            core_.path.exact_stop_off = (automatic_control_ & 4) != 0;
            tell_control();
            return VariableStatus::Ok;
        case 3005: {
            const auto bits = static_cast<unsigned>(std::llround(plain < 0 ? 0 : plain));
            settings_tv_ = bits & 1u;
            settings_iso_ = bits & 2u;
            settings_sequence_ = bits & 32u;
            settings_.series15 = bits & 512u;
            inch_ = bits & 4u;
            unit_ = inch_ ? 25.4 : 1.0;
            active_[static_cast<std::size_t>(GGroup::Units)] = table_.find(units_code(inch_));
            return VariableStatus::Ok;
        }
        case 3901:
            parts_ = plain;
            return VariableStatus::Ok;
        case 3902:
            if (plain < 0) return value_fault(number, plain);
            parts_wanted_ = plain;
            return VariableStatus::Ok;
        case 5900:
            pattern_ = plain;
            return VariableStatus::Ok;
        default:
            break;
    }
    const bool readable = (number >= 1000 && number <= 1035) ||
                          (number >= 3001 && number <= 3012) ||
                          (number >= 4001 && number <= 4130) || (number >= 5001 && number < 5200);
    return readable ? VariableStatus::ReadOnly : VariableStatus::Unknown;
}

}  // namespace polyturn::channels::fanuc
