#include "ipc/params/param_file.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <tuple>

#include "ipc/params/export.hpp"
#include "ipc/params/limits_text.hpp"
#include "ipc/params/utf8.hpp"

namespace polyturn::params {
namespace {

Diagnosis whole_file(Alarm alarm, std::string_view filename, std::uint32_t line,
                     std::string detail) {
    Diagnosis out;
    out.alarm = alarm;
    out.place = Place{std::string(filename), line, 0, 0};
    out.detail = std::move(detail);
    return out;
}

// Lines that say nothing: blanks and comments.
bool is_empty(std::string_view line) {
    const std::size_t first = line.find_first_not_of(" \t");
    return first == std::string_view::npos || line[first] == ';';
}

// Takes the next line off the text, with whatever ends it.
std::string_view next_line(std::string_view& text) {
    const std::size_t end = std::min(text.find_first_of("\r\n"), text.size());
    const std::string_view line = text.substr(0, end);
    const bool crlf = text.substr(end).substr(0, 2) == "\r\n";
    text.remove_prefix(std::min(text.size(), end + (crlf ? 2 : 1)));
    return line;
}

bool valid(const Assignment& assignment) {
    const Row* row = assignment.row;
    if (row == nullptr || row < rows().data() || row >= rows().data() + rows().size()) return false;
    if (assignment.instance > instances(row->scope)) return false;
    if (assignment.element < Target::kEveryElement ||
        assignment.element >= static_cast<int>(row->array))
        return false;
    if (row->type == Type::Text)
        return utf8::is_printable(assignment.text) && text_allowed(*row, assignment.text);
    if (assignment.bit != Target::kWhole) {
        if (row->type != Type::Bits || assignment.bit < 0 || assignment.bit > 7) return false;
        return assignment.number == 0.0 ||
               (assignment.number == 1.0 &&
                (static_cast<unsigned>(row->max) >> assignment.bit & 1U) != 0);
    }
    // Written so that a NaN, which compares false with everything, is refused.
    const bool inside = assignment.number >= row->min && assignment.number <= row->max;
    return inside &&
           (row->type == Type::Real || assignment.number == std::trunc(assignment.number));
}

void write(Table& table, const Assignment& assignment) {
    const Row& row = *assignment.row;
    const bool every = assignment.instance == Target::kEveryInstance;
    const unsigned first = every ? 1 : assignment.instance,
                   last = every ? instances(row.scope) : assignment.instance;
    for (unsigned instance = first; instance <= last; ++instance) {
        if (assignment.axis && get(table, n0100_axis_name1, instance) != assignment.axis) continue;
        for (unsigned element = 0; element < row.array; ++element) {
            if (assignment.element != Target::kEveryElement &&
                static_cast<int>(element) != assignment.element)
                continue;
            const std::size_t slot =
                row.first_slot + static_cast<std::size_t>(instance - 1) * row.array + element;
            if (row.type == Type::Text) {
                put_text_at(table, slot, assignment.text);
            } else if (assignment.bit != Target::kWhole) {
                const auto mask = 1U << assignment.bit;
                const auto old = static_cast<unsigned>(table.numbers[slot]);
                table.numbers[slot] = assignment.number == 1.0 ? old | mask : old & ~mask;
            } else {
                table.numbers[slot] = assignment.number;
            }
        }
    }
}

}  // namespace

bool text_allowed(const Row& row, std::string_view text) noexcept {
    if (text.size() > kTextCapacity) return false;
    const std::size_t characters = utf8::characters(text);
    if (static_cast<double>(characters) < row.min || static_cast<double>(characters) > row.max)
        return false;
    if (row.text_rule == TextRule::Choice)
        return std::find(row.choices.begin(), row.choices.end(), text) != row.choices.end();
    if (row.text_rule == TextRule::Any || text.empty()) return true;
    // Ipv4: four numbers, no blanks, no leading zeros that could be taken for octal
    unsigned parts = 0;
    for (std::string_view rest = text;; ++parts) {
        const std::size_t point = rest.find('.');
        const std::string_view part = rest.substr(0, point);
        if (part.empty() || part.size() > 3 || (part.size() > 1 && part[0] == '0')) return false;
        unsigned number = 0;
        for (const char c : part) {
            if (c < '0' || c > '9') return false;
            number = number * 10 + static_cast<unsigned>(c - '0');
        }
        if (number > 255) return false;
        if (point == std::string_view::npos) return parts == 3;
        rest.remove_prefix(point + 1);
    }
}

bool ParsedFile::ok() const noexcept {
    return std::none_of(diagnoses.begin(), diagnoses.end(),
                        [](const Diagnosis& one) { return one.severity() == Severity::Error; });
}

namespace {

// Warns where a line sets again exactly what a line before it set: usually a copy that was not
// finished.
void warn_of_repetitions(ParsedFile& file) {
    using Key = std::tuple<const Row*, unsigned, int, int, char>;
    std::map<Key, std::uint32_t> seen;
    for (const Assignment& one : file.assignments) {
        const auto [found, first] = seen.try_emplace(
            Key{one.row, one.instance, one.bit, one.element, one.axis}, one.place.line);
        if (first) continue;
        Diagnosis out;
        out.alarm = Alarm::ParamTwice;
        out.place = one.place;
        out.detail = fmt::format("{}, already on line {}", target_text(one), found->second);
        found->second = one.place.line;
        if (file.diagnoses.size() < kMostDiagnoses) file.diagnoses.push_back(std::move(out));
    }
}

}  // namespace

ParsedFile parse_param_file(std::string_view text, std::string_view filename) {
    ParsedFile out;
    if (text.substr(0, 2) == "\xff\xfe" || text.substr(0, 2) == "\xfe\xff") {
        out.diagnoses.push_back(whole_file(Alarm::FileUtf16, filename, 0, std::string(filename)));
        return out;
    }
    if (text.find('\0') != std::string_view::npos) {
        out.diagnoses.push_back(whole_file(Alarm::FileBinary, filename, 0, std::string(filename)));
        return out;
    }
    if (text.substr(0, 3) == "\xef\xbb\xbf") text.remove_prefix(3);
    for (std::uint32_t number = 1; !text.empty(); ++number) {
        const std::string_view line = next_line(text);
        if (is_empty(line)) continue;
        auto result = parse_assignment(line);
        if (result.ok()) {
            result->place = Place{std::string(filename), number, 0, 0};
            out.assignments.push_back(std::move(*result));
            continue;
        }
        if (out.diagnoses.size() == kMostDiagnoses) {
            out.diagnoses.push_back(whole_file(Alarm::ParamSyntax, filename, number,
                                               "too many bad lines, the rest was not read"));
            return out;
        }
        Diagnosis diagnosis = std::move(result.diagnosis());
        diagnosis.place.file = filename;
        diagnosis.place.line = number;
        out.diagnoses.push_back(std::move(diagnosis));
    }
    warn_of_repetitions(out);
    return out;
}

Result<void> apply(Table& table, std::span<const Assignment> assignments) {
    for (const Assignment& assignment : assignments) {
        if (valid(assignment)) continue;
        Diagnosis out;
        out.alarm = Alarm::ParamRange;
        out.place = assignment.place;
        out.detail = assignment.row == nullptr
                         ? std::string("no parameter")
                         : fmt::format("{}, allowed {}", assignment.row->title(),
                                       limits_text(*assignment.row));
        return out;
    }
    for (const Assignment& assignment : assignments) write(table, assignment);
    return {};
}

Result<void> apply(Table& table, const ParsedFile& file) {
    for (const Diagnosis& diagnosis : file.diagnoses)
        if (diagnosis.severity() == Severity::Error) return diagnosis;
    return apply(table, std::span<const Assignment>(file.assignments));
}

}  // namespace polyturn::params
