// Reading blocks and the flow between programs. What a block does is in block.cpp and behind
// the handlers.
#include "channels/sinumerik/interpreter.hpp"

#include <algorithm>
#include <utility>

#include "channels/text/word_scanner.hpp"

namespace polyturn::channels::sinumerik {
namespace {

constexpr std::size_t kLongestBlock = 512;  // with comment and line feed (sinumerik_part1 3.2)
constexpr unsigned kDeepestText = 16;       // EXECSTRING within EXECSTRING

}  // namespace

Interpreter::Interpreter(MachineView& view, Sink& sink, Port& port, ProgramFiles& files)
    : core_(view, sink, port),
      files_(&files),
      settings_(read_settings(view.table(), view)),
      r_(std::make_shared<Variable>()) {
    r_->name = "R";
    r_->dimensions = {static_cast<unsigned>(settings_.r_parameters)};
    r_->cells.assign(static_cast<std::size_t>(settings_.r_parameters), Value::of_real(0.0));
    core_.wait_for_spindle(true);
    core_.lie_in_frame(false, true);
    reset_modal();
}

// The state of cycle start: MD20150, else the delivery state.
void Interpreter::reset_modal() {
    const auto last = modal_.active;  // MD20152: what the program before has left
    modal_ = {};
    for (const GCode& row : g_codes())
        if (row.preset && row.modal) modal_.active[row.group] = row.number;
    for (unsigned group = 1; group < kGroups; ++group)
        if (const GCode* row = find_g(group, settings_.g_reset[group - 1]);
            row && row->act && row->modal)
            modal_.active[group] = row->number;
    for (unsigned group = 1; group < kGroups; ++group)
        if (settings_.g_keep[group - 1] && last[group] != 0 && group != 7)
            modal_.active[group] = last[group];
    core_.path.plane = static_cast<Plane>(modal_.active[6] - 1);
    core_.path.exact_stop_mode = modal_.active[10] == 1;
    core_.path.override_locked = false;
    modal_.feed_revolution = modal_.active[15] == 3 || modal_.active[15] == 4 ||
                             modal_.active[15] == 5 || modal_.active[15] == 13;
    core_.path.feed = 0;
    core_.path.feed_path = {};
    core_.path.surface_axis = -1;
    modal_.master_spindle = core_.path.spindle.spindle = core_.view().config().default_spindle;
    core_.path.tool = {};
    core_.path.tool.nose_off = true;
    core_.path.wanted = core_.path.vector = {};  // no overlay outlives its program
}

void Interpreter::activate(unsigned group, unsigned number) {
    modal_.active[group] = static_cast<std::uint8_t>(number);
}

Result<void> Interpreter::start(FileId main) {
    core_.begin_control();
    core_.compensation_reset();
    settings_ = read_settings(core_.view().table(), core_.view());
    if (auto wrong = reset_value_fault()) return std::move(*wrong);
    core_.path.spindle = {};
    stops_on_ = stops_wanted_ = 0;
    reset_modal();
    levels_.clear();
    Level level;
    level.file = main;
    level.scope = std::make_shared<Scope>();
    levels_.push_back(std::move(level));
    source_ = &files_->source(main);
    source_->seek({0, 1});
    indices_.clear();
    macros_.clear();
    channel_scope_->names.clear();
    routines_.clear();
    polynomials_.clear();
    std::erase_if(actions_, [](const SynchronizedAction& one) { return !one.is_static; });
    of_channel_ = false;
    ended_ = reread_ = jumped_ = needs_barrier_ = wants_barrier_ = called_ = false;
    managed_serial_ = 0;
    look_at_outputs();
    fresh_ = true;  // cycle start is a barrier
    serial_ = 0;
    points_.clear();
    undo_log_.clear();
    state_changed_ = true;
    core_.refresh_limits();
    core_.load_zeros();
    const GCode* zero = find_g(8, modal_.active[8]);
    g_zero(*zero);
    use_frame();  // none of the program before
    modal_.pending_zero = {};
    return {};
}

void Interpreter::barrier_done() {
    // compensation has read on: the program is ahead of this barrier
    if (!core_.barrier_passed()) return;
    fresh_ = true;
    core_.refresh_limits();
    for (unsigned i = 0; i < core_.view().axis_count; ++i)
        if (const auto now = core_.port().axis_taken_over(core_.view().axes[i].machine_axis))
            core_.take_machine(i, *now);
}

bool Interpreter::syntax(const char* at, std::string detail) {
    return fail_at(Alarm::SyntaxWrong, at, 1, std::move(detail));
}

bool Interpreter::fail_at(Alarm alarm, const char* from, std::size_t length, std::string detail,
                          double v0, double v1) {
    fault_column_ = cursor_.column(from);
    fault_length_ = length;
    return core_.fail(alarm, 0, std::move(detail), v0, v1);
}

bool Interpreter::rest_must_be_empty() {
    return cursor_.at_end() || syntax(cursor_.at(), std::string(1, cursor_.peek()));
}

Step Interpreter::fault(Fault fault) {
    Diagnosis diagnosis;
    diagnosis.alarm = fault.alarm;
    if (fault.block) {  // an earlier block of the program
        diagnosis.place = {files_->path(fault.block->file), fault.block->line, fault.column,
                           fault.length};
    } else {
        std::size_t column = fault_column_, length = fault_length_;
        if (!column && fault.letter)
            for (const Word& word : block_.words)
                if (word.address->name == std::string_view(&fault.letter, 1) ||
                    (word.axis >= 0 && axis_name(word.axis)[0] == fault.letter)) {
                    column = word.column;
                    length = word.length;
                }
        diagnosis.place = {files_->path(levels_.back().file),
                           fault_line_ ? fault_line_ : core_.at.line,
                           column ? character_column(line_, static_cast<std::uint32_t>(column)) : 0,
                           static_cast<std::uint32_t>(length)};
    }
    diagnosis.values = {fault.value0, fault.value1};
    diagnosis.detail = std::move(fault.detail);
    core_.sink().alarm(diagnosis, fault.block ? *fault.block : core_.at);
    ended_ = true;
    return Step::Failed;
}

void Interpreter::finish(StopReason reason) {
    core_.mark_emitted();
    core_.sink().stop({reason}, core_.at);
    ended_ = true;
}

Step Interpreter::step() {
    if (core_.reads_ahead()) {
        if (core_.halted()) return Step::AtBarrier;
        if (!ended_ && !core_.compensation_failed()) return fault(core_.fault());
    }
    if (ended_) return Step::Ended;
    return read_block();
}

// The corner before it stays without its next block.
void Interpreter::live_value_barrier() {
    if (core_.holds_block())
        core_.sink().alarm({Alarm::CompCornerCut,
                            {files_->path(levels_.back().file), core_.at.line, 0, 0},
                            {},
                            {}},
                           core_.at);
    core_.asks_at(levels_.back().file, here_.offset);
    core_.sink().barrier(core_.at);
}

// A live value may be read now? If not, the block stops here and is read again behind the barrier.
bool Interpreter::need_fresh() {
    if (fresh_) return true;
    needs_barrier_ = true;
    return false;
}

void Interpreter::seek(TextPosition to) {
    if (to.offset <= here_.offset) fresh_ = false;  // a loop asks the machine anew each time
    source_->seek(to);
    jumped_ = true;
}

Step Interpreter::end_of_text() {
    line_.clear();
    core_.at.line = source_->position().line;
    core_.at.block = -1;
    core_.begin_block();
    if (levels_.size() > 1) {  // a subprogram may end without M17
        if (!return_from_level()) return fault(core_.fault());
        return Step::Continue;
    }
    finish(StopReason::End);
    if (core_.reads_ahead() && !core_.compensation_failed()) return fault(core_.fault());
    core_.end_block();
    if (core_.reads_ahead() && core_.halted()) return Step::AtBarrier;
    return Step::Ended;
}

Step Interpreter::read_block() {
    if (!reread_) {
        // The end of a repeated section.
        while (levels_.back().section && source_->next_position().offset >= levels_.back().end) {
            Level& section = levels_.back();
            state_changed_ = true;
            if (section.repeats > 0) {
                --section.repeats;
                fresh_ = false;
                source_->seek(section.begin);
            } else {
                source_->seek(section.resume);
                levels_.pop_back();
            }
        }
        core_.at.serial = ++serial_;
        if (keep_states_) note_resume_point();
        at_hole_ = std::exchange(modal_.holes, nullptr);
        std::string_view line;
        switch (source_->next(line)) {
            case LineSource::Status::Line:
                break;
            case LineSource::Status::End:
                return end_of_text();
            case LineSource::Status::TooLong:
                fault_line_ = source_->position().line;
                fail(Alarm::LineTooLong);
                return fault(core_.fault());
            case LineSource::Status::ReadError:
                fail(Alarm::FileUnreadable, "reading failed");
                return fault(core_.fault());
        }
        line_ = line;
        here_ = source_->position();
        if (!macros_.empty()) expand_macros();
    }
    reread_ = needs_barrier_ = wants_barrier_ = jumped_ = called_ = false;
    fault_column_ = fault_length_ = 0;
    fault_line_ = 0;
    depth_ = 0;
    core_.begin_block();
    BlockContext& at = core_.at;
    at.file = levels_.back().file;
    unsigned depth = 0;
    for (const Level& level : levels_) depth += !level.section;
    at.stack_depth = static_cast<std::uint8_t>(depth - 1);
    at.line = here_.line;
    at.block = -1;
    at.cycle = {};
    ways_before_ = core_.ways();
    block_.clear();
    block_undo_.clear();
    written_.clear();
    written_zeros_.clear();
    overlays_.clear();
    statement_ = nullptr;
    execute_.clear();
    of_channel_ = false;
    cursor_ = Cursor(line_);
    if (line_.size() + 1 > kLongestBlock) {
        fail(Alarm::LineTooLong);
        return fault(core_.fault());
    }
    if (cursor_.at_end()) return Step::Continue;
    // the head of a file from an archive; the next one begins another program
    if (cursor_.peek() == '%') {
        if (here_.offset == 0) return Step::Continue;
        return end_of_text();
    }
    bool skipped = false;
    if (!parse_head(skipped)) return after_block(false);
    if (skipped || cursor_.at_end()) {
        if (core_.reads_ahead() && !skipped && !core_.end_compensated_block(false, false, false))
            return fault(core_.fault());
        return Step::Continue;
    }
    state_changed_ = true;
    reading_ = true;
    bool ok = read_line();
    // EXECSTRING: its text in the place of the line
    for (unsigned nested = 0; ok && !execute_.empty() && !needs_barrier_; ++nested) {
        if (nested == kDeepestText) {
            ok = fail(Alarm::CallTooDeep, "EXECSTRING", kDeepestText);
            break;
        }
        line_ = std::move(execute_);
        execute_.clear();
        block_.clear();
        statement_ = nullptr;
        cursor_ = Cursor(line_);
        reading_ = true;
        if (cursor_.at_end()) break;
        ok = parse_head(skipped) && (skipped || cursor_.at_end() || read_line());
    }
    reading_ = false;
    return after_block(ok);
}

// A statement, or words and what follows them.
bool Interpreter::read_line() {
    bool ok = true;
    const std::string_view first = cursor_.name_ahead();
    const Symbol symbol = first.size() > 1 ? find_symbol(upper(first)) : Symbol{};
    if (symbol.kind == Symbol::Kind::Statement) {
        statement_ = &symbol.statement();
        cursor_.advance(first.size());
        statement_at_ = cursor_.column(cursor_.at());
        reading_ = !statement_->act ? true : reading_;
        ok = statement_->act ? run_statement()
                             : fail_at(Alarm::NotBuilt, cursor_.at() - first.size(), first.size(),
                                       std::string(statement_->name));
    } else {
        ok = parse_words() && check_block() && spindles_to_axes() && take_back_released_axes() &&
             managed_tool() && synchronized_actions();
        reading_ = false;
        if (ok) block_undo_.clear();
        ok = ok && act();
        if (ok && statement_) {  // a jump or call behind the words
            cursor_.at() = cursor_.begin() + statement_at_ - 1 + statement_->name.size();
            ok = statement_->act ? run_statement()
                                 : fail_at(Alarm::NotBuilt, cursor_.begin() + statement_at_ - 1,
                                           statement_->name.size(), std::string(statement_->name));
        }
        if (ok && block_.program.wanted && !ended_) {
            std::int64_t repeats = 1;
            if (const Word* p = word("P")) repeats = static_cast<std::int64_t>(p->number());
            ok = call_program(block_.program.name, std::move(block_.program.arguments), repeats,
                              false);
        }
    }
    return ok;
}

// The statement itself; what it assigned is reported when it has succeeded.
bool Interpreter::run_statement() {
    const bool ok = (this->*statement_->act)();
    if (!ok) return false;
    for (const Written& one : written_) report_variable(one.name, one.value);
    written_.clear();
    return true;
}

// STOPRE and MSG leave a loop that waits for the machine where it was (Core::asks_at).
bool Interpreter::does_anything() const {
    const auto acts = [](const auto& one) {
        return one.first->act != &Interpreter::p_stopre && one.first->act != &Interpreter::p_msg;
    };
    return !block_.words.empty() || !block_.codes.empty() ||
           std::ranges::any_of(block_.procedures, acts);
}

Step Interpreter::after_block(bool ok) {
    reading_ = false;
    if (!ok) {
        if (!needs_barrier_) return fault(core_.fault());
        for (auto undo = block_undo_.rbegin(); undo != block_undo_.rend(); ++undo) (*undo)();
        block_undo_.clear();
        written_.clear();
        stops_wanted_ = 0;
        reread_ = true;
        live_value_barrier();
        return Step::AtBarrier;
    }
    block_undo_.clear();
    if (does_anything()) core_.did();
    if (core_.transformation_failed()) return fault(core_.fault());
    if (core_.reads_ahead()) {
        const bool counts = !called_ && !(block_.words.empty() && block_.codes.empty());
        if (!core_.end_compensated_block(counts, wants_barrier_, ended_)) {
            Fault why = core_.fault();
            // 11.4.1
            if (why.alarm == Alarm::CompIdleBlocks && why.block &&
                why.block->serial == modal_.geo.approach_serial)
                why.alarm = Alarm::ApproachNoEnd;
            return fault(why);
        }
        if (core_.transformation_failed()) return fault(core_.fault());
    }
    if (!ended_ && !called_ && modal_.call && modal_.call->cycle && core_.ways() != ways_before_ &&
        !modal_cycle())
        return fault(core_.fault());
    if (managed_serial_ == core_.at.serial) core_.mark_emitted();  // its T came before the barrier
    if (core_.emitted()) {
        fresh_ = false;
        core_.end_block();
    }
    // nothing that it calls calls it
    const bool calls =
        modal_.call && !modal_.call->cycle && std::ranges::none_of(levels_, &Level::modal_call);
    if (!ended_ && !called_ && calls && (core_.ways() != ways_before_ || at_hole_)) {
        const ModalCall call = *modal_.call;
        if (!call_program(call.name, call.arguments, 1, true)) return fault(core_.fault());
        if (at_hole_ && at_hole_->more()) {  // behind it the block of the pattern comes again
            levels_.back().resume = here_;
            levels_.back().holes = at_hole_;
        }
    }
    if (core_.reads_ahead())
        return core_.halted() ? Step::AtBarrier : ended_ ? Step::Ended : Step::Continue;
    if (ended_) return Step::Ended;
    return wants_barrier_ ? Step::AtBarrier : Step::Continue;
}

// Skip level, block number, labels.
bool Interpreter::parse_head(bool& skipped) {
    while (cursor_.peek() == '/') {
        const char* const from = cursor_.at();
        cursor_.advance(1);
        unsigned level = 0;
        if (is_digit(cursor_.next_raw())) {
            level = static_cast<unsigned>(cursor_.next_raw() - '0');
            cursor_.advance(1);
            if (is_digit(cursor_.next_raw())) return fail_at(Alarm::SkipLevelIllegal, from, 3);
        }
        if (core_.port().block_skip(level + 1)) skipped = true;
        // one level in a block
        if (cursor_.peek() == '/') return fail_at(Alarm::SkipLevelIllegal, cursor_.at(), 1);
    }
    if (skipped) return true;
    const char c = cursor_.peek();
    Cursor number = cursor_;
    if (c == ':' || c == 'N' || c == 'n') {
        number.advance(1);
        number.skip();
        if (is_digit(number.next_raw())) {
            double value = 0;
            while (is_digit(number.next_raw())) {
                value = value * 10 + (number.next_raw() - '0');
                number.advance(1);
            }
            if (value > 99999999) return fail_at(Alarm::DigitsTooMany, cursor_.at(), 1, "N");
            if (is_name_start(number.next_raw()) || is_blank(number.next_raw()) ||
                number.at_end() || !number.at_assign()) {
                core_.at.block = modal_.last_number = static_cast<std::int64_t>(value);
                cursor_ = number;
            }
        } else if (c == ':') {
            return syntax(cursor_.at(), ":");
        }
    }
    for (;;) {  // labels
        const std::string_view name = cursor_.name_ahead();
        if (name.size() < 2) return true;
        Cursor after = cursor_;
        after.advance(name.size());
        if (after.peek() != ':') return true;
        const std::string word = upper(name);
        after.eat(':');
        // GOTOF :20
        if (find_symbol(word).kind == Symbol::Kind::Statement && is_digit(after.peek()))
            return true;
        if (word != "ENDLABEL" &&
            (find_symbol(word).kind != Symbol::Kind::None || is_digit(name[1])))
            return fail_at(Alarm::NameReserved, cursor_.at(), name.size(), word);
        // one name, one thing
        if (find_variable(word)) return fail_at(Alarm::NameTwice, cursor_.at(), name.size(), word);
        cursor_ = after;
    }
}

}  // namespace polyturn::channels::sinumerik
