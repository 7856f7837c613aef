#include <algorithm>

#include "kernel/drives/simulated_drive.hpp"
#include "tests/unit/kernel/rig.hpp"

namespace polyturn::kernel {
namespace {

double slide(TickRig& rig, unsigned axis) {
    return static_cast<SimulatedDrive*>(rig.machine->core().axes[axis - 1].drive())
        ->true_position();
}
// What stands between the position that everybody sees and the drive.
double added(TickRig& rig, unsigned axis) { return slide(rig, axis) - rig.position(axis); }

CompensationTables table(std::initializer_list<std::pair<int, double>> cells) {
    CompensationTables t;
    t.measured = true;
    t.cells.assign(static_cast<std::size_t>(kLastCell - kFirstCell + 1),
                   std::numeric_limits<float>::quiet_NaN());
    for (const auto& [number, value] : cells)
        t.cells[static_cast<std::size_t>(number - kFirstCell)] = static_cast<float>(value);
    return t;
}

// The tables belong to the machine before it starts: a rig whose parameters switch compensation on
// at a later tick start.
void set_now(TickRig& rig, const std::function<void(params::Table&)>& change) {
    change(rig.machine->core().table);
    rig.machine->adopt_parameters();
}

TEST(Compensation, PitchIsLinearBetweenCellsAndHoldsAtTheEnds) {
    TickRig rig;
    rig.machine->take_tables(table({{10000, 0.0}, {10001, 0.010}, {10002, -0.010}}));
    set_now(rig, [](params::Table& t) {
        params::put(t, params::n2500_pitch_comp_contr, 1, 2);
        params::put(t, params::n2501_primary_interval, 10, 2);
        params::put(t, params::n2502_cell_no_of_mach_zero, 10000, 2);
        params::put(t, params::n2503_primary_smallest_cell_no, 10000, 2);
        params::put(t, params::n2504_primary_largest_cell_no, 10002, 2);
    });
    rig.start(1);
    const auto at = [&](double by) {
        rig.push(1, rig.line(1, {0, by}, 50));
        rig.run(1500);
        return added(rig, 2);
    };
    EXPECT_NEAR(at(5), 0.005, 1e-5);
    EXPECT_NEAR(at(5), 0.010, 1e-5);
    EXPECT_NEAR(at(5), 0.0, 1e-5);
    EXPECT_NEAR(at(15), -0.010, 1e-5);
    EXPECT_NEAR(rig.position(2), 30, 1e-9);  // nobody sees it
    EXPECT_NEAR(rig.machine->core().axes[1].measured(), 30, 1e-4);
}

TEST(Compensation, HasATableForEachDirection) {
    TickRig rig;
    rig.machine->take_tables(table({{10000, 0.0}, {10001, 0.0}, {10100, 0.004}, {10101, 0.004}}));
    set_now(rig, [](params::Table& t) {
        params::put(t, params::n2500_pitch_comp_contr, 3, 2);
        params::put(t, params::n2501_primary_interval, 100, 2);
        params::put(t, params::n2502_cell_no_of_mach_zero, 10000, 2);
        params::put(t, params::n2503_primary_smallest_cell_no, 10000, 2);
        params::put(t, params::n2504_primary_largest_cell_no, 10001, 2);
        params::put(t, params::n2505_primary_smallest_cell_no_both_dir, 10100, 2);
    });
    rig.start(1);
    rig.push(1, rig.line(1, {0, 20}, 50));
    rig.run(1500);
    EXPECT_NEAR(added(rig, 2), 0.0, 1e-5);
    rig.push(1, rig.line(1, {0, -10}, 50));
    rig.run(1500);
    EXPECT_NEAR(added(rig, 2), 0.004, 1e-5);
}

TEST(Compensation, IsFadedInWithoutAStep) {
    TickRig rig;
    set_now(rig, [](params::Table& t) {
        params::put(t, params::n2800_gradient_comp_contr, 1, 2);
        const double at[] = {-10, 0, 10, 20}, value[] = {0.1, 0.1, 0.2, 0.2};
        params::put(t, params::n2801_position_a, at[0], 2);
        params::put(t, params::n2802_position_b, at[1], 2);
        params::put(t, params::n2803_position_c, at[2], 2);
        params::put(t, params::n2804_position_d, at[3], 2);
        params::put(t, params::n2805_gradient_value_a, value[0], 2);
        params::put(t, params::n2806_gradient_value_b, value[1], 2);
        params::put(t, params::n2807_gradient_value_c, value[2], 2);
        params::put(t, params::n2808_gradient_value_d, value[3], 2);
    });
    double before = 0, v_before = 0;
    for (int i = 0; i < 1000; ++i) {
        rig.tick();
        const double now = rig.machine->core().axes[1].compensation(), v = (now - before) / 0.001;
        ASSERT_LE(std::fabs(v), 0.021 * TickRig::kVelocity);
        ASSERT_LE(std::fabs(v - v_before) / 0.001, 0.05 * TickRig::kAcceleration);
        before = now;
        v_before = v;
    }
    EXPECT_NEAR(before, 0.1, 1e-6);
    EXPECT_NEAR(added(rig, 2), 0.1, 1e-4);
    rig.start(1);
    rig.push(1, rig.line(1, {0, 5}, 50));
    rig.run(1500);
    EXPECT_NEAR(added(rig, 2), 0.15, 1e-4);
}

TEST(Compensation, StraightnessMovesTheOtherAxis) {
    TickRig rig;
    set_now(rig, [](params::Table& t) {
        params::put(t, params::n2600_straightness_comp_contr, 1, 1);
        params::put(t, params::n2601_no_of_moving_axis_1, 2, 1);
        params::put(t, params::n2607_no_of_compensation_axis_1, 1, 1);
        params::put(t, params::n2619_position_a_of_moving_axis_1, 0, 1);
        params::put(t, params::n2620_position_b_of_moving_axis_1, 10, 1);
        params::put(t, params::n2621_position_c_of_moving_axis_1, 20, 1);
        params::put(t, params::n2622_position_d_of_moving_axis_1, 30, 1);
        params::put(t, params::n2632_value_b_of_comp_axis_1, 0.02, 1);
        params::put(t, params::n2633_value_c_of_comp_axis_1, 0.02, 1);
    });
    rig.start(1);
    rig.push(1, rig.line(1, {0, 5}, 50));
    rig.run(1500);
    EXPECT_NEAR(added(rig, 1), 0.01, 1e-5);
    EXPECT_NEAR(added(rig, 2), 0.0, 1e-5);
}

TEST(Compensation, OfTheGridIsTrilinear) {
    TickRig rig;
    CompensationTables t3 = table({});
    for (int k = 0; k < 2; ++k)  // second axis
        for (int i = 0; i < 2; ++i)
            t3.points[0].push_back(
                {static_cast<float>(0.01 * i), static_cast<float>(0.02 * i * k), 0.0f});
    rig.machine->take_tables(std::move(t3));
    set_now(rig, [](params::Table& t) {
        params::put(t, params::n2700_1st_axis_of_3d_compensation, 1, 1);
        params::put(t, params::n2701_2nd_axis_of_3d_compensation, 2, 1);
        params::put(t, params::n2703_no_of_points_on_1st_axis, 2, 1);
        params::put(t, params::n2704_no_of_points_on_2nd_axis, 2, 1);
        params::put(t, params::n2709_comp_interval_on_1st_axis, 20, 1);
        params::put(t, params::n2710_comp_interval_on_2nd_axis, 20, 1);
    });
    rig.start(1);
    rig.push(1, rig.line(1, {10, 5}, 50));
    rig.run(1500);
    EXPECT_NEAR(added(rig, 1), 0.005, 1e-5);
    EXPECT_NEAR(added(rig, 2), 0.02 * 0.5 * 0.25, 1e-5);
}

// Cells and points of the file are in the unit of the axis, as the parameters beside them are.
TEST(Compensation, OfAnInchMachineCountsInches) {
    TickRig rig([](params::Table& t, RunOptions&) {
        params::put(t, params::n0104_unit_of_measure, 1, 1);
        params::put(t, params::n2500_pitch_comp_contr, 1, 2);
        params::put(t, params::n2501_primary_interval, 1, 2);
        params::put(t, params::n2502_cell_no_of_mach_zero, 10000, 2);
        params::put(t, params::n2503_primary_smallest_cell_no, 10000, 2);
        params::put(t, params::n2504_primary_largest_cell_no, 10002, 2);
        params::put(t, params::n2601_no_of_moving_axis_1, 2, 1);
        params::put(t, params::n2607_no_of_compensation_axis_1, 1, 1);
        params::put(t, params::n2613_smallest_cell_no_of_moving_axis_1, 10100, 1);
        params::put(t, params::n2700_1st_axis_of_3d_compensation, 2, 1);
        params::put(t, params::n2703_no_of_points_on_1st_axis, 2, 1);
        params::put(t, params::n2709_comp_interval_on_1st_axis, 20, 1);
    });
    CompensationTables cells = table({{10000, 0.001},
                                      {10001, 0.001},
                                      {10002, 0.001},
                                      {10100, 0.002},
                                      {10101, 0.002},
                                      {10102, 0.002}});
    cells.points[0] = {{0.0005F, 0, 0}, {0.0005F, 0, 0}};
    rig.machine->take_tables(std::move(cells));
    rig.machine->adopt_parameters();
    rig.start(1);
    rig.run(3000);
    EXPECT_NEAR(added(rig, 2), 0.0015 * 25.4, 1e-5);
    EXPECT_NEAR(added(rig, 1), 0.002 * 25.4, 1e-5);
}

TEST(Compensation, FollowsTheTemperature) {
    TickRig rig([](params::Table& t, RunOptions&) {
        params::put(t, params::pt_temp_shift, 0.001, 2);
        params::put(t, params::pt_temp_slope, -1e-5, 2);
    });
    rig.start(1);
    rig.push(1, rig.line(1, {0, 100}, 100));
    rig.run(2000);
    rig.command(CommandKind::SetSignal, 0, 800, 0, signals::ap_temp(2), 1);  // 8 degrees
    rig.run(2000);
    EXPECT_NEAR(added(rig, 2), 8 * (0.001 - 1e-5 * 100), 1e-5);
}

}  // namespace
}  // namespace polyturn::kernel
