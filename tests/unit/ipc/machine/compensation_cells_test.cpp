// Cells that a program enters: the file keeps everything else.
#include "ipc/machine/compensation_cells.hpp"

#include <gtest/gtest.h>

#include <memory>
#include <vector>

#include "ipc/machine/compensation_tables.hpp"

namespace polyturn {
namespace {

std::unique_ptr<params::Table> machine() {
    auto table = std::make_unique<params::Table>();
    params::set_defaults(*table);
    params::put(*table, params::n2500_pitch_comp_contr, 1, 2);
    params::put(*table, params::n2501_primary_interval, 10, 2);
    params::put(*table, params::n2502_cell_no_of_mach_zero, 10001, 2);
    params::put(*table, params::n2503_primary_smallest_cell_no, 10000, 2);
    params::put(*table, params::n2504_primary_largest_cell_no, 10003, 2);
    return table;
}

TEST(CompensationCells, AreReadFromALine) {
    ASSERT_TRUE(cell_entry("10500=-0.012").has_value());
    EXPECT_EQ(cell_entry("10500=-0.012")->cell, 10500);
    EXPECT_FLOAT_EQ(cell_entry("10500=-0.012")->value, -0.012F);
    for (const char* bad : {"", "10500", "9999=1", "30000=1", "10500=", "10500=1 2", "N10500=1", "10500=nan", "=1"}) EXPECT_FALSE(cell_entry(bad).has_value()) << bad;
}

TEST(CompensationCells, ReplaceTheirLinesAndNothingElse) {
    const auto table = machine();
    const std::vector<CellEntry> entries = {{10001, 0.5F}, {10002, 0.25F}, {10001, 0.125F}, {10009, 1.0F}};
    EXPECT_EQ(with_cells("; measured in May\n10000=0.001\n 10001 = 7 ; old\n3D L1 0=0 0 0\n10002=3", *table, entries),
              "; measured in May\n10000=0.001\n10001=0.125\n3D L1 0=0 0 0\n10002=0.25\n10009=1\n");
}

TEST(CompensationCells, BeginATableWithoutGaps) {
    const auto table = machine();
    const std::vector<CellEntry> entries = {{10002, 0.004F}};
    const std::string text = with_cells("", *table, entries);
    EXPECT_EQ(text, "10000=0\n10001=0\n10002=0.004\n10003=0\n");
    std::vector<Diagnosis> faults;
    check_compensation_tables(*table, parse_compensation(text, "x", faults), "x", faults);
    EXPECT_TRUE(faults.empty());
}

}  // namespace
}  // namespace polyturn
