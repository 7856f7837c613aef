#include "ipc/diagnosis/tongue.hpp"

#include <fmt/format.h>

#include <cstdlib>

#include "polyturn/alarm_tongues.hpp"

namespace polyturn {

std::optional<Tongue> tongue_of(std::string_view locale) {
    const std::string_view code = locale.substr(0, locale.find_first_of("_.-@"));
    if (code == "en" || code == "C" || code == "POSIX") return Tongue::English;
    if (code == "ru") return Tongue::Russian;
    if (code == "cs" || code == "cz") return Tongue::Czech;
    if (code == "hu") return Tongue::Hungarian;
    return std::nullopt;
}

Tongue tongue_of_environment() {
    for (const char* name : {"POLYTURN_LANG", "LC_ALL", "LC_MESSAGES", "LANG"}) {
        const char* value = std::getenv(name);
        if (value && *value) return tongue_of(value).value_or(Tongue::English);   // the first that is set decides
    }
    return Tongue::English;
}

TongueRow alarm_text(Alarm alarm, Tongue tongue) {
    const AlarmRow& english = alarm_row(alarm);
    TongueRow row{english.text, english.remedy};
    if (tongue == Tongue::English) return row;
    const TongueRow& own = kAlarmTongues[static_cast<std::size_t>(tongue) - 1][static_cast<std::size_t>(alarm)];
    if (!own.text.empty()) row = own;
    return row;
}

std::string text_in(const Diagnosis& diagnosis, Tongue tongue) {
    const std::string_view pattern = alarm_text(diagnosis.alarm, tongue).text;
    std::string out;
    for (std::size_t i = 0; i < pattern.size(); ++i) {
        const bool quotes = pattern[i] == '{' && i + 2 < pattern.size() && pattern[i + 2] == '}';
        const char what = quotes ? pattern[i + 1] : '\0';
        if (what == 'd') out += diagnosis.detail;
        else if (what == '0' || what == '1') out += fmt::format("{:.6g}", diagnosis.values[static_cast<std::size_t>(what - '0')]);
        else {
            out += pattern[i];
            continue;
        }
        i += 2;
    }
    return out;
}

std::string_view severity_word(Severity severity, Tongue tongue) {
    static constexpr std::string_view kWords[4][3] = {
        {"message", "warning", "alarm"}, {"сообщение", "предупреждение", "ошибка"}, {"hlášení", "varování", "porucha"}, {"üzenet", "figyelmeztetés", "hiba"}};
    return kWords[static_cast<std::size_t>(tongue)][static_cast<std::size_t>(severity)];
}

}  // namespace polyturn
