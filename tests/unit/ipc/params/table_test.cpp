// Values and typed handles.
#include "ipc/params/table.hpp"

#include <gtest/gtest.h>

#include <memory>

#include "ipc/params/registry.hpp"

namespace polyturn::params {
namespace {

std::unique_ptr<Table> fresh() {
    auto table = std::make_unique<Table>();
    set_defaults(*table);
    return table;
}

TEST(ParameterTable, BeginsWithTheDefaults) {
    const auto table = fresh();
    EXPECT_EQ(get(*table, pt_horizon), 1024);
    EXPECT_DOUBLE_EQ(get(*table, n0304_rapid, 1), 10000.0);
    EXPECT_DOUBLE_EQ(get(*table, n0304_rapid, kMaxAxes), 10000.0);
    EXPECT_DOUBLE_EQ(get(*table, pt_path_tol, 16), 0.005);
    EXPECT_EQ(get_text(*table, pt_language, 2), "fanuc");
    EXPECT_EQ(get_text(*table, n0003_channel_name, 1), "");
    EXPECT_EQ(get(*table, n1301_defaultg2, 1), 65U);
    EXPECT_TRUE(same(*table, defaults()));
}

TEST(ParameterTable, KeepsInstancesApart) {
    const auto table = fresh();
    put(*table, n0304_rapid, 24000.0, 3);
    EXPECT_DOUBLE_EQ(get(*table, n0304_rapid, 2), 10000.0);
    EXPECT_DOUBLE_EQ(get(*table, n0304_rapid, 3), 24000.0);
    EXPECT_DOUBLE_EQ(get(*table, n0304_rapid, 4), 10000.0);
    EXPECT_FALSE(same(*table, defaults()));
}

TEST(ParameterTable, ReadsSingleBits) {
    const auto table = fresh();
    put(*table, n0106_axis_properties, 0b0000'0101, 7);
    EXPECT_TRUE(bit(*table, n0106_axis_properties, 7, 0));
    EXPECT_FALSE(bit(*table, n0106_axis_properties, 7, 1));
    EXPECT_TRUE(bit(*table, n0106_axis_properties, 7, 2));
    EXPECT_FALSE(bit(*table, n0106_axis_properties, 8, 0));
}

TEST(ParameterTable, CutsATextThatIsTooLong) {
    const auto table = fresh();
    put_text(*table, n0003_channel_name, std::string(200, 'x'), 1);
    EXPECT_EQ(get_text(*table, n0003_channel_name, 1), std::string(kTextCapacity, 'x'));
    EXPECT_EQ(get_text(*table, n0003_channel_name, 2), "");
}

TEST(ParameterSeries, LeadsToTheRowOfEachGearRange) {
    static_assert(n0650_r1_s_max.series == 8);
    EXPECT_EQ(nth(n0650_r1_s_max, 1).first_slot, n0650_r1_s_max.first_slot);
    EXPECT_EQ(nth(n0650_r1_s_max, 3).first_slot, n0652_r3_s_max.first_slot);
    EXPECT_EQ(nth(n0650_r1_s_max, 8).row, n0657_r8_s_max.row);
    static_assert(n1101_sw1_axis_number.series == 32 && n1133_sw1_min_pos.series == 32);
    static_assert(n1317_m_gr_low_suppr_b1.series == 8 && n1307_m_suppr_b1.series == 10);
    EXPECT_EQ(rows()[nth(n1317_m_gr_low_suppr_b1, 8).row].number, "N1324");
}

TEST(ParameterHandles, AgreeWithTheirRows) {
    EXPECT_EQ(rows()[n0304_rapid.row].number, "N0304");
    EXPECT_EQ(rows()[n0304_rapid.row].first_slot, n0304_rapid.first_slot);
    EXPECT_EQ(rows()[f5002.row].number, "F5002");
    EXPECT_EQ(rows()[mefi_80.row].number, "MEFI.80");
    EXPECT_EQ(rows()[pt_language.row].number, "PT_LANGUAGE");
    EXPECT_EQ(rows().size(), kRowCount);
}

// A wrong index would read another axis: the process stops instead, and the drives' watchdog with
// it.
TEST(ParameterTableDeathTest, TrapsOnAnIndexOutsideTheCapacity) {
    const auto table = fresh();
    EXPECT_DEATH((void)get(*table, n0304_rapid, 0), "");
    EXPECT_DEATH((void)get(*table, n0304_rapid, kMaxAxes + 1), "");
    EXPECT_DEATH((void)nth(n0650_r1_s_max, 9), "");
}

}  // namespace
}  // namespace polyturn::params
