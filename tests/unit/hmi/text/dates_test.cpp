#include "hmi/text/dates.hpp"

#include <gtest/gtest.h>

namespace polyturn::hmi {
namespace {

TEST(Dates, APastMomentIsAsShortAsItIsClear) {
    const QDate today(2026, 11, 23);
    const QTime noon(12, 5, 9);
    const DisplayLanguage before = spoken();
    struct Row {
        DisplayLanguage display_language;
        QDate day;
        const char* wanted;
    };
    for (const Row& row : {Row{DisplayLanguage::English, today, "12:05:09"},
                           Row{DisplayLanguage::English, {2026, 3, 4}, "03-04 12:05:09"},
                           Row{DisplayLanguage::English, {2025, 11, 23}, "2025-11-23 12:05"},
                           Row{DisplayLanguage::Hungarian, {2026, 3, 4}, "03.04. 12:05:09"},
                           Row{DisplayLanguage::Czech, {2025, 3, 4}, "04.03.2025 12:05"},
                           Row{DisplayLanguage::Russian, today, "12:05:09"}}) {
        speak(row.display_language);
        EXPECT_EQ(pastMomentText(QDateTime(row.day, noon), today).toStdString(), row.wanted);
    }
    EXPECT_TRUE(pastMomentText({}, today).isEmpty());
    speak(before);
}

}  // namespace
}  // namespace polyturn::hmi
