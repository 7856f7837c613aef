#include "channels/fanuc/fault_place.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <charconv>
#include <cmath>
#include <fstream>

#include "channels/fanuc/interpreter.hpp"
#include "channels/text/chars.hpp"

namespace polyturn::channels::fanuc {
namespace {

// Behind the value that begins here: a number, #101, or an expression in brackets.
std::size_t behind_value(std::string_view line, std::size_t at) {
    int depth = 0;
    for (; at < line.size(); ++at) {
        const char c = line[at];
        if (c == '[')
            ++depth;
        else if (c == ']')
            --depth;
        else if (depth == 0 && !is_digit(c) && c != '.' && c != '-' && c != '+' && c != '#' &&
                 c != ' ')
            break;
    }
    while (at > 0 && line[at - 1] == ' ') --at;
    return at;
}

bool moves(const GTable& table, std::string_view digits) {
    double value = 0;
    if (std::from_chars(digits.data(), digits.data() + digits.size(), value).ec != std::errc() ||
        value < 0 || value > 999)
        return false;
    const GCode* row = table.find(static_cast<std::uint32_t>(std::lround(value * 10.0)));
    return row && row->group == GGroup::Motion;
}

}  // namespace

LinePlace place_in_line(std::string_view line, const GTable& table, char letter) {
    LinePlace first, code, moving, named;
    for (std::size_t at = 0; at < line.size();) {
        const char c = capital(line[at]);
        if (c == '(') {
            at = std::min(line.find(')', at), line.size() - 1) + 1;
            continue;
        }
        if (c == ';') {
            if (line.find_first_not_of("; \t\r", at) != std::string_view::npos) return {};
            break;
        }
        const auto column = static_cast<std::uint32_t>(at + 1);
        // a macro statement
        if (c == '#' || (is_capital(c) && at + 1 < line.size() && is_letter(line[at + 1]))) {
            if (first.column) break;
            std::size_t end = at + 1;
            while (end < line.size() && (c == '#' ? is_digit(line[end]) : is_letter(line[end])))
                ++end;
            return {column, static_cast<std::uint32_t>(end - at)};
        }
        if (!is_capital(c)) {
            ++at;
            continue;
        }
        const std::size_t end = behind_value(line, at + 1);
        const LinePlace word{column, static_cast<std::uint32_t>(end - at)};
        if (c != 'N' && c != 'O') {
            if (!first.column) first = word;
            if (c == 'G') code = word;
            if (c == 'G' && !moving.column && moves(table, line.substr(at + 1, end - at - 1)))
                moving = word;
            if (c == letter) named = word;
        }
        at = end;
    }
    return named.column ? named : moving.column ? moving : code.column ? code : first;
}

namespace {

// A length of the text has a decimal point. Comments, and words that are no lengths (G12.1, P1.12,
// F100.), say nothing.
bool length_with_point(std::string_view line) {
    constexpr std::string_view kLengths = "XYZUVWABCIJKRE";
    for (std::size_t at = 0; at < line.size();) {
        if (line[at] == '(') at = std::min(line.find(')', at), line.size() - 1);
        const char c = capital(line[at++]);
        if (!is_capital(c) || (at < line.size() && is_letter(line[at]))) continue;
        const std::size_t end = behind_value(line, at);
        if (kLengths.find(c) != std::string_view::npos &&
            line.substr(at, end - at).find('.') != std::string_view::npos)
            return true;
        at = std::max(at, end);
    }
    return false;
}

// The reader of the program is not disturbed. A text that cannot be read here says nothing.
bool file_has_points(const std::string& path) {
    std::ifstream text(path);
    if (!text) return true;
    for (std::string line; std::getline(text, line);)
        if (length_with_point(line)) return true;
    return false;
}

}  // namespace

// G0 X50 is 0.05 mm where F3401#0 is 0, as on the control. Whoever writes no point in a whole
// program means millimetres more often than not: one warning, at the first such word.
void Interpreter::judge_points() {
    if (points_judged_ || settings_.point_means_nothing || reads_contour_ ||
        coded_groups_ >> static_cast<unsigned>(GGroup::OneShot) & 1u)
        return;
    for (unsigned k = 0; k < axis_word_count_ && !points_judged_; ++k) {
        const Word& word = block_.words[axis_words_[k]];
        if (word.value == 0 || word.from_expression) continue;
        points_judged_ = true;
        if (word.has_point || file_has_points(files_->path(frames_.front().file))) return;
        const AxisOf axis = axis_of(word);
        std::string meant = fmt::format("{} = {:.4f}", text_of(word), length(word, axis.place));
        meant.erase(meant.find_last_not_of('0') + 1);
        core_.sink().alarm({Alarm::PointsMissing,
                            {{}, core_.at.line, character_column(line_, word.column), word.length},
                            {},
                            meant},
                           core_.at);
    }
}

// The source's position is unchanged afterwards; the line that was read last is no longer there.
LinePlace Interpreter::place_in_file(FileId file, std::uint32_t wanted, char letter) {
    LineSource& source = files_->source(file);
    const TextPosition back = source.next_position();
    source.seek({0, 1});
    std::string_view line;
    LinePlace place;
    while (source.next(line) == LineSource::Status::Line) {
        if (source.position().line < wanted) continue;
        if (source.position().line == wanted) place = place_in_line(line, table_, letter);
        if (place.column) place.column = character_column(line, place.column);
        break;
    }
    source.seek(back);
    line_ = {};
    return place;
}

}  // namespace polyturn::channels::fanuc
