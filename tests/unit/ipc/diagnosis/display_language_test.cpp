// Diagnoses in the reader's language: nothing that a text quotes is lost, and what is not
// translated is English.
#include "ipc/diagnosis/display_language.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cstdlib>
#include <string>

#include "tests/unit/ipc/left_english.hpp"

namespace polyturn {
namespace {

std::string quoted(std::string_view text) {
    std::string out;
    for (std::size_t i = 0; i + 2 < text.size(); ++i)
        if (text[i] == '{' && text[i + 2] == '}') out += text[i + 1];
    std::sort(out.begin(), out.end());
    return out;
}

TEST(DisplayLanguage, NoTranslationLosesAPlaceholderOrTheRemedy) {
    for (std::uint16_t i = 0; i < kAlarmCount; ++i)
        for (const DisplayLanguage display_language : kDisplayLanguages) {
            const AlarmRow& english = alarm_row(static_cast<Alarm>(i));
            const TranslatedAlarm row = alarm_text(static_cast<Alarm>(i), display_language);
            EXPECT_EQ(quoted(row.text), quoted(english.text)) << english.key;
            EXPECT_EQ(row.remedy.empty(), english.remedy.empty()) << english.key;
            EXPECT_FALSE(row.text.empty()) << english.key;
        }
}

TEST(DisplayLanguage, ValuesAndDetailAreFilledInInEveryLanguage) {
    const Diagnosis diagnosis{Alarm::StrokeExceeded, {}, {12.5, -3.0}, "X"};
    for (const DisplayLanguage display_language : kDisplayLanguages) {
        const std::string text = text_in(diagnosis, display_language);
        for (const char* part : {"12.5", "-3", "X"})
            EXPECT_NE(text.find(part), std::string::npos) << text;
        EXPECT_EQ(text.find('{'), std::string::npos) << text;
    }
    EXPECT_NE(text_in(diagnosis, DisplayLanguage::Czech),
              text_in(diagnosis, DisplayLanguage::English));
    // logs are for machines
    EXPECT_EQ(diagnosis.text(), text_in(diagnosis, DisplayLanguage::English));
}

TEST(DisplayLanguage, IsChosenByTheEnvironment) {
    const std::pair<const char*, DisplayLanguage> rows[] = {
        {"ru", DisplayLanguage::Russian},  {"ru_RU.UTF-8", DisplayLanguage::Russian},
        {"cs_CZ", DisplayLanguage::Czech}, {"hu-HU", DisplayLanguage::Hungarian},
        {"C", DisplayLanguage::English},   {"de_DE", DisplayLanguage::English}};
    const char* before = std::getenv("POLYTURN_LANG");
    const std::string kept = before ? before : "";
    for (const auto& [name, display_language] : rows) {
        setenv("POLYTURN_LANG", name, 1);
        EXPECT_EQ(display_language_of_environment(), display_language) << name;
    }
    setenv("POLYTURN_LANG", "cs", 1);
    EXPECT_NE(render({Alarm::FeedMissing, {"a.nc", 3, 0, 0}, {}, {}}, Dialect::Polyturn, {})
                  .find("posuv"),
              std::string::npos);
    if (before)
        setenv("POLYTURN_LANG", kept.c_str(), 1);
    else
        unsetenv("POLYTURN_LANG");
}

// English serves where a row is missing, so that nobody stands before an empty line; here it is
// told.
TEST(DisplayLanguage, EveryAlarmIsTranslated) {
    for (std::uint16_t i = 0; i < kAlarmCount; ++i)
        for (const DisplayLanguage display_language :
             {DisplayLanguage::Russian, DisplayLanguage::Czech, DisplayLanguage::Hungarian}) {
            const AlarmRow& english = alarm_row(static_cast<Alarm>(i));
            const TranslatedAlarm row = alarm_text(static_cast<Alarm>(i), display_language);
            EXPECT_FALSE(left_english(english.text, row.text, display_language))
                << english.key << ": " << row.text;
            EXPECT_FALSE(left_english(english.remedy, row.remedy, display_language))
                << english.key << ": " << row.remedy;
        }
}

}  // namespace
}  // namespace polyturn

namespace polyturn {
namespace {

TEST(DisplayLanguage, TellsAnEnglishEventInAnotherLanguage) {
    const Diagnosis wrong{Alarm::FileUnreadable, {}, {}, "O0001.nc"};
    const auto told = retell(alarm_number(Alarm::FileUnreadable, Dialect::Polyturn),
                             Dialect::Polyturn, wrong.text(), DisplayLanguage::Russian);
    ASSERT_TRUE(told);
    EXPECT_EQ(told->text, text_in(wrong, DisplayLanguage::Russian));
    EXPECT_EQ(told->remedy, alarm_text(Alarm::FileUnreadable, DisplayLanguage::Russian).remedy);
    EXPECT_FALSE(retell("PT0001", Dialect::Polyturn, "something else", DisplayLanguage::Russian));
}

// A controller that speaks Czech, read by somebody who reads Hungarian.
TEST(DisplayLanguage, TellsFromEveryLanguage) {
    const Diagnosis wrong{Alarm::StoreRequestBad, {}, {}, "G60"};
    for (const DisplayLanguage from : kDisplayLanguages)
        for (const DisplayLanguage to : kDisplayLanguages) {
            const auto told = retell(alarm_number(wrong.alarm, Dialect::Polyturn),
                                     Dialect::Polyturn, text_in(wrong, from), to);
            ASSERT_TRUE(told);
            EXPECT_EQ(told->text, text_in(wrong, to));
        }
}

TEST(DisplayLanguage, ReadsEveryTextOfTheCatalogueBack) {
    for (int id = 0; id < kAlarmCount; ++id) {
        Diagnosis diagnosis{static_cast<Alarm>(id), {}, {1.5, 2}, "some detail"};
        const auto told = retell(alarm_number(diagnosis.alarm, Dialect::Polyturn),
                                 Dialect::Polyturn, diagnosis.text(), DisplayLanguage::English);
        ASSERT_TRUE(told) << alarm_row(diagnosis.alarm).key;
        EXPECT_EQ(told->text, diagnosis.text());
    }
}

}  // namespace
}  // namespace polyturn
