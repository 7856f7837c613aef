// Reading blocks and the flow between programs. What a block does is in block.cpp and behind
// the handlers.
#include "channels/fanuc/interpreter.hpp"

#include <algorithm>
#include <cmath>
#include <cstring>
#include <utility>

#include "channels/text/chars.hpp"

namespace polyturn::channels::fanuc {
Interpreter::Interpreter(MachineView& view, Sink& sink, Port& port, ProgramFiles& files,
                         MakeSettings make_settings)
    : core_(view, sink, port),
      files_(&files),
      make_settings_(make_settings),
      settings_(make_settings(view.table(), view.channel)),
      table_(settings_.system),
      scanner_(*this),
      variables_(*this, *view.store, settings_.common_first, settings_.common_last),
      expression_(variables_, settings_.angle_positive, !settings_.nct && !settings_.mefi) {
    if (!settings_.nct && !settings_.mefi) {
        expression_.names_from(names_);
        names_in_brackets = true;
    }
    parts_ = settings_.parts_made;
    parts_wanted_ = settings_.parts_wanted;
    takes_program_names = !settings_.mefi;
    absolute_axis_.fill(-1);
    incremental_axis_.fill(-1);
    for (unsigned i = 0; i < view.axis_count; ++i) {
        const std::string_view name = view.axes[i].name;
        if (name.size() == 1)
            absolute_axis_[static_cast<std::size_t>(name[0] - 'A')] = static_cast<std::int8_t>(i);
        else
            has_long_names = true;
    }
    for (const auto& address : settings_.spindle_addresses)
        has_long_names |= address.name.size() > 1;
    has_long_names |= !settings_.spindle_names.empty();
    static constexpr char kIncrements[][2] = {{'U', 'X'}, {'V', 'Y'}, {'W', 'Z'}, {'H', 'C'}};
    for (const auto& [increment, axis] : kIncrements) {
        if (settings_.mefi) break;
        const std::int8_t place = absolute_axis_[static_cast<std::size_t>(axis - 'A')];
        if (place >= 0 &&
            std::ranges::find(settings_.aux_letters, increment) == settings_.aux_letters.end() &&
            absolute_axis_[static_cast<std::size_t>(increment - 'A')] < 0)
            incremental_axis_[static_cast<std::size_t>(increment - 'A')] = place;
    }
    for (std::size_t i = 0; i < 26; ++i)
        if (absolute_axis_[i] >= 0 || incremental_axis_[i] >= 0) axis_letters_ |= 1u << i;
    for (const GCode& row : g_codes()) {
        std::uint32_t mask = 0;
        for (const char letter : row.takes)
            mask |= letter == 'x' ? axis_letters_ : letter_bit(letter);
        takes_.push_back(mask);
    }
    frames_.reserve(32);
    variables_.share(settings_.shared_100, settings_.shared_500);
    clear_modal();
}

// The state of cycle start: what the parameters say, else the rows marked at_reset.
void Interpreter::clear_modal() {
    active_.fill(nullptr);
    for (const GCode& row : g_codes())
        if ((row.systems & settings_.system) && row.at_reset)
            active_[static_cast<std::size_t>(row.group)] = &row;
    const auto choose = [this](std::uint16_t tenths) {
        const GCode* row = table_.find(tenths);
        // mefi knows millimetres only
        if (row) active_[static_cast<std::size_t>(row->group)] = row;
        return row;
    };
    motion_ = choose(settings_.power_on_g1 ? 10 : 0);
    static constexpr std::uint16_t kPlanes[] = {170, 180, 190};
    choose(kPlanes[settings_.power_on_plane]);
    core_.path.plane = static_cast<Plane>(settings_.power_on_plane);
    inch_ = settings_.power_on_inch;
    choose(units_code(inch_));
    unit_ = inch_ ? 25.4 : 1.0;
    absolute_ = settings_.system == kA || !settings_.power_on_incremental;
    if (settings_.system != kA) choose(absolute_ ? 900 : 910);
    if (settings_.power_on_length) choose(settings_.power_on_length);
    core_.helix_in_plane(settings_.helix_in_plane);
    // feed per revolution waits for a spindle that the PLC may start; the kernel reports if none
    // turns
    core_.wait_for_spindle(true);
    const bool per_revolution = settings_.power_on_per_revolution;
    if (settings_.system == kA)
        choose(per_revolution ? 990 : 980);
    else
        choose(per_revolution ? 950 : 940);
    core_.path.feed_mode = per_revolution ? FeedMode::PerRevolution : FeedMode::PerMinute;
    core_.path.feed = per_revolution ? settings_.feed_per_revolution : settings_.feed_per_minute;
    core_.path.exact_stop_mode = core_.path.override_locked = core_.path.exact_stop_off =
        core_.path.stroke2_off = false;
    single_block_off_ = no_finish_wait_ = hidden_ = false;
    automatic_control_ = 0;
    if (core_.path.spindle.surface_m_min == 0)
        core_.path.spindle.surface_m_min = settings_.surface_speed;
    parameter_input_ = false;
    life_ = {};
    modal_calls_.clear();
}

Result<void> Interpreter::start(FileId main) {
    core_.begin_control();
    core_.compensation_reset();
    core_.fixture_off();
    core_.compensation_options(settings_.compensation);
    core_.shows = {settings_.shows_tool_vector, settings_.shows_nose};
    clear_modal();
    frames_.clear();
    loops_.clear();
    while (variables_.depth() > 1) variables_.pop_locals();
    CallLevel frame;
    frame.file = main;
    frames_.push_back(std::move(frame));
    source_ = &files_->source(main);
    source_->seek({0, 1});
    line_left_ = tape_begun_ = blocks_begun_ = ended_ = ended_by_code_ = reread_ = points_judged_ =
        false;
    managed_serial_ = letters_written_in_ = 0;
    fresh_ = true;  // cycle start is a barrier
    // Without a machine only the program can have closed a spindle's loop.
    turned_.fill({core_.port().axis_command(core_.view().axes[0].machine_axis)
                      ? SpindleLoop::Unknown
                      : SpindleLoop::Open,
                  0.0});
    program_number_ = 0;
    // As they are switched: by hand in a hold, or behind a process that died, another one has
    // written them.
    outputs_ =
        static_cast<std::uint32_t>(static_cast<std::int64_t>(core_.port().interface_value(1132)));
    outputs_wide_ = core_.port().interface_value(1133);
    measuring_ = {};
    barrier_fault_.reset();
    synchronous_ = 0;
    remote_.active = external_.active = false;
    remote_.from.close();
    finishing_ = {};
    cycle_data_ = {};
    interrupting_ = {};
    interruption_ = {};
    interrupted_.reset();
    serial_ = 0;
    points_.clear();
    variables_.undo().clear();
    state_changed_ = true;
    polygon_on_ = balance_on_ = false;  // a reset has ended them
    dialogue_ = {};
    core_.refresh_limits();
    if (settings_.mefi) core_.path.zero_row = settings_.priority_zero_row;
    core_.load_zeros();
    if (!settings_.nct && !settings_.mefi && !reads_contour_) recall_kept();
    return {};
}

void Interpreter::barrier_done() {
    // compensation has read on: the program is ahead of this barrier
    if (!core_.barrier_passed()) {
        inputs_fresh_ = reread_;
        return;
    }
    fresh_ = true;
    core_.refresh_limits();
    for (unsigned i = 0; i < core_.view().axis_count; ++i)
        if (const auto now = core_.port().axis_taken_over(core_.view().axes[i].machine_axis))
            core_.take_machine(i, *now);
    check_synchronous_axes();
}

// Simple synchronous control (F8311) must not begin while the slave's coordinates are shifted
// (fanuc_lathe 10.3).
void Interpreter::check_synchronous_axes() {
    const PathState& path = core_.path;
    for (unsigned i = 0; i < core_.view().axis_count; ++i) {
        const unsigned axis = core_.view().axes[i].machine_axis;
        const bool follows = core_.port().synchronous_master(axis) != 0 &&
                             params::get(core_.view().table(), params::f8311, axis + 1) != 0;
        const bool began = follows && !(synchronous_ >> i & 1u);
        synchronous_ = (synchronous_ & ~(1u << i)) | (follows ? 1u << i : 0u);
        const double shifts[] = {path.shift[i], path.vector[i], path.wanted[i], path.preset[i],
                                 path.local[i]};
        if (began &&
            std::any_of(std::begin(shifts), std::end(shifts), [](double by) { return by != 0; }))
            barrier_fault_ =
                Fault{Alarm::SyncShifted, 0, 0.0, 0.0, std::string(core_.view().axes[i].name),
                      std::nullopt};
    }
}

Step Interpreter::fault_at(Alarm alarm, std::uint32_t column, std::uint32_t length,
                           std::string detail, double v0, double v1) {
    Diagnosis diagnosis;
    diagnosis.alarm = alarm;
    diagnosis.place = {files_->path(frames_.back().file),
                       fault_line_ ? fault_line_ : source_->position().line,
                       column ? character_column(line_, column) : 0, length};
    // another line than the one at hand is at fault
    if (!column && diagnosis.alarm != Alarm::FileUnreadable &&
        diagnosis.alarm != Alarm::LineTooLong) {
        const LinePlace place = place_in_file(frames_.back().file, diagnosis.place.line, 0);
        diagnosis.place.column = place.column;
        diagnosis.place.length = place.length;
    }
    diagnosis.values = {v0, v1};
    diagnosis.detail = std::move(detail);
    core_.sink().alarm(diagnosis, core_.at);
    ended_ = true;
    return Step::Failed;
}

Step Interpreter::fault(Fault fault) {
    // An inner chamfer or corner R that is smaller than the nose (fanuc_lathe 3.16).
    if ((fault.alarm == Alarm::CompInterference || fault.alarm == Alarm::CompNoIntersection) &&
        corner_count_) {
        const std::uint32_t line = fault.block ? fault.block->line : core_.at.line;
        for (std::size_t k = 0; k < corner_lines_.size(); ++k) {
            if (corner_lines_[k] != line) continue;
            fault.alarm = Alarm::CompCornerElement;
            if (!fault.column && !fault.letter) fault.letter = corner_letters_[k];
        }
    }
    if (fault.block) {  // an earlier block of the program
        const BlockContext& at = *fault.block;
        if (!fault.column) {
            const LinePlace place = place_in_file(at.file, at.line, fault.letter);
            fault.column = place.column;
            fault.length = place.length;
        }
        core_.sink().alarm({fault.alarm,
                            {files_->path(at.file), at.line, fault.column, fault.length},
                            {fault.value0, fault.value1},
                            std::move(fault.detail)},
                           at);
        ended_ = true;
        return Step::Failed;
    }
    std::uint32_t column = fault_column_, length = fault_length_;
    if (!column && fault.letter >= 'A' && fault.letter <= 'Z' && block_.has(fault.letter)) {
        const Word& word = block_.word(fault.letter);
        column = word.column;
        length = word.length;
    }
    if (!column && !fault_line_) {
        if (const Word* word = word_at_fault(fault.alarm)) {
            column = word->column;
            length = word->length;
        }
    }
    return fault_at(fault.alarm, column, length, std::move(fault.detail), fault.value0,
                    fault.value1);
}

// Where what went wrong names no letter: the centre or radius of an arc that does not fit;
// otherwise the code that moves, the last G word or the first word of the block.
const Word* Interpreter::word_at_fault(Alarm alarm) const {
    if (block_.count == 0 || line_.empty()) return nullptr;
    if (alarm == Alarm::ArcRadiusDiffers || alarm == Alarm::CompArcCentre)
        for (const char letter : {'R', 'I', 'J', 'K'})
            if (block_.has(letter)) return &block_.word(letter);
    const Word* found = nullptr;
    for (std::size_t k = 0; k < block_.count; ++k) {  // it may not have been classified yet
        const Word& word = block_.words[k];
        if (word.address == 'N' || word.address == 'O') continue;
        if (word.address == 'G') {
            if (const GCode* row = table_.find(
                    static_cast<std::uint32_t>(std::lround(std::fabs(word.value) * 10.0)));
                row && row->group == GGroup::Motion)
                return &word;
            found = &word;
        }
        if (!found) found = &word;
    }
    return found;
}

void Interpreter::finish(StopReason reason) {
    core_.mark_emitted();
    core_.sink().stop({reason}, core_.at);
    ended_ = true;
    ended_by_code_ = reason != StopReason::End;
}

Step Interpreter::end_of_text() {
    core_.at.line = source_->position().line;
    core_.at.block = -1;
    line_ = {};
    if (frames_.size() > 1) return fault_at(Alarm::ProgramNotEnded, 0, 0, "M99");
    if (tape_begun_) return fault_at(Alarm::ProgramNotEnded, 0, 0, "%");
    core_.begin_block();
    finish(StopReason::End);
    if (core_.reads_ahead() && !core_.compensation_failed()) return fault(core_.fault());
    core_.end_block();
    if (core_.reads_ahead() && core_.halted()) return Step::AtBarrier;
    return Step::Ended;
}

Step Interpreter::step() {
    if (core_.reads_ahead()) {
        if (core_.halted()) return Step::AtBarrier;
        if (!ended_ && !core_.compensation_failed()) return fault(core_.fault());
    }
    if (ended_) return Step::Ended;
    if (barrier_fault_) return fault(*std::exchange(barrier_fault_, std::nullopt));
    if (measuring_.skipping) return finish_skip();
    if (remote_.active) return binary_step();
    if (external_.active) return external_step();
    return read_block();
}

// A statement waits for a live value. Under compensation it is evaluated as soon as it is read
// (fanuc_lathe 6.13, 3.12): inputs and clocks as they are at the end of the block before the held
// one. Where the axes are is known only when the held block has ended too.
void Interpreter::read_value_barrier() {
    reread_ = true;
    line_left_ = false;
    if (!core_.holds_block() || inputs_fresh_ || settings_.nct || settings_.mefi)
        return live_value_barrier();
    core_.at.statement = true;
    core_.barrier_before_held();
    core_.at.statement = false;
}

// The corner before it stays without its next block.
void Interpreter::live_value_barrier() {
    if (core_.holds_block())
        core_.sink().alarm({Alarm::CompCornerCut,
                            {files_->path(frames_.back().file), core_.at.line, 0, 0},
                            {},
                            {}},
                           core_.at);
    core_.at.statement = true;  // the block itself is still to come
    core_.asks_at(frames_.back().file, source_->position().offset, column_);
    core_.sink().barrier(core_.at);
    core_.at.statement = false;
}

Step Interpreter::read_block() {
    if (!reread_) {
        inputs_fresh_ = false;
        core_.at.serial = ++serial_;
        if (keep_states_) note_resume_point();
    }
    if (reread_) {
        reread_ = false;
    } else if (!line_left_) {
        switch (source_->next(line_)) {
            case LineSource::Status::Line:
                break;
            case LineSource::Status::End:
                return end_of_text();
            case LineSource::Status::TooLong:
                return fault_at(Alarm::LineTooLong, 0, 0);
            case LineSource::Status::ReadError:
                return fault_at(Alarm::FileUnreadable, 0, 0, "reading failed");
        }
        column_ = 0;
    }
    line_left_ = false;
    fault_line_ = fault_column_ = fault_length_ = 0;
    has_pending_fault_ = false;
    core_.begin_block();
    core_.rest_of_dwell = std::exchange(interruption_.goes_on, false);
    const CallLevel& frame = frames_.back();
    BlockContext& at = core_.at;
    at.file = frame.file;
    at.stack_depth = static_cast<std::uint8_t>(frames_.size() - 1);
    at.by_code = frames_.size() > 1 && std::any_of(frames_.begin() + 1, frames_.end(),
                                                   [](const CallLevel& f) { return f.by_code; });
    at.line = source_->position().line;
    at.block = -1;
    at.statement = false;
    at.cycle = finishing_.active ? finishing_.name : std::string_view{};
    const ScanStop stop = scanner_.scan(line_, column_, block_);
    switch (stop) {
        case ScanStop::EndOfLine:
            break;
        case ScanStop::Skipped:
            line_left_ = scanner_.stopped_at() < line_.size();
            break;
        case ScanStop::EndOfBlock:
            line_left_ = true;
            break;
        case ScanStop::TapeMark:
            if (!blocks_begun_ && !tape_begun_ && block_.count == 0) {
                tape_begun_ = state_changed_ = true;  // the rest of the line is the tape's title
                return Step::Continue;
            }
            if (block_.count == 0) {
                tape_begun_ = false;
                if (settings_.needs_end_code && frames_.size() == 1)
                    return fault_at(Alarm::ProgramEndMissing,
                                    static_cast<std::uint32_t>(scanner_.stopped_at() + 1), 1);
                return end_of_text();
            }
            return fault_at(Alarm::CharacterUnknown,
                            static_cast<std::uint32_t>(scanner_.stopped_at() + 1), 1, "%");
        case ScanStop::NeedsBarrier:
            read_value_barrier();
            return Step::AtBarrier;
        case ScanStop::Fault:
            if (has_pending_fault_) return fault(pending_fault_);
            return fault_at(
                scanner_.fault().alarm, scanner_.fault().column, scanner_.fault().length,
                scanner_.fault().letter ? std::string(1, scanner_.fault().letter) : std::string{});
        case ScanStop::Macro: {
            if (settings_.mefi)
                return fault_at(Alarm::NotBuilt,
                                static_cast<std::uint32_t>(scanner_.stopped_at() + 1), 1,
                                "macro statements in mefi");
            if (block_.has('N')) at.block = last_n_ = static_cast<std::int64_t>(block_.value('N'));
            blocks_begun_ = state_changed_ = true;
            return macro_statement(scanner_.stopped_at());
        }
    }
    for (const char letter : {'N', 'O'}) {
        if (!block_.has(letter)) continue;
        const Word& word = block_.word(letter);
        if (word.from_expression)  // fanuc_lathe 6.1
            return fault_at(Alarm::MacroFormat, word.column, word.length,
                            std::string(1, letter) + " takes no variable");
        if (word.value < 0 || word.has_point)  // whole numbers, as GOTO and M98 look for them
            return fault_at(word.value < 0 ? Alarm::NegativeSign : Alarm::PointForbidden,
                            word.column, word.length, std::string(1, letter));
    }
    const std::size_t next_column = scanner_.stopped_at();
    if (block_.count == 0 && !block_.name_length) {
        column_ = next_column;
        return Step::Continue;
    }
    // it waits for the path, and is read again
    if (only_macros_ && (block_.letters & ~letter_set("NO"))) {
        only_macros_ = false;
        reread_ = true;
        line_left_ = false;
        return Step::AtBarrier;
    }
    if (block_.has('N')) at.block = last_n_ = static_cast<std::int64_t>(block_.value('N'));
    if (keep_states_ && !is_plain_move()) state_changed_ = true;
    if (block_.has('O')) {
        if (blocks_begun_) {  // the next program of the text begins
            tape_begun_ = false;
            return end_of_text();
        }
        program_number_ = static_cast<std::int64_t>(block_.value('O'));
    }
    blocks_begun_ = true;
    behind_ = next_column;
    const Step step = nc_block();
    if (!jumped_ && !reread_) column_ = next_column;
    return step;
}

// Block number `number` of the running program: forward from here, then from its beginning.
const BlockIndex& Interpreter::index_of(FileId file) {
    if (indexes_.size() <= file) indexes_.resize(file + 1u);
    if (!indexes_[file]) indexes_[file] = std::make_unique<BlockIndex>();
    LineSource& source = files_->source(file);
    if (indexes_[file]->built()) return *indexes_[file];
    // it moves the window
    if (&source == source_) {
        kept_line_ = line_;
        line_ = kept_line_;
    }
    indexes_[file]->build(source);
    return *indexes_[file];
}

std::optional<TextPlace> Interpreter::find_block(std::int64_t number) {
    return index_of(frames_.back().file)
        .block(number, frames_.back().begin.offset, place_behind(behind_).byte());
}

bool Interpreter::jump_to(std::int64_t number) {
    const auto found = find_block(number);
    if (!found) return core_.fail(Alarm::SequenceNumberMissing, 'P', std::to_string(number));
    go_to(*found);
    return true;
}

void Interpreter::go_to(const TextPlace& place) {
    // a loop asks the machine anew each time
    if (place.offset <= source_->position().offset) fresh_ = false;
    go_on_at(place);
}

// The block there is the next to be read.
void Interpreter::go_on_at(const TextPlace& place) {
    source_->seek(place);
    jumped_ = true;
    line_left_ = place.column != 0 && source_->next(line_) == LineSource::Status::Line;
    if (line_left_) column_ = behind_ = place.column;
}

TextPlace Interpreter::place_behind(std::size_t column) const {
    return line_left_ ? TextPlace(source_->position(), column)
                      : TextPlace(source_->next_position());
}

std::optional<TextPosition> Interpreter::find_program_in(FileId file, std::int64_t number) {
    return index_of(file).program(number);
}

bool Interpreter::call_program(std::int64_t number, std::int64_t repeats, const LocalSet* arguments,
                               bool by_code, bool modal, char letter) {
    if (repeats < 1) return true;
    if (!call_levels_left(arguments != nullptr, modal, letter)) return false;
    // by its name
    if (number < 0)
        return enter_program(static_cast<FileId>(-1 - number), 0, repeats, arguments, by_code,
                             modal);
    if (const auto file = files_->find_number(number))
        return enter_program(*file, number, repeats, arguments, by_code, modal);
    if (find_program_in(frames_.back().file, number))
        return enter_program(frames_.back().file, number, repeats, arguments, by_code, modal);
    return core_.fail(Alarm::SubprogramMissing, letter, "O" + std::to_string(number));
}

void Interpreter::look_whether_hidden() {
    const std::int64_t program = frames_.back().program;
    const bool hidden = frames_.size() > 1 &&
                        ((program >= 8000 && program <= 8999 && (settings_.hidden_programs & 1u)) ||
                         (program >= 9000 && program <= 9999 && (settings_.hidden_programs & 2u)));
    if (hidden == hidden_) return;
    hidden_ = hidden;
    if (keep_states_) tell_control();
}

bool Interpreter::call_levels_left(bool macro, bool modal, char letter) {
    unsigned subs = 0, macros = 0;
    for (std::size_t i = 1; i < frames_.size(); ++i)
        if (!frames_[i].interrupt) ++(frames_[i].macro ? macros : subs);
    if (macro && macros >= settings_.macro_levels)
        return core_.fail(modal || settings_.nct ? Alarm::MacroTooDeep : Alarm::CallTooDeep, letter,
                          {}, settings_.macro_levels);
    if (!macro && subs >= settings_.sub_levels)
        return core_.fail(Alarm::CallTooDeep, letter, {}, settings_.sub_levels);
    return true;
}

// The next block is the first one of that program, at its O number or at the beginning of the text.
bool Interpreter::enter_program(FileId file, std::int64_t number, std::int64_t repeats,
                                const LocalSet* arguments, bool by_code, bool modal) {
    CallLevel frame;
    frame.file = file;
    if (const auto begin = find_program_in(file, number)) frame.begin = *begin;
    frame.resume = place_behind(behind_);
    frame.repeats = repeats - 1;
    frame.macro = arguments != nullptr;
    frame.by_code = by_code;
    frame.modal_call = modal;
    frame.loops = loops_.size();
    frame.outer_program = program_number_;
    frame.program = number;
    if (arguments) {
        frame.arguments = *arguments;
        variables_.push_locals(*arguments);
    }
    frame.outer_modals = modal_calls_;
    if (modal) modal_calls_.pop_back();
    source_ = &files_->source(frame.file);
    source_->seek(frame.begin);
    frames_.push_back(std::move(frame));
    look_whether_hidden();
    blocks_begun_ = false;
    line_left_ = false;
    jumped_ = true;
    return true;
}

// M97 P300: the watch for interrupts ends, and the program goes on at N300 of the same text, to M99
// and then behind this block. The specification knows M97 without P only; controls of this family
// call a part of the program so.
bool Interpreter::call_block(std::int64_t number) {
    if (ended_) return true;
    if (!call_levels_left(false, false, 'P')) return false;
    const CallLevel& here = frames_.back();
    const FileId file = here.file;
    const TextPosition begin = here.begin;
    const std::int64_t program = here.program;
    const auto found = find_block(number);
    if (!found) return core_.fail(Alarm::SequenceNumberMissing, 'P', std::to_string(number));
    called_ = true;
    CallLevel frame;
    frame.file = file;
    frame.begin = begin;  // jumps look through the whole program
    frame.resume = place_behind(behind_);
    frame.loops = loops_.size();
    frame.outer_program = program_number_;
    frame.program = program;
    frame.outer_modals = modal_calls_;
    frames_.push_back(std::move(frame));
    line_left_ = false;
    go_on_at(*found);
    return true;
}

// M99: the next repetition, the caller, or (in the main program) the end of a part.
bool Interpreter::return_from(bool has_target, std::int64_t target) {
    CallLevel& frame = frames_.back();
    if (frames_.size() == 1) {
        if (has_target) return jump_to(target);
        core_.mark_emitted();
        core_.sink().part(++parts_, core_.at);
        ended_ = true;
        return true;
    }
    if (frame.interrupt) return return_from_interrupt(has_target, target);
    loops_.resize(frame.loops);
    if (frame.repeats > 0 && !has_target) {
        --frame.repeats;
        // those of G66 are given once (fanuc_lathe 6.9.3)
        if (frame.macro && !frame.modal_call) variables_.locals() = frame.arguments;
        source_->seek(frame.begin);
        blocks_begun_ = false;
        jumped_ = true;
        line_left_ = false;
        return true;
    }
    CallLevel done = std::move(frame);
    frames_.pop_back();
    look_whether_hidden();
    // the next call goes on with them
    if (done.modal_call && !done.outer_modals.empty())
        done.outer_modals.back().arguments = variables_.locals();
    if (done.macro) variables_.pop_locals();
    if (done.modal_call) modal_calls_ = std::move(done.outer_modals);
    program_number_ = done.outer_program;
    source_ = &files_->source(frames_.back().file);
    go_on_at(done.resume);
    blocks_begun_ = true;
    return has_target ? jump_to(target) : true;
}

bool Interpreter::block_skip(unsigned number) { return core_.port().block_skip(number); }

std::size_t Interpreter::axis_name(const char* at, const char* end, int& axis) {
    const MachineView& view = core_.view();
    std::size_t longest = 0;
    const auto look = [&](std::string_view name, int place) {
        if (name.size() < 2 || name.size() <= longest ||
            static_cast<std::size_t>(end - at) <= name.size())
            return;
        bool same = true;
        for (std::size_t k = 0; k < name.size(); ++k)
            same = same && (at[k] == name[k] || at[k] == name[k] + 32);
        // A name that ends in a digit must be followed by '='.
        if (same && is_digit(name.back()) && at[name.size()] != '=') same = false;
        if (same) {
            longest = name.size();
            axis = place;
        }
    };
    for (unsigned i = 0; i < view.axis_count; ++i) look(view.axes[i].name, static_cast<int>(i));
    for (std::size_t i = 0; i < settings_.spindle_addresses.size(); ++i)
        look(settings_.spindle_addresses[i].name, kSpindleWord + static_cast<int>(i));
    for (std::size_t i = 0; i < settings_.spindle_names.size(); ++i)
        look(settings_.spindle_names[i].name, kNamedSpindle + static_cast<int>(i));
    return longest;
}

// Parameters were changed by the program: all but the G code system is taken at once.
void Interpreter::reload_settings() {
    const GSystem system = settings_.system;
    settings_ = make_settings_(core_.view().table(), core_.view().channel);
    settings_.system = system;
    core_.compensation_options(settings_.compensation);
    core_.shows = {settings_.shows_tool_vector, settings_.shows_nose};
    // F6004#0 may have changed
    expression_ =
        Expression(variables_, settings_.angle_positive, !settings_.nct && !settings_.mefi);
    if (!settings_.nct && !settings_.mefi) expression_.names_from(names_);
}

bool Interpreter::barrier_fresh() { return fresh_; }

// A variable of all channels is a live value: another program may have written it.
VariableStatus Interpreter::shared_variable(std::int64_t number, bool write, double& value) {
    double* const outside = core_.port().shared_variables();
    if (!write && !fresh_ && !inputs_fresh_) return VariableStatus::NeedsBarrier;
    double& cell = outside ? outside[number - 100]
                           : (*core_.view().shared)[static_cast<std::size_t>(number - 100)];
    if (write) {
        variables_.note_cell(cell);
        cell = value;
    } else {
        value = cell;
    }
    return VariableStatus::Ok;
}

}  // namespace polyturn::channels::fanuc
