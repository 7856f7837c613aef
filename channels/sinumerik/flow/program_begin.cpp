// What holds when a program begins.
#include "channels/sinumerik/flow/program_begin.hpp"

#include "channels/sinumerik/execution.hpp"
#include "channels/text/word_scanner.hpp"
#include "ipc/model/machine/store/work_zeros.hpp"

namespace polyturn::channels::sinumerik {

// MD20150 takes only commands that the tables of the groups mark (sinumerik_part3 2 and 6.3); what
// is active as delivered stands there too.
std::optional<Diagnosis> reset_value_fault(const Execution& x) {
    for (unsigned group = 1; group < kGroups; ++group) {
        const unsigned number = x.settings.g_reset[group - 1];
        const GCode* row = find_g(group, number);
        if (number == 0 || (row && row->preset)) continue;
        const std::string said = "MD20150[" + std::to_string(group - 1) +
                                 "]=" + std::to_string(number) +
                                 (row ? " (" + std::string(row->name) + ")" : "");
        const bool marked = row && row->modal && group != 7 && group != 26 && group != 31 &&
                            group != 32 && group != 33 && !(group == 35 && number >= 4);
        Diagnosis wrong;
        wrong.alarm = !marked ? Alarm::ParamRange : Alarm::NotBuilt;
        wrong.detail = !marked ? said : std::string(row->name);
        if (!marked || !row->act) return wrong;
    }
    return std::nullopt;
}
// The state of cycle start: MD20150, else the delivery state.
void reset_modal(Execution& x) {
    const auto last = x.modal.active;  // MD20152: what the program before has left
    x.modal = {};
    for (const GCode& row : g_codes())
        if (row.preset && row.modal) x.modal.active[row.group] = row.number;
    for (unsigned group = 1; group < kGroups; ++group)
        if (const GCode* row = find_g(group, x.settings.g_reset[group - 1]);
            row && row->act && row->modal)
            x.modal.active[group] = row->number;
    for (unsigned group = 1; group < kGroups; ++group)
        if (x.settings.g_keep[group - 1] && last[group] != 0 && group != 7)
            x.modal.active[group] = last[group];
    x.core.path.plane = static_cast<Plane>(x.modal.active[6] - 1);
    x.core.path.exact_stop_mode = x.modal.active[10] == 1;
    x.core.path.override_locked = false;
    x.modal.feed_revolution = x.modal.active[15] == 3 || x.modal.active[15] == 4 ||
                              x.modal.active[15] == 5 || x.modal.active[15] == 13;
    x.core.path.feed = 0;
    x.core.path.feed_path = {};
    x.core.path.surface_axis = -1;
    x.modal.master_spindle = x.core.path.spindle.spindle = x.core.view().config().default_spindle;
    x.core.path.tool = {};
    x.core.path.tool.nose_off = true;
    x.core.path.wanted = x.core.path.vector = {};  // no overlay outlives its program
}
}  // namespace polyturn::channels::sinumerik
