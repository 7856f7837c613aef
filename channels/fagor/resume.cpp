// Resume states of fagor: see Language::resume_at. A point is noted for each block; the full state beside it only when the
// block before was more than a plain move, so that a long contour costs a few words a block. Parameters, tables and zeros are
// put back from the undo log.
#include "channels/fagor/resume_state.hpp"

namespace polyturn::channels::fagor {

Interpreter::~Interpreter() = default;

void Interpreter::keep_resume_states(bool on) {
    keep_states_ = on;
    values_.undo().enable(on);
    state_changed_ = true;
}

// A block of nothing but axis words, after which only positions differ.
bool Interpreter::is_plain_move() const {
    if (modal_.motion > 1 || core_.path.after_thread || block_.label >= 0 || core_.vector_pending() || modal_.feed_code == 32) return false;
    if (modal_.modal_call.kind != ModalCall::Kind::None || block_.count == 0 || core_.path.feed <= 0.0) return false;
    for (unsigned k = 0; k < block_.count; ++k)
        if (!axis_number(block_.words[k].letter)) return false;
    return true;
}

void Interpreter::note_resume_point() {
    values_.begin_block(serial_);
    if (state_changed_ || states_.empty()) {
        auto state = std::make_shared<ResumeState>();
        state->number = next_state_++;
        state->path = core_.path;
        state->modal = modal_;
        state->frames = frames_;
        state->levels = values_.levels();
        states_.push_back(std::move(state));
        state_changed_ = false;
    }
    points_.push_back({serial_, source_->next_position(), core_.path.programmed, core_.path.machine, states_.back()->number, core_.reads_ahead()});
}

void Interpreter::executed(std::uint64_t serial) {
    while (points_.size() > 1 && points_.front().serial < serial) points_.pop_front();
    while (states_.size() > 1 && !points_.empty() && states_.front()->number < points_.front().state) states_.pop_front();
    values_.undo().executed(serial);
}

bool Interpreter::resume_at(std::uint64_t serial) {
    while (!points_.empty() && points_.back().serial > serial) points_.pop_back();
    if (points_.empty() || points_.back().serial != serial || points_.back().compensated) return false;
    const ResumePoint point = points_.back();
    points_.pop_back();
    while (states_.back()->number > point.state) states_.pop_back();
    const ResumeState& state = *states_.back();
    core_.compensation_reset();
    core_.path = state.path;
    core_.path.programmed = point.programmed;
    core_.path.machine = point.machine;
    modal_ = state.modal;
    frames_ = state.frames;
    values_.set_levels(state.levels);
    values_.undo().back_to(serial);
    core_.forget_pending();
    source_ = &files_->source(frames_.back().file);
    source_->seek(point.position);
    serial_ = serial - 1;
    ended_ = reread_ = jumped_ = called_ = probing_ = false;
    fresh_ = true;
    state_changed_ = true;
    core_.at.tool = core_.path.tool.ref;
    show_diameter();
    return true;
}

bool Interpreter::may_resume_at(std::uint64_t serial) const {
    for (auto point = points_.rbegin(); point != points_.rend() && point->serial >= serial; ++point)
        if (point->serial == serial) return !point->compensated && !core_.transformed();
    return false;
}

bool Interpreter::offsets_changed() {
    if (core_.reads_ahead() || core_.transformed()) return false;
    core_.change_offsets([this] { load_tool(); });
    state_changed_ = true;
    return true;
}

}  // namespace polyturn::channels::fagor
