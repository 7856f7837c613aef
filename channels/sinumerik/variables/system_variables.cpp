// System variables: $P_ what the program has brought about, $TC_ tool data, $A what the machine
// says now, $MN $MC $MA $SC $SA machine and setting data. A live value is read at a barrier only
// (sinumerik_part2 15.8).
#include <fmt/format.h>

#include <cmath>
#include <numbers>

#include "channels/sinumerik/interpreter.hpp"
#include "ipc/diagnosis/display_language.hpp"

namespace polyturn::channels::sinumerik {
namespace {

constexpr int kMostEdges = 12;  // of a tool (sinumerik_part1 6.6)

// $TC_DP3 -> 3 for the prefix $TC_DP; -1: another name.
int parameter_of(std::string_view name, std::string_view prefix) {
    if (!name.starts_with(prefix) || name.size() == prefix.size() ||
        name.size() > prefix.size() + 3)
        return -1;
    int number = 0;
    for (const char c : name.substr(prefix.size())) {
        if (!is_digit(c)) return -1;
        number = number * 10 + (c - '0');
    }
    return number;
}

// $TC_TPG1 to $TC_TPG9: its number; 0 another name.
int grinding_parameter(std::string_view name) {
    return name.size() == 8 && name.starts_with("$TC_TPG") && name[7] >= '1' && name[7] <= '9'
               ? name[7] - '0'
               : 0;
}

}  // namespace

// The name behind $ and its indices; the cursor is at $.
bool Interpreter::system_name(std::string& name, std::vector<Value>& indices) {
    const char* const from = cursor_.at();
    cursor_.advance(1);
    const std::string_view word = cursor_.name_ahead();
    if (word.empty() || cursor_.at() != from + 1) return syntax(from, "$");
    name = "$" + upper(word);
    cursor_.advance(word.size());
    indices.clear();
    return cursor_.peek() != '[' || index_list(indices);
}

bool Interpreter::is_system_variable(std::string_view name) const {
    static constexpr std::string_view kNames[] = {"$PI",
                                                  "$P_GG",
                                                  "$P_F",
                                                  "$P_S",
                                                  "$P_SDIR",
                                                  "$P_TOOLNO",
                                                  "$P_TOOL",
                                                  "$P_TOOLR",
                                                  "$P_TOOLL",
                                                  "$P_TOOLND",
                                                  "$P_EP",
                                                  "$P_TOFF",
                                                  "$P_TOFFL",
                                                  "$P_TOFFR",
                                                  "$P_FZ",
                                                  "$P_F_TYPE",
                                                  "$P_MSNUM",
                                                  "$P_CHANNO",
                                                  "$P_PROG",
                                                  "$P_LINENO",
                                                  "$P_STACK",
                                                  "$P_REPINF",
                                                  "$P_ISTEST",
                                                  "$P_SEARCH",
                                                  "$P_AXN1",
                                                  "$P_AXN2",
                                                  "$P_AXN3",
                                                  "$P_AD",
                                                  "$P_DRYRUN",
                                                  "$P_SVC",
                                                  "$P_S_TYPE",
                                                  "$P_GWPS",
                                                  "$PA_FGROUP",
                                                  "$PA_FGREF",
                                                  "$P_FGROUP_MASK",
                                                  "$AC_FGROUP_MASK",
                                                  "$AA_FGROUP",
                                                  "$AA_FGREF",
                                                  "$AC_TOFF",
                                                  "$AC_TOFFL",
                                                  "$AC_TOFFR",
                                                  "$AC_FZ",
                                                  "$AC_F_TYPE",
                                                  "$AC_SVC",
                                                  "$AC_S_TYPE",
                                                  "$P_APR",
                                                  "$P_AEP",
                                                  "$P_APDV",
                                                  "$P_PFRAME",
                                                  "$P_ACTFRAME",
                                                  "$P_IFRAME",
                                                  "$P_ACTBFRAME",
                                                  "$P_BFRAME",
                                                  "$P_CHBFRAME",
                                                  "$P_GFRAME",
                                                  "$P_GFR",
                                                  "$AC_LIFTFAST",
                                                  "$AA_ACC",
                                                  "$AA_IM",
                                                  "$AA_IW",
                                                  "$AA_MM",
                                                  "$AA_MW",
                                                  "$AC_MEA",
                                                  "$AC_DELT",
                                                  "$AA_DELT",
                                                  "$AA_IB",
                                                  "$AA_FXS",
                                                  "$AA_S",
                                                  "$AC_MARKER",
                                                  "$AC_PARAM",
                                                  "$AC_TIME",
                                                  "$A_YEAR",
                                                  "$A_MONTH",
                                                  "$A_DAY",
                                                  "$A_HOUR",
                                                  "$A_MINUTE",
                                                  "$A_SECOND",
                                                  "$A_IN",
                                                  "$A_OUT",
                                                  "$AN_LANGUAGE_ON_HMI",
                                                  "$AA_OFF",
                                                  "$AA_OFF_VAL",
                                                  "$AA_LEAD_SP",
                                                  "$AA_LEAD_SV",
                                                  "$AA_ESR_TRIGGER",
                                                  "$P_TOOLFRAME",
                                                  "$P_ACTID",
                                                  "$P_UIFR",
                                                  "$P_UIFRNUM",
                                                  "$P_NUM_SPINDLES"};
    for (const std::string_view known : kNames)
        if (known == name) return true;
    return name.starts_with("$TC_DP") || name.starts_with("$TC_MOP") || name == "$TC_TP9" ||
           name == "$TC_TP2" || name == "$TC_TP_MAX_VELO" || grinding_parameter(name);
}

bool Interpreter::system_value(Value& value) {
    const char* const from = cursor_.at();
    Reference reference;
    if (!reference_ahead(reference)) return false;
    if (reference) {  // $R5
        value = reference.cell();
        return true;
    }
    std::string name;
    std::vector<Value> indices;
    if (!system_name(name, indices)) return false;
    const auto length = static_cast<std::size_t>(cursor_.at() - from);
    const auto unknown = [&] { return fail_at(Alarm::SystemVariableUnknown, from, length, name); };
    const auto number = [&](std::size_t i) { return i < indices.size() ? indices[i].number : 0.0; };
    const auto place = [&](std::size_t i) {
        return i < indices.size() && indices[i].type == Type::Axis &&
                       indices[i].place() < kSpindleAxis
                   ? indices[i].place()
                   : -1;
    };
    const auto shown = [&](int axis, double mm) {
        return counts_diameter(static_cast<unsigned>(axis), false) ? mm * 2 : mm;
    };
    const PathState& path = core_.path;

    if (name == "$PI") {
        value = Value::of_real(std::numbers::pi);
        return true;
    }
    if (name == "$P_GG") {
        const auto group = static_cast<unsigned>(number(0));
        if (indices.size() != 1 || group < 1 || group >= kGroups)
            return fail_at(Alarm::ArrayIndexIllegal, from, length, name, number(0));
        value = Value::of_int(modal_.active[group]);
        return true;
    }
    if (name == "$P_F") {
        value = Value::of_real(modal_.feed);
        return true;
    }
    if (name == "$P_S" || name == "$P_SDIR" || name == "$AA_S") {
        if (name == "$AA_S" && !need_fresh()) return false;
        const double spindle = indices.empty() || number(0) == 0 ? modal_.master_spindle
                               : indices[0].type == Type::Axis   ? indices[0].place() - kSpindleAxis
                                                                 : number(0);
        if (!(spindle >= 1 && spindle <= kMaxSpindles))
            return fail_at(Alarm::ArrayIndexIllegal, from, length, name, spindle);
        const auto kept = modal_.spindles.find(static_cast<std::uint16_t>(spindle));
        const SpindleState state = spindle == path.spindle.spindle ? path.spindle
                                   : kept != modal_.spindles.end() ? kept->second
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
                                       : modal_.asked_rpm[static_cast<std::size_t>(spindle)]);
        return true;
    }
    if (name == "$P_TOOLNO") {
        value = Value::of_int(static_cast<double>(modal_.tool));
        return true;
    }
    if (name == "$P_TOOL") {
        value = Value::of_int(modal_.edge);
        return true;
    }
    if (name == "$P_TOOLR") {
        value = Value::of_real(path.tool.nose_radius + path.tool.allowance - modal_.geo.allowance);
        return true;
    }
    if (name == "$P_TOOLL") {
        const double i = number(0);
        if (!(i >= 1 && i <= 3)) return fail_at(Alarm::ArrayIndexIllegal, from, length, name, i);
        value = Value::of_real(modal_.length_mm[static_cast<std::size_t>(i) - 1]);
        return true;
    }
    if (bool known = false; !feed_value(name, indices, from, length, value, known))
        return false;
    else if (known)
        return true;
    if (name == "$P_UIFRNUM") {
        value = Value::of_int(active(8) - 1.0);
        return true;
    }
    if (name == "$P_MSNUM") {
        value = Value::of_int(modal_.master_spindle);
        return true;
    }
    if (name == "$P_CHANNO") {
        value = Value::of_int(core_.view().channel);
        return true;
    }
    if (name == "$P_STACK") {
        value = Value::of_int(core_.at.stack_depth);
        return true;
    }
    if (name == "$P_EP") {
        if (place(0) < 0) return fail_at(Alarm::AxisArgumentMissing, from, length, name);
        value = Value::of_real(
            shown(place(0), path.programmed[static_cast<std::size_t>(place(0))]) / unit());
        return true;
    }
    if (name == "$AA_OFF" || name == "$AA_OFF_VAL") {
        if (place(0) < 0 || place(0) >= kSpindleAxis)
            return fail_at(Alarm::AxisArgumentMissing, from, length, name);
        return need_fresh() &&
               (value = Value::of_real(path.wanted[static_cast<std::size_t>(place(0))]), true);
    }
    if (name == "$AA_FXS") {
        if (place(0) < 0 || place(0) >= kSpindleAxis)
            return fail_at(Alarm::AxisArgumentMissing, from, length, name);
        value = Value::of_int(core_.stops_met() >> place(0) & 1u);
        return true;
    }
    if (name == "$AA_IM" || name == "$AA_IW" || name == "$AA_IB") {
        if (place(0) < 0) return fail_at(Alarm::AxisArgumentMissing, from, length, name);
        if (!need_fresh()) return false;
        const auto i = static_cast<std::size_t>(place(0));
        if (name == "$AA_IW")
            value = Value::of_real(shown(place(0), path.programmed[i]));
        else
            // what PRESETON has called it (sinumerik_part3 7.1)
            value = Value::of_real(core_.machine_now(static_cast<unsigned>(i)) - path.preset[i]);
        return true;
    }
    // where the probe of MEAS stopped the axis, before braking; else its position
    if (name == "$AA_MM" || name == "$AA_MW") {
        if (place(0) < 0 || place(0) >= kSpindleAxis)
            return fail_at(Alarm::AxisArgumentMissing, from, length, name);
        if (!need_fresh()) return false;
        const auto i = static_cast<std::size_t>(place(0));
        AxisValues met = path.programmed;
        for (unsigned k = 0; k < core_.view().axis_count; ++k)
            if (core_.measured() >> k & 1u) met[k] = core_.skip_point(k);
        if (name == "$AA_MW")
            value = Value::of_real(shown(place(0), met[i]));
        else
            value = Value::of_real(core_.machine_now(static_cast<unsigned>(i)) +
                                   core_.framed(met)[i] - core_.framed(path.programmed)[i]);
        return true;
    }
    // what DELDTG or MEAS has deleted of the way (sinumerik_part3 8)
    if (name == "$AA_DELT" || name == "$AC_DELT") {
        if (name == "$AA_DELT" && (place(0) < 0 || place(0) >= kSpindleAxis))
            return fail_at(Alarm::AxisArgumentMissing, from, length, name);
        if (!need_fresh()) return false;
        double sum = 0.0;
        for (unsigned k = 0; k < core_.view().axis_count; ++k) {
            const double left = modal_.travel_limited ? modal_.travel_left[k]
                                : core_.measured() != 0
                                    ? modal_.measured_to[k] - core_.skip_point(k)
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
        return need_fresh() && (value = Value::of_int(core_.measured() != 0), true);
    if (name == "$A_YEAR" || name == "$A_MONTH" || name == "$A_DAY" || name == "$A_HOUR" ||
        name == "$A_MINUTE" || name == "$A_SECOND") {
        if (!need_fresh()) return false;
        core_.did();  // time goes on by itself
        const CalendarTime now = core_.port().clock();
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
            params::get_text(core_.view().table(), params::pt_display_language));
        value = Value::of_int(
            kNumbers[static_cast<std::size_t>(chosen.value_or(display_language_now()))]);
        return true;
    }
    if (name.starts_with("$TC_")) return tool_value(name, indices, from, length, value);
    // what a program has written: a retraction that ends the channel does not come back to it
    if (name == "$AC_LIFTFAST") {
        const auto found = written_system_.find(name);
        value = Value::of_int(found == written_system_.end() ? 0.0 : found->second.number);
        return true;
    }
    if (name == "$AC_MARKER" || name == "$AC_PARAM" || name == "$A_IN" || name == "$A_OUT") {
        if (indices.size() != 1 || !indices[0].is_number())
            return fail_at(Alarm::ArrayIndexIllegal, from, length, name);
        if (!need_fresh()) return false;
        const std::string key =
            name + "[" + to_text(Value::of_int(std::nearbyint(indices[0].number))) + "]";
        if (const auto found = written_system_.find(key); found != written_system_.end())
            value = found->second;
        else if (const auto given = core_.port().given_variable(key))
            value = Value::of_real(*given);
        else if (const double n = indices[0].number; name == "$A_IN" && n >= 1 && n <= 32)
            // as macros' #1000
            value = Value::of_real(
                core_.port().interface_value(static_cast<std::int32_t>(999 + std::nearbyint(n))));
        else
            value = Value::of_real(0.0);
        if (name != "$AC_PARAM")
            value = name == "$AC_MARKER" ? Value::of_int(value.number)
                                         : Value::of_bool(value.number != 0);
        return true;
    }
    if (bool known = false; !geometry_value(name, indices, value, known)) {
        fault_column_ = cursor_.column(from);
        fault_length_ = length;
        return false;
    } else if (known)
        return true;
    if (bool known = false; !configuration_value(name, indices, from, length, value, known))
        return false;
    else if (known)
        return true;
    DataCell data;
    if (!data_cell(name, indices, from, length, data)) return false;
    if (data.row) {
        if (data.row->type == params::Type::Text) {
            value = Value::of_text(std::string(params::text_at(core_.view().table(), data.slot)));
            return true;
        }
        const double cell = core_.view().table().numbers[data.slot];
        value = data.row->type == params::Type::Real ? Value::of_real(cell) : Value::of_int(cell);
        return true;
    }
    if (is_system_variable(name)) return fail_at(Alarm::NotBuilt, from, length, name);
    return unknown();
}

// $TC_DPx[t,d], $TC_DPNT[t,d], $TC_SCPxy, $TC_ECPxy[t,d], $TC_TP2[t], $TC_TP_MAX_VELO[t]
bool Interpreter::tool_value(const std::string& name, const std::vector<Value>& indices,
                             const char* from, std::size_t length, Value& value) {
    const auto tool_number = indices.empty() ? -1 : static_cast<std::int64_t>(indices[0].number);
    if (name.starts_with("$TC_MOP") || name == "$TC_TP9") {
        std::string field;
        double now = 0;
        if (!monitoring(name, indices, from, length, field, now)) return false;
        value = name == "$TC_TP9" ? Value::of_int(now) : Value::of_real(now);
        return true;
    }
    const auto found = tools_.find(tool_number);
    if (name == "$TC_TP2") {
        value = Value::of_text(found == tools_.end() ? std::string() : found->second.name);
        return true;
    }
    if (name == "$TC_TP_MAX_VELO") {
        value = Value::of_real(found == tools_.end() ? 0.0 : found->second.max_velocity);
        return true;
    }
    if (const int n = grinding_parameter(name)) {
        value = Value::of_real(
            found == tools_.end() ? 0.0 : found->second.grinding[static_cast<std::size_t>(n)]);
        return true;
    }
    double* cell = nullptr;
    if (!edge_cell(name, indices, from, length, false, cell)) return false;
    const bool whole = name == "$TC_DP1" || name == "$TC_DP2";
    value = whole ? Value::of_int(cell ? *cell : 0.0) : Value::of_real(cell ? *cell : 0.0);
    return true;
}

// Where an edge keeps the parameter `name`; nullptr: the tool or edge does not exist (and shall not
// be made).
bool Interpreter::edge_cell(const std::string& name, const std::vector<Value>& indices,
                            const char* from, std::size_t length, bool make, double*& cell) {
    cell = nullptr;
    if (indices.size() != 2 || !indices[0].is_number() || !indices[1].is_number())
        return fail_at(Alarm::ArrayIndexMissing, from, length, name);
    const auto number = static_cast<std::int64_t>(indices[0].number);
    const int d = static_cast<int>(indices[1].number);
    if (number < 1 || number > 32000)
        return fail_at(Alarm::ArrayIndexIllegal, from, length, name, indices[0].number);
    if (d < 1 || d > kMostEdges)
        return fail_at(Alarm::ArrayIndexIllegal, from, length, name, indices[1].number);
    const int parameter = parameter_of(name, "$TC_DP"), sum = parameter_of(name, "$TC_SCP"),
              setup = parameter_of(name, "$TC_ECP");
    const bool teeth = name == "$TC_DPNT";
    const bool known = teeth || (parameter >= 1 && parameter < static_cast<int>(kEdgeParameters)) ||
                       (sum >= 10 && sum < 70) || (setup >= 10 && setup < 70);
    if (!known) return fail_at(Alarm::SystemVariableUnknown, from, length, name);
    auto tool = tools_.find(number);
    if (tool == tools_.end() || !tool->second.edges.contains(d)) {
        if (!make) return true;
        const bool new_tool = tool == tools_.end();
        undo([this, number, d, new_tool] {
            if (new_tool)
                tools_.erase(number);
            else
                tools_[number].edges.erase(d);
        });
        tool = tools_.try_emplace(number).first;
        tool->second.edges[d];
    }
    Edge& edge = tool->second.edges[d];
    if (teeth)
        cell = &edge.teeth;
    else if (parameter >= 1)
        cell = &edge.dp[static_cast<std::size_t>(parameter)];
    else if (sum >= 10)
        cell = &edge.sum[static_cast<std::size_t>(sum / 10)][static_cast<std::size_t>(sum % 10)];
    else
        cell =
            &edge.setup[static_cast<std::size_t>(setup / 10)][static_cast<std::size_t>(setup % 10)];
    return true;
}

// $NAME[..] = value in a block of its own or among other words.
bool Interpreter::parse_system_assignment() {
    const char* const from = cursor_.at();
    std::string name;
    std::vector<Value> indices;
    if (!system_name(name, indices)) return false;
    const auto length = static_cast<std::size_t>(cursor_.at() - from);
    if (!cursor_.at_assign()) return syntax(cursor_.at(), "=");
    cursor_.advance(1);
    const char* const at = cursor_.at();
    Value value;
    return expression(value) && write_system(name, indices, std::move(value), from, length, at);
}

// `from`, `length`: where the name is, `at`: the value.
bool Interpreter::write_system(const std::string& name, const std::vector<Value>& indices,
                               Value value, const char* from, std::size_t length, const char* at) {
    core_.did();
    const auto key = [&] {
        return name + "[" + to_text(Value::of_int(std::nearbyint(indices[0].number))) + "]";
    };
    if (name == "$TC_TP2" || name == "$TC_TP_MAX_VELO" || grinding_parameter(name)) {
        if (indices.size() != 1 || !indices[0].is_number())
            return fail_at(Alarm::ArrayIndexMissing, from, length, name);
        const auto number = static_cast<std::int64_t>(indices[0].number);
        if (number < 1 || number > 32000)
            return fail_at(Alarm::ArrayIndexIllegal, from, length, name, indices[0].number);
        if (!convert(value, name == "$TC_TP2" ? Type::String : Type::Real))
            return fail_at(Alarm::ConversionImpossible, at, 1, name);
        const bool exists = tools_.contains(number);
        undo([this, number, exists, before = exists ? tools_[number] : Tool{}] {
            if (exists)
                tools_[number] = before;
            else
                tools_.erase(number);
        });
        if (name == "$TC_TP2")
            tools_[number].name = value.text;
        else if (const int n = grinding_parameter(name))
            tools_[number].grinding[static_cast<std::size_t>(n)] = value.number;
        else
            tools_[number].max_velocity = value.number;
        return true;
    }
    if (name.starts_with("$TC_MOP") || name == "$TC_TP9") {
        if (!convert(value, Type::Real)) return fail_at(Alarm::ConversionImpossible, at, 1, name);
        return write_monitoring(name, indices, from, length, value);
    }
    if (name.starts_with("$TC_")) {
        double* cell = nullptr;
        if (!convert(value, Type::Real)) return fail_at(Alarm::ConversionImpossible, at, 1, name);
        if (!edge_cell(name, indices, from, length, true, cell)) return false;
        undo([cell, before = *cell] { *cell = before; });
        *cell = value.number;
        written_.push_back(
            {fmt::format("{}[{:.0f},{:.0f}]", name, indices[0].number, indices[1].number), value});
        return true;
    }
    if (name == "$AA_OFF")
        return convert(value, Type::Real) ? write_overlay(name, indices, from, length, value)
                                          : fail_at(Alarm::ConversionImpossible, at, 1, name);
    if (name == "$AC_LIFTFAST" && indices.empty() && value.is_number()) {
        undo([this, before = written_system_["$AC_LIFTFAST"]] {
            written_system_["$AC_LIFTFAST"] = before;
        });
        written_system_["$AC_LIFTFAST"] = Value::of_int(value.number);
        return true;
    }
    if (name == "$AC_MARKER" || name == "$AC_PARAM" || name == "$A_OUT") {
        if (indices.size() != 1 || !indices[0].is_number())
            return fail_at(Alarm::ArrayIndexIllegal, from, length, name);
        if (!convert(value, name == "$AC_MARKER" ? Type::Int
                            : name == "$A_OUT"   ? Type::Bool
                                                 : Type::Real))
            return fail_at(Alarm::ConversionImpossible, at, 1, name);
        const std::string slot = key();
        const auto found = written_system_.find(slot);
        undo([this, slot, had = found != written_system_.end(),
              before = found != written_system_.end() ? found->second : Value{}] {
            if (had)
                written_system_[slot] = before;
            else
                written_system_.erase(slot);
        });
        written_system_[slot] = value;
        written_.push_back({slot, value});
        return true;
    }
    if (bool known = false; !write_geometry(name, indices, value, known)) {
        fault_column_ = cursor_.column(from);
        fault_length_ = length;
        return false;
    } else if (known)
        return true;
    if (is_data_name(name) && !name.starts_with("$S"))
        return fail_at(Alarm::SystemVariableReadOnly, from, length, name);
    DataCell data;
    if (!data_cell(name, indices, from, length, data)) return false;
    if (data.row) {
        if (!convert(value, data.row->type == params::Type::Real ? Type::Real : Type::Int))
            return fail_at(Alarm::ConversionImpossible, at, 1, name);
        return write_data(data, name, value.number, from, length);
    }
    if (is_system_variable(name)) return fail_at(Alarm::SystemVariableReadOnly, from, length, name);
    return fail_at(Alarm::SystemVariableUnknown, from, length, name);
}

}  // namespace polyturn::channels::sinumerik
