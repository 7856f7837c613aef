// Resume states of fagor: see Language::resume_at. Parameters, tables and zeros are put back from
// the undo log.
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
    if (modal_.motion > 1 || core_.path.after_thread || block_.label >= 0 ||
        core_.vector_pending() || modal_.feed_code == 32)
        return false;
    if (modal_.modal_call.kind != ModalCall::Kind::None || block_.count == 0 ||
        core_.path.feed <= 0.0)
        return false;
    for (unsigned k = 0; k < block_.count; ++k)
        if (!axis_number(block_.words[k].letter)) return false;
    return true;
}

void Interpreter::note_resume_point() {
    values_.begin_block(serial_);
    points_.note(core_, serial_, source_->next_position(), 0, state_changed_, [this] {
        return ResumeState{{}, modal_, frames_, values_.levels()};
    });
}

void Interpreter::executed(std::uint64_t serial) {
    points_.executed(serial);
    values_.undo().executed(serial);
}

bool Interpreter::resume_at(std::uint64_t serial) {
    const auto point = points_.back_to(core_, serial);
    if (!point) return false;
    const ResumeState& state = *point->state;
    modal_ = state.modal;
    frames_ = state.frames;
    values_.set_levels(state.levels);
    values_.undo().back_to(serial);
    source_ = &files_->source(frames_.back().file);
    source_->seek(point->position);
    serial_ = serial - 1;
    ended_ = reread_ = jumped_ = called_ = probing_ = false;
    managed_serial_ = 0;
    fresh_ = true;
    state_changed_ = true;
    show_diameter();
    return true;
}

bool Interpreter::may_resume_at(std::uint64_t serial) const {
    return points_.may_go_back(core_, serial);
}

bool Interpreter::offsets_changed() {
    if (core_.reads_ahead() || core_.transformed()) return false;
    core_.change_offsets([this] { load_tool(); });
    state_changed_ = true;
    return true;
}

// Screens show the way of moving first, then everything else that holds.
void Interpreter::active_codes(std::string& out) const {
    const auto add = [&](unsigned number) {
        if (!out.empty()) out += ' ';
        out += 'G';
        if (number < 10) out += '0';
        out += std::to_string(number);
    };
    add(modal_.motion);
    for (const unsigned code : {modal_.plane, modal_.corner, modal_.comp, modal_.feed_code,
                                modal_.zero, modal_.zero_added})
        if (code) add(code);
    if (modal_.zero == 159) out += " N" + std::to_string(modal_.zero_number);
    add(modal_.absolute ? 90 : 91);
    add(modal_.inch ? 70 : 71);
    if (modal_.scale != 1.0) add(72);
}

// Arithmetic parameters: local ones of the running level, global, of the user, of the maker.
void Interpreter::list_variables(const ShowVariable& show) const {
    values_.each_parameter(
        [&](std::size_t number, double value) { show("P" + std::to_string(number), value); });
}

}  // namespace polyturn::channels::fagor
