// Resume states of the fanuc family: see Language::resume_at.
//
// A point is noted for each block; the full state beside it only when the block before was more than a plain move, so that
// a long contour costs a few words a block. Variables, offsets and zeros are put back from the undo log.
#include "channels/fanuc/resume_state.hpp"

namespace polyturn::channels::fanuc {
Interpreter::~Interpreter() = default;

void Interpreter::keep_resume_states(bool on) {
    keep_states_ = on;
    variables_.undo().enable(on);
    state_changed_ = true;
}

// A block of nothing but axis words, after which only positions and the block number differ.
bool Interpreter::is_plain_move() const {
    constexpr std::uint32_t kPositions = letter_set("XYZUVW");
    const GCode* motion = motion_;
    if (motion->tenths > 10 || drilling_ || !modal_calls_.empty() || parameter_input_ || core_.path.after_thread) return false;
    return (block_.letters & ~kPositions) == 0 && block_.letters != 0 && block_.count > 0 && !core_.vector_pending();
}

void Interpreter::note_resume_point() {
    variables_.begin_block(serial_);
    if (state_changed_ || states_.empty()) {
        auto state = std::make_shared<ResumeState>();
        state->number = next_state_++;
        state->path = core_.path;
        state->modal = values_of(modal());
        state->frames = frames_;
        state->loops = loops_;
        state->modal_calls = modal_calls_;
        state->levels = variables_.levels();
        states_.push_back(std::move(state));
        state_changed_ = false;
    }
    points_.push_back({serial_, line_left_ ? source_->position() : source_->next_position(), line_left_ ? column_ : 0,
                       core_.path.programmed, core_.path.machine, core_.path.last_way, states_.back()->number, core_.reads_ahead()});
}

void Interpreter::executed(std::uint64_t serial) {
    while (points_.size() > 1 && points_.front().serial < serial) points_.pop_front();
    while (states_.size() > 1 && !points_.empty() && states_.front()->number < points_.front().state) states_.pop_front();
    variables_.undo().executed(serial);
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
    core_.path.last_way = point.last_way;
    modal() = state.modal;
    frames_ = state.frames;
    loops_ = state.loops;
    modal_calls_ = state.modal_calls;
    variables_.set_levels(state.levels);
    variables_.undo().back_to(serial);
    core_.forget_pending();
    source_ = &files_->source(frames_.back().file);
    source_->seek(point.position);
    line_left_ = false;
    if (point.column && source_->next(line_) == LineSource::Status::Line) {
        column_ = point.column;
        line_left_ = true;
    }
    serial_ = serial - 1;
    ended_ = reread_ = jumped_ = called_ = false;
    fresh_ = true;
    measuring_ = {};
    state_changed_ = true;
    core_.at.tool = core_.path.tool.ref;
    return true;
}

bool Interpreter::may_resume_at(std::uint64_t serial) const {
    for (auto point = points_.rbegin(); point != points_.rend() && point->serial >= serial; ++point)
        if (point->serial == serial) return !point->compensated && !core_.transformed();
    return false;
}

bool Interpreter::offsets_changed() {
    if (core_.reads_ahead() || core_.transformed()) return false;
    core_.change_offsets([this] { (void)apply_tool_offsets(); });
    state_changed_ = true;
    return true;
}

}  // namespace polyturn::channels::fanuc
