// Resume states: see Language::resume_at. A point is noted for each block; it shares the full state of the point before it
// while nothing but an empty line has been read since. Variables, tools and zeros come back from the undo log.
#include "channels/sinumerik/interpreter.hpp"

namespace polyturn::channels::sinumerik {

struct Interpreter::ResumeState {
    PathState path;
    Modal modal;
    std::vector<Level> levels;
    std::map<std::string, std::string, std::less<>> macros;
    double parts = 0;
};

Interpreter::~Interpreter() = default;

void Interpreter::keep_resume_states(bool on) {
    keep_states_ = on;
    state_changed_ = true;
}

void Interpreter::note_resume_point() {
    if (state_changed_ || points_.empty()) {
        auto state = std::make_shared<ResumeState>();
        state->path = core_.path;
        state->modal = modal_;
        state->levels = levels_;
        state->macros = macros_;
        state->parts = parts_;
        points_.push_back({serial_, source_->next_position(), std::move(state), core_.reads_ahead()});
        state_changed_ = false;
        return;
    }
    points_.push_back({serial_, source_->next_position(), points_.back().state, core_.reads_ahead()});
}

void Interpreter::executed(std::uint64_t serial) {
    while (points_.size() > 1 && points_.front().serial < serial) points_.pop_front();
    while (!undo_log_.empty() && undo_log_.front().first < serial) undo_log_.pop_front();
}

bool Interpreter::resume_at(std::uint64_t serial) {
    while (!points_.empty() && points_.back().serial > serial) points_.pop_back();
    if (points_.empty() || points_.back().serial != serial || points_.back().compensated) return false;
    const Point point = points_.back();
    points_.pop_back();
    core_.compensation_reset();
    core_.path = point.state->path;
    modal_ = point.state->modal;
    levels_ = point.state->levels;
    macros_ = point.state->macros;
    parts_ = point.state->parts;
    while (!undo_log_.empty() && undo_log_.back().first >= serial) {
        undo_log_.back().second();
        undo_log_.pop_back();
    }
    core_.forget_pending();
    source_ = &files_->source(levels_.back().file);
    source_->seek(point.position);
    serial_ = serial - 1;
    ended_ = reread_ = jumped_ = called_ = wants_barrier_ = needs_barrier_ = false;
    block_undo_.clear();
    fresh_ = true;
    state_changed_ = true;
    core_.at.tool = core_.path.tool.ref;
    return true;
}

bool Interpreter::may_resume_at(std::uint64_t serial) const {
    for (auto point = points_.rbegin(); point != points_.rend() && point->serial >= serial; ++point)
        if (point->serial == serial) return !point->compensated && !core_.transformed();
    return false;
}

// Tools and their lengths are the program's own data here; zeros are the operator's.
bool Interpreter::offsets_changed() {
    if (core_.reads_ahead() || core_.transformed()) return false;
    core_.change_offsets([] {});
    state_changed_ = true;
    return true;
}

}  // namespace polyturn::channels::sinumerik
