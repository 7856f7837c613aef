// What PLC flags and registers mean, in every language.
#include "ipc/image/signal_tongue.hpp"

#include <gtest/gtest.h>

#include "tests/unit/ipc/left_english.hpp"

namespace polyturn {
namespace {

TEST(SignalTongues, EverySignalIsTranslated) {
    for (const SignalRow& row : signal_rows()) {
        EXPECT_EQ(meaning_of(row, Tongue::English), row.meaning);
        for (const Tongue tongue : {Tongue::Russian, Tongue::Czech, Tongue::Hungarian})
            EXPECT_FALSE(left_english(row.meaning, meaning_of(row, tongue), tongue)) << static_cast<int>(tongue) << ' ' << row.name << ": " << meaning_of(row, tongue);
    }
}

}  // namespace
}  // namespace polyturn
