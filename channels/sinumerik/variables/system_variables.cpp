// System variables: $P_ what the program has brought about, $TC_ tool data, $A what the machine
// says now, $MN $MC $MA $SC $SA machine and setting data. A live value is read at a barrier only
// (sinumerik_part2 15.8).
#include "channels/sinumerik/variables/system_variables.hpp"

#include <fmt/format.h>

#include <cmath>
#include <numbers>

#include "channels/sinumerik/actions/overlays.hpp"
#include "channels/sinumerik/axes/axis_words.hpp"
#include "channels/sinumerik/execution.hpp"
#include "channels/sinumerik/faults.hpp"
#include "channels/sinumerik/flow/run.hpp"
#include "channels/sinumerik/frames/geo_variables.hpp"
#include "channels/sinumerik/geometry/units.hpp"
#include "channels/sinumerik/grammar/expression.hpp"
#include "channels/sinumerik/grammar/groups.hpp"
#include "channels/sinumerik/tools/managed_tools.hpp"
#include "channels/sinumerik/tools/tool_variables.hpp"
#include "channels/sinumerik/variables/changes.hpp"
#include "channels/sinumerik/variables/data_variables.hpp"
#include "channels/sinumerik/variables/feed_variables.hpp"
#include "channels/sinumerik/variables/system_names.hpp"
#include "channels/sinumerik/variables/variables.hpp"
#include "ipc/diagnosis/display_language.hpp"

