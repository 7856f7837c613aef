// Labels, subroutines, programs, and the frames in which they run.
#include <algorithm>

#include "channels/fagor/interpreter.hpp"

namespace polyturn::channels::fagor {
namespace {

constexpr unsigned kCallLevels = 15, kLocalLevels = 6;
constexpr std::int64_t kMakerFirst = 10'000;
// of the main program, looked through at its start
constexpr std::uint32_t kIndexedLines = 200'000;

// The number of "SUB 12)" ; -1: another statement.
std::int64_t subroutine_number(std::string_view statement) {
    if (!statement.starts_with("SUB")) return -1;
    std::size_t i = 3;
    while (i < statement.size() && statement[i] == ' ') ++i;
    std::int64_t number = 0;
    std::size_t digits = 0;
    for (; i < statement.size() && statement[i] >= '0' && statement[i] <= '9' && digits < 8;
         ++i, ++digits)
        number = number * 10 + (statement[i] - '0');
    return digits ? number : -1;
}

// Position of the first line that is the one (place() of it), from the top of the program; the
// reader stays where it was.
template <typename Wanted>
std::optional<TextPosition> look_for(LineSource& source, Wanted is_the_one,
                                     TextPosition (LineSource::*place)() const) {
    const TextPosition back = source.next_position();
    source.seek({0, 1});
    std::string_view line;
    std::optional<TextPosition> found;
    while (!found && source.next(line) == LineSource::Status::Line)
        if (is_the_one(line)) found = (source.*place)();
    source.seek(back);
    return found;
}

}  // namespace

// Letters between the commas of the first line: %NAME,MX,
bool Interpreter::attribute_of(FileId file, char attribute) {
    LineSource& source = files_->source(file);
    const TextPosition back = source.next_position();
    source.seek({0, 1});
    std::string_view line;
    bool found = false;
    if (source.next(line) == LineSource::Status::Line && !line.empty() && line[0] == '%') {
        const std::size_t comma = line.find(',');
        if (comma != std::string_view::npos)
            found = line.substr(comma).find(attribute) != std::string_view::npos;
    }
    source.seek(back);
    return found;
}

// The subroutines that the main program defines; what is wrong with a definition is reported before
// anything moves.
void Interpreter::index_subroutines(FileId file) {
    LineSource& source = files_->source(file);
    source.seek({0, 1});
    std::string_view line;
    const bool maker = attribute_of(file, 'O');
    definition_fault_.reset();
    while (!definition_fault_ && source.next_position().line < kIndexedLines &&
           source.next(line) == LineSource::Status::Line) {
        const std::int64_t number = subroutine_number(statement_of(line));
        if (number < 0) continue;
        const std::uint32_t at = source.position().line;
        if (number >= kMakerFirst && !maker)
            definition_fault_ = Diagnosis{Alarm::FagorMakerSubroutine,
                                          {files_->path(file), at, 0, 0},
                                          {},
                                          std::to_string(number)};
        else if (!subroutines_.emplace(number, std::pair{file, source.next_position()}).second)
            definition_fault_ = Diagnosis{Alarm::FagorSubroutineTwice,
                                          {files_->path(file), at, 0, 0},
                                          {},
                                          std::to_string(number)};
    }
    source.seek({0, 1});
}

std::optional<TextPosition> Interpreter::find_label(FileId file, std::int64_t label) {
    const auto known = labels_.find({file, label});
    if (known != labels_.end()) return known->second;
    // Of several the first one counts.
    const auto found = look_for(
        files_->source(file), [label](std::string_view line) { return label_of(line) == label; },
        &LineSource::position);
    if (found) labels_[{file, label}] = *found;
    return found;
}

std::optional<FileId> Interpreter::find_program(std::int64_t number) {
    for (const WrittenProgram& program : modal_.written) {
        if (program.number != number) continue;
        if (const auto open = text_files_.find(program.text.get()); open != text_files_.end())
            return open->second;
        texts_.push_back(program.text);
        const auto file = files_->open_text(*program.text, std::to_string(number) + ".PIT");
        if (!file) return std::nullopt;
        text_files_[program.text.get()] = *file;
        return *file;
    }
    return files_->find_number(number, ".PIT");
}

std::optional<TextPosition> Interpreter::subroutine_in(FileId file, std::int64_t number) {
    const auto defines = [number](std::string_view line) {
        return subroutine_number(statement_of(line)) == number;
    };
    // it begins behind its definition
    return look_for(files_->source(file), defines, &LineSource::next_position);
}

// Two programs that were loaded define it (part 2, 12.5: no two in the memory). What only lies in a
// folder is not loaded.
bool Interpreter::defined_twice(std::int64_t number, FileId known) {
    if (!looked_twice_.insert(number).second) return false;
    const std::size_t loaded = std::min(files_->library_count(), files_->memory_count(".PIT"));
    for (std::size_t i = 0; i < loaded; ++i) {
        const auto other = files_->memory_file(".PIT", i);
        if (other && files_->path(*other) != files_->path(known) && subroutine_in(*other, number))
            return true;
    }
    return false;
}

bool Interpreter::find_subroutine(std::int64_t number, FileId& file, TextPosition& begin) {
    const auto look = [&](FileId in) {
        const auto at = subroutine_in(in, number);
        if (at) {
            file = in;
            begin = *at;
        }
        return at.has_value();
    };
    if (const auto known = subroutines_.find(number); known != subroutines_.end()) {
        file = known->second.first;
        begin = known->second.second;
        return true;
    }
    bool found = look(frames_.back().file);
    for (std::size_t i = modal_.written.size(); !found && i-- > 0;)
        if (const auto written = find_program(modal_.written[i].number)) found = look(*written);
    for (std::size_t i = 0; !found && i < files_->memory_count(".PIT"); ++i)
        if (const auto stored = files_->memory_file(".PIT", i)) found = look(*stored);
    if (found && text_files_.empty()) subroutines_[number] = {file, begin};
    return found;
}

bool Interpreter::jump_to(std::int64_t label) {
    const auto found = find_label(frames_.back().file, label);
    if (!found) return core_.fail(Alarm::SequenceNumberMissing, 0, std::to_string(label));
    // A jump out of a repeated part ends the repetition.
    while (frames_.back().kind == CallFrame::Kind::Repeat &&
           (found->line < frames_.back().begin.line || found->line > frames_.back().last_line)) {
        const FileId file = frames_.back().file;
        frames_.pop_back();
        if (frames_.back().file != file)
            return core_.fail(Alarm::SequenceNumberMissing, 0, std::to_string(label));
    }
    source_->seek(*found);
    fresh_ = false;  // a loop asks the machine anew each time
    jumped_ = true;
    return true;
}

bool Interpreter::push_frame(CallFrame frame) {
    unsigned levels = 0, locals = 0;
    for (const CallFrame& other : frames_) {
        levels +=
            other.kind == CallFrame::Kind::Subroutine || other.kind == CallFrame::Kind::Program;
        locals += other.own_level;
    }
    if (frame.kind != CallFrame::Kind::Repeat && levels >= kCallLevels)
        return core_.fail(Alarm::CallTooDeep, 0, {}, kCallLevels);
    if (frame.own_level && locals >= kLocalLevels)
        return core_.fail(Alarm::FagorLevels, 0, {}, kLocalLevels);
    if (frames_.size() > 60) return core_.fail(Alarm::CallTooDeep, 0, {}, 60);
    frame.resume = source_->next_position();
    source_ = &files_->source(frame.file);
    source_->seek(frame.begin);
    frames_.push_back(frame);
    called_ = jumped_ = true;
    return true;
}

bool Interpreter::call_subroutine(std::int64_t number, CallFrame frame, const LocalSet* arguments) {
    FileId file = 0;
    TextPosition begin;
    if (!find_subroutine(number, file, begin))
        return core_.fail(Alarm::SubprogramMissing, 0, "SUB " + std::to_string(number));
    if (defined_twice(number, file))
        return core_.fail(Alarm::FagorSubroutineTwice, 0, std::to_string(number));
    if (number >= kMakerFirst) {
        if (!attribute_of(file, 'O'))
            return core_.fail(Alarm::FagorMakerSubroutine, 0, std::to_string(number));
        if (!frames_.back().maker)
            return core_.fail(Alarm::FagorMakerCall, 0, std::to_string(number));
    }
    frame.kind = CallFrame::Kind::Subroutine;
    frame.file = file;
    frame.begin = begin;
    frame.program = frames_.back().program;
    frame.maker = attribute_of(file, 'O');
    frame.own_level = arguments != nullptr;
    if (!push_frame(frame)) return false;
    if (arguments) values_.push_level(*arguments);
    return true;
}

bool Interpreter::call_program(std::int64_t number, CallFrame frame) {
    const auto file = find_program(number);
    if (!file) return core_.fail(Alarm::SubprogramMissing, 0, "P" + std::to_string(number));
    frame.kind = CallFrame::Kind::Program;
    frame.file = *file;
    frame.begin = {0, 1};
    frame.program = number;
    frame.maker = attribute_of(*file, 'O');
    return push_frame(frame);
}

void Interpreter::pop_frame() {
    const CallFrame done = frames_.back();
    frames_.pop_back();
    if (done.own_level) values_.pop_level();
    source_ = &files_->source(frames_.back().file);
    source_->seek(done.resume);
    jumped_ = true;
}

// RET, the end of a program, the end of a repeated part: once more, or back to the caller.
bool Interpreter::return_from_frame() {
    state_changed_ = true;
    CallFrame& frame = frames_.back();
    if (frame.interrupt) return return_from_interrupt();
    if (frame.runs_left > 0) {  // the same parameters as they are now (12.5)
        --frame.runs_left;
        source_->seek(frame.begin);
        jumped_ = true;
        return true;
    }
    const std::int32_t code = frame.m_itself ? frame.m_code : -1;
    const std::int32_t done = frame.reads_again ? frame.m_code : -1;
    pop_frame();
    if (done >= 0) modal_.m_done = done;
    if (code >= 0) {
        char text[16];
        const int length = std::snprintf(text, sizeof text, "M%d", code);
        core_.aux('M', code, {text, static_cast<std::size_t>(length)}, false);
        core_.end_block();
    }
    return true;
}

bool Interpreter::inside_modal_call() const {
    for (const CallFrame& frame : frames_)
        if (frame.modal) return true;
    return false;
}

bool Interpreter::run_modal_call(std::int64_t repeats) {
    if (repeats < 1) return true;
    const ModalCall call = modal_.modal_call;
    CallFrame frame;
    frame.modal = true;
    frame.given = call.given;
    // N does not count (12.7)
    if (call.kind == ModalCall::Kind::Program) return call_program(call.number, frame);
    frame.runs_left = repeats - 1;
    return call_subroutine(call.number, frame, &call.arguments);
}

}  // namespace polyturn::channels::fagor
