// Text files: READ WRITE DELETE FILESIZE ISFILE (sinumerik_part3 7.16, 9.9). What a program writes or deletes it finds again until its
// channel's process ends; the files of the operator are never changed.
#include <algorithm>

#include "channels/sinumerik/interpreter.hpp"

namespace polyturn::channels::sinumerik {
namespace {

enum FileError : int { kOk = 0, kFileMissing = 3, kFileFull = 10, kLineMissing = 21, kResultTooShort = 22, kRangeTooLarge = 23 };
constexpr std::size_t kLargestFile = 1 << 20, kLongestWritten = 200;

}  // namespace

// The text of a file with a line end behind each line; false: there is none.
bool Interpreter::text_of_file(const std::string& name, std::string& text) {
    if (const auto own = written_files_.find(name); own != written_files_.end()) {
        if (own->second) text = *own->second;
        return own->second.has_value();
    }
    const auto id = files_->find_name(name);
    if (!id) return false;
    LineSource& source = files_->source(*id);
    const TextPosition here = source.next_position();   // it may be the running program
    source.seek({0, 1});
    std::string_view line;
    while (text.size() <= kLargestFile && source.next(line) == LineSource::Status::Line) text.append(line) += '\n';
    source.seek(here);
    return true;
}

void Interpreter::change_file(const std::string& name, std::optional<std::string> text) {
    const auto own = written_files_.find(name);
    undo([this, name, had = own != written_files_.end(), before = own != written_files_.end() ? own->second : std::nullopt] {
        if (had) written_files_[name] = before;
        else written_files_.erase(name);
    });
    written_files_[name] = std::move(text);
}

bool Interpreter::p_write(Call& c) {   // WRITE(error, file, block)
    if (c.arguments.size() > 3) return fail(Alarm::NotBuilt, "WRITE(,,\"EXT\",)");
    if (!c.has(0) || !c.has(1) || !c.has(2)) return fail(Alarm::ArgumentCountIllegal, "WRITE", static_cast<double>(c.arguments.size()));
    const std::string name = program_of_path(c.value(1).text), block = to_text(c.value(2));
    if (block.size() > kLongestWritten) return fail(Alarm::TextTooLong, "WRITE", kLongestWritten);
    std::string text;
    (void)text_of_file(name, text);
    const bool full = text.size() + block.size() > kLargestFile;
    if (!full) change_file(name, text + block + "\n");
    return assign(c.arguments[0].reference, Value::of_int(full ? kFileFull : kOk), cursor_.begin());
}

// READ(error, file, line, count, result): the lines that are there, even when the file ends before.
bool Interpreter::p_read(Call& c) {
    for (std::size_t i = 0; i < 5; ++i)
        if (!c.has(i)) return fail(Alarm::ArgumentCountIllegal, "READ", static_cast<double>(i));
    const Reference& result = c.arguments[4].reference;
    if (result.variable->type != Type::String) return fail(Alarm::ArgumentTypeIllegal, "READ: " + std::string(type_name(result.variable->type)), 5);
    int error = kOk;
    std::string text;
    const auto first = c.number(2), count = c.number(3);
    if (!text_of_file(program_of_path(c.value(1).text), text)) error = kFileMissing;
    else if (first < 1 || count < 1) error = kLineMissing;
    else if (count > static_cast<double>(result.variable->cells.size() - result.element)) error = kResultTooShort;
    std::size_t at = 0;
    for (double line = 1; error == kOk && line < first + count; ++line) {
        const std::size_t end = text.find('\n', at);
        if (end == std::string::npos) {
            error = line <= first ? kLineMissing : kRangeTooLarge;
        } else if (line >= first) {
            if (end - at > result.variable->text_length) error = kResultTooShort;
            else store({result.variable, result.element + static_cast<std::size_t>(line - first), false}, Value::of_text(text.substr(at, end - at)));
        }
        at = end + 1;
    }
    return assign(c.arguments[0].reference, Value::of_int(error), cursor_.begin());
}

bool Interpreter::p_delete(Call& c) {
    if (!c.has(0) || !c.has(1)) return fail(Alarm::ArgumentCountIllegal, "DELETE", static_cast<double>(c.arguments.size()));
    const std::string name = program_of_path(c.value(1).text);
    std::string text;
    const bool there = text_of_file(name, text);
    if (there) change_file(name, std::nullopt);
    return assign(c.arguments[0].reference, Value::of_int(there ? kOk : kFileMissing), cursor_.begin());
}

bool Interpreter::p_file_size(Call& c) {   // bytes
    for (std::size_t i = 0; i < 3; ++i)
        if (!c.has(i)) return fail(Alarm::ArgumentCountIllegal, "FILESIZE", static_cast<double>(i));
    std::string text;
    const bool there = text_of_file(program_of_path(c.value(1).text), text);
    if (there && !assign(c.arguments[2].reference, Value::of_int(static_cast<double>(text.size())), cursor_.begin())) return false;
    return assign(c.arguments[0].reference, Value::of_int(there ? kOk : kFileMissing), cursor_.begin());
}

bool Interpreter::f_isfile(Call& c) {
    std::string text;
    c.result = Value::of_bool(text_of_file(program_of_path(c.value(0).text), text));
    return true;
}

}  // namespace polyturn::channels::sinumerik
