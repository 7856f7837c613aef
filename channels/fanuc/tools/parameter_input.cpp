#include "channels/fanuc/tools/parameter_input.hpp"

#include <fmt/format.h>

#include <cmath>

#include "channels/fanuc/execution.hpp"
#include "ipc/model/compensation/compensation_tables.hpp"
#include "ipc/params/param_file.hpp"

namespace polyturn::channels::fanuc {
namespace {

// N10000 and on: a point of the compensation tables, which the program itself does not need. Whole
// numbers of a fanuc program count increments of the channel's first axis.
bool compensation_cell(Core& core, std::int64_t cell, double value) {
    core.mark_emitted();
    core.sink().parameter(fmt::format("{}={}", cell, static_cast<float>(value)), core.at);
    return true;
}

// Parameters were changed by the program: all but the G code system is taken at once.
void reload_settings(Execution& x) {
    const GSystem system = x.settings.system;
    x.settings = x.make_settings(x.core.view().table(), x.core.view().channel);
    x.settings.system = system;
    x.core.compensation_options(x.settings.compensation);
    x.core.shows = {x.settings.shows_tool_vector, x.settings.shows_nose};
    // F6004#0 may have changed
    x.macro.expression = Expression(x.macro.variables, x.settings.angle_positive,
                                    x.settings.policy.macro.short_constants);
    if (x.settings.policy.macro.variable_names) x.macro.expression.names_from(x.macro.names);
}

}  // namespace

// A block between G10 L50 and G11: N parameter, P axis, R value (bit parameters: eight digits, #7
// first).
bool g10_parameter_block(Execution& x) {
    if (x.words.m_count || x.words.axis_count || x.words.groups)
        return x.core.fail(Alarm::TextInParameterInput, 'G');
    if (!x.block.has('N') || !x.block.has('R'))
        return x.core.fail(Alarm::ParameterInputIllegal, 'N', "N and R are needed");
    if (const Word& r = x.block.word('R');
        r.has_point && !r.from_expression && !x.settings.policy.tools.parameter_with_point)
        return x.core.fail(Alarm::PointForbidden, 'R', "R");
    const auto number = static_cast<std::int64_t>(x.block.value('N'));
    x.core.at.block = -1;
    if (number >= kFirstCell && number <= x.settings.policy.tools.last_cell)
        return compensation_cell(x.core, number,
                                 !x.settings.policy.tools.parameters_in_increments
                                     ? x.block.value('R')
                                     : x.block.value('R') * x.core.view().axes[0].increment);
    const std::string name = fmt::format("{}{:04}", x.settings.policy.tools.parameters, number);
    const params::Row* row = params::find(name);
    if (!row || row->type == params::Type::Text)
        return x.core.fail(Alarm::ParameterInputIllegal, 'N', name);
    MachineView& view = x.core.view();
    std::string line = name;
    if (row->scope == params::Scope::Channel) {
        line += fmt::format(" L{}", view.channel);
    } else if (row->scope == params::Scope::Axis) {
        const auto axis = x.block.has('P') ? static_cast<std::int64_t>(x.block.value('P')) : 0;
        if (axis < 1 || axis > view.axis_count)
            return x.core.fail(Alarm::ParameterInputIllegal, 'P', name + " needs P with the axis");
        line += fmt::format(" A{}", view.axes[static_cast<std::size_t>(axis - 1)].machine_axis + 1);
    }
    const double value = x.block.value('R');
    // digits of 0 and 1, #7 first; leading zeros may be left out
    if (row->type == params::Type::Bits) {
        bool binary = value >= 0 && value <= 11'111'111 && value == std::floor(value);
        for (auto digits = static_cast<std::int64_t>(binary ? value : 0); digits > 0; digits /= 10)
            binary = binary && digits % 10 <= 1;
        if (!binary)
            return x.core.fail(Alarm::ParameterInputIllegal, 'R',
                               name + " takes eight digits of 0 and 1");
        line += fmt::format("={:08.0f}", value);
    } else {
        // fanuc: no point in R; lengths and angles count increments, as on the control's own
        // parameter screen.
        const bool increments = x.settings.policy.tools.parameters_in_increments &&
                                row->type == params::Type::Real &&
                                (row->unit == "mm" || row->unit == "deg" || row->unit == "mm|deg");
        const auto place = row->scope == params::Scope::Axis
                               ? static_cast<std::size_t>(x.block.value('P') - 1)
                               : std::size_t{0};
        line += fmt::format("={}", increments ? value * view.axes[place].increment : value);
    }
    // ends of the stroke: as with G22 both sides must mean the same
    if (number == 1322 ||
        (x.settings.policy.tools.stroke_by_n1000 && number >= 1000 && number <= 1009))
        x.run.wants_barrier = true;
    if (!give_parameter(x, line, 'R')) return false;
    // the next word of the axis is read by them
    if (x.settings.policy.tools.rollover_by_f1008 && (number == 1008 || number == 1260)) {
        fanuc_rollover(view);
        x.core.load_zeros();
    }
    return true;
}

// The program's own machine has the value at once, everybody else when the machine comes here.
bool give_parameter(Execution& x, const std::string& line, char letter) {
    const auto parsed = params::parse_assignment(line);
    if (!parsed)
        return x.core.fail(Alarm::ParameterInputIllegal, letter, parsed.diagnosis().text());
    const auto applied = params::apply(*x.core.view().parameters, std::span(&*parsed, 1));
    if (!applied)
        return x.core.fail(Alarm::ParameterInputIllegal, letter, applied.diagnosis().text());
    x.core.mark_emitted();
    x.core.sink().parameter(line, x.core.at);
    MachineView& view = x.core.view();
    const MachineConfig derived = derive_machine_config(view.table());
    for (unsigned i = 0; i < view.axis_count; ++i) {
        ChannelAxis& axis = view.axes[i];
        axis.stroke = read_axis_stroke(view.table(), axis.machine_axis + 1u);
        axis.offset_diameter = derived.axis(axis.machine_axis + 1u).offset_diameter;
    }
    view.stroke = read_channel_stroke(view.table(), view.channel);
    reload_settings(x);
    return true;
}

}  // namespace polyturn::channels::fanuc