namespace polyturn::channels::sinumerik {
bool system_value(Execution& x, Value& value) {
    const char* const from = x.line.cursor.at();
    Reference reference;
    if (!reference_ahead(x, reference)) return false;
    if (reference) {  // $R5
        value = reference.cell();
        return true;
    }
    std::string name;
    std::vector<Value> indices;
    if (!system_name(x, name, indices)) return false;
    const auto length = static_cast<std::size_t>(x.line.cursor.at() - from);
    const auto unknown = [&] {
        return fail_at(x, Alarm::SystemVariableUnknown, from, length, name);
    };
    const auto number = [&](std::size_t i) { return i < indices.size() ? indices[i].number : 0.0; };
    const auto place = [&](std::size_t i) {
        return i < indices.size() && indices[i].type == Type::Axis &&
                       indices[i].place() < kSpindleAxis
                   ? indices[i].place()
                   : -1;
    };
    const auto shown = [&](int axis, double mm) {
        return counts_diameter(x, static_cast<unsigned>(axis), false) ? mm * 2 : mm;
    };
    const PathState& path = x.core.path;

    if (name == "$PI") {
        value = Value::of_real(std::numbers::pi);
        return true;
    }
    if (name == "$P_GG") {
        const auto group = static_cast<unsigned>(number(0));
        if (indices.size() != 1 || group < 1 || group >= kGroups)
            return fail_at(x, Alarm::ArrayIndexIllegal, from, length, name, number(0));
        value = Value::of_int(x.modal.active[group]);
        return true;
    }
    if (name == "$P_F") {
        value = Value::of_real(x.modal.feed);
        return true;
    }
    if (name == "$P_S" || name == "$P_SDIR" || name == "$AA_S") {
        if (name == "$AA_S" && !need_fresh(x)) return false;
        const double spindle = indices.empty() || number(0) == 0 ? x.modal.master_spindle
                               : indices[0].type == Type::Axis   ? indices[0].place() - kSpindleAxis
                                                                 : number(0);
        if (!(spindle >= 1 && spindle <= kMaxSpindles))
            return fail_at(x, Alarm::ArrayIndexIllegal, from, length, name, spindle);
        const auto kept = x.modal.spindles.find(static_cast<std::uint16_t>(spindle));
        const SpindleState state = spindle == path.spindle.spindle  ? path.spindle
                                   : kept != x.modal.spindles.end() ? kept->second
                                                                    : SpindleState{};
        if (name == "$P_SDIR")
            value = Value::of_int(state.turn == SpindleTurn::Cw    ? 3
                                  : state.turn == SpindleTurn::Ccw ? 4
                                                                   : 5);
        else if (name == "$AA_S")
            value = Value::of_real(state.turn == SpindleTurn::Stop  ? 0.0
                                   : state.turn == SpindleTurn::Ccw ? -state.rpm
                                                                    : state.rpm);
        else
            value = Value::of_real(state.mode == SpindleModeCode::SurfaceSpeed
                                       ? state.surface_m_min
                                       : x.modal.asked_rpm[static_cast<std::size_t>(spindle)]);
        return true;
    }
    if (name == "$P_TOOLNO") {
        value = Value::of_int(static_cast<double>(x.modal.tool));
        return true;
    }
    if (name == "$P_TOOL") {
        value = Value::of_int(x.modal.edge);
        return true;
    }
    if (name == "$P_TOOLR") {
        value = Value::of_real(path.tool.nose_radius + path.tool.allowance - x.modal.geo.allowance);
        return true;
    }
    if (name == "$P_TOOLL") {
        const double i = number(0);
        if (!(i >= 1 && i <= 3)) return fail_at(x, Alarm::ArrayIndexIllegal, from, length, name, i);
        value = Value::of_real(x.modal.length_mm[static_cast<std::size_t>(i) - 1]);
        return true;
    }
    if (bool known = false; !feed_value(x, name, indices, from, length, value, known))
        return false;
    else if (known)
        return true;
    if (name == "$P_UIFRNUM") {
        value = Value::of_int(active(x, 8) - 1.0);
        return true;
    }
    if (name == "$P_MSNUM") {
        value = Value::of_int(x.modal.master_spindle);
        return true;
    }
    if (name == "$P_CHANNO") {
        value = Value::of_int(x.core.view().channel);
        return true;
    }
    if (name == "$P_STACK") {
        value = Value::of_int(x.core.at.stack_depth);
        return true;
    }
    if (name == "$P_EP") {
        if (place(0) < 0) return fail_at(x, Alarm::AxisArgumentMissing, from, length, name);
        value = Value::of_real(
            shown(place(0), path.programmed[static_cast<std::size_t>(place(0))]) / unit(x));
        return true;
    }
    if (name == "$AA_OFF" || name == "$AA_OFF_VAL") {
        if (place(0) < 0 || place(0) >= kSpindleAxis)
            return fail_at(x, Alarm::AxisArgumentMissing, from, length, name);
        return need_fresh(x) &&
               (value = Value::of_real(path.wanted[static_cast<std::size_t>(place(0))]), true);
    }
    if (name == "$AA_FXS") {
        if (place(0) < 0 || place(0) >= kSpindleAxis)
            return fail_at(x, Alarm::AxisArgumentMissing, from, length, name);
        value = Value::of_int(x.core.stops_met() >> place(0) & 1u);
        return true;
    }
    if (name == "$AA_IM" || name == "$AA_IW" || name == "$AA_IB") {
        if (place(0) < 0) return fail_at(x, Alarm::AxisArgumentMissing, from, length, name);
        if (!need_fresh(x)) return false;
        const auto i = static_cast<std::size_t>(place(0));
        if (name == "$AA_IW")
            value = Value::of_real(shown(place(0), path.programmed[i]));
        else
            // what PRESETON has called it (sinumerik_part3 7.1)
            value = Value::of_real(x.core.machine_now(static_cast<unsigned>(i)) - path.preset[i]);
        return true;
    }
    // where the probe of MEAS stopped the axis, before braking; else its position
    if (name == "$AA_MM" || name == "$AA_MW") {
        if (place(0) < 0 || place(0) >= kSpindleAxis)
            return fail_at(x, Alarm::AxisArgumentMissing, from, length, name);
        if (!need_fresh(x)) return false;
        const auto i = static_cast<std::size_t>(place(0));
        AxisValues met = path.programmed;
        for (unsigned k = 0; k < x.core.view().axis_count; ++k)
            if (x.core.measured() >> k & 1u) met[k] = x.core.skip_point(k);
        if (name == "$AA_MW")
            value = Value::of_real(shown(place(0), met[i]));
        else
            value = Value::of_real(x.core.machine_now(static_cast<unsigned>(i)) +
                                   x.core.framed(met)[i] - x.core.framed(path.programmed)[i]);
        return true;
    }
    // what DELDTG or MEAS has deleted of the way (sinumerik_part3 8)
    if (name == "$AA_DELT" || name == "$AC_DELT") {
        if (name == "$AA_DELT" && (place(0) < 0 || place(0) >= kSpindleAxis))
            return fail_at(x, Alarm::AxisArgumentMissing, from, length, name);
        if (!need_fresh(x)) return false;
        double sum = 0.0;
        for (unsigned k = 0; k < x.core.view().axis_count; ++k) {
            const double left = x.modal.travel_limited ? x.modal.travel_left[k]
                                : x.core.measured() != 0
                                    ? x.modal.measured_to[k] - x.core.skip_point(k)
                                    : 0.0;
            sum += left * left;
            if (name == "$AA_DELT" && place(0) == static_cast<int>(k)) {
                value = Value::of_real(shown(place(0), left));
                return true;
            }
        }
        value = Value::of_real(std::sqrt(sum));
        return true;
    }
    if (name == "$AC_MEA")
        return need_fresh(x) && (value = Value::of_int(x.core.measured() != 0), true);
    if (name == "$A_YEAR" || name == "$A_MONTH" || name == "$A_DAY" || name == "$A_HOUR" ||
        name == "$A_MINUTE" || name == "$A_SECOND") {
        if (!need_fresh(x)) return false;
        x.core.did();  // time goes on by itself
        const CalendarTime now = x.core.port().clock();
        const int part = name == "$A_YEAR"     ? now.year
                         : name == "$A_MONTH"  ? now.month
                         : name == "$A_DAY"    ? now.day
                         : name == "$A_HOUR"   ? now.hour
                         : name == "$A_MINUTE" ? now.minute
                                               : now.second;
        value = Value::of_int(part);
        return true;
    }
    if (name == "$AN_LANGUAGE_ON_HMI") {                    // sinumerik_part3 10
        static constexpr int kNumbers[] = {3, 57, 28, 18};  // English, Russian, Czech, Hungarian
        const auto chosen = display_language_of(
            params::get_text(x.core.view().table(), params::pt_display_language));
        value = Value::of_int(
            kNumbers[static_cast<std::size_t>(chosen.value_or(display_language_now()))]);
        return true;
    }
    if (name.starts_with("$TC_")) return tool_value(x, name, indices, from, length, value);
    // what a program has written: a retraction that ends the channel does not come back to it
    if (name == "$AC_LIFTFAST") {
        const auto found = x.names.system.find(name);
        value = Value::of_int(found == x.names.system.end() ? 0.0 : found->second.number);
        return true;
    }
    if (name == "$AC_MARKER" || name == "$AC_PARAM" || name == "$A_IN" || name == "$A_OUT") {
        if (indices.size() != 1 || !indices[0].is_number())
            return fail_at(x, Alarm::ArrayIndexIllegal, from, length, name);
        if (!need_fresh(x)) return false;
        const std::string key =
            name + "[" + to_text(Value::of_int(std::nearbyint(indices[0].number))) + "]";
        if (const auto found = x.names.system.find(key); found != x.names.system.end())
            value = found->second;
        else if (const auto given = x.core.port().given_variable(key))
            value = Value::of_real(*given);
        else if (const double n = indices[0].number; name == "$A_IN" && n >= 1 && n <= 32)
            // as macros' #1000
            value = Value::of_real(
                x.core.port().interface_value(static_cast<std::int32_t>(999 + std::nearbyint(n))));
        else
            value = Value::of_real(0.0);
        if (name != "$AC_PARAM")
            value = name == "$AC_MARKER" ? Value::of_int(value.number)
                                         : Value::of_bool(value.number != 0);
        return true;
    }
    if (bool known = false; !geometry_value(x, name, indices, value, known)) {
        x.blame.column = x.line.cursor.column(from);
        x.blame.length = length;
        return false;
    } else if (known)
        return true;
    if (bool known = false; !configuration_value(x, name, indices, from, length, value, known))
        return false;
    else if (known)
        return true;
    DataCell data;
    if (!data_cell(x, name, indices, from, length, data)) return false;
    if (data.row) {
        if (data.row->type == params::Type::Text) {
            value = Value::of_text(std::string(params::text_at(x.core.view().table(), data.slot)));
            return true;
        }
        const double cell = x.core.view().table().numbers[data.slot];
        value = data.row->type == params::Type::Real ? Value::of_real(cell) : Value::of_int(cell);
        return true;
    }
    if (is_system_variable(name)) return fail_at(x, Alarm::NotBuilt, from, length, name);
    return unknown();
}

// $NAME[..] = value in a block of its own or among other words.
bool parse_system_assignment(Execution& x) {
    const char* const from = x.line.cursor.at();
    std::string name;
    std::vector<Value> indices;
    if (!system_name(x, name, indices)) return false;
    const auto length = static_cast<std::size_t>(x.line.cursor.at() - from);
    if (!x.line.cursor.at_assign()) return syntax(x, x.line.cursor.at(), "=");
    x.line.cursor.advance(1);
    const char* const at = x.line.cursor.at();
    Value value;
    return expression(x, value) &&
           write_system(x, name, indices, std::move(value), from, length, at);
}

// `from`, `length`: where the name is, `at`: the value.
bool write_system(Execution& x, const std::string& name, const std::vector<Value>& indices,
                  Value value, const char* from, std::size_t length, const char* at) {
    x.core.did();
    const auto key = [&] {
        return name + "[" + to_text(Value::of_int(std::nearbyint(indices[0].number))) + "]";
    };
    if (name == "$TC_TP2" || name == "$TC_TP_MAX_VELO" || grinding_parameter(name)) {
        if (indices.size() != 1 || !indices[0].is_number())
            return fail_at(x, Alarm::ArrayIndexMissing, from, length, name);
        const auto number = static_cast<std::int64_t>(indices[0].number);
        if (number < 1 || number > 32000)
            return fail_at(x, Alarm::ArrayIndexIllegal, from, length, name, indices[0].number);
        if (!convert(value, name == "$TC_TP2" ? Type::String : Type::Real))
            return fail_at(x, Alarm::ConversionImpossible, at, 1, name);
        const bool exists = x.tools.table.contains(number);
        undo(x, [&x, number, exists, before = exists ? x.tools.table[number] : Tool{}] {
            if (exists)
                x.tools.table[number] = before;
            else
                x.tools.table.erase(number);
        });
        if (name == "$TC_TP2")
            x.tools.table[number].name = value.text;
        else if (const int n = grinding_parameter(name))
            x.tools.table[number].grinding[static_cast<std::size_t>(n)] = value.number;
        else
            x.tools.table[number].max_velocity = value.number;
        return true;
    }
    if (name.starts_with("$TC_MOP") || name == "$TC_TP9") {
        if (!convert(value, Type::Real))
            return fail_at(x, Alarm::ConversionImpossible, at, 1, name);
        return write_monitoring(x, name, indices, from, length, value);
    }
    if (name.starts_with("$TC_")) {
        double* cell = nullptr;
        if (!convert(value, Type::Real))
            return fail_at(x, Alarm::ConversionImpossible, at, 1, name);
        if (!edge_cell(x, name, indices, from, length, true, cell)) return false;
        undo(x, [cell, before = *cell] { *cell = before; });
        *cell = value.number;
        x.changes.written.push_back(
            {fmt::format("{}[{:.0f},{:.0f}]", name, indices[0].number, indices[1].number), value});
        return true;
    }
    if (name == "$AA_OFF")
        return convert(value, Type::Real) ? write_overlay(x, name, indices, from, length, value)
                                          : fail_at(x, Alarm::ConversionImpossible, at, 1, name);
    if (name == "$AC_LIFTFAST" && indices.empty() && value.is_number()) {
        undo(x, [&x, before = x.names.system["$AC_LIFTFAST"]] {
            x.names.system["$AC_LIFTFAST"] = before;
        });
        x.names.system["$AC_LIFTFAST"] = Value::of_int(value.number);
        return true;
    }
    if (name == "$AC_MARKER" || name == "$AC_PARAM" || name == "$A_OUT") {
        if (indices.size() != 1 || !indices[0].is_number())
            return fail_at(x, Alarm::ArrayIndexIllegal, from, length, name);
        if (!convert(value, name == "$AC_MARKER" ? Type::Int
                            : name == "$A_OUT"   ? Type::Bool
                                                 : Type::Real))
            return fail_at(x, Alarm::ConversionImpossible, at, 1, name);
        const std::string slot = key();
        const auto found = x.names.system.find(slot);
        undo(x, [&x, slot, had = found != x.names.system.end(),
                 before = found != x.names.system.end() ? found->second : Value{}] {
            if (had)
                x.names.system[slot] = before;
            else
                x.names.system.erase(slot);
        });
        x.names.system[slot] = value;
        x.changes.written.push_back({slot, value});
        return true;
    }
    if (bool known = false; !write_geometry(x, name, indices, value, known)) {
        x.blame.column = x.line.cursor.column(from);
        x.blame.length = length;
        return false;
    } else if (known)
        return true;
    if (is_data_name(name) && !name.starts_with("$S"))
        return fail_at(x, Alarm::SystemVariableReadOnly, from, length, name);
    DataCell data;
    if (!data_cell(x, name, indices, from, length, data)) return false;
    if (data.row) {
        if (!convert(value, data.row->type == params::Type::Real ? Type::Real : Type::Int))
            return fail_at(x, Alarm::ConversionImpossible, at, 1, name);
        return write_data(x, data, name, value.number, from, length);
    }
    if (is_system_variable(name))
        return fail_at(x, Alarm::SystemVariableReadOnly, from, length, name);
    return fail_at(x, Alarm::SystemVariableUnknown, from, length, name);
}

}  // namespace polyturn::channels::sinumerik
