// M96, M97: a signal interrupts the program (fanuc_lathe 6.14, nct part 2 18.7).
//
//   N10 ----+- - - -> N20        type I: N10 breaks off. The rest of it is lost if the interrupt program has NC statements,
//           |          ^         and driven after M99 if it has only macro statements.
//           '-> O8300 -'         type II: at the end of N10.
//
// The kernel stops the path, drops what was pushed and reports the first block that is not
// executed. Interpretation goes back there, and the interrupt program is called as if it were
// before that block. While it runs no signal counts; M99 switches the watch on again, in path
// order. Compensation rests meanwhile; behind M99 the path goes straight to the next vector.
#include <algorithm>

#include "channels/fanuc/resume_state.hpp"

namespace polyturn::channels::fanuc {

void Interpreter::arm_interrupts(bool on) {
    core_.mark_emitted();
    core_.sink().interrupts(
        {on, settings_.interrupt.at_block_end, settings_.interrupt.by_level, settings_.nct},
        core_.at);
}

bool Interpreter::interrupt_code(const Word& word) {
    const bool on = word.value == settings_.interrupt.on;
    if (on) {
        if (!block_.has('P')) return core_.fail(Alarm::SubprogramWordMissing, 'M');
        std::int64_t program = 0;
        if (!whole('P', program)) return false;
        if (!files_->find_number(program) && !find_program_in(frames_.back().file, program))
            return core_.fail(Alarm::SubprogramMissing, 'P', "O" + std::to_string(program));
        interrupting_ = {true, program};
        if (!keep_states_) keep_resume_states(true);
    } else {
        interrupting_.on = false;
        if (block_.has('P')) {
            if (!whole('P', local_call_)) return false;
            sub_column_ = block_.word('P').column;
            sub_length_ = block_.word('P').length;
        }
    }
    if (!interruption_.running) arm_interrupts(on);
    return true;
}

// Are there blocks of words in it? Calls count: what they do cannot be seen from here.
bool Interpreter::interrupt_program_has_statements(std::int64_t program) {
    const auto file = files_->find_number(program);
    const FileId id = file ? *file : frames_.front().file;
    const auto begin = find_program_in(id, program);
    LineSource& source = files_->source(id);
    const TextPosition back = source.next_position();
    source.seek(begin.value_or(TextPosition{}));
    std::string_view line;
    bool found = false;
    for (int lines = 0; !found && lines < 10'000 && source.next(line) == LineSource::Status::Line;
         ++lines) {
        std::size_t i = 0;
        const auto blanks = [&] {
            while (i < line.size() && (line[i] == ' ' || line[i] == '\t')) ++i;
        };
        for (blanks(); i < line.size() &&
                       (line[i] == 'N' || line[i] == 'O' || line[i] == 'n' || line[i] == 'o');
             blanks()) {
            ++i;
            blanks();
            while (i < line.size() && line[i] >= '0' && line[i] <= '9') ++i;
        }
        if (i >= line.size() || line[i] == '(' || line[i] == ';' || line[i] == '%' ||
            line[i] == '#' || line[i] == '[')
            continue;
        const std::string_view rest = line.substr(i);
        if (rest.starts_with("M99") || rest.starts_with("m99")) break;
        static constexpr std::string_view kMacro[] = {"IF",    "WHILE", "GOTO",  "DO",    "END",
                                                      "POPEN", "PCLOS", "DPRNT", "BPRNT", "SETVN"};
        found = std::none_of(std::begin(kMacro), std::end(kMacro),
                             [&](std::string_view word) { return rest.starts_with(word); });
    }
    source.seek(back);
    return found;
}

bool Interpreter::interrupt(std::uint64_t serial, bool within, unsigned) {
    // What held in that block, and not what was read since then.
    Interrupting watch = interrupting_;
    if (const auto* point = points_.find(serial))
        watch = std::get<Interrupting>(point->state->modal);
    if (!watch.on) return false;
    interruption_ = {};
    const bool goes_on_behind = within && interrupt_program_has_statements(watch.program);
    interruption_.again = within && !goes_on_behind;
    const auto* point = points_.find(serial + 1);
    const bool read_on = within && point;
    if (read_on)
        interruption_.end = point->programmed;
    else
        interruption_.end = core_.path.programmed;
    const std::uint64_t target = goes_on_behind ? (read_on ? serial + 1 : 0) : serial;
    const bool compensating = core_.compensating();
    if (target && !go_back_to(target, true)) return false;
    // nothing that was held back is driven
    if (compensating || core_.reads_ahead()) core_.compensation_reset();
    GCode const*& comp = active_[static_cast<std::size_t>(GGroup::Comp)];
    if (comp && comp->act == &Interpreter::g_comp_on)
        interruption_.side = comp->tenths == 410 ? CompSide::Left : CompSide::Right;
    ended_ = false;
    interrupting_ = watch;
    // of a tap that is broken off nothing else would end it
    if (within && drilling_) core_.taps(false);
    if (!within) interruption_.end = core_.path.programmed;
    interruption_.begin = core_.path.programmed;
    if (!only_macros_) restore_interrupted_position();
    for (std::size_t k = 0; k < interruption_.modal_variables.size(); ++k) {
        double value = 0.0;
        interruption_.modal_variables[k] =
            modal_variable(4001 + static_cast<std::int64_t>(k), value) ? value : kNull;
    }
    interrupted_ = std::make_shared<ResumeState>();
    interrupted_->path = core_.path;  // its feed, plane and zero hold again behind it
    interrupted_->modal = values_of(modal());
    interrupted_->modal_calls = modal_calls_;
    interruption_.running = interruption_.shows_end = true;
    comp = table_.find(400);  // the interrupt program drives what it says
    modal_calls_.clear();

    CallLevel frame;
    frame.interrupt = true;
    if (const auto file = files_->find_number(interrupting_.program))
        frame.file = *file;
    else
        frame.file = frames_.front().file;
    if (const auto begin = find_program_in(frame.file, interrupting_.program)) frame.begin = *begin;
    frame.resume = place_behind(column_);
    frame.macro = settings_.interrupt.own_locals;
    frame.loops = loops_.size();
    frame.outer_program = program_number_;
    frame.program = interrupting_.program;
    if (frame.macro) variables_.push_locals(empty_locals());
    source_ = &files_->source(frame.file);
    source_->seek(frame.begin);
    frames_.push_back(std::move(frame));
    blocks_begun_ = line_left_ = reread_ = false;
    managed_serial_ = letters_written_in_ = 0;
    fresh_ = state_changed_ = true;
    measuring_ = {};
    return true;
}

void Interpreter::restore_interrupted_position() {
    for (unsigned i = 0; i < core_.view().axis_count; ++i)
        if (const auto now = core_.port().axis_taken_over(core_.view().axes[i].machine_axis))
            core_.take_machine(i, *now);
}

// Type II: the macro statements at the beginning of the interrupt program act while the block is
// still driven, what follows the first other one behind it. What they read is of the tick at which
// the signal was seen.
bool Interpreter::interrupt_ahead(std::uint64_t serial) {
    // a loop that waits for something waits at the end of the block
    constexpr int kMostStatements = 10'000;
    if (settings_.nct || core_.reads_ahead() || !may_resume_at(serial)) return false;
    only_macros_ = true;
    if (!interrupt(serial, false, 0)) return only_macros_ = false;
    for (int n = 0; n < kMostStatements && only_macros_; ++n) {
        fresh_ = true;
        if (read_block() == Step::Failed) only_macros_ = false;
    }
    only_macros_ = false;
    return true;
}

void Interpreter::interrupt_arrived() {
    restore_interrupted_position();
    core_.refresh_limits();
    fresh_ = true;
}

// M99 restores what held before; M99 P leaves what the interrupt program has set.
bool Interpreter::return_from_interrupt(bool has_target, std::int64_t target) {
    const CallLevel done = std::move(frames_.back());
    frames_.pop_back();
    loops_.resize(done.loops);
    if (done.macro) variables_.pop_locals();
    program_number_ = done.outer_program;
    source_ = &files_->source(frames_.back().file);
    go_on_at(done.resume);
    blocks_begun_ = state_changed_ = true;
    interruption_.running = false;
    if (!has_target) {
        const ResumeState& before = *interrupted_;
        const double parts = parts_;
        const Interrupting watch = interrupting_;
        const std::uint32_t control = control_bits();
        modal() = before.modal;
        // the machine has what the interrupt program has put off
        if (control_bits() != control) tell_control();
        parts_ = parts;
        interrupting_ = watch;
        modal_calls_ = before.modal_calls;
        PathState& path = core_.path;
        path.feed_mode = before.path.feed_mode;
        path.feed = before.path.feed;
        path.plane = before.path.plane;
        path.exact_stop_mode = before.path.exact_stop_mode;
        path.override_locked = before.path.override_locked;
        path.exact_stop_off = before.path.exact_stop_off;
        if (path.zero_row != before.path.zero_row) core_.select_zero(before.path.zero_row);
        interruption_.goes_on = interruption_.again;
        // the block is read again: increments count from its start
        if (interruption_.again) path.programmed = interruption_.begin;
        // From where the tool is now straight to the vector at the end of the next block.
        if (interruption_.side != CompSide::Off && core_.compensation(interruption_.side))
            core_.compensation_resumes();
    }
    if (interrupting_.on) arm_interrupts(true);
    return has_target ? jump_to(target) : true;
}

}  // namespace polyturn::channels::fanuc
