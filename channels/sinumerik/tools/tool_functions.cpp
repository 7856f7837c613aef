// Tools and edges by name, group and D number (sinumerik_part3 7.17, 9.5; part 1 6.6).
//
// An edge is called by its D number. That is the edge's own number until SETDNO gives it another;
// DZERO takes the numbers of all edges, and only SETDNO brings them back. Tools of one name are a
// group, in the order of their duplo numbers.
#include "channels/sinumerik/tools/tool_functions.hpp"

#include <fmt/format.h>

#include <algorithm>

#include "channels/sinumerik/execution.hpp"
#include "channels/sinumerik/faults.hpp"
#include "channels/sinumerik/flow/run.hpp"
#include "channels/sinumerik/tools/managed_tools.hpp"
#include "channels/sinumerik/tools/tools.hpp"
#include "channels/sinumerik/variables/changes.hpp"
#include "channels/sinumerik/variables/variables.hpp"
#include "ipc/model/machine/store/tool_fields.hpp"

namespace polyturn::channels::sinumerik {
namespace {

constexpr int kDone = 0, kNoTool = -1, kSeveral = -2;  // answers: found, none, more than one
constexpr int kMostD = 32000;

int d_number(int edge, const Edge& data) { return data.d_number < 0 ? edge : data.d_number; }

std::vector<int> d_numbers(const Tool& tool) {
    std::vector<int> all;
    for (const auto& [number, edge] : tool.edges)
        if (const int d = d_number(number, edge); d > 0) all.push_back(d);
    return all;
}

// Is no D number that both have the one asked for (0: any)?
bool apart(const Tool& a, const Tool& b, int d) {
    const std::vector<int> others = d_numbers(b);
    return std::ranges::none_of(d_numbers(a), [&](int one) {
        return (d == 0 || one == d) && std::ranges::find(others, one) != others.end();
    });
}

std::vector<std::int64_t> tools_named(const Execution& x, const std::string& name) {
    std::vector<std::int64_t> group;
    for (const auto& [number, tool] : x.tools.table)
        if (!name.empty() && tool.name == name) group.push_back(number);
    std::ranges::stable_sort(group, {},
                             [&](std::int64_t number) { return x.tools.table.at(number).duplo; });
    return group;
}

// The tool of that name and duplo number (the first where none is asked for); 0: there is none.
std::int64_t tool_named(const Execution& x, const Call& c, std::size_t duplo) {
    const std::vector<std::int64_t> group = tools_named(x, c.value(0).text);
    for (std::size_t i = 0; i < group.size(); ++i) {
        const std::int32_t given = x.tools.table.at(group[i]).duplo;
        if (!c.has(duplo) || c.number(duplo) == (given ? given : static_cast<double>(i + 1)))
            return group[i];
    }
    return 0;
}

bool call_tool(Execution& x, std::int64_t number, ToolCallBy by) {
    if (!managed(x)) {
        if (!x.settings.tool_checked_late && number && !x.tools.table.contains(number))
            return fail(x, Alarm::ToolUnknown, std::to_string(number));
        x.core.aux('T', static_cast<double>(number), fmt::format("T{}", number), false);
        x.modal.tool_selected = number;
    } else {
        if (x.run.tool_serial != x.core.at.serial) {
            if (!need_fresh(x)) return false;
            x.core.aux('T', static_cast<double>(number), fmt::format("T{}", number), false, false,
                       by);
            x.run.tool_serial = x.core.at.serial;
            // its answer first
            if (!x.settings.tool_by_m6) {
                x.pass.needs_barrier = true;
                return false;
            }
        }
        x.modal.tool_selected =
            x.settings.tool_by_m6
                ? 0
                : x.core.port().tool_at_work().value_or(Port::ToolAtWork{}).number;
    }
    return x.settings.tool_by_m6 || change_tool(x);
}

}  // namespace

int edge_of_d(const Tool& tool, int d) {
    for (const auto& [number, edge] : tool.edges)
        if (d > 0 && d_number(number, edge) == d) return number;
    return 0;
}

bool f_gett(Execution& x, Call& c) {
    const std::int64_t found = tool_named(x, c, 1);
    c.result = Value::of_int(found ? static_cast<double>(found) : -1.0);
    return true;
}

bool f_newt(Execution& x, Call& c) {
    std::int64_t number = 1;
    while (x.tools.table.contains(number)) ++number;
    if (number > 32000)
        return fail(x, Alarm::FunctionArgument, "NEWT", static_cast<double>(number));
    undo(x, [&x, number] { x.tools.table.erase(number); });
    Tool& tool = x.tools.table[number];
    tool.name = c.value(0).text;
    tool.duplo = c.has(1) ? static_cast<std::int32_t>(c.number(1)) : 0;
    tool.edges[1];
    c.result = Value::of_int(static_cast<double>(number));
    return true;
}

bool p_delt(Execution& x, Call& c) {
    const std::int64_t number = tool_named(x, c, 1);
    if (!number || number == x.modal.tool) return fail(x, Alarm::ToolUnknown, c.value(0).text);
    undo(x, [&x, number, before = x.tools.table.at(number)] { x.tools.table[number] = before; });
    x.tools.table.erase(number);
    return true;
}

// --- D numbers

bool f_getdno(Execution& x, Call& c) {  // (t, edge): 0 where it has none
    const auto tool = x.tools.table.find(static_cast<std::int64_t>(c.number(0)));
    const auto edge = static_cast<int>(c.number(1));
    const bool there = tool != x.tools.table.end() && tool->second.edges.contains(edge);
    c.result = Value::of_int(there ? d_number(edge, tool->second.edges.at(edge)) : 0);
    return true;
}

// (t, edge, d): TRUE where it has been done. A number that another edge of the tool has is refused:
// D would mean two.
bool f_setdno(Execution& x, Call& c) {
    const auto tool = x.tools.table.find(static_cast<std::int64_t>(c.number(0)));
    const auto edge = static_cast<int>(c.number(1)), d = static_cast<int>(c.number(2));
    c.result = Value::of_bool(false);
    if (tool == x.tools.table.end() || !tool->second.edges.contains(edge) || d < 1 || d > kMostD)
        return true;
    if (const int other = edge_of_d(tool->second, d); other != 0 && other != edge) return true;
    int& cell = tool->second.edges.at(edge).d_number;
    undo(x, [&x, number = tool->first, edge, before = cell] {
        x.tools.table[number].edges[edge].d_number = before;
    });
    cell = d;
    c.result = Value::of_bool(true);
    return true;
}

bool p_dzero(Execution& x, Call&) {
    undo(x, [&x, before = x.tools.table] { x.tools.table = before; });
    for (auto& [number, tool] : x.tools.table)
        for (auto& [edge, data] : tool.edges) data.d_number = 0;
    return true;
}

// CHKDNO([t1[, t2[, d]]]): TRUE where no D number (or not this one) is in two tools.
bool f_chkdno(Execution& x, Call& c) {
    const auto known = [&](std::size_t i) {
        return !c.has(i) || x.tools.table.contains(static_cast<std::int64_t>(c.number(i)));
    };
    if (!known(0) || !known(1)) {
        c.result = Value::of_bool(false);
        return true;
    }
    const auto d = static_cast<int>(c.number(2));
    bool unique = true;
    for (const auto& [a, one] : x.tools.table)
        for (const auto& [b, other] : x.tools.table) {
            if (a == b || (c.has(0) && a != static_cast<std::int64_t>(c.number(0))) ||
                (c.has(1) && b != static_cast<std::int64_t>(c.number(1))))
                continue;
            unique = unique && apart(one, other, d);
        }
    c.result = Value::of_bool(unique);
    return true;
}

// CHKDM(magazine[, d]): the same among the tools that stand in it.
bool f_chkdm(Execution& x, Call& c) {
    if (!managed(x)) return fail(x, Alarm::NotBuilt, "CHKDM without tool management (N2900)");
    if (!need_fresh(x)) return false;
    const auto& rows = x.core.port().tool_table()->rows;
    const auto stands = [&](std::int64_t number) {
        const ToolRow& row = rows[static_cast<std::size_t>(number - 1)];
        return row.used && row.magazine == static_cast<std::int32_t>(c.number(0));
    };
    bool unique = true;
    for (auto a = x.tools.table.begin(); a != x.tools.table.end(); ++a)
        for (auto b = std::next(a); b != x.tools.table.end(); ++b)
            if (a->first <= static_cast<std::int64_t>(kTools) &&
                b->first <= static_cast<std::int64_t>(kTools) && stands(a->first) &&
                stands(b->first))
                unique = unique && apart(a->second, b->second, static_cast<int>(c.number(1)));
    c.result = Value::of_bool(unique);
    return true;
}

bool f_getacttd(Execution& x, Call& c) {  // (VAR t, d): whose D number that is
    std::int64_t found = 0;
    int answer = kNoTool;
    for (const auto& [number, tool] : x.tools.table) {
        if (!edge_of_d(tool, static_cast<int>(c.number(1)))) continue;
        if (found == 0) found = number;
        answer = answer == kNoTool ? kDone : kSeveral;
    }
    store(x, c.arguments[0].reference, Value::of_int(static_cast<double>(found)));
    c.result = Value::of_int(answer);
    return true;
}

// (t[, edge]): sum and set-up offsets of the edge, or of all edges, become 0.
bool f_deldl(Execution& x, Call& c) {
    const auto tool = x.tools.table.find(static_cast<std::int64_t>(c.number(0)));
    const int wanted = c.has(1) ? static_cast<int>(c.number(1)) : 0;
    if (tool == x.tools.table.end() || (wanted && !tool->second.edges.contains(wanted))) {
        c.result = Value::of_int(kNoTool);
        return true;
    }
    undo(x, [&x, number = tool->first, before = tool->second] { x.tools.table[number] = before; });
    for (auto& [edge, data] : tool->second.edges)
        if (wanted == 0 || edge == wanted) {
            data.sum = {};
            data.setup = {};
        }
    c.result = Value::of_int(kDone);
    return true;
}

// --- groups

bool f_toolgnt(Execution& x, Call& c) {
    c.result = Value::of_int(static_cast<double>(tools_named(x, c.value(0).text).size()));
    return true;
}

bool f_toolgt(Execution& x, Call& c) {  // (name, i): the i-th of the group, 0 where there is none
    const std::vector<std::int64_t> group = tools_named(x, c.value(0).text);
    const double i = c.number(1);
    c.result = Value::of_int(i >= 1 && i <= static_cast<double>(group.size())
                                 ? static_cast<double>(group[static_cast<std::size_t>(i) - 1])
                                 : 0.0);
    return true;
}

// (VAR t, name): the one of the group that works: the active one of tool management, else the tool
// that cuts, else the first.
bool f_getactt(Execution& x, Call& c) {
    const std::vector<std::int64_t> group = tools_named(x, c.value(1).text);
    std::int64_t found = group.empty() ? 0 : group.front();
    if (std::ranges::find(group, x.modal.tool) != group.end()) found = x.modal.tool;
    if (managed(x)) {
        if (!need_fresh(x)) return false;
        for (const std::int64_t number : group)
            if (number <= static_cast<std::int64_t>(kTools) &&
                x.core.port().tool_table()->rows[static_cast<std::size_t>(number - 1)].state &
                    kToolActive)
                found = number;
    }
    store(x, c.arguments[0].reference, Value::of_int(static_cast<double>(found)));
    c.result = Value::of_int(found ? kDone : kNoTool);
    return true;
}

// --- calls that are no T

// TCA(name[, duplo[, holder]]): this tool, whatever its state. Tool management is asked as T asks
// it.
bool p_tca(Execution& x, Call& c) {
    const std::string& name = c.value(0).text;
    const std::int64_t number = tool_named(x, c, 1);
    if (!number)
        return fail(x, Alarm::ToolUnknown,
                    c.has(1) ? fmt::format("{}/{:.0f}", name, c.number(1)) : name);
    return call_tool(x, number, ToolCallBy::Forced);
}

bool p_tml(Execution& x, Call& c) {  // TML(location): the tool that is there
    if (c.number(0) != std::floor(c.number(0))) return fail(x, Alarm::PointForbidden, "TML");
    return call_tool(x, static_cast<std::int64_t>(c.number(0)), ToolCallBy::Location);
}

}  // namespace polyturn::channels::sinumerik
