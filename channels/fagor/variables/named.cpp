#include "channels/fagor/variables/named.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

#include "channels/fagor/execution.hpp"
#include "channels/fagor/frames/plane.hpp"
#include "channels/fagor/frames/zeros.hpp"
#include "channels/fagor/motion/lengths.hpp"
#include "channels/fagor/statements/control.hpp"
#include "channels/fagor/variables/coordinates.hpp"
#include "channels/fagor/variables/feed_and_spindle.hpp"
#include "channels/fagor/variables/plc.hpp"
#include "channels/fagor/variables/states.hpp"
#include "channels/fagor/variables/tables.hpp"
#include "ipc/model/machine/store/work_zeros.hpp"

namespace polyturn::channels::fagor {
namespace {

// A loop that asks for one of these comes to another answer although nothing else in the machine
// changes (Core::asks_at).
bool continues_by_itself(Var var) {
    switch (var) {
        case Var::Clock:
        case Var::Time:
        case Var::Date:
        case Var::CycleTime:
        case Var::PlcTimer:
        case Var::SpindleAngle:
        case Var::SpindleTurnAngle:
            return true;
        default:
            return false;
    }
}

}  // namespace

Access variable_fault(Execution& x, Alarm alarm, std::string detail, double v0, double v1) {
    x.fail(alarm, 0, std::move(detail), v0, v1);
    ExpressionFault told;
    told.alarm = alarm;
    told.detail = x.core.fault().detail;
    x.parsers.expression.set_fault(told);
    return Access::Fault;
}

Access write_value(Execution& x, const Target& target, double value) {
    if (target.row) return write_named(x, target, value);
    const std::int64_t number = target.number;
    if (!Values::exists(number)) return Access::Unknown;
    if (Values::of_maker(number) && !x.calls.here().maker)
        return variable_fault(x, Alarm::FagorMakerParameter, target_name(target));
    double& cell = x.values.parameter(number);
    if (cell != value) x.core.did();
    if (Values::is_local(number))
        cell = value;
    else
        x.values.write(cell, value);
    x.facts.message = target_name(target);
    x.core.mark_emitted();
    x.core.sink().variable({x.facts.message, value, -1}, x.core.at);
    return Access::Ok;
}

Access read_named(Execution& x, const Target& target, double& value) {
    const VariableRow& row = *target.row;
    if (target.axis && x.places.of(target.axis) < 0) return Access::Unknown;
    if (row.live && !x.run.fresh) return Access::NeedsBarrier;
    const int place = x.places.of(target.axis);
    const auto i = static_cast<std::size_t>(place < 0 ? 0 : place);
    const PathState& path = x.core.path;
    if (continues_by_itself(row.var)) x.core.did();
    switch (row.var) {
        case Var::TableX:
        case Var::TableZ:
        case Var::TableTip:
        case Var::TableRadius:
        case Var::TableWearX:
        case Var::TableWearZ:
        case Var::NoseAngle:
        case Var::NoseWidth:
        case Var::CutAngle:
        case Var::ToolOffset:
        case Var::ToolFamily:
        case Var::ToolLife:
        case Var::ToolUsed:
        case Var::PocketTool:
        case Var::TablePocket:
            return table_value(x, target, value);
        case Var::Programmed:
        case Var::Position:
        case Var::Theoretical:
        case Var::PartPosition:
        case Var::PartTheoretical:
        case Var::Lag:
        case Var::Displayed:
        case Var::BlockPosition:
            return read_coordinate(x, target, value);
        case Var::PlcInputs:
        case Var::PlcOutputs:
        case Var::PlcMarks:
        case Var::PlcRegister:
        case Var::PlcTimer:
        case Var::PlcCounter:
        case Var::PlcMark:
            return plc_value(x, target, false, value);
        case Var::FeedReal:
        case Var::FeedAxis:
        case Var::Feed:
        case Var::FeedProgram:
        case Var::FeedRev:
        case Var::FeedRevProgram:
        case Var::FeedInverse:
        case Var::Override:
        case Var::OverrideProgram:
        case Var::OverridePanel:
        case Var::SpindleReal:
        case Var::SpindleTheoretical:
        case Var::SpindleSpeed:
        case Var::SpindleProgram:
        case Var::SurfaceSpeed:
        case Var::SurfaceProgram:
        case Var::SpindleOverride:
        case Var::SpindleOverrideProgram:
        case Var::SpindleOverridePanel:
        case Var::SpindleLimit:
        case Var::SpindleAngle:
        case Var::SpindleTurnAngle:
        case Var::SpindleLag:
        case Var::SpindleAngleProgram:
            return read_feed_or_spindle(x, target, value);
        case Var::Tool:
            value = static_cast<double>(std::max<std::int64_t>(path.tool.ref.number, 0));
            return Access::Ok;
        case Var::Tod:
            value = std::max(path.tool.ref.offset, 0);
            return Access::Ok;
        case Var::NextTool:
            value = static_cast<double>(std::max<std::int64_t>(x.modal.next_tool, 0));
            return Access::Ok;
        case Var::NextOffset:
            value = static_cast<double>(std::max<std::int64_t>(x.modal.next_offset, 0));
            return Access::Ok;
        case Var::ManagedTool:
            value = static_cast<double>(std::max<std::int64_t>(
                x.modal.next_tool >= 0 ? x.modal.next_tool : path.tool.ref.number, 0));
            return Access::Ok;
        case Var::UsedRadius:
            value = from_length_plain(x, path.tool.nose_radius);
            return Access::Ok;
        case Var::ActiveZero: {
            double zero = path.work[i] + path.preset[i] + path.local[i];
            if (target.has_index) {
                const auto n = static_cast<std::int64_t>(target.index);
                if (n < 54 || n > 59)
                    return variable_fault(x, Alarm::FagorValueRange, target_name(target),
                                          target.index);
                zero =
                    x.core.view().store->zeros[static_cast<std::size_t>(n - 53) * kChannelAxes + i];
            }
            value = x.core.view().axes[i].rotary ? zero : from_length_plain(x, zero);
            return Access::Ok;
        }
        case Var::PolarF:
        case Var::PolarS: {
            int p = -1, q = -1;
            x.core.plane_axes(p, q);
            double op = 0, oq = 0;
            polar_origin(x, op, oq);
            value = row.var == Var::PolarF ? from_length(x, op, p) : from_length(x, oq, q);
            return Access::Ok;
        }
        case Var::PlcZero:
            value = from_length_plain(
                x,
                x.core.view()
                    .store->zeros[static_cast<std::size_t>(kZeroExternalRow) * kChannelAxes + i]);
            return Access::Ok;
        case Var::ParameterGeneral:
        case Var::ParameterAxis:
        case Var::ParameterSpindle:
        case Var::ParameterPlc:
            value = machine_parameter(x, target);
            return Access::Ok;
        case Var::ZoneState:
            value = static_cast<double>(path.zones[row.sub].guard);
            return Access::Ok;
        case Var::ZoneLow:
            value = from_length_plain(x, path.zones[row.sub].low[i]);
            return Access::Ok;
        case Var::ZoneHigh:
            value = from_length_plain(x, path.zones[row.sub].high[i]);
            return Access::Ok;
        case Var::Kept:
        case Var::KeptAxis:
            if (row.name == "ANAO" && (target.index < 1 || target.index > 8))
                return variable_fault(x, Alarm::FagorValueRange, target_name(target), target.index);
            value = x.values.kept(static_cast<std::size_t>(&row - &variable_row(0)),
                                  row.shape == Shape::Plain ? Values::kNoPlace
                                  : row.shape == Shape::Axis
                                      ? i
                                      : static_cast<std::size_t>(target.index) % Values::kNoPlace);
            return Access::Ok;
        case Var::Way: {
            const double way = x.out.ways.way(static_cast<unsigned>(i)) +
                               x.values.kept(static_cast<std::size_t>(&row - &variable_row(0)), i);
            value = x.core.view().axes[i].rotary ? way : from_length_plain(x, way);
            return Access::Ok;
        }
        case Var::Nothing:
        case Var::AdditiveZero:
            if (row.name == "ANAI" && (target.index < 1 || target.index > 8))
                return variable_fault(x, Alarm::FagorValueRange, target_name(target), target.index);
            value = x.core.port().given_variable(target_name(target)).value_or(0.0);
            return Access::Ok;
        default:
            return read_state(x, target, value);
    }
}

Access write_named(Execution& x, const Target& target, double value) {
    const VariableRow& row = *target.row;
    if (target.axis && x.places.of(target.axis) < 0) return Access::Unknown;
    if (!row.writable || (row.shape == Shape::AxisOrIndex && !target.has_index))
        return Access::ReadOnly;
    if (row.live && !x.run.fresh) return Access::NeedsBarrier;
    x.core.did();
    // tables are shared: looking ahead writes none, and what depends on it is not known
    if (x.ahead.scans_loops) {
        x.ahead.over = true;
        return Access::Ok;
    }
    const int place = x.places.of(target.axis);
    const auto i = static_cast<std::size_t>(place < 0 ? 0 : place);
    MachineView& view = x.core.view();
    const auto write_zero = [&](std::int32_t zero_row) {
        const double raw = view.axes[i].rotary ? value : value * x.modal.unit();
        x.values.write(view.store->zeros[static_cast<std::size_t>(zero_row) * kChannelAxes + i],
                       raw);
        x.core.mark_emitted();
        const std::string name = work_zero_name(static_cast<std::size_t>(zero_row));
        OffsetWrite told;
        told.table = "work";
        told.axis = view.axes[i].name;
        told.zero_name = name;
        told.number = zero_row;
        told.work = true;
        told.row = zero_row;
        told.place = static_cast<std::int32_t>(i);
        told.value = raw;
        x.core.sink().offset(told, x.core.at);
    };
    switch (row.var) {
        case Var::PlcZero:
            write_zero(kZeroExternalRow);
            refresh_zero(x);
            return Access::Ok;
        case Var::ActiveZero: {
            const auto n = static_cast<std::int64_t>(target.index);
            if (n < 54 || n > 59)
                return variable_fault(x, Alarm::FagorValueRange, target_name(target), target.index);
            // it counts when the offset is chosen the next time
            write_zero(static_cast<std::int32_t>(n - 53));
            return Access::Ok;
        }
        case Var::PlcInputs:
        case Var::PlcOutputs:
        case Var::PlcMarks:
        case Var::PlcRegister:
        case Var::PlcTimer:
        case Var::PlcCounter:
        case Var::PlcMark:
            return plc_value(x, target, true, value);
        case Var::UsedRadius:
            x.core.path.tool.nose_radius = value * x.modal.unit();
            return Access::Ok;
        case Var::OverrideProgram:
            if (value < 0 || value > 255)
                return variable_fault(x, Alarm::FagorValueRange, "PRGFRO", value);
            x.modal.override_program = std::fmin(value, x.settings.override_max);
            return Access::Ok;
        case Var::SpindleOverrideProgram:
            if (value < 0 || value > 255)
                return variable_fault(x, Alarm::FagorValueRange, "PRGSSO", value);
            x.modal.spindle_override_program =
                value == 0 ? 0
                           : std::clamp(value, x.settings.spindle_override_min,
                                        x.settings.spindle_override_max);
            x.out.spindles.set(x.modal.spindle_override_program > 0
                                   ? x.modal.spindle_override_program / 100.0
                                   : 1.0,
                               x.core.at);
            tell_control(x, false);
            x.core.mark_emitted();
            return Access::Ok;
        case Var::ProbeInput:
            if (value != 1 && value != 2)
                return variable_fault(x, Alarm::FagorValueRange, "SELPRO", value);
            x.modal.probe_input = value;
            return Access::Ok;
        case Var::ProbeMode:
            if (value != 0 && value != 1)
                return variable_fault(x, Alarm::FagorValueRange, "PRBMOD", value);
            x.modal.probe_mode = value;
            return Access::Ok;
        case Var::Diameter:
            if (value != 0 && value != 1)
                return variable_fault(x, Alarm::FagorValueRange, "DIAM", value);
            x.modal.diameter = value != 0;
            show_diameter(x);
            return Access::Ok;
        case Var::Parts:
            x.modal.parts = value;
            return Access::Ok;
        case Var::Way:  // what is kept is the difference to the way since the start
            x.values.write(x.values.kept(static_cast<std::size_t>(&row - &variable_row(0)), i),
                           (view.axes[i].rotary ? value : value * x.modal.unit()) -
                               x.out.ways.way(static_cast<unsigned>(i)));
            return Access::Ok;
        case Var::Kept:
        case Var::KeptAxis:
            if (row.name == "KEYSRC") {  // only while it is 0 (11.2.14)
                if (value < 0 || value > 2 || value != std::nearbyint(value))
                    return variable_fault(x, Alarm::FagorValueRange, "KEYSRC", value);
                if (x.values.kept(static_cast<std::size_t>(&row - &variable_row(0)),
                                  Values::kNoPlace) != 0)
                    return Access::ReadOnly;
            }
            if (row.name == "ANAO" && (target.index < 1 || target.index > 8))
                return variable_fault(x, Alarm::FagorValueRange, target_name(target), target.index);
            if (row.name == "ANAO" && std::fabs(value) > 10.0)
                return variable_fault(x, Alarm::FagorValueRange, target_name(target), value);
            // from machine zero, X as a radius; they act when the PLC sets ACTLIM2
            if (row.name == "LIMPL" || row.name == "LIMMI") {
                WorkZone& limits = x.core.path.second_limits;
                const bool upper = row.name == "LIMPL";
                (upper ? limits.high : limits.low)[i] =
                    view.axes[i].rotary ? value : value * x.modal.unit();
                (upper ? limits.has_high : limits.has_low) |= 1u << i;
            }
            x.values.write(
                x.values.kept(static_cast<std::size_t>(&row - &variable_row(0)),
                              row.shape == Shape::Plain ? Values::kNoPlace
                              : row.shape == Shape::Axis
                                  ? i
                                  : static_cast<std::size_t>(target.index) % Values::kNoPlace),
                value);
            return Access::Ok;
        default:
            return write_table(x, target, value);
    }
}

}  // namespace polyturn::channels::fagor
