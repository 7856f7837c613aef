// What PLC flags and registers mean, in every language.
#include "ipc/image/signal_translations.hpp"

#include <gtest/gtest.h>

#include "tests/unit/ipc/left_english.hpp"

namespace polyturn {
namespace {

TEST(SignalTranslations, EverySignalIsTranslated) {
    for (const SignalRow& row : signal_rows()) {
        EXPECT_EQ(meaning_of(row, DisplayLanguage::English), row.meaning);
        for (const DisplayLanguage display_language :
             {DisplayLanguage::Russian, DisplayLanguage::Czech, DisplayLanguage::Hungarian})
            EXPECT_FALSE(
                left_english(row.meaning, meaning_of(row, display_language), display_language))
                << static_cast<int>(display_language) << ' ' << row.name << ": "
                << meaning_of(row, display_language);
    }
}

}  // namespace
}  // namespace polyturn
