// Values that setup and operator give by name, and what screens show of the language.
#include "channels/sinumerik/variables/presets.hpp"

#include <algorithm>

#include "channels/sinumerik/execution.hpp"

namespace polyturn::channels::sinumerik {

// Screens show the groups that every block depends on, and of the others what is not as delivered.
void active_codes(const Execution& x, std::string& out) {
    static constexpr std::array<unsigned, 9> kAlways{1, 6, 7, 8, 10, 13, 14, 15, 29};
    const auto add = [&](unsigned group) {
        const GCode* row = find_g(group, x.modal.active[group]);
        if (!row) return;
        if (!out.empty()) out += ' ';
        out += row->name;
    };
    for (const unsigned group : kAlways) add(group);
    for (unsigned group = 1; group < kGroups; ++group) {
        if (std::find(kAlways.begin(), kAlways.end(), group) != kAlways.end()) continue;
        if (const GCode* row = find_g(group, x.modal.active[group]); row && !row->preset)
            add(group);
    }
}
// R parameters that are not 0, then what the running level and its channel have declared; texts,
// axes and frames have no number.
void list_variables(const Execution& x, const Language::ShowVariable& show) {
    for (std::size_t n = 0; x.names.r && n < x.names.r->cells.size(); ++n)
        if (x.names.r->cells[n].number != 0.0)
            show("R" + std::to_string(n), x.names.r->cells[n].number);
    const auto declared = [&](const Scope& scope) {
        for (const auto& [name, reference] : scope.names) {
            if (!reference || reference.variable == x.names.r) continue;
            const Variable& variable = *reference.variable;
            for (std::size_t i = 0; i < variable.cells.size(); ++i) {
                if (!variable.cells[i].is_number() ||
                    (!variable.dimensions.empty() && variable.cells[i].number == 0.0))
                    continue;
                show(variable.dimensions.empty() ? name : name + "[" + std::to_string(i) + "]",
                     variable.cells[i].number);
            }
        }
    };
    if (!x.calls.levels.empty() && x.calls.levels.back().scope)
        declared(*x.calls.levels.back().scope);
    if (x.names.of_channel) declared(*x.names.of_channel);
}
bool preset_variable(Execution& x, std::string_view name, double value) {
    const std::string word = upper(name);
    if (word.size() > 1 && word[0] == 'R') {
        std::size_t number = 0;
        for (std::size_t i = 1; i < word.size(); ++i) {
            if (!is_digit(word[i])) return false;
            number = number * 10 + static_cast<std::size_t>(word[i] - '0');
            if (number >= x.names.r->cells.size()) return false;
        }
        x.names.r->cells[number] = Value::of_real(value);
        return true;
    }
    if (!word.empty() && word[0] == '$') {
        x.names.system[word] = Value::of_real(value);
        return true;
    }
    return false;
}
// STRING variables are declared by the program itself: there is nothing that a text could be
// entered into before.
bool preset_text(std::string_view, std::string_view) { return false; }
bool preset_tool(Execution& x, int number, std::string_view name) {
    if (number < 1 || number > 32000) return false;
    x.tools.table[number].name = name;
    return true;
}
// DP1 to DP35, DPNT.
bool preset_edge(Execution& x, int tool, int edge, std::string_view parameter, double value) {
    const std::string word = upper(parameter);
    if (tool < 1 || tool > 32000 || edge < 1 || !word.starts_with("DP")) return false;
    Edge& entry = x.tools.table[tool].edges[edge];
    if (word == "DPNT") {
        entry.teeth = value;
        return true;
    }
    unsigned number = 0;
    for (const char c : word.substr(2)) {
        if (!is_digit(c) || number > 99) return false;
        number = number * 10 + static_cast<unsigned>(c - '0');
    }
    if (number < 1 || number >= kEdgeParameters) return false;
    entry.dp[number] = value;
    return true;
}
}  // namespace polyturn::channels::sinumerik
