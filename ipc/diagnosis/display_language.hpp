// The language in which people read diagnoses: text and remedy of an alarm in English, Russian,
// Czech or Hungarian. Event logs and everything else that machines read stay in English
// (Diagnosis::text). A row that is not translated is shown in English. Sources:
// ipc/diagnosis/alarms.csv and alarms.ru.csv, alarms.cs.csv, alarms.hu.csv (key, text, remedy), by
// the alarm's key.
#pragma once
#include <optional>
#include <string>
#include <string_view>

#include "ipc/diagnosis/diagnosis.hpp"

namespace polyturn {

enum class DisplayLanguage : std::uint8_t { English, Russian, Czech, Hungarian };
inline constexpr DisplayLanguage kDisplayLanguages[] = {
    DisplayLanguage::English, DisplayLanguage::Russian, DisplayLanguage::Czech,
    DisplayLanguage::Hungarian};

// "ru", "cs_CZ.UTF-8", "hu"; nothing for a language that Polyturn does not speak.
std::optional<DisplayLanguage> display_language_of(std::string_view locale);
// The one in which this process speaks: as chosen, else POLYTURN_LANG, LC_ALL, LC_MESSAGES, LANG.
DisplayLanguage display_language_now();
// PT_DISPLAY_LANGUAGE of the machine, where the person has not said otherwise (POLYTURN_LANG);
// "auto" and what is not spoken change nothing.
void choose_display_language(std::string_view code);
// POLYTURN_LANG, else LC_ALL, LC_MESSAGES, LANG; English when none of them names a language that is
// spoken.
DisplayLanguage display_language_of_environment();

struct TranslatedAlarm {
    std::string_view text, remedy;  // empty: not translated
};
// As it is in the catalogue, with {0} {1} {d}; English where there is no translation.
TranslatedAlarm alarm_text(Alarm alarm, DisplayLanguage display_language);
// Values and detail filled in.
std::string text_in(const Diagnosis& diagnosis, DisplayLanguage display_language);
// An English text with its number, as event logs have them, translated into another language: text
// and remedy. Nothing when no alarm of that number reads so.
struct Retold {
    std::string text;
    std::string_view remedy;
};
std::optional<Retold> retell(std::string_view number, Dialect dialect, std::string_view english,
                             DisplayLanguage display_language);
// "alarm", "warning", "message".
std::string_view severity_word(Severity severity, DisplayLanguage display_language);

}  // namespace polyturn
