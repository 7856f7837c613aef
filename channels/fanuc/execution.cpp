#include "channels/fanuc/execution.hpp"

#include "channels/fanuc/program/start.hpp"

namespace polyturn::channels::fanuc {

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
        hooks.has_long_names |= view.axes[i].name.size() != 1;
    for (const auto& address : settings.spindle_addresses)
        hooks.has_long_names |= address.name.size() > 1;
    modal.parts = settings.parts_made;
    calls.frames.reserve(32);
    clear_modal(*this);
}

}  // namespace polyturn::channels::fanuc
