// Resume states of the fanuc family: see Language::resume_at.
// Variables, offsets and zeros are put back from the undo log.
#include "channels/fanuc/program/resume.hpp"

#include "channels/fanuc/execution.hpp"
#include "channels/fanuc/program/calls.hpp"

namespace polyturn::channels::fanuc {

void keep_resume_states(Execution& x, bool on) {
    x.run.keeps_states = on;
    x.macro.variables.undo().enable(on);
    x.run.state_changed = true;
}

// A block of nothing but axis words, after which only positions and the block number differ.
bool is_plain_move(const Execution& x) {
    constexpr std::uint32_t kPositions = letter_set("XYZUVW");
    const GCode* motion = x.modal.motion;
    if (motion->tenths > 10 || x.modal.drilling || !x.calls.modal.empty() ||
        x.modal.parameter_input || x.modal.life.mode || x.core.path.after_thread)
        return false;
    return (x.block.letters & ~kPositions) == 0 && x.block.letters != 0 && x.block.count > 0 &&
           !x.core.vector_pending();
}

void note_resume_point(Execution& x) {
    x.macro.variables.begin_block(x.run.serial);
    x.way_back.points.note(
        x.core, x.run.serial,
        x.text.line_left ? x.text.source->position() : x.text.source->next_position(),
        x.text.line_left ? x.text.column : 0, x.run.state_changed, [&x] {
            ResumeState state;
            state.modal = x.modal;
            state.frames = x.calls.frames;
            state.loops = x.calls.loops;
            state.modal_calls = x.calls.modal;
            state.levels = x.macro.variables.levels();
            state.turned = x.machine.turned;
            return state;
        });
}

bool go_back_to(Execution& x, std::uint64_t serial, bool within_compensation) {
    const auto point = x.way_back.points.back_to(x.core, serial, within_compensation);
    if (!point) return false;
    const ResumeState& state = *point->state;
    x.modal = state.modal;
    x.calls.frames = state.frames;
    x.calls.loops = state.loops;
    x.calls.modal = state.modal_calls;
    x.macro.variables.set_levels(state.levels);
    x.machine.turned = state.turned;
    x.macro.variables.undo().back_to(serial);
    x.text.source = &x.files.source(x.calls.frames.back().file);
    x.text.source->seek(point->position);
    x.text.line_left = false;
    if (point->column && x.text.source->next(x.text.line) == LineSource::Status::Line) {
        x.text.column = point->column;
        x.text.line_left = true;
    }
    x.run.serial = serial - 1;
    x.run.ended = x.run.reread = x.run.jumped = x.run.called = false;
    x.run.tool_serial = x.macro.written.serial = 0;
    x.run.fresh = true;
    x.awaited.measuring = {};
    x.machine.away.reset();
    x.awaited.remote.active = x.awaited.external.active = false;
    look_whether_hidden(x);
    x.run.state_changed = true;
    return true;
}

}  // namespace polyturn::channels::fanuc
