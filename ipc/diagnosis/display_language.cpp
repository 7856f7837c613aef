#include "ipc/diagnosis/display_language.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <iterator>

#include "ipc/diagnosis/details.hpp"
#include "polyturn/alarm_display_languages.hpp"

namespace polyturn {

std::optional<DisplayLanguage> display_language_of(std::string_view locale) {
    const std::string_view code = locale.substr(0, locale.find_first_of("_.-@"));
    if (code == "en" || code == "C" || code == "POSIX") return DisplayLanguage::English;
    if (code == "ru") return DisplayLanguage::Russian;
    if (code == "cs" || code == "cz") return DisplayLanguage::Czech;
    if (code == "hu") return DisplayLanguage::Hungarian;
    return std::nullopt;
}

DisplayLanguage display_language_of_environment() {
    for (const char* name : {"POLYTURN_LANG", "LC_ALL", "LC_MESSAGES", "LANG"}) {
        const char* value = std::getenv(name);
        // the first that is set decides
        if (value && *value) return display_language_of(value).value_or(DisplayLanguage::English);
    }
    return DisplayLanguage::English;
}

namespace {
std::optional<DisplayLanguage> chosen;

// The parts of `text` that stand for {0} {1} {d} in `pattern`; false: it does not read so.
// Placeholders match as little as they can.
bool read_parts(std::string_view pattern, std::string_view text, std::string (&parts)[3]) {
    const std::size_t open = pattern.find('{');
    if (open == std::string_view::npos || open + 2 >= pattern.size() || pattern[open + 2] != '}')
        return pattern == text;
    if (text.substr(0, open) != pattern.substr(0, open)) return false;
    const char what = pattern[open + 1];
    std::string& part = parts[what == '0' ? 0 : what == '1' ? 1 : 2];
    const std::string_view rest = pattern.substr(open + 3);
    for (std::size_t end = open; end <= text.size(); ++end)
        if (read_parts(rest, text.substr(end), parts)) {
            part = std::string(text.substr(open, end - open));
            return true;
        }
    return false;
}
}  // namespace

DisplayLanguage display_language_now() {
    return chosen.value_or(display_language_of_environment());
}

void choose_display_language(std::string_view code) {
    const char* own = std::getenv("POLYTURN_LANG");
    if (own && *own) return;
    if (const auto display_language = display_language_of(code)) chosen = display_language;
}

std::optional<Retold> retell(std::string_view number, Dialect dialect, std::string_view english,
                             DisplayLanguage display_language) {
    for (int id = 0; id < kAlarmCount; ++id) {
        const auto alarm = static_cast<Alarm>(id);
        if (alarm_number(alarm, dialect) != number) continue;
        std::string parts[3];
        // A process reports it in the machine's language, which may be another one than the
        // reader's.
        if (std::none_of(std::begin(kDisplayLanguages), std::end(kDisplayLanguages),
                         [&](DisplayLanguage told) {
                             return read_parts(alarm_text(alarm, told).text, english, parts);
                         }))
            continue;
        const TranslatedAlarm row = alarm_text(alarm, display_language);
        parts[2] = detail_in(parts[2], display_language);
        Retold out{{}, row.remedy};
        for (std::size_t i = 0; i < row.text.size(); ++i) {
            const bool quotes =
                row.text[i] == '{' && i + 2 < row.text.size() && row.text[i + 2] == '}';
            if (!quotes) {
                out.text += row.text[i];
                continue;
            }
            out.text += parts[row.text[i + 1] == '0' ? 0 : row.text[i + 1] == '1' ? 1 : 2];
            i += 2;
        }
        return out;
    }
    return std::nullopt;
}

TranslatedAlarm alarm_text(Alarm alarm, DisplayLanguage display_language) {
    const AlarmRow& english = alarm_row(alarm);
    TranslatedAlarm row{english.text, english.remedy};
    if (display_language == DisplayLanguage::English) return row;
    const TranslatedAlarm& own = kAlarmTranslations[static_cast<std::size_t>(display_language) - 1]
                                                   [static_cast<std::size_t>(alarm)];
    if (!own.text.empty()) row = own;
    return row;
}

// A figure as people write it: block number 9000001, not 9e+06; six digits are enough for what was
// measured or computed.
static std::string figure(double value) {
    return value == std::trunc(value) && std::abs(value) < 1e15 ? fmt::format("{:.0f}", value + 0.0)
                                                                : fmt::format("{:.6g}", value);
}

std::string text_in(const Diagnosis& diagnosis, DisplayLanguage display_language) {
    const std::string_view pattern = alarm_text(diagnosis.alarm, display_language).text;
    std::string out;
    for (std::size_t i = 0; i < pattern.size(); ++i) {
        const bool quotes = pattern[i] == '{' && i + 2 < pattern.size() && pattern[i + 2] == '}';
        const char what = quotes ? pattern[i + 1] : '\0';
        if (what == 'd')
            out += display_language == DisplayLanguage::English
                       ? diagnosis.detail
                       : detail_in(diagnosis.detail, display_language);
        else if (what == '0' || what == '1')
            out += figure(diagnosis.values[static_cast<std::size_t>(what - '0')]);
        else {
            out += pattern[i];
            continue;
        }
        i += 2;
    }
    return out;
}

std::string_view severity_word(Severity severity, DisplayLanguage display_language) {
    static constexpr std::string_view kWords[4][3] = {{"message", "warning", "alarm"},
                                                      {"сообщение", "предупреждение", "ошибка"},
                                                      {"hlášení", "varování", "porucha"},
                                                      {"üzenet", "figyelmeztetés", "hiba"}};
    return kWords[static_cast<std::size_t>(display_language)][static_cast<std::size_t>(severity)];
}

}  // namespace polyturn
