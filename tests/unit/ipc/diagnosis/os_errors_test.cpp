// What the operating system says is read in the language of the reader, wherever it stands in a text.
#include "ipc/diagnosis/os_errors.hpp"

#include <gtest/gtest.h>

#include <cerrno>
#include <clocale>
#include <cstring>
#include <set>
#include <system_error>

#include "ipc/diagnosis/details.hpp"
#include "tests/unit/ipc/left_english.hpp"

namespace polyturn {
namespace {

TEST(OsErrors, AreCompleteAndAsTheLibrarySaysThem) {
    std::set<std::string_view> told[4];
    for (const OsErrorRow& row : os_error_rows()) {
        EXPECT_EQ(row.in[0], std::strerror(row.number));   // tests run without a locale: as processes do
        EXPECT_EQ(row.in[0], std::error_code(row.number, std::system_category()).message());
        for (const Tongue tongue : kTongues) {
            const std::string_view words = row.in[static_cast<std::size_t>(tongue)];
            EXPECT_FALSE(left_english(row.in[0], words, tongue)) << words;
            EXPECT_TRUE(told[static_cast<std::size_t>(tongue)].insert(words).second) << words << ": stands twice";
            EXPECT_EQ(os_error(row.number, tongue), words);
        }
    }
    EXPECT_EQ(os_error(EILSEQ, Tongue::Russian), std::strerror(EILSEQ));   // no row
}

TEST(OsErrors, AreReadInsideOtherTexts) {
    struct Row { std::string_view english, russian; };
    constexpr Row kRows[] = {
        {"No such file or directory", "такого файла или папки нет"},
        {"a.nc: Permission denied", "a.nc: нет прав доступа"},
        {"/x/y.nc (No space left on device)", "/x/y.nc (на диске нет места)"},
        {"/x (exec: No such file or directory)", "/x (exec: такого файла или папки нет)"},
        {"SCHED_FIFO: Operation not permitted; mlockall: Cannot allocate memory", "SCHED_FIFO: это не разрешено; mlockall: не хватает памяти"},
        {"Is a directory of mine.nc", "Is a directory of mine.nc"},   // a name that reads so
        {"No such device or address", "такого устройства или адреса нет"},   // not: No such device
    };
    for (const Row& row : kRows) {
        EXPECT_EQ(os_errors_in(row.english, Tongue::Russian), row.russian);
        EXPECT_EQ(os_errors_in(row.russian, Tongue::English), row.english);
        EXPECT_EQ(detail_in(row.english, Tongue::Russian), row.russian);
    }
}

TEST(OsErrors, StandInWhatADiagnosisSays) {
    const auto text = [](Tongue tongue) { return text_in(Diagnosis{Alarm::OutputFile, {}, {}, "/media/stick/a.pt (Read-only file system)"}, tongue); };
    EXPECT_NE(text(Tongue::Russian).find("(диск только для чтения)"), std::string::npos) << text(Tongue::Russian);
    EXPECT_NE(text(Tongue::Czech).find("(disk je jen pro čtení)"), std::string::npos) << text(Tongue::Czech);
    EXPECT_NE(text(Tongue::Hungarian).find("(a lemez csak olvasható)"), std::string::npos) << text(Tongue::Hungarian);
    EXPECT_EQ(detail_in("its socket (Address already in use)", Tongue::Hungarian), "a foglalata (a cím már foglalt)");   // inside another detail
    EXPECT_EQ(detail_in("Failed to set time: Access denied", Tongue::Czech), "čas se nenastavil: přístup odepřen");
}

}  // namespace
}  // namespace polyturn
