#include "ipc/diagnosis/diagnosis.hpp"

#include <fmt/format.h>

namespace polyturn {

std::string_view alarm_number(Alarm id, Dialect dialect) {
    const AlarmRow& row = alarm_row(id);
    const std::string_view own = row.number[static_cast<std::size_t>(dialect)];
    return own.empty() ? row.number[0] : own;
}

std::string Diagnosis::text() const {
    std::string out;
    const std::string_view pattern = alarm_row(alarm).text;
    for (std::size_t i = 0; i < pattern.size(); ++i) {
        if (pattern[i] == '{' && i + 2 < pattern.size() && pattern[i + 2] == '}') {
            const char what = pattern[i + 1];
            if (what == 'd') out += detail;
            else if (what == '0' || what == '1') out += fmt::format("{:.6g}", values[static_cast<std::size_t>(what - '0')]);
            else { out += pattern[i]; continue; }
            i += 2;
        } else {
            out += pattern[i];
        }
    }
    return out;
}

std::string render(const Diagnosis& diagnosis, Dialect dialect, std::string_view source_line) {
    const Place& place = diagnosis.place;
    std::string out = place.file;
    if (place.line) out += fmt::format(":{}", place.line);
    if (place.column) out += fmt::format(":{}", place.column);
    const char* what = diagnosis.severity() == Severity::Error ? "alarm" : diagnosis.severity() == Severity::Warning ? "warning" : "message";
    out += fmt::format("{}{} {}: {}\n", out.empty() ? "" : ": ", what, alarm_number(diagnosis.alarm, dialect), diagnosis.text());
    if (!source_line.empty()) {
        out += fmt::format("{:5} | {}\n", place.line, source_line);
        if (place.column) {
            // Tabs are kept, so that the mark stands under the word whatever their width on the screen.
            std::string pad;
            for (std::size_t i = 0; i + 1 < place.column && i < source_line.size(); ++i) pad += source_line[i] == '\t' ? '\t' : ' ';
            out += fmt::format("      | {}{}\n", pad, std::string(place.length ? place.length : 1, '^'));
        }
    }
    if (!diagnosis.remedy().empty()) out += fmt::format("   {}\n", diagnosis.remedy());
    return out;
}

}  // namespace polyturn
