#include "channels/fagor/flow/resume.hpp"

#include "channels/engine/block_edges.hpp"
#include "channels/fagor/execution.hpp"
#include "channels/fagor/motion/lengths.hpp"
#include "channels/fagor/tools/tool_words.hpp"

namespace polyturn::channels::fagor {

void keep_resume_states(Execution& x, bool on) {
    x.run.keeps_states = on;
    x.values.undo().enable(on);
    x.run.state_changed = true;
}

// A block of nothing but axis words, after which only positions differ.
bool is_plain_move(const Execution& x) {
    if (x.modal.motion > 1 || x.core.path.after_thread || x.line.block.label >= 0 ||
        x.core.vector_pending() || x.modal.feed_code == 32)
        return false;
    if (x.modal.modal_call.kind != ModalCall::Kind::None || x.line.block.count == 0 ||
        x.core.path.feed <= 0.0)
        return false;
    for (unsigned k = 0; k < x.line.block.count; ++k)
        if (!axis_number(x.line.block.words[k].letter)) return false;
    return true;
}

void note_resume_point(Execution& x) {
    x.values.begin_block(x.run.serial);
    x.points.note(x.core, x.run.serial, x.calls.source().next_position(), 0, x.run.state_changed,
                  [&x] {
                      return ResumeState{{}, x.modal, x.calls.frames(), x.values.levels()};
                  });
}

void executed(Execution& x, std::uint64_t serial) {
    x.points.executed(serial);
    x.values.undo().executed(serial);
}

bool resume_at(Execution& x, std::uint64_t serial) {
    const auto point = x.points.back_to(x.core, serial);
    if (!point) return false;
    const ResumeState& state = *point->state;
    x.modal = state.modal;
    x.values.set_levels(state.levels);
    x.values.undo().back_to(serial);
    x.calls.restore(state.frames, point->position);
    engine::go_back(x.run, serial);
    x.probe.under_way = false;
    show_diameter(x);
    return true;
}

bool offsets_changed(Execution& x) {
    if (x.core.reads_ahead() || x.core.transformed()) return false;
    x.core.change_offsets([&x] { load_tool(x); });
    x.run.state_changed = true;
    return true;
}

}  // namespace polyturn::channels::fagor
