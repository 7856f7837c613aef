// Resume states: see Language::resume_at. Variables, tools and zeros come back from the undo log.
#include "channels/sinumerik/interpreter.hpp"

namespace polyturn::channels::sinumerik {

void Interpreter::note_resume_point() {
    points_.note(
        x_.core, x_.run.serial, x_.calls.source->next_position(), 0, x_.run.state_changed, [this] {
            return ResumeState{
                {}, x_.modal, x_.calls.levels, x_.names.macros, x_.shown.parts, x_.actions.all};
        });
}

void Interpreter::executed(std::uint64_t serial) {
    points_.executed(serial);
    while (!x_.changes.of_run.empty() && x_.changes.of_run.front().first < serial)
        x_.changes.of_run.pop_front();
}

bool Interpreter::resume_at(std::uint64_t serial) {
    const auto point = points_.back_to(x_.core, serial);
    if (!point) return false;
    x_.modal = point->state->modal;
    x_.calls.levels = point->state->levels;
    x_.names.macros = point->state->macros;
    x_.shown.parts = point->state->parts;
    x_.actions.all = point->state->actions;
    x_.actions.in_action = false;
    while (!x_.changes.of_run.empty() && x_.changes.of_run.back().first >= serial) {
        x_.changes.of_run.back().second();
        x_.changes.of_run.pop_back();
    }
    x_.calls.source = &x_.files.source(x_.calls.levels.back().file);
    x_.calls.source->seek(point->position);
    x_.run.serial = serial - 1;
    x_.run.ended = x_.run.reread = x_.run.jumped = x_.run.called = x_.run.wants_barrier =
        x_.pass.needs_barrier = false;
    x_.run.tool_serial = 0;
    x_.changes.of_block.clear();
    x_.run.fresh = true;
    x_.run.state_changed = true;
    return true;
}

bool Interpreter::may_resume_at(std::uint64_t serial) const {
    return points_.may_go_back(x_.core, serial);
}

}  // namespace polyturn::channels::sinumerik
