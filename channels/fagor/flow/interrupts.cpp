#include "channels/fagor/flow/interrupts.hpp"

#include <utility>

#include "channels/engine/block_edges.hpp"
#include "channels/fagor/execution.hpp"
#include "channels/fagor/flow/calls.hpp"
#include "channels/fagor/flow/programs.hpp"
#include "channels/fagor/flow/resume.hpp"
#include "channels/fagor/motion/lengths.hpp"

namespace polyturn::channels::fagor {

void arm_interrupts(Execution& x) {
    Interrupts watch;
    for (unsigned n = 0; n < x.settings.interrupt_subroutine.size(); ++n)
        if (x.settings.interrupt_subroutine[n] > 0) watch.inputs |= 1u << n;
    if (!watch.inputs || x.ahead.reads_profile) return;
    watch.on = true;
    if (!x.run.keeps_states) keep_resume_states(x, true);
    x.core.sink().interrupts(watch, x.core.at);
}

bool enter_interrupt(Execution& x, std::uint64_t serial, bool within, unsigned input) {
    if (input < 1 || input > x.settings.interrupt_subroutine.size()) return false;
    const std::int64_t number = x.settings.interrupt_subroutine[input - 1];
    FileId file = 0;
    TextPosition begin;
    if (x.core.reads_ahead() || (serial && !resume_at(x, serial))) return false;
    if (!find_subroutine(x, number, file, begin)) return false;
    x.interrupt.again = within;
    x.interrupt.begin = x.core.path.programmed;
    x.interrupt.before = std::make_shared<ResumeState>();
    x.interrupt.before->path = x.core.path;
    x.interrupt.before->modal = x.modal;
    engine::take_machine(x.core);
    if (within) x.core.taps(false);  // of a tap that is broken off nothing else would end it
    x.modal.modal_call = {};
    CallFrame frame;
    frame.kind = CallFrame::Kind::Subroutine;
    frame.file = file;
    frame.begin = begin;
    frame.interrupt = true;
    frame.program = x.calls.here().program;
    frame.maker = x.calls.here().maker;
    frame.point = x.core.path.programmed;
    x.calls.enter(frame);
    engine::break_in(x.run);
    x.probe.under_way = false;
    return true;
}

// An axis outside of the plane that neither REPOS nor the block read again names stays where the
// subroutine has left it.
void stay_where_left(Execution& x) {
    int p = -1, q = -1;
    x.core.plane_axes(p, q);
    for (unsigned i = 0; i < x.core.view().axis_count; ++i)
        if (!x.words.axis[i] && static_cast<int>(i) != p && static_cast<int>(i) != q)
            x.core.path.programmed[i] = x.interrupt.left[i];
}

// RET: what held before holds again; parameters keep what the subroutine has written.
bool return_from_interrupt(Execution& x) {
    pop_frame(x);
    const ResumeState& before = *x.interrupt.before;
    const double parts = x.modal.parts;
    std::vector<WrittenProgram> written = x.modal.written;
    x.modal = before.modal;
    x.modal.parts = parts;
    x.modal.written = std::move(written);
    PathState& path = x.core.path;
    path.feed_mode = before.path.feed_mode;
    path.feed = before.path.feed;
    path.exact_stop_mode = before.path.exact_stop_mode;
    path.override_locked = before.path.override_locked;
    path.plane = before.path.plane;
    path.plane_p = before.path.plane_p;
    path.plane_q = before.path.plane_q;
    if (path.zero_row != before.path.zero_row) x.core.select_zero(before.path.zero_row);
    show_diameter(x);
    x.interrupt.left = path.programmed;
    x.interrupt.fill = x.interrupt.again;
    // the block is read again: increments and centres count from its start
    if (x.interrupt.again) path.programmed = x.interrupt.begin;
    x.run.called = true;
    arm_interrupts(x);
    return true;
}

}  // namespace polyturn::channels::fagor
