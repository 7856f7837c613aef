#include "channels/fanuc/program/fault_place.hpp"

#include <algorithm>
#include <charconv>
#include <cmath>

#include "channels/text/chars.hpp"

namespace polyturn::channels::fanuc {
namespace {

bool moves(const GTable& table, std::string_view digits) {
    double value = 0;
    if (std::from_chars(digits.data(), digits.data() + digits.size(), value).ec != std::errc() ||
        value < 0 || value > 999)
        return false;
    const GCode* row = table.find(static_cast<std::uint32_t>(std::lround(value * 10.0)));
    return row && row->group == GGroup::Motion;
}

}  // namespace

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

}  // namespace polyturn::channels::fanuc
