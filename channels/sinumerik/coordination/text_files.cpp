// Text files: READ WRITE DELETE FILESIZE FILEDATE FILETIME FILESTAT FILEINFO ISFILE
// (sinumerik_part3 7.16, 9.9). What a program writes or deletes it finds again until its channel's
// process ends; the files of the operator are never changed.
#include "channels/sinumerik/coordination/text_files.hpp"

#include <fmt/format.h>

#include <chrono>
#include <filesystem>

#include "channels/sinumerik/execution.hpp"
#include "channels/sinumerik/faults.hpp"
#include "channels/sinumerik/flow/call_statements.hpp"
#include "channels/sinumerik/variables/changes.hpp"
#include "channels/sinumerik/variables/variables.hpp"

namespace polyturn::channels::sinumerik {
namespace {

enum FileError : int {
    kOk = 0,
    kFileMissing = 3,
    kFileFull = 10,
    kLineMissing = 21,
    kResultTooShort = 22,
    kRangeTooLarge = 23
};
constexpr std::size_t kLargestFile = 1 << 20, kLongestWritten = 200;
constexpr std::string_view kRights = "77777";  // read write execute show delete: for everybody

// The text of a file with a line end behind each line; false: there is none.
bool text_of_file(Execution& x, const std::string& name, std::string& text) {
    if (const auto own = x.texts.written.find(name); own != x.texts.written.end()) {
        if (own->second) text = *own->second;
        return own->second.has_value();
    }
    const auto id = x.files.find_name(name);
    if (!id) return false;
    LineSource& source = x.files.source(*id);
    const TextPosition here = source.next_position();  // it may be the running program
    source.seek({0, 1});
    std::string_view line;
    while (text.size() <= kLargestFile && source.next(line) == LineSource::Status::Line)
        text.append(line) += '\n';
    source.seek(here);
    return true;
}

void change_file(Execution& x, const std::string& name, std::optional<std::string> text) {
    const auto own = x.texts.written.find(name);
    undo(x, [&x, name, had = own != x.texts.written.end(),
             before = own != x.texts.written.end() ? own->second : std::nullopt] {
        if (had)
            x.texts.written[name] = before;
        else
            x.texts.written.erase(name);
    });
    x.texts.written[name] = std::move(text);
    x.texts.written_at[name] = x.core.port().clock();
}

// When the file was written last: by a program of this run, or on the disk.
CalendarTime time_of_file(Execution& x, const std::string& name) {
    if (const auto own = x.texts.written_at.find(name); own != x.texts.written_at.end())
        return own->second;
    CalendarTime time;
    const auto id = x.files.find_name(name);
    std::error_code failed;
    const auto stamp = id ? std::filesystem::last_write_time(x.files.path(*id), failed)
                          : std::filesystem::file_time_type{};
    if (!id || failed) return time;
    const auto system = std::chrono::file_clock::to_sys(stamp);
    const auto day = std::chrono::floor<std::chrono::days>(system);
    const std::chrono::year_month_day date{day};
    const std::chrono::hh_mm_ss clock{std::chrono::floor<std::chrono::seconds>(system - day)};
    time.year = static_cast<int>(date.year());
    time.month = static_cast<int>(static_cast<unsigned>(date.month()));
    time.day = static_cast<int>(static_cast<unsigned>(date.day()));
    time.hour = static_cast<int>(clock.hours().count());
    time.minute = static_cast<int>(clock.minutes().count());
    time.second = static_cast<int>(clock.seconds().count());
    return time;
}

}  // namespace

// FILEDATE "dd.mm.yy", FILETIME "hh.mm.ss", FILESTAT the rights, FILEINFO all of them and the size.
bool p_file_facts(Execution& x, Call& c) {
    const std::string_view asked = x.block.procedures.front().first->name;
    for (std::size_t i = 0; i < 3; ++i)
        if (!c.has(i))
            return fail(x, Alarm::ArgumentCountIllegal, std::string(asked), static_cast<double>(i));
    std::string text;
    const std::string name = program_of_path(c.value(1).text);
    if (!text_of_file(x, name, text))
        return assign(x, c.arguments[0].reference, Value::of_int(kFileMissing),
                      x.line.cursor.begin());
    const CalendarTime time = time_of_file(x, name);
    const std::string date =
        fmt::format("{:02}.{:02}.{:02}", time.day, time.month, time.year % 100);
    const std::string answer =
        asked == "FILEDATE" ? date
        : asked == "FILETIME"
            ? fmt::format("{:02}.{:02}.{:02}", time.hour, time.minute, time.second)
        : asked == "FILESTAT" ? std::string(kRights)
                              : fmt::format("{} {:>8} {} {:02}:{:02}:{:02}", kRights, text.size(),
                                            date, time.hour, time.minute, time.second);
    const Reference& result = c.arguments[2].reference;
    const bool fits =
        result.variable->type == Type::String && answer.size() <= result.variable->text_length;
    if (fits && !assign(x, result, Value::of_text(answer), x.line.cursor.begin())) return false;
    return assign(x, c.arguments[0].reference, Value::of_int(fits ? kOk : kResultTooShort),
                  x.line.cursor.begin());
}

bool p_write(Execution& x, Call& c) {  // WRITE(error, file, block)
    if (c.arguments.size() > 3) return fail(x, Alarm::NotBuilt, "WRITE(,,\"EXT\",)");
    if (!c.has(0) || !c.has(1) || !c.has(2))
        return fail(x, Alarm::ArgumentCountIllegal, "WRITE",
                    static_cast<double>(c.arguments.size()));
    const std::string name = program_of_path(c.value(1).text), block = to_text(c.value(2));
    if (block.size() > kLongestWritten)
        return fail(x, Alarm::TextTooLong, "WRITE", kLongestWritten);
    std::string text;
    (void)text_of_file(x, name, text);
    const bool full = text.size() + block.size() > kLargestFile;
    if (!full) change_file(x, name, text + block + "\n");
    return assign(x, c.arguments[0].reference, Value::of_int(full ? kFileFull : kOk),
                  x.line.cursor.begin());
}

// READ(error, file, line, count, result): the lines that are there, even when the file ends before.
bool p_read(Execution& x, Call& c) {
    for (std::size_t i = 0; i < 5; ++i)
        if (!c.has(i)) return fail(x, Alarm::ArgumentCountIllegal, "READ", static_cast<double>(i));
    const Reference& result = c.arguments[4].reference;
    if (result.variable->type != Type::String)
        return fail(x, Alarm::ArgumentTypeIllegal,
                    "READ: " + std::string(type_name(result.variable->type)), 5);
    int error = kOk;
    std::string text;
    const auto first = c.number(2), count = c.number(3);
    if (!text_of_file(x, program_of_path(c.value(1).text), text))
        error = kFileMissing;
    else if (first < 1 || count < 1)
        error = kLineMissing;
    else if (count > static_cast<double>(result.variable->cells.size() - result.element))
        error = kResultTooShort;
    std::size_t at = 0;
    for (double line = 1; error == kOk && line < first + count; ++line) {
        const std::size_t end = text.find('\n', at);
        if (end == std::string::npos) {
            error = line <= first ? kLineMissing : kRangeTooLarge;
        } else if (line >= first) {
            if (end - at > result.variable->text_length)
                error = kResultTooShort;
            else
                store(x,
                      {result.variable, result.element + static_cast<std::size_t>(line - first),
                       false},
                      Value::of_text(text.substr(at, end - at)));
        }
        at = end + 1;
    }
    return assign(x, c.arguments[0].reference, Value::of_int(error), x.line.cursor.begin());
}

bool p_delete(Execution& x, Call& c) {
    if (!c.has(0) || !c.has(1))
        return fail(x, Alarm::ArgumentCountIllegal, "DELETE",
                    static_cast<double>(c.arguments.size()));
    const std::string name = program_of_path(c.value(1).text);
    std::string text;
    const bool there = text_of_file(x, name, text);
    if (there) change_file(x, name, std::nullopt);
    return assign(x, c.arguments[0].reference, Value::of_int(there ? kOk : kFileMissing),
                  x.line.cursor.begin());
}

bool p_file_size(Execution& x, Call& c) {  // bytes
    for (std::size_t i = 0; i < 3; ++i)
        if (!c.has(i))
            return fail(x, Alarm::ArgumentCountIllegal, "FILESIZE", static_cast<double>(i));
    std::string text;
    const bool there = text_of_file(x, program_of_path(c.value(1).text), text);
    if (there && !assign(x, c.arguments[2].reference,
                         Value::of_int(static_cast<double>(text.size())), x.line.cursor.begin()))
        return false;
    return assign(x, c.arguments[0].reference, Value::of_int(there ? kOk : kFileMissing),
                  x.line.cursor.begin());
}

bool f_isfile(Execution& x, Call& c) {
    std::string text;
    c.result = Value::of_bool(text_of_file(x, program_of_path(c.value(0).text), text));
    return true;
}

}  // namespace polyturn::channels::sinumerik
