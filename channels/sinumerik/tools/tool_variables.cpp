// $TC_...: tool data as system variables.
#include "channels/sinumerik/tools/tool_variables.hpp"

#include "channels/sinumerik/execution.hpp"
#include "channels/sinumerik/faults.hpp"
#include "channels/sinumerik/tools/managed_tools.hpp"
#include "channels/sinumerik/variables/changes.hpp"
#include "ipc/diagnosis/display_language.hpp"

namespace polyturn::channels::sinumerik {

// $TC_DPx[t,d], $TC_DPNT[t,d], $TC_SCPxy, $TC_ECPxy[t,d], $TC_TP2[t], $TC_TP_MAX_VELO[t]
bool tool_value(Execution& x, const std::string& name, const std::vector<Value>& indices,
                const char* from, std::size_t length, Value& value) {
    const auto tool_number = indices.empty() ? -1 : static_cast<std::int64_t>(indices[0].number);
    if (name.starts_with("$TC_MOP") || name == "$TC_TP9") {
        std::string field;
        double now = 0;
        if (!monitoring(x, name, indices, from, length, field, now)) return false;
        value = name == "$TC_TP9" ? Value::of_int(now) : Value::of_real(now);
        return true;
    }
    const auto found = x.tools.table.find(tool_number);
    if (name == "$TC_TP2") {
        value = Value::of_text(found == x.tools.table.end() ? std::string() : found->second.name);
        return true;
    }
    if (name == "$TC_TP_MAX_VELO") {
        value = Value::of_real(found == x.tools.table.end() ? 0.0 : found->second.max_velocity);
        return true;
    }
    if (const int n = grinding_parameter(name)) {
        value = Value::of_real(found == x.tools.table.end()
                                   ? 0.0
                                   : found->second.grinding[static_cast<std::size_t>(n)]);
        return true;
    }
    double* cell = nullptr;
    if (!edge_cell(x, name, indices, from, length, false, cell)) return false;
    const bool whole = name == "$TC_DP1" || name == "$TC_DP2";
    value = whole ? Value::of_int(cell ? *cell : 0.0) : Value::of_real(cell ? *cell : 0.0);
    return true;
}
// Where an edge keeps the parameter `name`; nullptr: the tool or edge does not exist (and shall not
// be made).
bool edge_cell(Execution& x, const std::string& name, const std::vector<Value>& indices,
               const char* from, std::size_t length, bool make, double*& cell) {
    cell = nullptr;
    if (indices.size() != 2 || !indices[0].is_number() || !indices[1].is_number())
        return fail_at(x, Alarm::ArrayIndexMissing, from, length, name);
    const auto number = static_cast<std::int64_t>(indices[0].number);
    const int d = static_cast<int>(indices[1].number);
    if (number < 1 || number > 32000)
        return fail_at(x, Alarm::ArrayIndexIllegal, from, length, name, indices[0].number);
    if (d < 1 || d > kMostEdges)
        return fail_at(x, Alarm::ArrayIndexIllegal, from, length, name, indices[1].number);
    const int parameter = parameter_of(name, "$TC_DP"), sum = parameter_of(name, "$TC_SCP"),
              setup = parameter_of(name, "$TC_ECP");
    const bool teeth = name == "$TC_DPNT";
    const bool known = teeth || (parameter >= 1 && parameter < static_cast<int>(kEdgeParameters)) ||
                       (sum >= 10 && sum < 70) || (setup >= 10 && setup < 70);
    if (!known) return fail_at(x, Alarm::SystemVariableUnknown, from, length, name);
    auto tool = x.tools.table.find(number);
    if (tool == x.tools.table.end() || !tool->second.edges.contains(d)) {
        if (!make) return true;
        const bool new_tool = tool == x.tools.table.end();
        undo(x, [&x, number, d, new_tool] {
            if (new_tool)
                x.tools.table.erase(number);
            else
                x.tools.table[number].edges.erase(d);
        });
        tool = x.tools.table.try_emplace(number).first;
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
}  // namespace polyturn::channels::sinumerik
