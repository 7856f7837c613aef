#include "ipc/diagnosis/diagnosis.hpp"

#include <fmt/format.h>

#include <algorithm>

#include "ipc/diagnosis/display_language.hpp"

namespace polyturn {

std::string_view alarm_number(Alarm id, Dialect dialect) {
    const AlarmRow& row = alarm_row(id);
    const std::string_view own = row.number[static_cast<std::size_t>(dialect)];
    return own.empty() ? row.number[0] : own;
}

std::string Diagnosis::text() const { return text_in(*this, DisplayLanguage::English); }

namespace {

// Of a line that fills screens, what is around the column.
std::string_view around(std::string_view line, std::uint32_t column) {
    constexpr std::size_t kWidest = 240, kBefore = 80;
    if (line.size() <= kWidest) return line;
    // a letter of several bytes
    const auto inside = [&](std::size_t at) {
        return at < line.size() && (static_cast<unsigned char>(line[at]) & 0xC0) == 0x80;
    };
    std::size_t from = column > kBefore ? std::min<std::size_t>(column - kBefore, line.size()) : 0;
    while (inside(from)) ++from;
    std::size_t to = std::min(from + kWidest, line.size());
    while (inside(to)) --to;
    return line.substr(from, to - from);
}

}  // namespace

std::string render(const Diagnosis& diagnosis, Dialect dialect, std::string_view source_line) {
    const Place& place = diagnosis.place;
    std::string out = place.file;
    if (place.line) out += fmt::format(":{}", place.line);
    if (place.column) out += fmt::format(":{}", place.column);
    const DisplayLanguage display_language = display_language_now();
    const std::string_view what = severity_word(diagnosis.severity(), display_language),
                           remedy = alarm_text(diagnosis.alarm, display_language).remedy;
    out +=
        fmt::format("{}{} {}: {}\n", out.empty() ? "" : ": ", what,
                    alarm_number(diagnosis.alarm, dialect), text_in(diagnosis, display_language));
    if (!source_line.empty()) {
        const std::string_view shown = around(source_line, place.column);
        const auto before = static_cast<std::size_t>(shown.data() - source_line.data());
        out += fmt::format("{:5} | {}\n", place.line, shown);
        if (place.column) {
            // Tabs are kept, so that the mark is under the word whatever their width on the
            // screen.
            std::string pad;
            for (std::size_t i = before; i + 1 < place.column && i < source_line.size(); ++i)
                pad += source_line[i] == '\t' ? '\t' : ' ';
            out += fmt::format("      | {}{}\n", pad,
                               std::string(place.length ? place.length : 1, '^'));
        }
    }
    if (!remedy.empty()) out += fmt::format("   {}\n", remedy);
    return out;
}

}  // namespace polyturn
