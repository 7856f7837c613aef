// Reading blocks and the end of each. What a block does is in block.cpp, statements.cpp and
// behind the handlers.
#include "channels/fagor/interpreter.hpp"

#include <cmath>
#include <utility>

#include "channels/text/word_scanner.hpp"

namespace polyturn::channels::fagor {
namespace {

// 000611.PIT is program 611; -1: the name is no number.
std::int64_t number_of_file(const std::string& path) {
    std::int64_t number = -1;
    for (std::size_t i = path.find_last_of('/') + 1; i < path.size() && path[i] != '.'; ++i) {
        if (path[i] < '0' || path[i] > '9' || number > 999'999) return -1;
        number = (number < 0 ? 0 : number * 10) + (path[i] - '0');
    }
    return number;
}

}  // namespace

Interpreter::Interpreter(MachineView& view, Sink& sink, Port& port, ProgramFiles& files)
    : spindles_(sink),
      ways_(spindles_),
      core_(view, ways_, port),
      files_(&files),
      settings_(read_settings(view.table(), view.channel)),
      reader_(*this),
      expression_(*this) {
    place_.fill(-1);
    for (unsigned i = 0; i < view.axis_count; ++i) {
        const std::string& name = view.axes[i].name;
        if (name.size() == 1 && axis_number(name[0]))
            place_[static_cast<std::size_t>(name[0] - 'A')] = static_cast<std::int8_t>(i);
    }
    // a tool's own offset until TLFD says otherwise
    for (std::size_t n = 0; n < kTools; ++n)
        values_.tool(ToolField::Offset, n) = static_cast<double>(n);
    frames_.reserve(32);
    // G95 waits for a spindle that the PLC may start; the kernel reports if none turns
    core_.wait_for_spindle(true);
    modal_.diameter =
        core_.view().axis_by_role(PlaneRole::BasicX) >= 0 &&
        view.axes[static_cast<std::size_t>(view.axis_by_role(PlaneRole::BasicX))].diameter;
    core_.await_factors();
    clear_modal();
    core_.path.zero_row = kZeroNone;
}

// What the machine parameters say holds at the start of a program (fagor_8037t part 1, 9.1).
void Interpreter::clear_modal() {
    const bool diameter = modal_.diameter;
    Modal fresh;
    fresh.written = modal_.written;
    fresh.parts = modal_.parts;
    fresh.speed_limit = modal_.speed_limit;  // until power-off (4.4.1)
    // M30 and reset leave them (4.4.2)
    fresh.zero = modal_.zero;
    fresh.zero_number = modal_.zero_number;
    fresh.zero_added = modal_.zero_added;
    fresh.inclined = core_.transformed() ? 1 : 0;  // only its freezing ends (part 2, 13)
    modal_ = fresh;
    modal_.diameter = diameter;
    modal_.motion = settings_.g1 ? 1 : 0;
    modal_.plane = settings_.g17 ? 17 : 18;
    modal_.corner = settings_.round_corner ? 5 : 7;
    modal_.inch = settings_.inch;
    modal_.absolute = !settings_.incremental;
    modal_.feed_code = settings_.per_revolution ? 95 : 94;
    core_.path.plane = settings_.g17 ? Plane::XY : Plane::ZX;
    core_.path.plane_p = core_.path.plane_q = -1;
    core_.path.feed_mode = settings_.per_revolution ? FeedMode::PerRevolution : FeedMode::PerMinute;
    core_.path.feed = 0.0;
    core_.path.exact_stop_mode = modal_.corner == 7;
    core_.path.override_locked = false;
    spindles_.set(1.0, core_.at);
    AxisValues ones{};
    ones.fill(1.0);
    core_.set_factors(ones, Frame{});
}

void Interpreter::show_diameter() {
    const int x = core_.view().axis_by_role(PlaneRole::BasicX);
    if (x >= 0) core_.view().axes[static_cast<std::size_t>(x)].diameter = modal_.diameter;
}

compensation::Corner Interpreter::outer_corner() const {
    return settings_.comp_mode == 1   ? compensation::Corner::Arc
           : settings_.comp_mode == 2 ? compensation::Corner::Intersection
                                      : compensation::Corner::Extended;
}

Result<void> Interpreter::start(FileId main) {
    core_.begin_control();
    core_.compensation_reset();
    compensation::Options options;
    options.tips = &compensation::kTipsAround;
    options.corner = outer_corner();
    // 300 degrees on the tool's side
    options.intersection_from_deg = options.arc_below_deg = 60.0;
    options.small_vector = compensation::kTangentialMm;
    // 8.2.6: from the perpendicular point straight to the end of the G40 block
    options.leaves_direct = true;
    options.in_place = options.sides_meet_on_paths = options.rapid_suspends =
        options.straight_after_halt = options.idle_is_fault = true;
    options.idle_blocks = 48;
    core_.compensation_options(options);
    clear_modal();
    frames_.clear();
    while (values_.levels().size() > 1) values_.pop_level();
    CallFrame frame;
    frame.file = main;
    frame.maker = attribute_of(main, 'O');
    frame.program = number_of_file(files_->path(main));
    frames_.push_back(frame);
    source_ = &files_->source(main);
    source_->seek({0, 1});
    ended_ = reread_ = probing_ = interrupt_fill_ = false;
    managed_serial_ = 0;
    began_ms_ = core_.port().running_ms();
    fresh_ = true;  // cycle start is a barrier
    serial_ = 0;
    points_.clear();
    values_.undo().clear();
    state_changed_ = true;
    core_.refresh_limits();
    core_.load_zeros();
    show_diameter();
    index_subroutines(main);
    arm_interrupts();
    return {};
}

void Interpreter::barrier_done() {
    // compensation has read on: the program is ahead of this barrier
    if (!core_.barrier_passed()) return;
    fresh_ = true;
    core_.refresh_limits();
    take_machine();
}

void Interpreter::take_machine() {
    const MachineView& view = core_.view();
    for (unsigned i = 0; i < view.axis_count; ++i)
        if (const auto now = core_.port().axis_taken_over(view.axes[i].machine_axis))
            core_.take_machine(i, *now);
}

Step Interpreter::fault_at(Alarm alarm, std::uint32_t column, std::uint32_t length,
                           std::string detail, double v0, double v1) {
    Diagnosis diagnosis;
    diagnosis.alarm = alarm;
    diagnosis.place = {files_->path(frames_.back().file), fault_line_ ? fault_line_ : core_.at.line,
                       column ? character_column(line_, column) : 0, length};
    diagnosis.values = {v0, v1};
    diagnosis.detail = std::move(detail);
    core_.sink().alarm(diagnosis, core_.at);
    ended_ = true;
    return Step::Failed;
}

Step Interpreter::fault(Fault fault) {
    if (fault.block) {  // another block of the program
        const BlockContext& at = *fault.block;
        core_.sink().alarm({fault.alarm,
                            {files_->path(at.file), at.line, fault.column, fault.length},
                            {fault.value0, fault.value1},
                            std::move(fault.detail)},
                           at);
        ended_ = true;
        return Step::Failed;
    }
    std::uint32_t column = fault_column_, length = fault_length_;
    if (!column && fault.letter >= 'A' && fault.letter <= 'Z') {
        const Word* word = by_letter_[static_cast<std::size_t>(fault.letter - 'A')];
        for (unsigned k = 0; !word && k < block_.count; ++k)
            if (block_.words[k].letter == fault.letter) word = &block_.words[k];
        if (word) {
            column = word->column;
            length = word->length;
        }
    }
    return fault_at(fault.alarm, column, length, std::move(fault.detail), fault.value0,
                    fault.value1);
}

bool Interpreter::fail_word(const Word& word, Alarm alarm, std::string detail, double v0,
                            double v1) {
    fault_column_ = word.column;
    fault_length_ = word.length;
    return core_.fail(alarm, 0, std::move(detail), v0, v1);
}

void Interpreter::finish(StopReason reason) {
    core_.mark_emitted();
    core_.sink().stop({reason}, core_.at);
    ended_ = true;
}

Step Interpreter::end_of_text() {
    CallFrame& frame = frames_.back();
    if (frame.kind == CallFrame::Kind::Subroutine)
        return fault_at(Alarm::ProgramNotEnded, 0, 0, "RET");
    if (frame.kind != CallFrame::Kind::Main) {
        core_.begin_block();
        return return_from_frame() ? Step::Continue : fault(core_.fault());
    }
    core_.at.block = -1;
    line_ = {};
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
    if (probing_) return finish_probe();
    return read_block();
}

void Interpreter::live_value_barrier() { core_.sink().barrier(core_.at); }

Step Interpreter::read_block() {
    if (definition_fault_) {  // reported before anything moves
        core_.at.line = definition_fault_->place.line;
        core_.sink().alarm(*definition_fault_, core_.at);
        ended_ = true;
        return Step::Failed;
    }
    CallFrame& frame = frames_.back();
    if (frame.kind == CallFrame::Kind::Repeat && !reread_ &&
        source_->next_position().line > frame.last_line) {
        core_.begin_block();
        return return_from_frame() ? Step::Continue : fault(core_.fault());
    }
    if (!reread_) {
        core_.at.serial = ++serial_;
        if (keep_states_)
            note_resume_point();
        else
            values_.begin_block(serial_);
        std::string_view line;
        switch (source_->next(line)) {
            case LineSource::Status::Line:
                break;
            case LineSource::Status::End:
                return end_of_text();
            case LineSource::Status::TooLong:
                return fault_at(Alarm::LineTooLong, 0, 0);
            case LineSource::Status::ReadError:
                return fault_at(Alarm::FileUnreadable, 0, 0, "reading failed");
        }
        line_storage_.assign(line);
        line_ = line_storage_;
        core_.at.line = source_->position().line;
        line_at_ = source_->position();
        title_allowed_ = line_at_.line == 1;
    }
    reread_ = false;
    fault_line_ = fault_column_ = fault_length_ = 0;
    by_letter_.fill(nullptr);
    core_.begin_block();
    BlockContext& at = core_.at;
    at.file = frame.file;
    at.stack_depth = static_cast<std::uint8_t>(frames_.size() - 1);
    at.block = -1;
    at.cycle = {};
    const BlockKind kind = reader_.read(line_, block_);
    if (block_.label >= 0) at.block = modal_.last_label = block_.label;
    switch (kind) {
        case BlockKind::Blank:
            return blank_line();
        case BlockKind::Comment:
        case BlockKind::Skipped:
            return Step::Continue;
        case BlockKind::Title:
            if (title_allowed_) return Step::Continue;
            return fault_at(Alarm::CharacterUnknown, 1, 1, "%");
        case BlockKind::NeedsBarrier:
        case BlockKind::Fault:
            return fault_at(reader_.fault().alarm, reader_.fault().column, reader_.fault().length,
                            reader_.fault().detail);
        case BlockKind::Iso:
            if (keep_states_ && !is_plain_move()) state_changed_ = true;
            return iso_block();
        case BlockKind::Statement:
            break;
    }
    state_changed_ = true;
    return statement_block();
}

// Blank lines may only stand behind the last block (fagor_8037t part 1, 2).
Step Interpreter::blank_line() {
    const TextPosition back = source_->next_position();
    std::string_view line;
    bool last = true;
    while (last && source_->next(line) == LineSource::Status::Line)
        last = line.find_first_not_of(" \t") == std::string_view::npos;
    source_->seek(back);
    return last ? Step::Continue : fault_at(Alarm::FagorBlockEmpty, 0, 0);
}

Step Interpreter::iso_block() {
    jumped_ = called_ = wants_barrier_ = false;
    const std::uint64_t ways_before = core_.ways();
    if (!classify()) return fault(core_.fault());
    if (std::exchange(interrupt_fill_, false)) stay_where_left();
    const GCode* one_shot = coded_[static_cast<std::size_t>(GGroup::OneShot)];
    // the axes rest first (architecture 5.8)
    if (one_shot && one_shot->number == 46 && !fresh_ && !core_.reads_ahead()) {
        reread_ = true;
        core_.sink().barrier(core_.at);
        return Step::AtBarrier;
    }
    // what is held for its corner ends first
    if (has('T') && core_.reads_ahead() && !fresh_ && managed_serial_ != core_.at.serial &&
        !scanning_ && managed()) {
        reread_ = true;
        live_value_barrier();
        return Step::AtBarrier;
    }
    if (asks_for_tool()) {
        reread_ = true;
        return Step::AtBarrier;
    }
    // G04 alone leaves a loop that asks the machine where it was
    if (!(one_shot && one_shot->number == 4 && ends_reading())) core_.did();
    if (!(check_words() && act())) return fault(core_.fault());
    if (managed_serial_ == core_.at.serial) core_.mark_emitted();  // its T came before the barrier
    if (core_.transformation_failed()) return fault(core_.fault());
    if (!called_) modal_.m_done = -1;
    if (scan_due_ || (scanned_to_ && serial_ >= scanned_to_)) {
        scan_due_ = false;
        if (!scan_loops()) return fault(core_.fault());
    }
    return end_block(block_.count != 0, ways_before);
}

// Behind words and statements: compensation goes on, and the modal subroutine runs where the block
// has moved.
Step Interpreter::end_block(bool counts, std::uint64_t ways_before) {
    if (core_.reads_ahead() &&
        !core_.end_compensated_block(counts && !called_, wants_barrier_, ended_))
        return fault(core_.fault());
    if (core_.emitted()) {
        fresh_ = false;
        core_.end_block();
    }
    if (!ended_ && core_.ways() != ways_before && modal_.modal_call.kind != ModalCall::Kind::None &&
        !inside_modal_call()) {
        if (!run_modal_call(repeats_ < 0 ? 1 : repeats_)) return fault(core_.fault());
    }
    // a barrier ahead may be held back
    if (core_.reads_ahead())
        return core_.halted() ? Step::AtBarrier : ended_ ? Step::Ended : Step::Continue;
    if (ended_) return Step::Ended;
    return wants_barrier_ ? Step::AtBarrier : Step::Continue;
}

std::optional<Alarm> Interpreter::parameter_value(std::int64_t number, double& value) {
    if (!Values::exists(number)) return Alarm::VariableUnknown;
    if (Values::of_maker(number) && !frames_.back().maker) return Alarm::FagorMakerParameter;
    value = values_.parameter(number);
    return std::nullopt;
}

bool Interpreter::preset_variable(std::string_view name, double value) {
    const char* at = name.data();
    Target to;
    if (expression_.target(at, name.data() + name.size(), to) != Expression::Status::Ok ||
        at != name.data() + name.size())
        return false;
    if (!to.row) {
        if (!Values::exists(to.number)) return false;
        values_.parameter(to.number) = std::isnan(value) ? 0.0 : value;
        return true;
    }
    const bool fresh = std::exchange(fresh_, true);
    const bool good = to.row->writable && write_named(to, value) == Access::Ok;
    fresh_ = fresh;
    return good;
}

}  // namespace polyturn::channels::fagor
