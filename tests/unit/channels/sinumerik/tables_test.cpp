// Every word of the specification is known: it acts, or it is refused by its name; and the tables
// contradict nothing.
#include <gtest/gtest.h>

#include <set>

#include "channels/sinumerik/interpreter.hpp"

namespace polyturn::channels::sinumerik {
namespace {

TEST(SinumerikTables, HaveOneRowForAGroupAndNumber) {
    std::set<std::pair<int, int>> seen;
    std::set<int> preset;
    for (const GCode& row : g_codes()) {
        EXPECT_TRUE(seen.insert({row.group, row.number}).second) << row.name;
        if (row.preset && row.modal) { EXPECT_TRUE(preset.insert(row.group).second) << row.name; }
        EXPECT_EQ(find_symbol(row.name).kind, Symbol::Kind::G) << row.name;
    }
    EXPECT_EQ(find_g(8, 100)->name, "G599");
    EXPECT_EQ(find_g(64, 101)->name, "GFRAME100");
    for (const GCode& row : g_codes())
        if (row.preset && row.modal) {
            EXPECT_TRUE(row.act) << row.name << " is active at the start and must act";
        }
}

TEST(SinumerikTables, KnowEveryReservedWord) {
    for (const std::string_view name : reserved_words())
        EXPECT_NE(find_symbol(name).kind, Symbol::Kind::None) << name;
    EXPECT_GT(reserved_words().size(), 600u);
}

}  // namespace
}  // namespace polyturn::channels::sinumerik
