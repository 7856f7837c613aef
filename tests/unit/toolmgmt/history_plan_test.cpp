// A million rows of history: what screens ask for is found by an index, in its order, without a
// look at the other rows.
#include <gtest/gtest.h>
#include <sqlite3.h>
#include <unistd.h>

#include <filesystem>

#include "ipc/params/registry.hpp"
#include "toolmgmt/database.hpp"
#include "toolmgmt/schema.hpp"
#include "toolmgmt/statement.hpp"

namespace polyturn::toolmgmt {
namespace {

using Of = Database::HistoryOf;

class HistoryPlan : public ::testing::Test {
protected:
    void SetUp() override {
        ASSERT_EQ(sqlite3_open(":memory:", &db), SQLITE_OK);
        ASSERT_TRUE(migrate(db)) << sqlite3_errmsg(db);
    }
    void TearDown() override { sqlite3_close_v2(db); }
    std::string plan(const Of& of) const {
        Statement steps(db, ("EXPLAIN QUERY PLAN " + Database::history_query(of)).c_str());
        std::string out;
        while (steps.row()) out += steps.text(3) + "\n";
        EXPECT_TRUE(steps.done()) << sqlite3_errmsg(db);
        return out;
    }
    sqlite3* db = nullptr;
};

TEST_F(HistoryPlan, EachQuestionHasItsIndexAndNothingIsSorted) {
    const std::pair<Of, const char*> kQuestions[] = {
        {{Of::Kind::Value, "L1 offset 3 wear X"}, "INDEX history_what (what=?)"},
        {{Of::Kind::Value, "N1600 L1", "", "2026-01-31T12:00:00.000Z", 7},
         "INDEX history_what (what=? AND utc<?)"},
        {{Of::Kind::Parameters}, "INDEX history_parameters"},
        {{Of::Kind::Parameters, "", "", "2026-01-31T12:00:00.000Z", 7},
         "INDEX history_parameters (utc<?)"},
        {{Of::Kind::EnteredOffsets, "L2 offset"}, "INDEX history_entered"},
        {{Of::Kind::EnteredEdges, "tool 3 D1 "}, "INDEX history_edges"},
        {{Of::Kind::All}, "INDEX history_utc"},
    };
    for (const auto& [of, index] : kQuestions) {
        const std::string steps = plan(of);
        EXPECT_NE(steps.find(index), std::string::npos) << Database::history_query(of) << "\n"
                                                        << steps;
        EXPECT_EQ(steps.find("TEMP B-TREE"), std::string::npos) << steps;
    }
}

// A text that stands in the oldest row only: it is found, and no answer has looked at more rows
// than the others may wait for.
TEST(HistoryByText, IsLookedForSomeRowsAtATime) {
    const std::string folder =
        (std::filesystem::temp_directory_path() / ("history-text-" + std::to_string(getpid())))
            .string();
    constexpr std::int64_t kRows = 2 * Database::kHistoryLook + 500;
    {
        auto disk = Database::open(folder);
        ASSERT_TRUE(disk) << disk.diagnosis().text();
        sqlite3* db = nullptr;
        {
            const std::string file = disk->path();
            disk = Database::open(folder + "-other");  // lets go of the file
            ASSERT_EQ(sqlite3_open(file.c_str(), &db), SQLITE_OK);
        }
        ASSERT_TRUE(run(
            db,
            ("WITH RECURSIVE n(i) AS (SELECT 1 UNION ALL SELECT i + 1 FROM n WHERE i < " +
             std::to_string(kRows) +
             ") INSERT INTO history(utc, who, what, old, new) "
             "SELECT printf('2026-01-01T%02d:%02d:%02d.000Z', i / 3600, i / 60 % 60, i % 60), CASE "
             "i % 2 WHEN 0 THEN 'anna' ELSE 'program' END, CASE i WHEN 1 THEN 'L7 offset 9 wear Z' "
             "ELSE 'L1 offset 3 wear X' END, '0', '1' FROM n")
                .c_str()))
            << sqlite3_errmsg(db);
        sqlite3_close_v2(db);
    }
    auto disk = Database::open(folder);
    ASSERT_TRUE(disk) << disk.diagnosis().text();
    Of of{Of::Kind::All, "L7 offset 9"};
    int answers = 1;
    for (;; ++answers) {
        const auto found = disk->history(of);
        ASSERT_TRUE(found);
        if (!found->more) {
            ASSERT_EQ(found->entries.size(), 1u);
            EXPECT_EQ(found->entries[0].id, 1);
            break;
        }
        EXPECT_TRUE(found->entries.empty());
        of.before_utc = found->more->first;
        of.before_id = found->more->second;
    }
    EXPECT_EQ(answers, 3);
    // What is found at once is answered at once; who entered it is a text too.
    const auto newest = disk->history({Of::Kind::All, "wear X", "anna", {}, 0, 4});
    ASSERT_TRUE(newest);
    EXPECT_FALSE(newest->more);
    ASSERT_EQ(newest->entries.size(), 4u);
    EXPECT_EQ(newest->entries[0].id, kRows);
    EXPECT_EQ(newest->entries[3].id, kRows - 6);
    EXPECT_EQ(disk->history({Of::Kind::Value, "L1 offset 3 wear X", "", {}, 0, 7})->entries.size(),
              7u);
    EXPECT_FALSE(disk->history({Of::Kind::All, "", "", {}, 0, 7})->more);
    std::filesystem::remove_all(folder);
    std::filesystem::remove_all(folder + "-other");
}

// The index of parameters knows them by their first letter.
TEST_F(HistoryPlan, EveryParameterIsAmongTheParameters) {
    for (const params::Row& row : params::rows()) {
        Statement found(db, "SELECT ? GLOB '[NFMPS]*'");
        ASSERT_TRUE(found.bind(1, row.number).row());
        EXPECT_EQ(found.whole(0), 1) << row.number;
    }
}

}  // namespace
}  // namespace polyturn::toolmgmt
