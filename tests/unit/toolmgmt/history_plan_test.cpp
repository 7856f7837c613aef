// A million rows of history: what screens ask for is found by an index, in its order, without a look at the other rows.
#include <gtest/gtest.h>
#include <sqlite3.h>

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
        {{Of::Kind::Value, "N1600 L1", "", "2026-01-31T12:00:00.000Z", 7}, "INDEX history_what (what=? AND utc<?)"},
        {{Of::Kind::Parameters}, "INDEX history_parameters"},
        {{Of::Kind::Parameters, "", "", "2026-01-31T12:00:00.000Z", 7}, "INDEX history_parameters (utc<?)"},
        {{Of::Kind::EnteredOffsets, "L2 offset"}, "INDEX history_entered"},
        {{Of::Kind::All}, "INDEX history_utc"},
    };
    for (const auto& [of, index] : kQuestions) {
        const std::string steps = plan(of);
        EXPECT_NE(steps.find(index), std::string::npos) << Database::history_query(of) << "\n" << steps;
        EXPECT_EQ(steps.find("TEMP B-TREE"), std::string::npos) << steps;
    }
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
