// Cells that a program enters: the file keeps everything else.
#include "ipc/model/compensation/compensation_cells.hpp"

#include <gtest/gtest.h>

#include <memory>
#include <vector>

#include "ipc/model/compensation/compensation_tables.hpp"

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
    for (const char* bad :
         {"", "10500", "9999=1", "30000=1", "10500=", "10500=1 2", "N10500=1", "10500=nan", "=1"})
        EXPECT_FALSE(cell_entry(bad).has_value()) << bad;
}

TEST(CompensationCells, ReplaceTheirLinesAndNothingElse) {
    const auto table = machine();
    const std::vector<CellEntry> entries = {
        {10001, 0.5F}, {10002, 0.25F}, {10001, 0.125F}, {10009, 1.0F}};
    EXPECT_EQ(with_cells("; measured in May\n10000=0.001\n 10001 = 7 ; old\n3D L1 0=0 0 0\n10002=3",
                         *table, entries),
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

// A grid of L1 over A1 and A2, 3 by 2 points.
std::unique_ptr<params::Table> with_grid() {
    auto table = machine();
    params::put(*table, params::n2700_1st_axis_of_3d_compensation, 1, 1);
    params::put(*table, params::n2702_3rd_axis_of_3d_compensation, 2, 1);
    params::put(*table, params::n2703_no_of_points_on_1st_axis, 3, 1);
    params::put(*table, params::n2704_no_of_points_on_2nd_axis, 7, 1);  // of no axis: counts one
    params::put(*table, params::n2705_no_of_points_on_3rd_axis, 2, 1);
    return table;
}

TEST(CompensationCells, APointOfAGridKeepsItsOtherTwoCorrections) {
    const auto table = with_grid();
    const std::vector<PointEntry> points = {{1, 4, 2, 0.25F}, {2, 0, 0, 1.0F}, {1, 4, 0, 0.5F}};
    EXPECT_EQ(
        with_cells("; gauge 7\n10000=0\n3D L1 3=0 0 0\n 3D L1 4 = 9, -0.5 8 ; old\n3D L2 4=1 1 1\n",
                   *table, {}, points),
        "; gauge 7\n10000=0\n3D L1 3=0 0 0\n3D L1 4=0.5 -0.5 0.25\n3D L2 4=1 1 1\n3D L2 0=1 0 0\n");
}

TEST(CompensationCells, LeaveNoGapsWhereTheyAreFilled) {
    const auto table = with_grid();
    EXPECT_EQ(compensation_grid(*table, 1).points(), 6);
    const std::vector<PointEntry> points = {{1, 5, 0, 0.001F}};
    const std::string text =
        with_cells("10001=0.5\n3D L1 0=0 0 0\n", *table, {}, points, Gaps::Filled);
    EXPECT_EQ(text,
              "10001=0.5\n3D L1 0=0 0 0\n10000=0\n10002=0\n"
              "10003=0\n3D L1 1=0 0 0\n3D L1 2=0 0 0\n3D L1 3=0 0 0\n"
              "3D L1 4=0 0 0\n3D L1 5=0.001 0 0\n");
    std::vector<Diagnosis> faults;
    check_compensation_tables(*table, parse_compensation(text, "x", faults), "x", faults);
    EXPECT_TRUE(faults.empty());
    // A grid without its first axis is a grid, too.
    params::put(*table, params::n2700_1st_axis_of_3d_compensation, 0, 1);
    params::put(*table, params::n2701_2nd_axis_of_3d_compensation, 1, 1);
    check_compensation_tables(*table, parse_compensation(text, "x", faults), "x", faults);
    ASSERT_EQ(faults.size(), 1u);
    EXPECT_EQ(faults[0].detail, "L1: point 6 of the grid has no value");
}

// However the file writes a line, what replaces it is the same line: a second one of its cell or
// point would make the file wrong.
TEST(CompensationCells, ALineIsKnownHoweverItIsWritten) {
    const auto table = machine();
    const std::string file = "+10500 = 1 ; a cell\n,10501=2\n\t3D L 1, +2 = 1 2 3\n10502=3\r\n";
    const CellEntry cells[] = {{10500, 5}, {10501, 6}, {10502, 7}};
    const PointEntry points[] = {{1, 2, 1, 9}};
    std::vector<Diagnosis> faults;
    const CompensationTables now =
        parse_compensation(with_cells(file, *table, cells, points), "file", faults);
    EXPECT_TRUE(faults.empty()) << (faults.empty() ? "" : faults[0].text());
    EXPECT_EQ(now.cell(10500), 5);
    EXPECT_EQ(now.cell(10501), 6);
    EXPECT_EQ(now.cell(10502), 7);
    ASSERT_EQ(now.points[0].size(), 3u);
    EXPECT_EQ(now.points[0][2], (std::array<float, 3>{1, 9, 3}));
}

}  // namespace
}  // namespace polyturn
