#include "channels/fagor/flow/programs.hpp"

#include <algorithm>

#include "channels/engine/text_search.hpp"
#include "channels/fagor/execution.hpp"

namespace polyturn::channels::fagor {
namespace {

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

std::optional<TextPosition> subroutine_in(Execution& x, FileId file, std::int64_t number) {
    const auto found =
        engine::first_line(x.programs.files.source(file), [number](std::string_view line) {
            return subroutine_number(statement_of(line)) == number;
        });
    // it begins behind its definition
    return found ? std::optional(found->behind) : std::nullopt;
}

}  // namespace

// Letters between the commas of the first line: %NAME,MX,
bool attribute_of(Execution& x, FileId file, char attribute) {
    LineSource& source = x.programs.files.source(file);
    const engine::KeepPosition keep(source);
    source.seek({0, 1});
    std::string_view line;
    if (source.next(line) != LineSource::Status::Line || line.empty() || line[0] != '%')
        return false;
    const std::size_t comma = line.find(',');
    return comma != std::string_view::npos &&
           line.substr(comma).find(attribute) != std::string_view::npos;
}

// The subroutines that the main program defines; what is wrong with a definition is reported before
// anything moves.
void index_subroutines(Execution& x, FileId file) {
    LineSource& source = x.programs.files.source(file);
    source.seek({0, 1});
    std::string_view line;
    const bool maker = attribute_of(x, file, 'O');
    x.programs.definition_fault.reset();
    while (!x.programs.definition_fault && source.next_position().line < kIndexedLines &&
           source.next(line) == LineSource::Status::Line) {
        const std::int64_t number = subroutine_number(statement_of(line));
        if (number < 0) continue;
        const std::uint32_t at = source.position().line;
        if (number >= kMakerFirst && !maker)
            x.programs.definition_fault = Diagnosis{Alarm::FagorMakerSubroutine,
                                                    {x.programs.files.path(file), at, 0, 0},
                                                    {},
                                                    std::to_string(number)};
        else if (!x.programs.subroutines.emplace(number, std::pair{file, source.next_position()})
                      .second)
            x.programs.definition_fault = Diagnosis{Alarm::FagorSubroutineTwice,
                                                    {x.programs.files.path(file), at, 0, 0},
                                                    {},
                                                    std::to_string(number)};
    }
    source.seek({0, 1});
}

std::optional<TextPosition> find_label(Execution& x, FileId file, std::int64_t label) {
    const auto known = x.programs.labels.find({file, label});
    if (known != x.programs.labels.end()) return known->second;
    // Of several the first one counts.
    const auto found =
        engine::first_line(x.programs.files.source(file),
                           [label](std::string_view line) { return label_of(line) == label; });
    if (!found) return std::nullopt;
    return x.programs.labels[{file, label}] = found->at;
}

std::optional<FileId> find_program(Execution& x, std::int64_t number) {
    for (const WrittenProgram& program : x.modal.written) {
        if (program.number != number) continue;
        if (const auto open = x.programs.text_files.find(program.text.get());
            open != x.programs.text_files.end())
            return open->second;
        x.programs.texts.push_back(program.text);
        const auto file =
            x.programs.files.open_text(*program.text, std::to_string(number) + ".PIT");
        if (!file) return std::nullopt;
        x.programs.text_files[program.text.get()] = *file;
        return *file;
    }
    return x.programs.files.find_number(number, ".PIT");
}

bool find_subroutine(Execution& x, std::int64_t number, FileId& file, TextPosition& begin) {
    const auto look = [&](FileId in) {
        const auto at = subroutine_in(x, in, number);
        if (at) {
            file = in;
            begin = *at;
        }
        return at.has_value();
    };
    if (const auto known = x.programs.subroutines.find(number);
        known != x.programs.subroutines.end()) {
        file = known->second.first;
        begin = known->second.second;
        return true;
    }
    bool found = look(x.calls.here().file);
    for (std::size_t i = x.modal.written.size(); !found && i-- > 0;)
        if (const auto written = find_program(x, x.modal.written[i].number)) found = look(*written);
    for (std::size_t i = 0; !found && i < x.programs.files.memory_count(".PIT"); ++i)
        if (const auto stored = x.programs.files.memory_file(".PIT", i)) found = look(*stored);
    if (found && x.programs.text_files.empty()) x.programs.subroutines[number] = {file, begin};
    return found;
}

// Two programs that were loaded define it (part 2, 12.5: no two in the memory). What only lies in a
// folder is not loaded.
bool defined_twice(Execution& x, std::int64_t number, FileId known) {
    if (!x.programs.looked_twice.insert(number).second) return false;
    const std::size_t loaded =
        std::min(x.programs.files.library_count(), x.programs.files.memory_count(".PIT"));
    for (std::size_t i = 0; i < loaded; ++i) {
        const auto other = x.programs.files.memory_file(".PIT", i);
        if (other && x.programs.files.path(*other) != x.programs.files.path(known) &&
            subroutine_in(x, *other, number))
            return true;
    }
    return false;
}

}  // namespace polyturn::channels::fagor
