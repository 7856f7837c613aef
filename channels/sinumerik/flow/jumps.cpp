// Labels and block numbers: GOTOF GOTOB GOTO GOTOC GOTOS, CASE, REPEAT of a section.
#include "channels/sinumerik/flow/jumps.hpp"

#include <cmath>

#include "channels/sinumerik/execution.hpp"
#include "channels/sinumerik/faults.hpp"
#include "channels/sinumerik/flow/calls.hpp"
#include "channels/sinumerik/flow/control.hpp"
#include "channels/sinumerik/flow/run.hpp"
#include "channels/sinumerik/grammar/expression.hpp"
#include "channels/sinumerik/variables/variables.hpp"

namespace polyturn::channels::sinumerik {
namespace {

// N120 or :120 at the beginning of a line, behind its skip level; -1: no number.
std::int64_t block_number(std::string_view line) {
    Cursor cursor(line);
    while (cursor.eat('/'))
        if (is_digit(cursor.next_raw())) cursor.advance(1);
    const char c = upper(cursor.peek());
    if (c != 'N' && c != ':') return -1;
    cursor.advance(1);
    cursor.skip();
    if (!is_digit(cursor.next_raw())) return -1;
    std::int64_t number = 0;
    for (unsigned digits = 0; is_digit(cursor.next_raw()) && digits < 12;
         ++digits, cursor.advance(1))
        number = number * 10 + (cursor.next_raw() - '0');
    return number;
}

// The number that "N120" or ":120" names; -1: a label.
std::int64_t named_block(const std::string& label) {
    if (label.size() < 2 || (label[0] != 'N' && label[0] != ':')) return -1;
    std::int64_t number = 0;
    for (std::size_t i = 1; i < label.size(); ++i) {
        if (!is_digit(label[i]) || i > 12) return -1;
        number = number * 10 + (label[i] - '0');
    }
    return number;
}

// direction 0: towards the end, then towards the beginning.
bool jump_to_label(Execution& x, const std::string& label, int direction, bool alarm) {
    auto found = find_label(x, label, direction == 0 ? 1 : direction);
    if (!found && direction == 0) found = find_label(x, label, -1);
    if (!found) return !alarm || fail(x, Alarm::JumpTargetMissing, label);
    leave_sections(x, found->offset);
    seek(x, *found);
    return true;
}

}  // namespace

const TextIndex& index_of(Execution& x, FileId file) {
    TextIndex& index = x.calls.indices[file];
    if (!index.built()) index.build(x.files.source(file));
    return index;
}

// direction > 0 towards the end, < 0 towards the beginning, from the present block on.
std::optional<TextPosition> find_label(Execution& x, const std::string& label, int direction) {
    const TextPosition here = x.calls.source->next_position();
    const std::uint64_t line = x.line.here.offset;
    if (const std::int64_t number = named_block(label); number >= 0) {
        std::optional<TextPosition> found;
        std::string_view text;
        x.calls.source->seek(direction > 0 ? here : TextPosition{0, 1});
        while ((direction > 0 || x.calls.source->next_position().offset <= line) &&
               x.calls.source->next(text) == LineSource::Status::Line) {
            if (block_number(text) != number) continue;
            found = x.calls.source->position();
            if (direction > 0) break;  // backwards the nearest one is the last
        }
        x.calls.source->seek(here);
        return found;
    }
    const auto* places = index_of(x, x.calls.levels.back().file).label(label);
    if (!places) return std::nullopt;
    if (direction > 0) {
        for (const TextPosition& at : *places)
            if (at.offset > line) return at;
        return std::nullopt;
    }
    for (auto at = places->rbegin(); at != places->rend(); ++at)
        if (at->offset <= line) return *at;
    return std::nullopt;
}

// GOTOF LABEL, GOTOF N120, GOTOF "text", GOTOF name of a STRING variable.
bool jump_target(Execution& x, std::string& label) {
    const char* const from = x.line.cursor.at();
    const char c = x.line.cursor.peek();
    if (c == ':') {
        x.line.cursor.advance(1);
        label = ":";
        x.line.cursor.skip();
        while (is_digit(x.line.cursor.next_raw())) {
            label += x.line.cursor.next_raw();
            x.line.cursor.advance(1);
        }
        return label.size() > 1 || syntax(x, from, ":");
    }
    const std::string_view name = x.line.cursor.name_ahead();
    const std::string word = upper(name);
    Cursor after = x.line.cursor;
    after.advance(name.size());
    const bool plain =
        !name.empty() &&
        (after.at_end() || std::string_view("([<+").find(after.peek()) == std::string_view::npos) &&
        !find_variable(x, word);
    if (plain) {
        label = word;
        x.line.cursor.advance(name.size());
        return true;
    }
    Value value;
    if (!expression(x, value)) return false;
    if (value.type == Type::Int)
        label = "N" + to_text(value);
    else if (value.type == Type::String)
        label = upper(value.text);
    else
        return fail_at(x, Alarm::OperandTypeIllegal, from, 1, std::string(type_name(value.type)));
    return true;
}

bool st_goto(Execution& x) {
    const std::string word(x.line.statement->name);
    // IF a GOTOF b IF c GOTOF d
    const auto ends_here = [&x] {
        return upper(x.line.cursor.name_ahead()) == "IF" || rest_must_be_empty(x);
    };
    if (word == "GOTOS") {
        if (!ends_here()) return false;
        while (x.calls.levels.back().section) x.calls.levels.pop_back();
        seek(x, x.calls.levels.back().begin);
        return true;
    }
    std::string label;
    if (!jump_target(x, label) || !ends_here()) return false;
    const int direction = word == "GOTOF" ? 1 : word == "GOTOB" ? -1 : 0;
    return jump_to_label(x, label, direction, word != "GOTOC");
}

// CASE (expression) OF constant GOTOF label ... DEFAULT GOTOF label
bool st_case(Execution& x) {
    Value chosen;
    const char* const from = x.line.cursor.at();
    if (!expression(x, chosen)) return false;
    if (chosen.type != Type::Int && chosen.type != Type::Real && chosen.type != Type::Bool &&
        chosen.type != Type::Char)
        return fail_at(x, Alarm::OperandTypeIllegal, from, 1, std::string(type_name(chosen.type)));
    if (upper(x.line.cursor.name_ahead()) != "OF") return syntax(x, x.line.cursor.at(), "OF");
    x.line.cursor.advance(2);
    while (!x.line.cursor.at_end()) {
        bool fits = false;
        if (upper(x.line.cursor.name_ahead()) == "DEFAULT") {
            x.line.cursor.advance(7);
            fits = true;
        } else {
            Value constant;
            if (!expression(x, constant)) return false;
            if (!constant.is_number())
                return fail_at(x, Alarm::OperandTypeIllegal, x.line.cursor.at(), 1,
                               std::string(type_name(constant.type)));
            fits = std::floor(constant.number + 0.5) == std::floor(chosen.number + 0.5);
        }
        const std::string jump = upper(x.line.cursor.name_ahead());
        if (jump != "GOTOF" && jump != "GOTOB" && jump != "GOTO" && jump != "GOTOC" &&
            jump != "GOTOS")
            return syntax(x, x.line.cursor.at(), jump);
        x.line.cursor.advance(jump.size());
        std::string label;
        if (jump != "GOTOS" && !jump_target(x, label)) return false;
        if (!fits) continue;
        if (jump == "GOTOS") {
            while (x.calls.levels.back().section) x.calls.levels.pop_back();
            seek(x, x.calls.levels.back().begin);
            return true;
        }
        return jump_to_label(x, label,
                             jump == "GOTOF"   ? 1
                             : jump == "GOTOB" ? -1
                                               : 0,
                             jump != "GOTOC");
    }
    return true;
}

// REPEAT label [P=n], REPEAT first last [P=n], REPEATB label [P=n]; REPEAT alone begins a loop.
bool st_repeat(Execution& x) {
    if (x.line.cursor.at_end())
        return x.line.statement->name == "REPEAT" ? structure_needed(x) != nullptr
                                                  : syntax(x, x.line.cursor.at(), "REPEATB");
    const bool block_only = x.line.statement->name == "REPEATB";
    std::string first, last;
    const auto count_ahead = [&] {
        const std::string word = upper(x.line.cursor.name_ahead());
        if (word.empty() || word[0] != 'P') return false;
        Cursor after = x.line.cursor;
        after.advance(word.size());
        return (word.size() == 1 && (after.at_assign() || is_digit(after.peek()))) ||
               (word.size() > 1 && word.find_first_not_of("0123456789", 1) == std::string::npos &&
                !index_of(x, x.calls.levels.back().file).label(word));
    };
    if (!jump_target(x, first)) return false;
    if (!block_only && !x.line.cursor.at_end() && !count_ahead() && !jump_target(x, last))
        return false;
    double count = 1;
    if (!x.line.cursor.at_end()) {
        const char* const from = x.line.cursor.at();
        if (upper(x.line.cursor.peek()) != 'P') return syntax(x, from);
        x.line.cursor.advance(1);
        if (x.line.cursor.at_assign()) x.line.cursor.advance(1);
        Value value;
        if (!expression(x, value) || !number_of(x, value, from, count)) return false;
        if (!(count >= 0 && count <= 9999))
            return fail_at(x, Alarm::RepeatsIllegal, from, 1, {}, count);
    }
    if (!rest_must_be_empty(x)) return false;
    const std::uint64_t own = x.line.here.offset;
    auto begin = find_label(x, first, -1);
    if (!begin || begin->offset == own) begin = find_label(x, first, 1);
    if (!begin) return fail(x, Alarm::JumpTargetMissing, first);
    const auto line_behind = [&](TextPosition at) {
        const TextPosition back = x.calls.source->next_position();
        std::string_view text;
        x.calls.source->seek(at);
        TextPosition behind = at;
        if (x.calls.source->next(text) == LineSource::Status::Line)
            behind = x.calls.source->next_position();
        x.calls.source->seek(back);
        return behind;
    };
    std::uint64_t end = 0;
    if (block_only) {
        end = line_behind(*begin).offset;
    } else if (!last.empty()) {
        std::optional<TextPosition> stop;
        if (const auto* places = index_of(x, x.calls.levels.back().file).label(last))
            for (const TextPosition& at : *places)
                if (!stop && at.offset >= begin->offset) stop = at;
        if (!stop) return fail(x, Alarm::JumpTargetMissing, last);
        end = line_behind(*stop).offset;
    } else {
        TextPosition behind;
        if (const auto stop =
                index_of(x, x.calls.levels.back().file).end_label(begin->offset, behind);
            stop)
            end = behind.offset;
        else if (begin->offset < own)
            end = own;  // up to this block
        else
            return fail(x, Alarm::JumpTargetMissing, "ENDLABEL");
        if (begin->offset < own && end > own) end = own;
    }
    // it would repeat itself
    if (begin->offset <= own && own < end)
        return fail(x, Alarm::StructureNesting, std::string(x.line.statement->name));
    return run_section(x, *begin, end, static_cast<std::int64_t>(count), block_only);
}

}  // namespace polyturn::channels::sinumerik
