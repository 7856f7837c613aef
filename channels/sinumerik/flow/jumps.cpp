// Labels and block numbers: GOTOF GOTOB GOTO GOTOC GOTOS, CASE, REPEAT of a section.
#include <algorithm>
#include <cmath>

#include "channels/sinumerik/interpreter.hpp"

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

}  // namespace

const TextIndex& Interpreter::index_of(FileId file) {
    TextIndex& index = indices_[file];
    if (!index.built()) index.build(files_->source(file));
    return index;
}

// direction > 0 towards the end, < 0 towards the beginning, from the present block on.
std::optional<TextPosition> Interpreter::find_label(const std::string& label, int direction) {
    const TextPosition here = source_->next_position();
    const std::uint64_t line = here_.offset;
    if (const std::int64_t number = named_block(label); number >= 0) {
        std::optional<TextPosition> found;
        std::string_view text;
        source_->seek(direction > 0 ? here : TextPosition{0, 1});
        while ((direction > 0 || source_->next_position().offset <= line) &&
               source_->next(text) == LineSource::Status::Line) {
            if (block_number(text) != number) continue;
            found = source_->position();
            if (direction > 0) break;  // backwards the nearest one is the last
        }
        source_->seek(here);
        return found;
    }
    const auto* places = index_of(levels_.back().file).label(label);
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
bool Interpreter::jump_target(std::string& label) {
    const char* const from = cursor_.at();
    const char c = cursor_.peek();
    if (c == ':') {
        cursor_.advance(1);
        label = ":";
        cursor_.skip();
        while (is_digit(cursor_.next_raw())) {
            label += cursor_.next_raw();
            cursor_.advance(1);
        }
        return label.size() > 1 || syntax(from, ":");
    }
    const std::string_view name = cursor_.name_ahead();
    const std::string word = upper(name);
    Cursor after = cursor_;
    after.advance(name.size());
    const bool plain =
        !name.empty() &&
        (after.at_end() || std::string_view("([<+").find(after.peek()) == std::string_view::npos) &&
        !find_variable(word);
    if (plain) {
        label = word;
        cursor_.advance(name.size());
        return true;
    }
    Value value;
    if (!expression(value)) return false;
    if (value.type == Type::Int)
        label = "N" + to_text(value);
    else if (value.type == Type::String)
        label = upper(value.text);
    else
        return fail_at(Alarm::OperandTypeIllegal, from, 1, std::string(type_name(value.type)));
    return true;
}

// direction 0: towards the end, then towards the beginning.
bool Interpreter::jump_to_label(const std::string& label, int direction, bool alarm) {
    auto found = find_label(label, direction == 0 ? 1 : direction);
    if (!found && direction == 0) found = find_label(label, -1);
    if (!found) return !alarm || fail(Alarm::JumpTargetMissing, label);
    leave_sections(found->offset);
    seek(*found);
    return true;
}

bool Interpreter::st_goto() {
    const std::string word(statement_->name);
    // IF a GOTOF b IF c GOTOF d
    const auto ends_here = [this] {
        return upper(cursor_.name_ahead()) == "IF" || rest_must_be_empty();
    };
    if (word == "GOTOS") {
        if (!ends_here()) return false;
        while (levels_.back().section) levels_.pop_back();
        seek(levels_.back().begin);
        return true;
    }
    std::string label;
    if (!jump_target(label) || !ends_here()) return false;
    const int direction = word == "GOTOF" ? 1 : word == "GOTOB" ? -1 : 0;
    return jump_to_label(label, direction, word != "GOTOC");
}

// CASE (expression) OF constant GOTOF label ... DEFAULT GOTOF label
bool Interpreter::st_case() {
    Value chosen;
    const char* const from = cursor_.at();
    if (!expression(chosen)) return false;
    if (chosen.type != Type::Int && chosen.type != Type::Real && chosen.type != Type::Bool &&
        chosen.type != Type::Char)
        return fail_at(Alarm::OperandTypeIllegal, from, 1, std::string(type_name(chosen.type)));
    if (upper(cursor_.name_ahead()) != "OF") return syntax(cursor_.at(), "OF");
    cursor_.advance(2);
    while (!cursor_.at_end()) {
        bool fits = false;
        if (upper(cursor_.name_ahead()) == "DEFAULT") {
            cursor_.advance(7);
            fits = true;
        } else {
            Value constant;
            if (!expression(constant)) return false;
            if (!constant.is_number())
                return fail_at(Alarm::OperandTypeIllegal, cursor_.at(), 1,
                               std::string(type_name(constant.type)));
            fits = std::floor(constant.number + 0.5) == std::floor(chosen.number + 0.5);
        }
        const std::string jump = upper(cursor_.name_ahead());
        if (jump != "GOTOF" && jump != "GOTOB" && jump != "GOTO" && jump != "GOTOC" &&
            jump != "GOTOS")
            return syntax(cursor_.at(), jump);
        cursor_.advance(jump.size());
        std::string label;
        if (jump != "GOTOS" && !jump_target(label)) return false;
        if (!fits) continue;
        if (jump == "GOTOS") {
            while (levels_.back().section) levels_.pop_back();
            seek(levels_.back().begin);
            return true;
        }
        return jump_to_label(label,
                             jump == "GOTOF"   ? 1
                             : jump == "GOTOB" ? -1
                                               : 0,
                             jump != "GOTOC");
    }
    return true;
}

// REPEAT label [P=n], REPEAT first last [P=n], REPEATB label [P=n]; REPEAT alone begins a loop.
bool Interpreter::st_repeat() {
    if (cursor_.at_end())
        return statement_->name == "REPEAT" ? structure_needed() != nullptr
                                            : syntax(cursor_.at(), "REPEATB");
    const bool block_only = statement_->name == "REPEATB";
    std::string first, last;
    const auto count_ahead = [&] {
        const std::string word = upper(cursor_.name_ahead());
        if (word.empty() || word[0] != 'P') return false;
        Cursor after = cursor_;
        after.advance(word.size());
        return (word.size() == 1 && (after.at_assign() || is_digit(after.peek()))) ||
               (word.size() > 1 && word.find_first_not_of("0123456789", 1) == std::string::npos &&
                !index_of(levels_.back().file).label(word));
    };
    if (!jump_target(first)) return false;
    if (!block_only && !cursor_.at_end() && !count_ahead() && !jump_target(last)) return false;
    double count = 1;
    if (!cursor_.at_end()) {
        const char* const from = cursor_.at();
        if (upper(cursor_.peek()) != 'P') return syntax(from);
        cursor_.advance(1);
        if (cursor_.at_assign()) cursor_.advance(1);
        Value value;
        if (!expression(value) || !number_of(value, from, count)) return false;
        if (!(count >= 0 && count <= 9999))
            return fail_at(Alarm::RepeatsIllegal, from, 1, {}, count);
    }
    if (!rest_must_be_empty()) return false;
    const std::uint64_t own = here_.offset;
    auto begin = find_label(first, -1);
    if (!begin || begin->offset == own) begin = find_label(first, 1);
    if (!begin) return fail(Alarm::JumpTargetMissing, first);
    const auto line_behind = [&](TextPosition at) {
        const TextPosition back = source_->next_position();
        std::string_view text;
        source_->seek(at);
        TextPosition behind = at;
        if (source_->next(text) == LineSource::Status::Line) behind = source_->next_position();
        source_->seek(back);
        return behind;
    };
    std::uint64_t end = 0;
    if (block_only) {
        end = line_behind(*begin).offset;
    } else if (!last.empty()) {
        std::optional<TextPosition> stop;
        if (const auto* places = index_of(levels_.back().file).label(last))
            for (const TextPosition& at : *places)
                if (!stop && at.offset >= begin->offset) stop = at;
        if (!stop) return fail(Alarm::JumpTargetMissing, last);
        end = line_behind(*stop).offset;
    } else {
        TextPosition behind;
        if (const auto stop = index_of(levels_.back().file).end_label(begin->offset, behind); stop)
            end = behind.offset;
        else if (begin->offset < own)
            end = own;  // up to this block
        else
            return fail(Alarm::JumpTargetMissing, "ENDLABEL");
        if (begin->offset < own && end > own) end = own;
    }
    // it would repeat itself
    if (begin->offset <= own && own < end)
        return fail(Alarm::StructureNesting, std::string(statement_->name));
    return run_section(*begin, end, static_cast<std::int64_t>(count), block_only);
}

}  // namespace polyturn::channels::sinumerik
