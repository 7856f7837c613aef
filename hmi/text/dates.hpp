// A day as people write it in the language of the screens: 2026-11-23, 23.11.2026, 2026.11.23. Two
// orders of day and month are common in English, so its days are written the one way that everybody
// reads alike (ISO 8601).
#pragma once
#include <QDateTime>

#include "hmi/text/display_languages.hpp"

namespace polyturn::hmi {

inline QString dayForm() {
    return spoken() == DisplayLanguage::English     ? "yyyy-MM-dd"
           : spoken() == DisplayLanguage::Hungarian ? "yyyy.MM.dd."
                                                    : "dd.MM.yyyy";
}
inline QString shortDayForm() {  // of this year
    switch (spoken()) {
        case DisplayLanguage::English:
            return "MM-dd";
        case DisplayLanguage::Hungarian:
            return "MM.dd.";
        case DisplayLanguage::Russian:
            return "dd.MM";
        case DisplayLanguage::Czech:
            break;
    }
    return "dd.MM.";
}

// `time`: "HH:mm", "HH:mm:ss".
inline QString momentText(const QDateTime& when, const char* time) {
    return when.isValid() ? when.toString(dayForm() + ' ' + time) : QString();
}
inline QString shortMomentText(const QDateTime& when, const char* time) {
    return when.isValid() ? when.toString(shortDayForm() + ' ' + time) : QString();
}
// As short as it is clear on the day `today`: the time of today, day and time of this year, else
// the whole day with hour and minute.
inline QString pastMomentText(const QDateTime& when, const QDate& today) {
    if (!when.isValid()) return {};
    if (when.date() == today) return when.toString("HH:mm:ss");
    return when.date().year() == today.year() ? shortMomentText(when, "HH:mm:ss")
                                              : momentText(when, "HH:mm");
}

}  // namespace polyturn::hmi
