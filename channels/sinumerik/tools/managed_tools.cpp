// Tools of tool management (sinumerik_part1 5.2): T names a place of the turret or a tool, the
// store chooses among its sisters, and which one it is - and so whose edges D means - is known when
// T, or the tool change, has been executed. What is monitored of a tool lives in the store's table
// alone:
//
//   $TC_TP9[t]       0 none, 1 time, 2 pieces, 4 wear
//   $TC_MOP1 3 5     warning limit of time (min), pieces, wear (mm)     $TC_MOP2 4 6  what is left     $TC_MOP11 13 15  the life
#include "channels/sinumerik/tools/managed_tools.hpp"

#include <fmt/format.h>

#include <cmath>
#include <cstring>

#include "channels/sinumerik/coordination/functions_ms.hpp"
#include "channels/sinumerik/execution.hpp"
#include "channels/sinumerik/faults.hpp"
#include "channels/sinumerik/flow/run.hpp"
#include "channels/sinumerik/grammar/words.hpp"
#include "channels/sinumerik/tools/tools.hpp"
#include "channels/sinumerik/variables/variables.hpp"
#include "ipc/model/machine/store/tool_fields.hpp"

namespace polyturn::channels::sinumerik {
namespace {

// Kinds as $TC_TP9 counts them.
int monitoring_of(LifeKind kind) {
    return kind == LifeKind::Minutes  ? 1
           : kind == LifeKind::Pieces ? 2
           : kind == LifeKind::Wear   ? 4
                                      : 0;
}
LifeKind kind_of(int monitoring) {
    return monitoring == 1   ? LifeKind::Minutes
           : monitoring == 2 ? LifeKind::Pieces
           : monitoring == 4 ? LifeKind::Wear
                             : LifeKind::None;
}

struct Mop {
    LifeKind kind = LifeKind::None;
    enum { Warning, Left, Life } what = Warning;
};
bool read_mop(const std::string& name, Mop& out) {
    const int n = std::atoi(name.c_str() + std::strlen("$TC_MOP"));
    static constexpr LifeKind kKinds[] = {LifeKind::Minutes, LifeKind::Pieces, LifeKind::Wear};
    if (n >= 1 && n <= 6) {
        out = {kKinds[(n - 1) / 2], n % 2 ? Mop::Warning : Mop::Left};
        return true;
    }
    if (n == 11 || n == 13 || n == 15) {
        out = {kKinds[(n - 11) / 2], Mop::Life};
        return true;
    }
    return false;
}

}  // namespace

bool managed(Execution& x) { return x.core.port().tool_table() != nullptr; }

void preset_stored(Execution& x, const polyturn::ToolTable& tools,
                   const polyturn::ToolEdgeTable& edges, int unit) {
    std::size_t e = 0;  // edges stand in the order of their tools
    for (std::size_t i = 0; i < kTools; ++i) {
        const ToolRow& row = tools.rows[i];
        const auto number = static_cast<std::int32_t>(i + 1);
        while (e < edges.count && edges.edges[e].tool < number) ++e;
        if (!row.used || (row.unit != 0 && row.unit != unit)) continue;
        Tool& tool = x.tools.table[number];
        tool.name = std::string(row.name.data(), ::strnlen(row.name.data(), row.name.size()));
        tool.duplo = row.duplo;
        tool.max_velocity = row.speed;
        for (std::size_t k = e; k < edges.count && edges.edges[k].tool == number; ++k)
            for (std::size_t p = 1; p < kEdgeParameters && p < edges.edges[k].dp.size(); ++p)
                tool.edges[edges.edges[k].number].dp[p] = edges.edges[k].dp[p];
    }
}

bool managed_tool(Execution& x) {
    if (x.run.tool_serial == x.core.at.serial || !managed(x)) return true;
    const Word* tool = word(x, "T");
    const bool changes = changes_tool(x);
    if (!tool && !changes) return true;
    // what is held for its corner ends first
    if (x.core.reads_ahead() && !need_fresh(x)) return false;
    if (tool) {
        const bool named = tool->value.type == Type::String;
        if (!named && tool->number() != std::floor(tool->number()))
            return fail_word(x, Alarm::PointForbidden, *tool, "T");
        if (named)
            x.core.aux('T', 0, fmt::format("T=\"{}\"", tool->value.text), false, false,
                       ToolCallBy::Name, tool->value.text);
        else
            x.core.aux('T', tool->number(), fmt::format("T{:.0f}", tool->number()), false, false,
                       ToolCallBy::Location);
        if (x.settings.tool_by_m6) x.modal.tool_selected = 0;
    }
    if (changes)
        for (const Word& one : x.block.words)
            if (one.address->name == "M" &&
                one.number() == static_cast<double>(x.settings.tool_change_m))
                m_to_plc(x, one, x.settings.tool_change_m);
    x.run.tool_serial = x.core.at.serial;
    // it waits for the change, the program does not wait for it
    if (x.settings.tool_by_m6 && !changes) return true;
    x.pass.needs_barrier = true;
    return false;
}

// The column of the tool table that the variable means, and its value now.
bool monitoring(Execution& x, const std::string& name, const std::vector<Value>& indices,
                const char* from, std::size_t length, std::string& field, double& value) {
    const bool of_edge = name != "$TC_TP9";
    if (indices.size() != (of_edge ? 2u : 1u) || !indices[0].is_number())
        return fail_at(x, Alarm::ArrayIndexMissing, from, length, name);
    const double number = indices[0].number;
    if (!(number >= 1 && number <= static_cast<double>(kTools)))
        return fail_at(x, Alarm::ArrayIndexIllegal, from, length, name, number);
    Mop mop;
    if (of_edge && !read_mop(name, mop))
        return fail_at(x, Alarm::SystemVariableUnknown, from, length, name);
    field = !of_edge                   ? "life_kind"
            : mop.what == Mop::Warning ? "warning"
            : mop.what == Mop::Life    ? "life"
                                       : "counter";
    if (!managed(x))
        return fail_at(x, Alarm::NotBuilt, from, length, name + " without tool management (N2900)");
    if (!need_fresh(x)) return false;
    const ToolRow& row = x.core.port().tool_table()->rows[static_cast<std::size_t>(number) - 1];
    const auto kind = static_cast<LifeKind>(row.life_kind);
    if (!of_edge)
        value = monitoring_of(kind);
    else if (kind != mop.kind)
        value = 0;
    else
        value = mop.what == Mop::Warning ? row.warning
                : mop.what == Mop::Life  ? row.life
                                         : row.life - row.counter;
    return true;
}

bool write_monitoring(Execution& x, const std::string& name, const std::vector<Value>& indices,
                      const char* from, std::size_t length, const Value& value) {
    std::string field;
    double now = 0;
    if (!monitoring(x, name, indices, from, length, field, now)) return false;
    x.changes.written.push_back(
        {indices.size() == 2
             ? fmt::format("{}[{:.0f},{:.0f}]", name, indices[0].number, indices[1].number)
             : fmt::format("{}[{:.0f}]", name, indices[0].number),
         value});
    return true;
}

// What a block has assigned to tool data reaches the store in path order.
void tell_tool(Execution& x, const std::string& name, const Value& value) {
    if (!managed(x) || value.type > Type::Real) return;
    int tool = 0, edge = 0, dp = 0;
    ToolWrite write;
    if (std::sscanf(name.c_str(), "$TC_DP%d[%d,%d]", &dp, &tool, &edge) == 3) {
        write.edge = edge;
        write.dp = dp;
        write.value = value.number;
    } else if (std::sscanf(name.c_str(), "$TC_TP9[%d]", &tool) == 1) {
        write.field = "life_kind";
        write.value = static_cast<double>(kind_of(static_cast<int>(value.number)));
    } else if (std::sscanf(name.c_str(), "$TC_MOP%d[%d,", &dp, &tool) == 2) {
        Mop mop;
        if (!read_mop(name, mop)) return;
        write.value = value.number;
        write.field = mop.what == Mop::Warning ? "warning"
                      : mop.what == Mop::Life  ? "life"
                                               : "counter";
        if (mop.what == Mop::Left)
            write.value =
                x.core.port().tool_table()->rows[static_cast<std::size_t>(tool - 1)].life -
                value.number;
    } else {
        return;
    }
    if (tool < 1 || tool > static_cast<int>(kTools) || edge > 12) return;
    write.tool = tool;
    x.core.mark_emitted();
    x.core.sink().tool_write(write, x.core.at);
}

// RESETMON(VAR state, t, d, options): the life of the tool begins anew. state: 0 done, -1 no tool
// management, -2 no such tool. SETPIECE(n, s): n pieces more for each tool that has cut since the
// last SETPIECE or since the part began; what it has counted the end of the part does not count
// again. Without tool management nothing is monitored.
bool p_reset_monitoring(Execution& x, Call& c) {
    if (x.block.procedures.front().first->name == "SETPIECE") {
        constexpr double kMostPieces = 1e6;
        const double n = c.number(0), s = c.number(1, 1);
        if (n != std::floor(n) || n < 0 || n > kMostPieces)
            return fail(x, Alarm::FunctionArgument, "SETPIECE", n);
        if (s != std::floor(s) || !(s >= 1 && s <= static_cast<double>(kMaxSpindles)) ||
            !x.core.view().machine.spindle(static_cast<std::size_t>(s)).exists())
            return fail(x, Alarm::SpindleNumberIllegal, {}, s);
        if (!managed(x) || n == 0) return true;
        ToolWrite write;  // of no tool: all that took part
        write.field = "counter";
        write.value = n;
        x.core.mark_emitted();
        x.core.sink().tool_write(write, x.core.at);
        return true;
    }
    const auto number = static_cast<std::int64_t>(c.number(1));
    double state = 0;
    if (!managed(x))
        state = -1;
    else if (number < 1 || number > static_cast<std::int64_t>(kTools) ||
             !x.core.port().tool_table()->rows[static_cast<std::size_t>(number - 1)].used)
        state = -2;
    else
        for (const std::string_view field : {"counter", "worn", "warned"}) {
            ToolWrite write;
            write.tool = static_cast<std::int32_t>(number);
            write.field = field;
            x.core.mark_emitted();
            x.core.sink().tool_write(write, x.core.at);
        }
    store(x, c.arguments[0].reference, Value::of_int(state));
    return true;
}

}  // namespace polyturn::channels::sinumerik
