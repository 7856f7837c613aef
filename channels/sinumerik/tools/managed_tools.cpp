// Tools of tool management (sinumerik_part1 5.2): T names a place of the turret or a tool, the
// store chooses among its sisters, and which one it is - and so whose edges D means - is known when
// T, or the tool change, has been executed. What is monitored of a tool lives in the store's table
// alone:
//
//   $TC_TP9[t]       0 none, 1 time, 2 pieces, 4 wear
//   $TC_MOP1 3 5     warning limit of time (min), pieces, wear (mm)     $TC_MOP2 4 6  what is left     $TC_MOP11 13 15  the life
#include <fmt/format.h>

#include <cmath>
#include <cstdio>
#include <cstring>

#include "channels/sinumerik/interpreter.hpp"
#include "ipc/machine/store/tool_fields.hpp"

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

bool Interpreter::managed() { return core_.port().tool_table() != nullptr; }

void Interpreter::preset_stored(const polyturn::ToolTable& tools,
                                const polyturn::ToolEdgeTable& edges, int unit) {
    std::size_t e = 0;  // edges stand in the order of their tools
    for (std::size_t i = 0; i < kTools; ++i) {
        const ToolRow& row = tools.rows[i];
        const auto number = static_cast<std::int32_t>(i + 1);
        while (e < edges.count && edges.edges[e].tool < number) ++e;
        if (!row.used || (row.unit != 0 && row.unit != unit)) continue;
        Tool& tool = tools_[number];
        tool.name = std::string(row.name.data(), ::strnlen(row.name.data(), row.name.size()));
        tool.duplo = row.duplo;
        tool.max_velocity = row.speed;
        for (std::size_t k = e; k < edges.count && edges.edges[k].tool == number; ++k)
            for (std::size_t p = 1; p < kEdgeParameters && p < edges.edges[k].dp.size(); ++p)
                tool.edges[edges.edges[k].number].dp[p] = edges.edges[k].dp[p];
    }
}

bool Interpreter::managed_tool() {
    if (managed_serial_ == core_.at.serial || !managed()) return true;
    const Word* tool = word("T");
    const bool changes = changes_tool();
    if (!tool && !changes) return true;
    // what is held for its corner ends first
    if (core_.reads_ahead() && !need_fresh()) return false;
    if (tool) {
        const bool named = tool->value.type == Type::String;
        if (!named && tool->number() != std::floor(tool->number()))
            return fail_word(Alarm::PointForbidden, *tool, "T");
        if (named)
            core_.aux('T', 0, fmt::format("T=\"{}\"", tool->value.text), false, false,
                      ToolCallBy::Name, tool->value.text);
        else
            core_.aux('T', tool->number(), fmt::format("T{:.0f}", tool->number()), false, false,
                      ToolCallBy::Location);
        if (settings_.tool_by_m6) modal_.tool_selected = 0;
    }
    if (changes)
        for (const Word& one : block_.words)
            if (one.address->name == "M" &&
                one.number() == static_cast<double>(settings_.tool_change_m))
                m_to_plc(one, settings_.tool_change_m);
    managed_serial_ = core_.at.serial;
    // it waits for the change, the program does not wait for it
    if (settings_.tool_by_m6 && !changes) return true;
    needs_barrier_ = true;
    return false;
}

// The column of the tool table that the variable means, and its value now.
bool Interpreter::monitoring(const std::string& name, const std::vector<Value>& indices,
                             const char* from, std::size_t length, std::string& field,
                             double& value) {
    const bool of_edge = name != "$TC_TP9";
    if (indices.size() != (of_edge ? 2u : 1u) || !indices[0].is_number())
        return fail_at(Alarm::ArrayIndexMissing, from, length, name);
    const double number = indices[0].number;
    if (!(number >= 1 && number <= static_cast<double>(kTools)))
        return fail_at(Alarm::ArrayIndexIllegal, from, length, name, number);
    Mop mop;
    if (of_edge && !read_mop(name, mop))
        return fail_at(Alarm::SystemVariableUnknown, from, length, name);
    field = !of_edge                   ? "life_kind"
            : mop.what == Mop::Warning ? "warning"
            : mop.what == Mop::Life    ? "life"
                                       : "counter";
    if (!managed())
        return fail_at(Alarm::NotBuilt, from, length, name + " without tool management (N2900)");
    if (!need_fresh()) return false;
    const ToolRow& row = core_.port().tool_table()->rows[static_cast<std::size_t>(number) - 1];
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

bool Interpreter::write_monitoring(const std::string& name, const std::vector<Value>& indices,
                                   const char* from, std::size_t length, const Value& value) {
    std::string field;
    double now = 0;
    if (!monitoring(name, indices, from, length, field, now)) return false;
    written_.push_back({indices.size() == 2 ? fmt::format("{}[{:.0f},{:.0f}]", name,
                                                          indices[0].number, indices[1].number)
                                            : fmt::format("{}[{:.0f}]", name, indices[0].number),
                        value});
    return true;
}

// What a block has assigned to tool data reaches the store in path order.
void Interpreter::tell_tool(const std::string& name, const Value& value) {
    if (!managed() || value.type > Type::Real) return;
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
            write.value = core_.port().tool_table()->rows[static_cast<std::size_t>(tool - 1)].life -
                          value.number;
    } else {
        return;
    }
    if (tool < 1 || tool > static_cast<int>(kTools) || edge > 12) return;
    write.tool = tool;
    core_.mark_emitted();
    core_.sink().tool_write(write, core_.at);
}

// RESETMON(VAR state, t, d, options): the life of the tool begins anew. state: 0 done, -1 no tool
// management, -2 no such tool. SETPIECE(n, s): n pieces more for each tool that has cut since the
// last SETPIECE or since the part began; what it has counted the end of the part does not count
// again. Without tool management nothing is monitored.
bool Interpreter::p_reset_monitoring(Call& c) {
    if (block_.procedures.front().first->name == "SETPIECE") {
        constexpr double kMostPieces = 1e6;
        const double n = c.number(0), s = c.number(1, 1);
        if (n != std::floor(n) || n < 0 || n > kMostPieces)
            return fail(Alarm::FunctionArgument, "SETPIECE", n);
        if (s != std::floor(s) || !(s >= 1 && s <= static_cast<double>(kMaxSpindles)) ||
            !core_.view().machine.spindle(static_cast<std::size_t>(s)).exists())
            return fail(Alarm::SpindleNumberIllegal, {}, s);
        if (!managed() || n == 0) return true;
        ToolWrite write;  // of no tool: all that took part
        write.field = "counter";
        write.value = n;
        core_.mark_emitted();
        core_.sink().tool_write(write, core_.at);
        return true;
    }
    const auto number = static_cast<std::int64_t>(c.number(1));
    double state = 0;
    if (!managed())
        state = -1;
    else if (number < 1 || number > static_cast<std::int64_t>(kTools) ||
             !core_.port().tool_table()->rows[static_cast<std::size_t>(number - 1)].used)
        state = -2;
    else
        for (const std::string_view field : {"counter", "worn", "warned"}) {
            ToolWrite write;
            write.tool = static_cast<std::int32_t>(number);
            write.field = field;
            core_.mark_emitted();
            core_.sink().tool_write(write, core_.at);
        }
    store(c.arguments[0].reference, Value::of_int(state));
    return true;
}

}  // namespace polyturn::channels::sinumerik
