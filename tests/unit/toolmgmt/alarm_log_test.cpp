// The alarms of all days: kept in the store's file, read newest first and in pages.
#include <gtest/gtest.h>
#include <unistd.h>

#include <filesystem>

#include "toolmgmt/database.hpp"

namespace polyturn::toolmgmt {
namespace {

TEST(AlarmLog, IsReadInPagesAndOutlivesTheProcess) {
    const std::string folder =
        (std::filesystem::temp_directory_path() / ("alarm-log-" + std::to_string(getpid())))
            .string();
    {
        auto disk = Database::open(folder);
        ASSERT_TRUE(disk) << disk.diagnosis().text();
        for (int day = 1; day <= 5; ++day) {
            const std::string utc = "2026-01-0" + std::to_string(day) + "T12:00:00Z";
            ASSERT_TRUE(disk->note_alarms({{0, utc, "{\"day\":" + std::to_string(day) + "}"}}));
        }
    }
    {
        auto disk = Database::open(folder);
        ASSERT_TRUE(disk) << disk.diagnosis().text();
        // before the fifth: the controller itself still knows that one
        const auto first = disk->alarms("2026-01-05T12:00:00Z", 0, 2);
        ASSERT_TRUE(first);
        ASSERT_EQ(first->size(), 2u);
        EXPECT_EQ((*first)[0].event, "{\"day\":4}");
        EXPECT_EQ((*first)[1].event, "{\"day\":3}");
        const auto rest = disk->alarms("2026-01-05T12:00:00Z", first->back().id, 10);
        ASSERT_TRUE(rest);
        ASSERT_EQ(rest->size(), 2u);
        EXPECT_EQ(rest->back().event, "{\"day\":1}");
        EXPECT_EQ(disk->alarms("", 0, 10)->size(), 5u);
    }
    std::filesystem::remove_all(folder);
}

}  // namespace
}  // namespace polyturn::toolmgmt
