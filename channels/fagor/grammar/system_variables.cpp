// Values behind the names of variable_names.hpp: tables, zeros, states, coordinates (fagor_8037t
// part 2, 11.2).
#include <algorithm>
#include <cmath>
#include <numbers>

#include "channels/fagor/interpreter.hpp"
#include "ipc/machine/store/work_zeros.hpp"

namespace polyturn::channels::fagor {
namespace {
constexpr double kPanelMost = 120.0;  // %, the end of the feed switch (part 1, 5.2)

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

Access Interpreter::variable_fault(Alarm alarm, std::string detail, double v0, double v1) {
    core_.fail(alarm, 0, std::move(detail), v0, v1);
    ExpressionFault told;
    told.alarm = alarm;
    told.detail = core_.fault().detail;
    expression_.set_fault(told);
    return Access::Fault;
}

int Interpreter::place_of(char axis) const {
    return axis ? place_[static_cast<std::size_t>(axis - 'A')] : -1;
}

Access Interpreter::read(const Target& target, double& value) {
    if (!target.row) {
        if (!Values::exists(target.number)) return Access::Unknown;
        if (Values::of_maker(target.number) && !frames_.back().maker)
            return variable_fault(Alarm::FagorMakerParameter, target_name(target));
        value = values_.parameter(target.number);
        return Access::Ok;
    }
    return read_named(target, value);
}

Access Interpreter::write_value(const Target& target, double value) {
    if (target.row) return write_named(target, value);
    const std::int64_t number = target.number;
    if (!Values::exists(number)) return Access::Unknown;
    if (Values::of_maker(number) && !frames_.back().maker)
        return variable_fault(Alarm::FagorMakerParameter, target_name(target));
    double& cell = values_.parameter(number);
    if (cell != value) core_.did();
    if (Values::is_local(number))
        cell = value;
    else
        values_.write(cell, value);
    message_ = target_name(target);
    core_.mark_emitted();
    core_.sink().variable({message_, value, -1}, core_.at);
    return Access::Ok;
}

Access Interpreter::read_named(const Target& target, double& value) {
    const VariableRow& row = *target.row;
    if (target.axis && place_of(target.axis) < 0) return Access::Unknown;
    if (row.live && !fresh_) return Access::NeedsBarrier;
    const int place = place_of(target.axis);
    const auto i = static_cast<std::size_t>(place < 0 ? 0 : place);
    const PathState& path = core_.path;
    if (continues_by_itself(row.var)) core_.did();
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
            return table_value(target, value);
        case Var::Programmed:
        case Var::Position:
        case Var::Theoretical:
        case Var::PartPosition:
        case Var::PartTheoretical:
        case Var::Lag:
        case Var::Displayed:
        case Var::BlockPosition:
            return read_coordinate(target, value);
        case Var::PlcInputs:
        case Var::PlcOutputs:
        case Var::PlcMarks:
        case Var::PlcRegister:
        case Var::PlcTimer:
        case Var::PlcCounter:
        case Var::PlcMark:
            return plc_value(target, false, value);
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
            return read_feed_or_spindle(target, value);
        case Var::Tool:
            value = static_cast<double>(std::max<std::int64_t>(path.tool.ref.number, 0));
            return Access::Ok;
        case Var::Tod:
            value = std::max(path.tool.ref.offset, 0);
            return Access::Ok;
        case Var::NextTool:
            value = static_cast<double>(std::max<std::int64_t>(modal_.next_tool, 0));
            return Access::Ok;
        case Var::NextOffset:
            value = static_cast<double>(std::max<std::int64_t>(modal_.next_offset, 0));
            return Access::Ok;
        case Var::ManagedTool:
            value = static_cast<double>(std::max<std::int64_t>(
                modal_.next_tool >= 0 ? modal_.next_tool : path.tool.ref.number, 0));
            return Access::Ok;
        case Var::UsedRadius:
            value = from_length_plain(path.tool.nose_radius);
            return Access::Ok;
        case Var::ActiveZero: {
            double zero = path.work[i] + path.preset[i] + path.local[i];
            if (target.has_index) {
                const auto n = static_cast<std::int64_t>(target.index);
                if (n < 54 || n > 59)
                    return variable_fault(Alarm::FagorValueRange, target_name(target),
                                          target.index);
                zero =
                    core_.view().store->zeros[static_cast<std::size_t>(n - 53) * kChannelAxes + i];
            }
            value = core_.view().axes[i].rotary ? zero : from_length_plain(zero);
            return Access::Ok;
        }
        case Var::PolarF:
        case Var::PolarS: {
            int p = -1, q = -1;
            core_.plane_axes(p, q);
            double op = 0, oq = 0;
            polar_origin(op, oq);
            value = row.var == Var::PolarF ? from_length(op, p) : from_length(oq, q);
            return Access::Ok;
        }
        case Var::PlcZero:
            value = from_length_plain(
                core_.view()
                    .store->zeros[static_cast<std::size_t>(kZeroExternalRow) * kChannelAxes + i]);
            return Access::Ok;
        case Var::ParameterGeneral:
        case Var::ParameterAxis:
        case Var::ParameterSpindle:
        case Var::ParameterPlc:
            value = machine_parameter(target);
            return Access::Ok;
        case Var::ZoneState:
            value = static_cast<double>(path.zones[row.sub].guard);
            return Access::Ok;
        case Var::ZoneLow:
            value = from_length_plain(path.zones[row.sub].low[i]);
            return Access::Ok;
        case Var::ZoneHigh:
            value = from_length_plain(path.zones[row.sub].high[i]);
            return Access::Ok;
        case Var::Kept:
        case Var::KeptAxis:
            if (row.name == "ANAO" && (target.index < 1 || target.index > 8))
                return variable_fault(Alarm::FagorValueRange, target_name(target), target.index);
            value = values_.kept(static_cast<std::size_t>(&row - &variable_row(0)),
                                 row.shape == Shape::Plain ? Values::kNoPlace
                                 : row.shape == Shape::Axis
                                     ? i
                                     : static_cast<std::size_t>(target.index) % Values::kNoPlace);
            return Access::Ok;
        case Var::Way: {
            const double way = ways_.way(static_cast<unsigned>(i)) +
                               values_.kept(static_cast<std::size_t>(&row - &variable_row(0)), i);
            value = core_.view().axes[i].rotary ? way : from_length_plain(way);
            return Access::Ok;
        }
        case Var::Nothing:
        case Var::AdditiveZero:
            if (row.name == "ANAI" && (target.index < 1 || target.index > 8))
                return variable_fault(Alarm::FagorValueRange, target_name(target), target.index);
            value = core_.port().given_variable(target_name(target)).value_or(0.0);
            return Access::Ok;
        default:
            return read_state(target, value);
    }
}

Access Interpreter::read_state(const Target& target, double& value) {
    const VariableRow& row = *target.row;
    const PathState& path = core_.path;
    const MachineView& view = core_.view();
    switch (row.var) {
        case Var::CallParameters:
            value = 0;
            for (auto frame = frames_.rbegin(); frame != frames_.rend(); ++frame)
                if (frame->own_level) {
                    value = frame->given;
                    break;
                }
            return Access::Ok;
        case Var::Mode:
            value = core_.port().single_block() ? 11 : 10;
            return Access::Ok;
        case Var::ModeBits:
            value = 1;
            return Access::Ok;
        case Var::Program:
            value = static_cast<double>(frames_.back().program);
            return Access::Ok;
        case Var::Label:
            value = static_cast<double>(std::max<std::int64_t>(modal_.last_label, 0));
            return Access::Ok;
        case Var::GState:
            value = target.index >= 0 && target.index < 1000 &&
                    g_active(static_cast<unsigned>(target.index));
            return Access::Ok;
        case Var::MState:
            value = target.index >= 0 && target.index < 64 &&
                    (modal_.m_states >> static_cast<unsigned>(target.index) & 1u);
            return Access::Ok;
        case Var::PlaneAxes: {
            int p = -1, q = -1;
            core_.plane_axes(p, q);
            // G17 G18 G19: X = 1, Y = 2, Z = 3, on a machine without them too
            static constexpr int kBasic[][2] = {{1, 2}, {3, 1}, {2, 3}};
            const auto& basic = kBasic[static_cast<std::size_t>(path.plane)];
            const auto axis = [&](int place, int named) {
                return place < 0 ? named
                                 : axis_number(view.axes[static_cast<std::size_t>(place)].name[0]);
            };
            value = axis(p, basic[0]) * 16 + axis(q, basic[1]);
            return Access::Ok;
        }
        case Var::LengthAxis: {
            const int z = view.axis_by_role(PlaneRole::BasicZ);
            value = z < 0 ? 0 : axis_number(view.axes[static_cast<std::size_t>(z)].name[0]);
            return Access::Ok;
        }
        case Var::Mirror: {  // by the order of the axes that exist (14)
            double bit = 1.0;
            value = 0.0;
            for (const char letter : kAxisLetters) {
                const int place = place_of(letter);
                if (place < 0) continue;
                if (modal_.mirrored >> place & 1u) value += bit;
                bit *= 2;
            }
            return Access::Ok;
        }
        case Var::Scale:
            value = modal_.scale;
            return Access::Ok;
        case Var::ScaleAxis: {
            const double factor =
                modal_.axis_scale[static_cast<std::size_t>(place_of(target.axis))];
            value = factor == 0.0 ? 1.0 : factor;
            return Access::Ok;
        }
        case Var::Probe: {
            const auto given = core_.port().given_variable("PRBST");
            value = given ? *given
                          : core_.port().measuring_input(modal_.probe_input == 2 ? "2" : "1", view,
                                                         path.machine);
            return Access::Ok;
        }
        case Var::Clock: {
            const CalendarTime t = core_.port().clock();
            value = t.hour * 3600.0 + t.minute * 60.0 + t.second;
            return Access::Ok;
        }
        case Var::Time: {
            const CalendarTime t = core_.port().clock();
            value = t.hour * 10'000.0 + t.minute * 100.0 + t.second;
            return Access::Ok;
        }
        case Var::Date: {
            const CalendarTime t = core_.port().clock();
            value = (t.year % 100) * 10'000.0 + t.month * 100.0 + t.day;
            return Access::Ok;
        }
        case Var::CycleTime:
            value = std::trunc((core_.port().running_ms() - began_ms_) / 10.0);
            return Access::Ok;
        case Var::First:
            value = first_run_;
            return Access::Ok;
        case Var::ProbeInput:
            value = modal_.probe_input;
            return Access::Ok;
        case Var::Diameter:
            value = modal_.diameter;
            return Access::Ok;
        case Var::ProbeMode:
            value = modal_.probe_mode;
            return Access::Ok;
        case Var::Parts:
            value = modal_.parts;
            return Access::Ok;
        default:
            break;
    }
    value = 0.0;
    return Access::Ok;
}

Access Interpreter::read_coordinate(const Target& target, double& value) {
    if (target.row->var == Var::BlockPosition) return block_position(target, value);
    const int place = place_of(target.axis);
    const auto i = static_cast<unsigned>(place);
    const PathState& path = core_.path;
    const unsigned machine_axis = core_.view().axes[i].machine_axis;
    // The tool's tip in the machine, commanded and measured; a transformation stands between it and
    // the axes.
    // a probe's point, not the way of braking
    const bool touches = moves_at_touch_ != 0 && moves_at_touch_ == core_.moves();
    const double commanded =
        core_.machine_now(i) - path.vector[i] - (touches ? braked_mm_[i] : 0.0);
    const auto command = core_.port().axis_command(machine_axis),
               measured = core_.port().axis_measured(machine_axis);
    const double error = command && measured && !(touches && core_.skip_moved() >> i & 1u)
                             ? *command - *measured
                             : 0.0;
    switch (target.row->var) {
        case Var::Programmed:
            value = from_length(core_.framed(path.programmed)[i], place);
            return Access::Ok;
        case Var::Position:
            value = from_length(commanded - error, place);
            return Access::Ok;
        case Var::Theoretical:
            value = from_length(commanded, place);
            return Access::Ok;
        case Var::PartPosition:
            value = from_length(commanded - error - path.zero[i], place);
            return Access::Ok;
        case Var::PartTheoretical:
            value = from_length(commanded - path.zero[i], place);
            return Access::Ok;
        case Var::Lag:
            value = from_length_plain(error);
            return Access::Ok;
        default:
            value = from_length(commanded - path.zero[i], place);
            return Access::Ok;
    }
}

Access Interpreter::read_feed_or_spindle(const Target& target, double& value) {
    const SpindleState& s = core_.path.spindle;
    Port& port = core_.port();
    const double panel = std::round(port.feed_override() * 100.0),
                 spindle_panel =
                     s.spindle ? std::round(port.spindle_override(s.spindle) * 100.0) : 100.0;
    switch (target.row->var) {
        case Var::Feed:
            value = from_length_plain(modal_.feed_code == 32 ? modal_.feed_of_block
                                                             : modal_.feed_minute);
            break;
        case Var::FeedProgram:
            value = from_length_plain(modal_.feed_minute);
            break;
        case Var::FeedRev:
        case Var::FeedRevProgram:
            value = from_length_plain(modal_.feed_revolution);
            break;
        case Var::FeedInverse:
            value = modal_.feed_inverse;
            break;
        case Var::Override:
            value = modal_.override_program > 0
                        ? modal_.override_program
                        : std::fmin(std::fmin(panel, kPanelMost), settings_.override_max);
            break;
        case Var::OverrideProgram:
            value = modal_.override_program;
            break;
        case Var::OverridePanel:
            value = panel;
            break;
        case Var::SpindleOverridePanel:
            value = spindle_panel;
            break;
        case Var::SpindleOverride:
            value = modal_.spindle_override_program > 0
                        ? modal_.spindle_override_program
                        : std::min(std::max(spindle_panel, settings_.spindle_override_min),
                                   settings_.spindle_override_max);
            break;
        case Var::SpindleOverrideProgram:
            value = modal_.spindle_override_program;
            break;
        case Var::SpindleReal: {
            const auto turns = s.spindle ? port.spindle_speed(s.spindle) : std::nullopt;
            // beyond tenths an encoder reports noise
            value = turns ? std::round(*turns * 10.0) / 10.0 : spindle_turns_at();
            break;
        }
        case Var::SpindleTheoretical:
            value = spindle_turns_at();
            break;
        case Var::SpindleSpeed:
        case Var::SpindleProgram:
            value = s.rpm;
            break;
        case Var::SurfaceSpeed:
        case Var::SurfaceProgram:
            value = modal_.inch ? s.surface_m_min / 0.3048 : s.surface_m_min;
            break;
        case Var::SpindleLimit:
            value = modal_.speed_limit;
            break;
        case Var::SpindleAngle:
        case Var::SpindleAngleProgram:
            value = modal_.position_angle;
            break;
        case Var::SpindleTurnAngle:
            value = modal_.position_angle - std::floor(modal_.position_angle / 360.0) * 360.0;
            break;
        // nothing moves while a program reads it
        default:
            value = 0.0;
            break;
    }
    return Access::Ok;
}

// 1/min that the commands come to: in G96 at the present diameter, with the override of the
// program.
double Interpreter::spindle_turns_at() const {
    const SpindleState& s = core_.path.spindle;
    if (s.turn == SpindleTurn::Stop) return 0.0;
    double rpm = s.rpm;
    const int x = core_.view().axis_by_role(PlaneRole::BasicX);
    if (s.mode == SpindleModeCode::SurfaceSpeed && x >= 0) {
        const double radius =
            std::fabs(core_.framed(core_.path.programmed)[static_cast<std::size_t>(x)]);
        rpm = radius > 0 ? 1000.0 * s.surface_m_min / (2 * std::numbers::pi * radius) : s.limit_rpm;
    }
    if (modal_.spindle_override_program > 0) rpm *= modal_.spindle_override_program / 100.0;
    return s.limit_rpm > 0 ? std::fmin(rpm, s.limit_rpm) : rpm;
}

bool Interpreter::g_active(unsigned n) const {
    const Modal& m = modal_;
    if (n <= 3 || n == 33 || n == 34) return m.motion == n;
    if (n == 5 || n == 7 || n == 50 || n == 51) return m.corner == n;
    if (n == 10) return m.mirrored == 0;
    if (n >= 11 && n <= 13) {
        static constexpr PlaneRole kRoles[] = {PlaneRole::BasicX, PlaneRole::BasicY,
                                               PlaneRole::BasicZ};
        const int place = core_.view().axis_by_role(kRoles[n - 11]);
        return place >= 0 && (m.mirrored >> place & 1u);
    }
    if (n == 14) return m.mirrored != 0;
    if (n >= 16 && n <= 19) return m.plane == n;
    if (n == 32 || n == 94 || n == 95) return m.feed_code == n;
    if (n >= 40 && n <= 42) return m.comp == n;
    if (n == 46) return m.inclined != 0;
    if (n == 53) return m.zero == 0;
    if (n >= 54 && n <= 57) return m.zero == n;
    if (n == 58 || n == 59) return m.zero_added == n;
    if (n == 70 || n == 71) return m.inch == (n == 70);
    if (n == 72) {
        for (const double factor : m.axis_scale)
            if (factor != 0.0 && factor != 1.0) return true;
        return m.scale != 1.0;
    }
    if (n == 90 || n == 91) return m.absolute == (n == 90);
    if (n == 92) return m.zero == 92;
    if (n == 96 || n == 97)
        return (core_.path.spindle.mode == SpindleModeCode::SurfaceSpeed) == (n == 96);
    if (n == 151 || n == 152) return m.diameter == (n == 151);
    if (n == 159) return m.zero == 159;
    return n == 233 && m.withdraws;
}

// Machine parameters by the numbers that the manual names.
double Interpreter::machine_parameter(const Target& target) const {
    const auto n = static_cast<int>(target.index);
    if (target.row->var == Var::ParameterGeneral) {
        switch (n) {
            case 8:
                return settings_.inch;
            case 35:
            case 36:
            case 37:
            case 38:
                return settings_.interrupt_subroutine[static_cast<std::size_t>(n - 35)];
            case 73:
                return settings_.interpolation_period;
            case 119:
                return settings_.probe_error;
            case 123:
                return settings_.geometry_by_offset;
            case 160:
                return settings_.look_ahead_kind;
            default:
                return 0.0;
        }
    }
    if (target.row->var == Var::ParameterAxis) {
        const MachineView& view = core_.view();
        const ChannelAxis& axis = view.axes[static_cast<std::size_t>(place_of(target.axis))];
        switch (n) {
            case 1: {
                const auto format = static_cast<double>(
                    params::get(view.table(), params::fg_dformat, axis.machine_axis + 1u));
                return format >= 0 ? format
                       : params::bit(view.table(), params::n0106_axis_properties,
                                     axis.machine_axis + 1u, 0)
                           ? 4.0
                           : 0.0;
            }
            // in the active unit (11.2.4)
            case 5:
                return axis.rotary ? axis.limit_max : from_length_plain(axis.limit_max);
            case 6:
                return axis.rotary ? axis.limit_min : from_length_plain(axis.limit_min);
            default:
                return 0.0;
        }
    }
    if (target.row->var == Var::ParameterSpindle && n == 43) return settings_.thread_angle;
    return 0.0;
}

}  // namespace polyturn::channels::fagor
