// Resume states: see Language::resume_at. Variables, tools and zeros come back from the undo log.
#include <algorithm>

#include "channels/sinumerik/interpreter.hpp"

namespace polyturn::channels::sinumerik {

struct Interpreter::ResumeState {
    PathState path;
    Modal modal;
    std::vector<Level> levels;
    std::map<std::string, std::string, std::less<>> macros;
    double parts = 0;
    std::vector<SynchronizedAction> actions;
};

Interpreter::~Interpreter() = default;

void Interpreter::keep_resume_states(bool on) {
    keep_states_ = on;
    state_changed_ = true;
}

void Interpreter::note_resume_point() {
    points_.note(core_, serial_, source_->next_position(), 0, state_changed_,
                 [this] { return ResumeState{{}, modal_, levels_, macros_, parts_, actions_}; });
}

void Interpreter::executed(std::uint64_t serial) {
    points_.executed(serial);
    while (!undo_log_.empty() && undo_log_.front().first < serial) undo_log_.pop_front();
}

bool Interpreter::resume_at(std::uint64_t serial) {
    const auto point = points_.back_to(core_, serial);
    if (!point) return false;
    modal_ = point->state->modal;
    levels_ = point->state->levels;
    macros_ = point->state->macros;
    parts_ = point->state->parts;
    actions_ = point->state->actions;
    in_action_ = false;
    while (!undo_log_.empty() && undo_log_.back().first >= serial) {
        undo_log_.back().second();
        undo_log_.pop_back();
    }
    source_ = &files_->source(levels_.back().file);
    source_->seek(point->position);
    serial_ = serial - 1;
    ended_ = reread_ = jumped_ = called_ = wants_barrier_ = needs_barrier_ = false;
    managed_serial_ = 0;
    block_undo_.clear();
    fresh_ = true;
    state_changed_ = true;
    return true;
}

bool Interpreter::may_resume_at(std::uint64_t serial) const {
    return points_.may_go_back(core_, serial);
}

// Tools and their lengths are the program's own data here; zeros are the operator's.
bool Interpreter::offsets_changed() {
    if (core_.reads_ahead() || core_.transformed()) return false;
    core_.change_offsets([] {});
    state_changed_ = true;
    return true;
}

// Screens show the groups that every block depends on, and of the others what is not as delivered.
void Interpreter::active_codes(std::string& out) const {
    static constexpr std::array<unsigned, 9> kAlways{1, 6, 7, 8, 10, 13, 14, 15, 29};
    const auto add = [&](unsigned group) {
        const GCode* row = find_g(group, modal_.active[group]);
        if (!row) return;
        if (!out.empty()) out += ' ';
        out += row->name;
    };
    for (const unsigned group : kAlways) add(group);
    for (unsigned group = 1; group < kGroups; ++group) {
        if (std::find(kAlways.begin(), kAlways.end(), group) != kAlways.end()) continue;
        if (const GCode* row = find_g(group, modal_.active[group]); row && !row->preset) add(group);
    }
}

// R parameters that are not 0, then what the running level and its channel have declared; texts,
// axes and frames have no number.
void Interpreter::list_variables(const ShowVariable& show) const {
    for (std::size_t n = 0; r_ && n < r_->cells.size(); ++n)
        if (r_->cells[n].number != 0.0) show("R" + std::to_string(n), r_->cells[n].number);
    const auto declared = [&](const Scope& scope) {
        for (const auto& [name, reference] : scope.names) {
            if (!reference || reference.variable == r_) continue;
            const Variable& variable = *reference.variable;
            for (std::size_t i = 0; i < variable.cells.size(); ++i) {
                if (!variable.cells[i].is_number() ||
                    (!variable.dimensions.empty() && variable.cells[i].number == 0.0))
                    continue;
                show(variable.dimensions.empty() ? name : name + "[" + std::to_string(i) + "]",
                     variable.cells[i].number);
            }
        }
    };
    if (!levels_.empty() && levels_.back().scope) declared(*levels_.back().scope);
    if (channel_scope_) declared(*channel_scope_);
}

}  // namespace polyturn::channels::sinumerik
