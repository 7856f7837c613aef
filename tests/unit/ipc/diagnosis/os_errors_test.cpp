// What the operating system says is read in the language of the reader, wherever it stands in a
// text.
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
        // tests run without a locale: as processes do
        EXPECT_EQ(row.in[0], std::strerror(row.number));
        EXPECT_EQ(row.in[0], std::error_code(row.number, std::system_category()).message());
        for (const DisplayLanguage display_language : kDisplayLanguages) {
            const std::string_view words = row.in[static_cast<std::size_t>(display_language)];
            EXPECT_FALSE(left_english(row.in[0], words, display_language)) << words;
            EXPECT_TRUE(told[static_cast<std::size_t>(display_language)].insert(words).second)
                << words << ": stands twice";
            EXPECT_EQ(os_error(row.number, display_language), words);
        }
    }
    EXPECT_EQ(os_error(EILSEQ, DisplayLanguage::Russian), std::strerror(EILSEQ));  // no row
}

TEST(OsErrors, AreReadInsideOtherTexts) {
    struct Row {
        std::string_view english, russian;
    };
    constexpr Row kRows[] = {
        {"No such file or directory", "такого файла или папки нет"},
        {"a.nc: Permission denied", "a.nc: нет прав доступа"},
        {"/x/y.nc (No space left on device)", "/x/y.nc (на диске нет места)"},
        {"/x (exec: No such file or directory)", "/x (exec: такого файла или папки нет)"},
        {"SCHED_FIFO: Operation not permitted; mlockall: Cannot allocate memory",
         "SCHED_FIFO: это не разрешено; mlockall: не хватает памяти"},
        {"Is a directory of mine.nc", "Is a directory of mine.nc"},         // a name that reads so
        {"No such device or address", "такого устройства или адреса нет"},  // not: No such device
    };
    for (const Row& row : kRows) {
        EXPECT_EQ(os_errors_in(row.english, DisplayLanguage::Russian), row.russian);
        EXPECT_EQ(os_errors_in(row.russian, DisplayLanguage::English), row.english);
        EXPECT_EQ(detail_in(row.english, DisplayLanguage::Russian), row.russian);
    }
}

TEST(OsErrors, StandInWhatADiagnosisSays) {
    const auto text = [](DisplayLanguage display_language) {
        return text_in(
            Diagnosis{Alarm::OutputFile, {}, {}, "/media/stick/a.pt (Read-only file system)"},
            display_language);
    };
    EXPECT_NE(text(DisplayLanguage::Russian).find("(диск только для чтения)"), std::string::npos)
        << text(DisplayLanguage::Russian);
    EXPECT_NE(text(DisplayLanguage::Czech).find("(disk je jen pro čtení)"), std::string::npos)
        << text(DisplayLanguage::Czech);
    EXPECT_NE(text(DisplayLanguage::Hungarian).find("(a lemez csak olvasható)"), std::string::npos)
        << text(DisplayLanguage::Hungarian);
    // inside another detail
    EXPECT_EQ(detail_in("its socket (Address already in use)", DisplayLanguage::Hungarian),
              "a foglalata (a cím már foglalt)");
    EXPECT_EQ(detail_in("Failed to set time: Access denied", DisplayLanguage::Czech),
              "čas se nenastavil: přístup odepřen");
}

}  // namespace
}  // namespace polyturn
