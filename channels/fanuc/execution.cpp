#include "channels/fanuc/execution.hpp"

#include <algorithm>

#include "channels/fanuc/program/start.hpp"

namespace polyturn::channels::fanuc {

Vocabulary::Vocabulary(const MachineView& view, const Settings& settings) : table(settings.system) {
    absolute_axis.fill(-1);
    incremental_axis.fill(-1);
    for (unsigned i = 0; i < view.axis_count; ++i)
        if (const std::string_view name = view.axes[i].name; name.size() == 1)
            absolute_axis[static_cast<std::size_t>(name[0] - 'A')] = static_cast<std::int8_t>(i);
    static constexpr char kIncrements[][2] = {{'U', 'X'}, {'V', 'Y'}, {'W', 'Z'}, {'H', 'C'}};
    for (const auto& [increment, axis] : kIncrements) {
        if (!settings.policy.words.increment_letters) break;
        const std::int8_t place = absolute_axis[static_cast<std::size_t>(axis - 'A')];
        if (place >= 0 &&
            std::ranges::find(settings.aux_letters, increment) == settings.aux_letters.end() &&
            absolute_axis[static_cast<std::size_t>(increment - 'A')] < 0)
            incremental_axis[static_cast<std::size_t>(increment - 'A')] = place;
    }
    for (std::size_t i = 0; i < 26; ++i)
        if (absolute_axis[i] >= 0 || incremental_axis[i] >= 0) axis_letters |= 1u << i;
    for (const GCode& row : g_codes()) {
        std::uint32_t mask = 0;
        for (const char letter : row.takes)
            mask |= letter == 'x' ? axis_letters : letter_bit(letter);
        takes.push_back(mask);
    }
}

Macro::Macro(VariableHost& host, ChannelStore& store, const Settings& settings)
    : variables(host, store, settings.common_first, settings.common_last),
      expression(variables, settings.angle_positive, settings.policy.macro.short_constants) {
    if (settings.policy.macro.variable_names) expression.names_from(names);
    system.parts_wanted = settings.parts_wanted;
    variables.share(settings.shared_100, settings.shared_500);
}

Execution::Execution(MachineView& view, Sink& sink, Port& port, ProgramFiles& program_files,
                     MakeSettings make)
    : core(view, sink, port),
      files(program_files),
      make_settings(make),
      settings(make(view.table(), view.channel)),
      vocabulary(view, settings),
      hooks(*this),
      scanner(hooks),
      macro(hooks, *view.store, settings) {
    hooks.names_in_brackets = settings.policy.macro.variable_names;
    hooks.takes_program_names = settings.policy.macro.program_names;
    hooks.has_long_names = !settings.spindle_names.empty();
    for (unsigned i = 0; i < view.axis_count; ++i)
        hooks.has_long_names |= view.axes[i].name.size() > 1;
    for (const auto& address : settings.spindle_addresses)
        hooks.has_long_names |= address.name.size() > 1;
    modal.parts = settings.parts_made;
    calls.frames.reserve(32);
    clear_modal(*this);
}

}  // namespace polyturn::channels::fanuc
