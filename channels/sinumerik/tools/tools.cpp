// T, D, M6, TOFF: which tool and edge hold, and along which axes its lengths lie (sinumerik_part1 5
// and 6).
#include <fmt/format.h>

#include <cmath>

#include "channels/sinumerik/interpreter.hpp"
#include "ipc/machine/store/edge_lengths.hpp"

namespace polyturn::channels::sinumerik {

bool Interpreter::tool_words() {
    const Word* tool = word("T");
    const Word* edge = word("D");
    if (tool && !select_tool(*tool)) return false;
    if (edge && !changes_tool()) {
        if (edge->number() != std::floor(edge->number()))
            return fail_word(Alarm::PointForbidden, *edge, "D");
        fault_column_ = edge->column;
        fault_length_ = edge->length;
        if (!select_edge(static_cast<int>(edge->number()))) return false;
        fault_column_ = fault_length_ = 0;
    }
    return true;
}

// M6 in the block, where it changes the tool.
bool Interpreter::changes_tool() const {
    if (!settings_.tool_by_m6) return false;
    for (const Word& word : block_.words)
        if (word.address->name == "M" &&
            word.number() == static_cast<double>(settings_.tool_change_m))
            return true;
    return false;
}

bool Interpreter::select_tool(const Word& word) {
    std::int64_t number = 0;
    // T has been output already (managed_tools.cpp); with M6 the tool is known behind the change
    if (managed()) {
        modal_.tool_selected =
            settings_.tool_by_m6 ? 0
                                 : core_.port().tool_at_work().value_or(Port::ToolAtWork{}).number;
        return settings_.tool_by_m6 ? true : change_tool();
    }
    if (word.value.type == Type::String) {
        for (const auto& [n, tool] : tools_)
            if (tool.name == word.value.text && !word.value.text.empty()) {
                number = n;
                break;
            }
        if (!number) return fail_word(Alarm::ToolUnknown, word, word.value.text);
    } else {
        if (word.number() != std::floor(word.number()))
            return fail_word(Alarm::PointForbidden, word, "T");
        if (word.number() > 32000) return fail_word(Alarm::ToolUnknown, word, to_text(word.value));
        number = static_cast<std::int64_t>(word.number());
        if (number && !settings_.tool_checked_late && !tools_.contains(number))
            return fail_word(Alarm::ToolUnknown, word, to_text(word.value));
    }
    core_.aux('T', static_cast<double>(number), fmt::format("T{}", number), false);
    modal_.tool_selected = number;
    // T0 deselects the tool at once on either machine (5.1)
    return settings_.tool_by_m6 && number != 0 ? true : change_tool();
}

bool Interpreter::change_tool() {
    if (modal_.tool_selected < 0) return true;
    if (managed())
        modal_.tool_selected = core_.port().tool_at_work().value_or(Port::ToolAtWork{}).number;
    modal_.tool = modal_.tool_selected;
    modal_.tool_selected = -1;
    const auto found = tools_.find(modal_.tool);
    ToolRef& ref = core_.path.tool.ref;
    ref.number = modal_.tool;
    ref.name = found == tools_.end() ? std::string_view{} : std::string_view(found->second.name);
    // the block says it itself
    if (const Word* edge = word("D"))
        return !settings_.tool_by_m6 || select_edge(static_cast<int>(edge->number()));
    if (settings_.default_edge == -2) return true;  // the old offset holds until D
    int edge = modal_.tool == 0 ? 0 : settings_.default_edge;
    if (edge > 0 && found != tools_.end() && !edge_of_d(found->second, edge))
        return fail(Alarm::EdgeUnknown, std::to_string(modal_.tool), edge);
    if (edge > 0 && found == tools_.end()) edge = 0;
    return select_edge(edge);
}

bool Interpreter::select_edge(int edge) {
    const auto found = tools_.find(modal_.tool);
    if (edge > 0) {
        if (found == tools_.end()) {
            if (modal_.tool != 0 || !tools_.empty())
                return fail(Alarm::ToolUnknown, std::to_string(modal_.tool));
            return fail(Alarm::EdgeUnknown, std::to_string(modal_.tool), edge);
        }
        if (!edge_of_d(found->second, edge))
            return fail(Alarm::EdgeUnknown, std::to_string(modal_.tool), edge);
    }
    modal_.edge = edge;
    modal_.sum_offset = 0;
    core_.path.tool.ref.edge = edge;
    // changed values wait for the next T or D
    modal_.edge_data =
        edge > 0
            ? std::make_shared<const Edge>(found->second.edges.at(edge_of_d(found->second, edge)))
            : nullptr;
    modal_.teeth = modal_.edge_data ? modal_.edge_data->teeth : 0.0;
    apply_tool();
    return refresh_cutting_speeds();
}

// Of the active edge, with SD42940 and SD42950.
std::array<int, 3> Interpreter::axes_of_lengths() const {
    const int assigned = settings_.length_type ? settings_.length_type
                         : modal_.edge_data    ? static_cast<int>(modal_.edge_data->dp[1])
                                               : 0;
    unsigned plane = static_cast<unsigned>(core_.path.plane);
    if (settings_.length_const >= 17 && settings_.length_const <= 19)
        plane = static_cast<unsigned>(settings_.length_const - 17);
    return axes_of_edge(assigned, plane);
}

// LENTOAX(VAR ind[3], VAR mat[3,3][, system]): which length acts along abscissa, ordinate and
// applicate (sinumerik_part3 9.8; numbers, signs and answers as on the real control: 0 the indices
// say all, 1 a length lies across the axes, -1 no such system, -2 no edge is active). Rows of the
// matrix: abscissa, ordinate, applicate; columns: L1, L2, L3. In the workpiece system a rotation
// turns it.
bool Interpreter::f_lentoax(Call& c) {
    constexpr double kAlong = 1.0 - 1e-9;
    const std::string system =
        c.has(2) && !c.value(2).text.empty() ? upper(c.value(2).text) : "WCS";
    const bool turned = system == "WCS" || system == "W";
    Variable& indices = *c.arguments[0].reference.variable;
    Variable& matrix = *c.arguments[1].reference.variable;
    if (indices.cells.size() < 3 || matrix.cells.size() < 9)
        return fail(Alarm::FunctionArgument, "LENTOAX", 1);
    if (!turned && system != "MCS" && system != "M" && system != "BCS" && system != "B") {
        c.result = Value::of_int(-1);
        return true;
    }
    if (!modal_.edge_data) {
        c.result = Value::of_int(-2);
        return true;
    }
    const std::array<int, 3> axes = axes_of_lengths();
    // X Y Z, Z X Y, Y Z X
    static constexpr int kOfPlane[3][3] = {{0, 1, 2}, {2, 0, 1}, {1, 2, 0}};
    const auto& plane = kOfPlane[static_cast<std::size_t>(core_.path.plane)];
    const auto& linear = core_.path.frame.linear;
    bool across = false;
    for (std::size_t row = 0; row < 3; ++row) {
        double index = 0;
        for (std::size_t k = 0; k < 3; ++k) {
            double part = axes[k] == plane[row] ? 1.0 : 0.0;
            // the part of that axis along the one of the workpiece
            if (turned && core_.path.framed && axes[k] >= 0) {
                const auto to = static_cast<std::size_t>(plane[row]),
                           of = static_cast<std::size_t>(axes[k]);
                const double size =
                    std::sqrt(linear[0][to] * linear[0][to] + linear[1][to] * linear[1][to] +
                              linear[2][to] * linear[2][to]);
                part = size > 0 ? linear[of][to] / size : 0.0;
            }
            if (std::fabs(part) >= kAlong)
                index = (part > 0 ? 1.0 : -1.0) * static_cast<double>(k + 1);
            else if (std::fabs(part) > 1e-9)
                across = true;
            store({c.arguments[1].reference.variable, row * 3 + k, false}, Value::of_real(part));
        }
        store({c.arguments[0].reference.variable, row, false}, Value::of_int(index));
    }
    c.result = Value::of_int(across ? 1 : 0);
    return true;
}

// Lengths become a shift of their axes: an axis takes it along with its next word.
void Interpreter::apply_tool() {
    ToolState& state = core_.path.tool;
    const Edge* const edge = modal_.edge_data.get();
    const int type = edge ? static_cast<int>(edge->dp[1]) : 0;
    const std::array<int, 3> axes = axes_of_lengths();
    static constexpr PlaneRole kRoles[] = {PlaneRole::BasicX, PlaneRole::BasicY, PlaneRole::BasicZ};
    AxisValues shift{};
    const auto sum = static_cast<std::size_t>(modal_.sum_offset);  // DL
    const auto add = [&](int geometry, double mm) {
        if (geometry < 0) return;
        if (const int place = core_.view().axis_by_role(kRoles[geometry]); place >= 0)
            shift[static_cast<std::size_t>(place)] += mm;
    };
    for (std::size_t i = 0; i < 3; ++i) {
        modal_.length_mm[i] = edge ? edge->dp[3 + i] + edge->dp[12 + i] + edge->dp[21 + i] : 0.0;
        if (edge && modal_.sum_offset > 0)
            modal_.length_mm[i] += edge->sum[sum][3 + i] + edge->setup[sum][3 + i];
        if (!edge) continue;
        add(axes[i], modal_.length_mm[i]);
        if (!modal_.toff_by_axis) add(axes[i], modal_.toff.length_mm[i]);
    }
    if (edge && modal_.toff_by_axis)
        for (int g = 0; g < 3; ++g) add(g, modal_.toff.length_mm[static_cast<std::size_t>(g)]);
    // turning and grinding: the edge has a position
    const bool tipped = type >= 400 && type < 600;
    const bool wear_only = active(22) == 9 || active(22) == 10;  // CUT2DD CUT2DFD
    state.nose_radius = edge ? edge->dp[6] + edge->dp[15] : 0.0;
    if (edge && modal_.sum_offset > 0) state.nose_radius += edge->sum[sum][6] + edge->setup[sum][6];
    // OFFN and TOFFR widen the distance to the contour; the tip stays where the nose has it (6.8
    // rule 5, 11.1).
    state.allowance = modal_.geo.allowance;
    if (edge) state.allowance += modal_.toff.radius_mm - (wear_only ? edge->dp[6] : 0.0);
    state.geometry = edge || modal_.geo.allowance != 0.0 ? 1 : 0;
    state.tip = edge && tipped ? static_cast<std::int32_t>(edge->dp[2]) : edge ? 9 : 0;
    state.nose_off = edge == nullptr && modal_.geo.allowance == 0.0;
    const AxisValues before = core_.path.programmed;
    core_.set_shift(shift);
    for (unsigned i = 0; i < core_.view().axis_count; ++i)
        modal_.pending_tool[i] += before[i] - core_.path.programmed[i];
}

bool Interpreter::a_tool_length_offset(const Word& word) {
    if (has("TOFF")) return fail_word(Alarm::CodesContradict, word, "TOFFL, TOFF");
    const std::int32_t n = word.index <= 0 ? 1 : word.index;
    if (n > 3) return fail_word(Alarm::ArrayIndexIllegal, word, "TOFFL", n);
    for (const Word& other : block_.words)
        if (&other != &word && other.address == word.address &&
            (other.index <= 0 ? 1 : other.index) == n)
            return fail_word(Alarm::AddressTwice, word, "TOFFL");
    if (modal_.toff_by_axis) {
        modal_.toff.length_mm = {};
        modal_.toff_by_axis = false;
    }
    modal_.toff.length_mm[static_cast<std::size_t>(n - 1)] = word.number() * unit();
    apply_tool();
    return true;
}

bool Interpreter::a_tool_axis_offset(const Word& word) {
    if (has("TOFFL")) return fail_word(Alarm::CodesContradict, word, "TOFFL, TOFF");
    static constexpr PlaneRole kRoles[] = {PlaneRole::BasicX, PlaneRole::BasicY, PlaneRole::BasicZ};
    for (std::size_t g = 0; g < 3; ++g) {
        if (core_.view().axes[static_cast<std::size_t>(word.axis)].role != kRoles[g]) continue;
        if (!modal_.toff_by_axis) {
            modal_.toff.length_mm = {};
            modal_.toff_by_axis = true;
        }
        modal_.toff.length_mm[g] = word.number() * unit();
        apply_tool();
        return true;
    }
    return fail_word(Alarm::AxisKindWrong, word, axis_name(word.axis));
}

// DL: which of the edge's sum and set-up offsets ($TC_SCP, $TC_ECP) count besides its values; D
// takes it back.
bool Interpreter::a_sum_offset(const Word& word) {
    const double n = word.number();
    if (n != std::floor(n) || n > 6) return fail_word(Alarm::ValueOutOfRange, word, "DL", n);
    if (n > 0 && !modal_.edge_data)
        return fail_word(Alarm::EdgeUnknown, word, std::to_string(modal_.tool), modal_.edge);
    modal_.sum_offset = static_cast<int>(n);
    apply_tool();
    return true;
}

bool Interpreter::a_tool_radius_offset(const Word& word) {
    modal_.toff.radius_mm = word.number() * unit();
    apply_tool();
    return true;
}

}  // namespace polyturn::channels::sinumerik
