// T, D, M6, TOFF: which tool and edge hold, and along which axes its lengths lie (sinumerik_part1 5
// and 6).
#include "channels/sinumerik/tools/tools.hpp"

#include <fmt/format.h>

#include <cmath>

#include "channels/sinumerik/axes/axis_names.hpp"
#include "channels/sinumerik/execution.hpp"
#include "channels/sinumerik/faults.hpp"
#include "channels/sinumerik/geometry/units.hpp"
#include "channels/sinumerik/grammar/groups.hpp"
#include "channels/sinumerik/grammar/words.hpp"
#include "channels/sinumerik/spindles/cutting_speeds.hpp"
#include "channels/sinumerik/tools/managed_tools.hpp"
#include "channels/sinumerik/tools/tool_functions.hpp"
#include "channels/sinumerik/variables/variables.hpp"
#include "ipc/model/machine/store/edge_lengths.hpp"

namespace polyturn::channels::sinumerik {
namespace {

bool select_tool(Execution& x, const Word& word) {
    std::int64_t number = 0;
    // T has been output already (managed_tools.cpp); with M6 the tool is known behind the change
    if (managed(x)) {
        x.modal.tool_selected =
            x.settings.tool_by_m6
                ? 0
                : x.core.port().tool_at_work().value_or(Port::ToolAtWork{}).number;
        return x.settings.tool_by_m6 ? true : change_tool(x);
    }
    if (word.value.type == Type::String) {
        for (const auto& [n, tool] : x.tools.table)
            if (tool.name == word.value.text && !word.value.text.empty()) {
                number = n;
                break;
            }
        if (!number) return fail_word(x, Alarm::ToolUnknown, word, word.value.text);
    } else {
        if (word.number() != std::floor(word.number()))
            return fail_word(x, Alarm::PointForbidden, word, "T");
        if (word.number() > 32000)
            return fail_word(x, Alarm::ToolUnknown, word, to_text(word.value));
        number = static_cast<std::int64_t>(word.number());
        if (number && !x.settings.tool_checked_late && !x.tools.table.contains(number))
            return fail_word(x, Alarm::ToolUnknown, word, to_text(word.value));
    }
    x.core.aux('T', static_cast<double>(number), fmt::format("T{}", number), false);
    x.modal.tool_selected = number;
    // T0 deselects the tool at once on either machine (5.1)
    return x.settings.tool_by_m6 && number != 0 ? true : change_tool(x);
}

bool select_edge(Execution& x, int edge) {
    const auto found = x.tools.table.find(x.modal.tool);
    if (edge > 0) {
        if (found == x.tools.table.end()) {
            if (x.modal.tool != 0 || !x.tools.table.empty())
                return fail(x, Alarm::ToolUnknown, std::to_string(x.modal.tool));
            return fail(x, Alarm::EdgeUnknown, std::to_string(x.modal.tool), edge);
        }
        if (!edge_of_d(found->second, edge))
            return fail(x, Alarm::EdgeUnknown, std::to_string(x.modal.tool), edge);
    }
    x.modal.edge = edge;
    x.modal.sum_offset = 0;
    x.core.path.tool.ref.edge = edge;
    // changed values wait for the next T or D
    x.modal.edge_data =
        edge > 0
            ? std::make_shared<const Edge>(found->second.edges.at(edge_of_d(found->second, edge)))
            : nullptr;
    x.modal.teeth = x.modal.edge_data ? x.modal.edge_data->teeth : 0.0;
    apply_tool(x);
    return refresh_cutting_speeds(x);
}

// Of the active edge, with SD42940 and SD42950.
std::array<int, 3> axes_of_lengths(const Execution& x) {
    const int assigned = x.settings.length_type ? x.settings.length_type
                         : x.modal.edge_data    ? static_cast<int>(x.modal.edge_data->dp[1])
                                                : 0;
    unsigned plane = static_cast<unsigned>(x.core.path.plane);
    if (x.settings.length_const >= 17 && x.settings.length_const <= 19)
        plane = static_cast<unsigned>(x.settings.length_const - 17);
    return axes_of_edge(assigned, plane);
}

}  // namespace

bool tool_words(Execution& x) {
    const Word* tool = word(x, "T");
    const Word* edge = word(x, "D");
    if (tool && !select_tool(x, *tool)) return false;
    if (edge && !changes_tool(x)) {
        if (edge->number() != std::floor(edge->number()))
            return fail_word(x, Alarm::PointForbidden, *edge, "D");
        x.blame.column = edge->column;
        x.blame.length = edge->length;
        if (!select_edge(x, static_cast<int>(edge->number()))) return false;
        x.blame.column = x.blame.length = 0;
    }
    return true;
}

// M6 in the block, where it changes the tool.
bool changes_tool(const Execution& x) {
    if (!x.settings.tool_by_m6) return false;
    for (const Word& word : x.block.words)
        if (word.address->name == "M" &&
            word.number() == static_cast<double>(x.settings.tool_change_m))
            return true;
    return false;
}

bool change_tool(Execution& x) {
    if (x.modal.tool_selected < 0) return true;
    if (managed(x))
        x.modal.tool_selected = x.core.port().tool_at_work().value_or(Port::ToolAtWork{}).number;
    x.modal.tool = x.modal.tool_selected;
    x.modal.tool_selected = -1;
    const auto found = x.tools.table.find(x.modal.tool);
    ToolRef& ref = x.core.path.tool.ref;
    ref.number = x.modal.tool;
    ref.name =
        found == x.tools.table.end() ? std::string_view{} : std::string_view(found->second.name);
    // the block says it itself
    if (const Word* edge = word(x, "D"))
        return !x.settings.tool_by_m6 || select_edge(x, static_cast<int>(edge->number()));
    if (x.settings.default_edge == -2) return true;  // the old offset holds until D
    int edge = x.modal.tool == 0 ? 0 : x.settings.default_edge;
    if (edge > 0 && found != x.tools.table.end() && !edge_of_d(found->second, edge))
        return fail(x, Alarm::EdgeUnknown, std::to_string(x.modal.tool), edge);
    if (edge > 0 && found == x.tools.table.end()) edge = 0;
    return select_edge(x, edge);
}

// LENTOAX(VAR ind[3], VAR mat[3,3][, system]): which length acts along abscissa, ordinate and
// applicate (sinumerik_part3 9.8; numbers, signs and answers as on the real control: 0 the indices
// say all, 1 a length lies across the axes, -1 no such system, -2 no edge is active). Rows of the
// matrix: abscissa, ordinate, applicate; columns: L1, L2, L3. In the workpiece system a rotation
// turns it.
bool f_lentoax(Execution& x, Call& c) {
    constexpr double kAlong = 1.0 - 1e-9;
    const std::string system =
        c.has(2) && !c.value(2).text.empty() ? upper(c.value(2).text) : "WCS";
    const bool turned = system == "WCS" || system == "W";
    Variable& indices = *c.arguments[0].reference.variable;
    Variable& matrix = *c.arguments[1].reference.variable;
    if (indices.cells.size() < 3 || matrix.cells.size() < 9)
        return fail(x, Alarm::FunctionArgument, "LENTOAX", 1);
    if (!turned && system != "MCS" && system != "M" && system != "BCS" && system != "B") {
        c.result = Value::of_int(-1);
        return true;
    }
    if (!x.modal.edge_data) {
        c.result = Value::of_int(-2);
        return true;
    }
    const std::array<int, 3> axes = axes_of_lengths(x);
    // X Y Z, Z X Y, Y Z X
    static constexpr int kOfPlane[3][3] = {{0, 1, 2}, {2, 0, 1}, {1, 2, 0}};
    const auto& plane = kOfPlane[static_cast<std::size_t>(x.core.path.plane)];
    const auto& linear = x.core.path.frame.linear;
    bool across = false;
    for (std::size_t row = 0; row < 3; ++row) {
        double index = 0;
        for (std::size_t k = 0; k < 3; ++k) {
            double part = axes[k] == plane[row] ? 1.0 : 0.0;
            // the part of that axis along the one of the workpiece
            if (turned && x.core.path.framed && axes[k] >= 0) {
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
            store(x, {c.arguments[1].reference.variable, row * 3 + k, false}, Value::of_real(part));
        }
        store(x, {c.arguments[0].reference.variable, row, false}, Value::of_int(index));
    }
    c.result = Value::of_int(across ? 1 : 0);
    return true;
}

// Lengths become a shift of their axes: an axis takes it along with its next word.
void apply_tool(Execution& x) {
    ToolState& state = x.core.path.tool;
    const Edge* const edge = x.modal.edge_data.get();
    const int type = edge ? static_cast<int>(edge->dp[1]) : 0;
    const std::array<int, 3> axes = axes_of_lengths(x);
    static constexpr PlaneRole kRoles[] = {PlaneRole::BasicX, PlaneRole::BasicY, PlaneRole::BasicZ};
    AxisValues shift{};
    const auto sum = static_cast<std::size_t>(x.modal.sum_offset);  // DL
    const auto add = [&](int geometry, double mm) {
        if (geometry < 0) return;
        if (const int place = x.core.view().axis_by_role(kRoles[geometry]); place >= 0)
            shift[static_cast<std::size_t>(place)] += mm;
    };
    for (std::size_t i = 0; i < 3; ++i) {
        x.modal.length_mm[i] = edge ? edge->dp[3 + i] + edge->dp[12 + i] + edge->dp[21 + i] : 0.0;
        if (edge && x.modal.sum_offset > 0)
            x.modal.length_mm[i] += edge->sum[sum][3 + i] + edge->setup[sum][3 + i];
        if (!edge) continue;
        add(axes[i], x.modal.length_mm[i]);
        if (!x.modal.toff_by_axis) add(axes[i], x.modal.toff.length_mm[i]);
    }
    if (edge && x.modal.toff_by_axis)
        for (int g = 0; g < 3; ++g) add(g, x.modal.toff.length_mm[static_cast<std::size_t>(g)]);
    // turning and grinding: the edge has a position
    const bool tipped = type >= 400 && type < 600;
    const bool wear_only = active(x, 22) == 9 || active(x, 22) == 10;  // CUT2DD CUT2DFD
    state.nose_radius = edge ? edge->dp[6] + edge->dp[15] : 0.0;
    if (edge && x.modal.sum_offset > 0)
        state.nose_radius += edge->sum[sum][6] + edge->setup[sum][6];
    // OFFN and TOFFR widen the distance to the contour; the tip stays where the nose has it (6.8
    // rule 5, 11.1).
    state.allowance = x.modal.geo.allowance;
    if (edge) state.allowance += x.modal.toff.radius_mm - (wear_only ? edge->dp[6] : 0.0);
    state.geometry = edge || x.modal.geo.allowance != 0.0 ? 1 : 0;
    state.tip = edge && tipped ? static_cast<std::int32_t>(edge->dp[2]) : edge ? 9 : 0;
    state.nose_off = edge == nullptr && x.modal.geo.allowance == 0.0;
    const AxisValues before = x.core.path.programmed;
    x.core.set_shift(shift);
    for (unsigned i = 0; i < x.core.view().axis_count; ++i)
        x.modal.pending_tool[i] += before[i] - x.core.path.programmed[i];
}

bool a_tool_length_offset(Execution& x, const Word& word) {
    if (has(x, "TOFF")) return fail_word(x, Alarm::CodesContradict, word, "TOFFL, TOFF");
    const std::int32_t n = word.index <= 0 ? 1 : word.index;
    if (n > 3) return fail_word(x, Alarm::ArrayIndexIllegal, word, "TOFFL", n);
    for (const Word& other : x.block.words)
        if (&other != &word && other.address == word.address &&
            (other.index <= 0 ? 1 : other.index) == n)
            return fail_word(x, Alarm::AddressTwice, word, "TOFFL");
    if (x.modal.toff_by_axis) {
        x.modal.toff.length_mm = {};
        x.modal.toff_by_axis = false;
    }
    x.modal.toff.length_mm[static_cast<std::size_t>(n - 1)] = word.number() * unit(x);
    apply_tool(x);
    return true;
}

bool a_tool_axis_offset(Execution& x, const Word& word) {
    if (has(x, "TOFFL")) return fail_word(x, Alarm::CodesContradict, word, "TOFFL, TOFF");
    static constexpr PlaneRole kRoles[] = {PlaneRole::BasicX, PlaneRole::BasicY, PlaneRole::BasicZ};
    for (std::size_t g = 0; g < 3; ++g) {
        if (x.core.view().axes[static_cast<std::size_t>(word.axis)].role != kRoles[g]) continue;
        if (!x.modal.toff_by_axis) {
            x.modal.toff.length_mm = {};
            x.modal.toff_by_axis = true;
        }
        x.modal.toff.length_mm[g] = word.number() * unit(x);
        apply_tool(x);
        return true;
    }
    return fail_word(x, Alarm::AxisKindWrong, word, axis_name(x, word.axis));
}

// DL: which of the edge's sum and set-up offsets ($TC_SCP, $TC_ECP) count besides its values; D
// takes it back.
bool a_sum_offset(Execution& x, const Word& word) {
    const double n = word.number();
    if (n != std::floor(n) || n > 6) return fail_word(x, Alarm::ValueOutOfRange, word, "DL", n);
    if (n > 0 && !x.modal.edge_data)
        return fail_word(x, Alarm::EdgeUnknown, word, std::to_string(x.modal.tool), x.modal.edge);
    x.modal.sum_offset = static_cast<int>(n);
    apply_tool(x);
    return true;
}

bool a_tool_radius_offset(Execution& x, const Word& word) {
    x.modal.toff.radius_mm = word.number() * unit(x);
    apply_tool(x);
    return true;
}

}  // namespace polyturn::channels::sinumerik
