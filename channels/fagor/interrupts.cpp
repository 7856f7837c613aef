// INT1 to INT4: an input interrupts the program by a subroutine (fagor_8037t part 2, 12.6).
//
// The kernel stops the path, drops what was pushed and reports the first block that is not
// executed. Interpretation goes back there and the subroutine is called as if it were before that
// block; it keeps the local parameters. Behind RET the block in which the program was left is
// driven to its end, from wherever the subroutine (or its REPOS) has left the axes.
#include "channels/fagor/resume_state.hpp"

namespace polyturn::channels::fagor {

void Interpreter::arm_interrupts() {
    Interrupts watch;
    for (unsigned n = 0; n < settings_.interrupt_subroutine.size(); ++n)
        if (settings_.interrupt_subroutine[n] > 0) watch.inputs |= 1u << n;
    if (!watch.inputs || reads_profile_) return;
    watch.on = true;
    if (!keep_states_) keep_resume_states(true);
    core_.sink().interrupts(watch, core_.at);
}

bool Interpreter::interrupt(std::uint64_t serial, bool within, unsigned input) {
    if (input < 1 || input > settings_.interrupt_subroutine.size()) return false;
    const std::int64_t number = settings_.interrupt_subroutine[input - 1];
    FileId file = 0;
    TextPosition begin;
    if (core_.reads_ahead() || (serial && !resume_at(serial))) return false;
    if (!find_subroutine(number, file, begin)) return false;
    interrupt_again_ = within;
    interrupt_begin_ = core_.path.programmed;
    interrupted_ = std::make_shared<ResumeState>();
    interrupted_->path = core_.path;
    interrupted_->modal = modal_;
    take_machine();
    if (within) core_.taps(false);  // of a tap that is broken off nothing else would end it
    modal_.modal_call = {};
    CallFrame frame;
    frame.kind = CallFrame::Kind::Subroutine;
    frame.file = file;
    frame.begin = begin;
    frame.interrupt = true;
    frame.program = frames_.back().program;
    frame.maker = frames_.back().maker;
    frame.point = core_.path.programmed;
    frame.resume = source_->next_position();
    source_ = &files_->source(file);
    source_->seek(begin);
    frames_.push_back(frame);
    ended_ = reread_ = probing_ = false;
    managed_serial_ = 0;
    fresh_ = state_changed_ = true;
    return true;
}

// An axis outside of the plane that neither REPOS nor the block read again names stays where the
// subroutine has left it.
void Interpreter::stay_where_left() {
    int p = -1, q = -1;
    core_.plane_axes(p, q);
    for (unsigned i = 0; i < core_.view().axis_count; ++i)
        if (!axis_words_[i] && static_cast<int>(i) != p && static_cast<int>(i) != q)
            core_.path.programmed[i] = interrupt_left_[i];
}

// RET: what held before holds again; parameters keep what the subroutine has written.
bool Interpreter::return_from_interrupt() {
    pop_frame();
    const ResumeState& before = *interrupted_;
    const double parts = modal_.parts;
    std::vector<WrittenProgram> written = modal_.written;
    modal_ = before.modal;
    modal_.parts = parts;
    modal_.written = std::move(written);
    PathState& path = core_.path;
    path.feed_mode = before.path.feed_mode;
    path.feed = before.path.feed;
    path.exact_stop_mode = before.path.exact_stop_mode;
    path.override_locked = before.path.override_locked;
    path.plane = before.path.plane;
    path.plane_p = before.path.plane_p;
    path.plane_q = before.path.plane_q;
    if (path.zero_row != before.path.zero_row) core_.select_zero(before.path.zero_row);
    show_diameter();
    interrupt_left_ = path.programmed;
    interrupt_fill_ = interrupt_again_;
    // the block is read again: increments and centres count from its start
    if (interrupt_again_) path.programmed = interrupt_begin_;
    called_ = true;
    arm_interrupts();
    return true;
}

}  // namespace polyturn::channels::fagor
