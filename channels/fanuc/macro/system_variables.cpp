#include "channels/fanuc/macro/system_variables.hpp"

#include <cmath>
#include <optional>

#include "channels/fanuc/execution.hpp"
#include "channels/fanuc/macro/modal_values.hpp"
#include "channels/fanuc/macro/offset_variables.hpp"

namespace polyturn::channels::fanuc {
namespace {

double offset_value(const OffsetCell& cell, const OffsetRange& range) {
    const auto k = static_cast<std::size_t>(range.field);
    if (range.field == OffsetField::T) return cell.tip;
    if (range.field == OffsetField::R)
        return range.table == OffsetTable::Geometry ? cell.geometry_r : cell.wear_r;
    return range.table == OffsetTable::Geometry ? cell.geometry[k] : cell.wear[k];
}

// Bit 0 is the first axis: those that run against what the program says.
double mirrored_axes(const Execution& x) {
    const PathState& path = x.core.path;
    if (!path.framed) return 0.0;
    static constexpr PlaneRole kRoles[] = {PlaneRole::BasicX, PlaneRole::BasicY, PlaneRole::BasicZ};
    double bits = 0.0;
    for (std::size_t k = 0; k < 3; ++k) {
        const int place = x.core.view().axis_by_role(kRoles[k]);
        if (place >= 0 && place < 8 && path.frame.linear[k][k] < 0)
            bits += static_cast<double>(1u << place);
    }
    return bits;
}

// #5001 to #5199: where the axes are. Nothing: the variable is none of them.
std::optional<VariableStatus> read_position(Execution& x, std::int64_t number, double& value) {
    MachineView& view = x.core.view();
    Port& port = x.core.port();
    const double programmed_unit = 1.0 / x.modal.input.unit;
    const auto place_of = [&](std::int64_t first) { return static_cast<unsigned>(number - first); };
    // the same values under a second number (nct part 2 38)
    if (number >= 100101 && number < 100151)
        number += 5041 - 100101;
    else if (number >= 100151 && number < 100201)
        number += 5061 - 100151;
    // A position in the workpiece system: with the tool's lengths in it, or, nct TLC, without; nct
    // PCS: as the programmed frame counts.
    const auto work_position = [&](const AxisValues& machine, unsigned i) {
        const PathState& path = x.core.path;
        AxisValues point = machine;
        const bool whole = x.settings.positions_programmed && path.framed;
        for (unsigned k = whole ? 0 : i; k < (whole ? view.axis_count : i + 1); ++k)
            point[k] = machine[k] - path.zero[k] - path.turns_deg[k] -
                       (x.settings.positions_with_length && !whole ? 0.0 : path.shift[k]);
        if (!whole) return point[i];
        const double plain = x.core.unframed(point)[i];
        return plain + (x.settings.positions_with_length ? path.shift[i] : 0.0);
    };
    // Behind a barrier the path has ended: an axis is where the path has brought it, however
    // much its loop still lags in that tick. Only an interrupt program that runs asynchronously to
    // the path asks while the axes move.
    const auto where = [&](std::uint8_t machine_axis) {
        const auto rests =
            x.way_back.interruption.running ? std::nullopt : port.axis_taken_over(machine_axis);
        return rests ? rests : port.axis_position(machine_axis);
    };
    const auto shown = [&](unsigned i, double true_value) {
        return view.to_shown(i, true_value) * (view.axes[i].rotary ? 1.0 : programmed_unit);
    };
    if (number >= 5001 && number < 5001 + static_cast<std::int64_t>(view.axis_count)) {
        const AxisValues& end = x.way_back.interruption.running && x.way_back.interruption.shows_end
                                    ? x.way_back.interruption.end
                                    : x.core.path.programmed;
        value = shown(place_of(5001), end[place_of(5001)]);
        return VariableStatus::Ok;
    }
    const bool machine_now =
        number >= 5021 && number < 5021 + static_cast<std::int64_t>(view.axis_count);
    const bool work_now =
        number >= 5041 && number < 5041 + static_cast<std::int64_t>(view.axis_count);
    if (machine_now || work_now) {
        if (!x.run.fresh) return VariableStatus::NeedsBarrier;
        const unsigned i = place_of(machine_now ? 5021 : 5041);
        const ChannelAxis& axis = view.axes[i];
        const auto now = where(axis.machine_axis);
        const double machine = now ? axis.from_drive(*now) : x.core.path.machine[i];
        if (machine_now) {
            value = shown(i, axis.to_drive(machine) + port.axis_added(axis.machine_axis));
            return VariableStatus::Ok;
        }
        AxisValues all = x.core.path.machine;
        for (unsigned k = 0; k < view.axis_count; ++k)
            if (const auto there = where(view.axes[k].machine_axis))
                all[k] = view.axes[k].from_drive(*there);
        value = shown(i, work_position(all, i));
        return VariableStatus::Ok;
    }
    if (number >= 5061 && number < 5061 + static_cast<std::int64_t>(view.axis_count)) {
        if (!x.run.fresh && !x.reading.inputs_fresh) return VariableStatus::NeedsBarrier;
        const unsigned i = place_of(5061);
        AxisValues all = x.core.path.machine;
        for (unsigned k = 0; k < view.axis_count; ++k)
            if (const auto there = port.axis_at_skip(view.axes[k].machine_axis))
                all[k] = view.axes[k].from_drive(*there);
        value = shown(i, work_position(all, i));
        return VariableStatus::Ok;
    }
    if (number >= 5081 && number < 5081 + static_cast<std::int64_t>(view.axis_count)) {
        const unsigned i = place_of(5081);
        value = shown(i, x.core.path.shift[i] + x.core.path.vector[i]);
        return VariableStatus::Ok;
    }
    if (number >= 5101 && number < 5101 + static_cast<std::int64_t>(view.axis_count)) {
        if (!x.run.fresh) return VariableStatus::NeedsBarrier;
        const unsigned i = place_of(5101);
        const auto command = port.axis_command(view.axes[i].machine_axis),
                   measured = port.axis_measured(view.axes[i].machine_axis);
        value = command && measured ? *command - *measured : 0.0;
        return VariableStatus::Ok;
    }
    return std::nullopt;
}

// What programs have set. Nothing: the variable is none of them.
std::optional<VariableStatus> read_setting(Execution& x, std::int64_t number, double& value) {
    switch (number) {
        case 3003:
            value = x.modal.control.single_block_off * 1.0 + x.modal.control.no_finish_wait * 2.0;
            return VariableStatus::Ok;
        case 3004:
            value = x.modal.control.automatic;
            return VariableStatus::Ok;
        case 3005:
            value = (x.macro.system.tv ? 1 : 0) + (x.macro.system.iso ? 2 : 0) +
                    (x.modal.input.inch ? 4 : 0) + (x.macro.system.sequence ? 32 : 0) +
                    (x.settings.series15 ? 512 : 0);
            return VariableStatus::Ok;
        case 3007:
            value = mirrored_axes(x);
            return VariableStatus::Ok;
        case 3901:
            value = x.modal.parts;
            return VariableStatus::Ok;
        case 3902:
            value = x.macro.system.parts_wanted;
            return VariableStatus::Ok;
        case 5900:
            value = x.core.port().given_variable("#5900").value_or(x.macro.system.pattern);
            return VariableStatus::Ok;
        default:
            return std::nullopt;
    }
}

// #1000 to #1135, #3001, #3002, #3011, #3012: the interface of the PLC, and clocks.
VariableStatus read_interface(Execution& x, std::int64_t number, double& value) {
    Port& port = x.core.port();
    const bool interface_input =
        (number >= 1000 && number <= 1035) || (number >= 1100 && number <= 1135);
    const bool clock = number == 3001 || number == 3002 || number == 3011 || number == 3012;
    if (!interface_input && !clock) return VariableStatus::Unknown;
    if (!x.run.fresh && !x.reading.inputs_fresh && (number < 1100 || number > 1133))
        return VariableStatus::NeedsBarrier;
    if (number >= 1100 && number <= 1131) {
        value = x.macro.system.outputs >> (number - 1100) & 1u;
        return VariableStatus::Ok;
    }
    if (number == 1132 || number == 1133) {
        value = number == 1132 ? x.macro.system.outputs & 0xFFFFu : x.macro.system.outputs_wide;
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
    x.core.did();  // time goes on by itself
    const CalendarTime now = port.clock();
    switch (number) {
        case 3001:
            value = std::fmod(port.running_ms() + x.macro.system.timer_ms_offset, 2147483648.0);
            break;
        case 3002:
            value = std::fmod(port.lamp_ms() / 3'600'000.0 + x.macro.system.timer_h_offset,
                              9544.371767);
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

}  // namespace

VariableStatus read_system(Execution& x, std::int64_t number, double& value) {
    MachineView& view = x.core.view();
    std::int32_t offset = 0;
    if (const OffsetRange* range = find_range(number, offset)) {
        if (offset > view.config().offset_count) return VariableStatus::Unknown;
        // in the unit of the program
        value = offset_value(view.store->offsets[offset], *range) /
                (range->field == OffsetField::T ? 1.0 : x.modal.input.unit);
        return VariableStatus::Ok;
    }
    if (const auto status = read_position(x, number, value)) return *status;
    if (number >= 5201 && number < 5340) {
        const std::int64_t row = (number - 5201) / 20, i = (number - 5201) % 20;
        if (i >= static_cast<std::int64_t>(view.axis_count)) return VariableStatus::Unknown;
        value =
            view.store
                ->zeros[static_cast<std::size_t>(row) * kChannelAxes + static_cast<std::size_t>(i)];
        if (!view.axes[static_cast<std::size_t>(i)].rotary) value *= 1.0 / x.modal.input.unit;
        return VariableStatus::Ok;
    }
    if (number >= 4001 && number <= 4130) {
        if (x.way_back.interruption.running) {
            value =
                x.way_back.interruption.modal_variables[static_cast<std::size_t>(number - 4001)];
            return is_null(value) ? VariableStatus::Unknown : VariableStatus::Ok;
        }
        return modal_variable(x, number, value) ? VariableStatus::Ok : VariableStatus::Unknown;
    }
    if (const auto status = read_setting(x, number, value)) return *status;
    return read_interface(x, number, value);
}

}  // namespace polyturn::channels::fanuc
