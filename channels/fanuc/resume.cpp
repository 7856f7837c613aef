// Resume states of the fanuc family: see Language::resume_at.
// Variables, offsets and zeros are put back from the undo log.
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
    if (motion->tenths > 10 || drilling_ || !modal_calls_.empty() || parameter_input_ ||
        life_.mode || core_.path.after_thread)
        return false;
    return (block_.letters & ~kPositions) == 0 && block_.letters != 0 && block_.count > 0 &&
           !core_.vector_pending();
}

void Interpreter::note_resume_point() {
    variables_.begin_block(serial_);
    points_.note(core_, serial_, line_left_ ? source_->position() : source_->next_position(),
                 line_left_ ? column_ : 0, state_changed_, [this] {
                     ResumeState state;
                     state.modal = values_of(modal());
                     state.frames = frames_;
                     state.loops = loops_;
                     state.modal_calls = modal_calls_;
                     state.levels = variables_.levels();
                     state.turned = turned_;
                     return state;
                 });
}

void Interpreter::executed(std::uint64_t serial) {
    points_.executed(serial);
    variables_.undo().executed(serial);
}

bool Interpreter::resume_at(std::uint64_t serial) { return go_back_to(serial, false); }

bool Interpreter::go_back_to(std::uint64_t serial, bool within_compensation) {
    const auto point = points_.back_to(core_, serial, within_compensation);
    if (!point) return false;
    const ResumeState& state = *point->state;
    modal() = state.modal;
    frames_ = state.frames;
    loops_ = state.loops;
    modal_calls_ = state.modal_calls;
    variables_.set_levels(state.levels);
    turned_ = state.turned;
    variables_.undo().back_to(serial);
    source_ = &files_->source(frames_.back().file);
    source_->seek(point->position);
    line_left_ = false;
    if (point->column && source_->next(line_) == LineSource::Status::Line) {
        column_ = point->column;
        line_left_ = true;
    }
    serial_ = serial - 1;
    ended_ = reread_ = jumped_ = called_ = false;
    managed_serial_ = letters_written_in_ = 0;
    fresh_ = true;
    measuring_ = {};
    away_.reset();
    remote_.active = external_.active = false;
    look_whether_hidden();
    state_changed_ = true;
    return true;
}

bool Interpreter::may_resume_at(std::uint64_t serial) const {
    return points_.may_go_back(core_, serial);
}

// nct N1337 #5: only incremental words move along with what was done by hand; every other path is
// the programmed one.
void Interpreter::start_away(const AxisValues& by) {
    if (settings_.shifts_when_away) away_ = by;
}

bool Interpreter::offsets_changed() {
    if (core_.reads_ahead() || core_.transformed()) return false;
    core_.change_offsets([this] { (void)apply_tool_offsets(); });
    state_changed_ = true;
    return true;
}

}  // namespace polyturn::channels::fanuc
