// Contradictions of straightness, volumetric and gradient compensation (nct_parameters_part2 27 to
// 29) and of what follows a spindle (19, PT_SPINDLE_MASTER).
#include <array>
#include <string>

#include "ipc/model/machine/check/config_report.hpp"
#include "ipc/model/compensation/compensation_tables.hpp"

namespace polyturn::config {
namespace {

using namespace params;

constexpr std::array kStraightAt{
    n2619_position_a_of_moving_axis_1, n2620_position_b_of_moving_axis_1,
    n2621_position_c_of_moving_axis_1, n2622_position_d_of_moving_axis_1,
    n2623_position_a_of_moving_axis_2, n2624_position_b_of_moving_axis_2,
    n2625_position_c_of_moving_axis_2, n2626_position_d_of_moving_axis_2,
    n2627_position_a_of_moving_axis_3, n2628_position_b_of_moving_axis_3,
    n2629_position_c_of_moving_axis_3, n2630_position_d_of_moving_axis_3};
constexpr std::array kPosition{n2801_position_a, n2802_position_b, n2803_position_c,
                               n2804_position_d};
constexpr std::array kGridAxis{n2700_1st_axis_of_3d_compensation, n2701_2nd_axis_of_3d_compensation,
                               n2702_3rd_axis_of_3d_compensation};
constexpr std::array kGridPoints{n2703_no_of_points_on_1st_axis, n2704_no_of_points_on_2nd_axis,
                                 n2705_no_of_points_on_3rd_axis};
constexpr std::array kGridZero{n2706_point_no_of_machine_zero_on_1st_axis,
                               n2707_point_no_of_machine_zero_on_2nd_axis,
                               n2708_point_no_of_machine_zero_on_3rd_axis};
constexpr std::array kGridInterval{n2709_comp_interval_on_1st_axis, n2710_comp_interval_on_2nd_axis,
                                   n2711_comp_interval_on_3rd_axis};

const AxisConfig* axis_of(const Report& report, std::int64_t number) {
    if (number < 1 || number > static_cast<std::int64_t>(kMaxAxes)) return nullptr;
    const AxisConfig& axis = report.machine.axis(static_cast<std::size_t>(number));
    return axis.exists() ? &axis : nullptr;
}

void wrong(Report& report, std::string detail) {
    report.add(Alarm::ConfigCompensation, std::move(detail));
}

void check_straightness(Report& report, unsigned l) {
    const bool simple = bit(report.table, n2600_straightness_comp_contr, l, 0);
    for (unsigned g = 1; g <= 6; ++g) {
        const auto moving_row = nth(n2601_no_of_moving_axis_1, g),
                   other_row = nth(n2607_no_of_compensation_axis_1, g);
        const auto moving = get(report.table, moving_row, l),
                   other = get(report.table, other_row, l);
        if (moving == 0) continue;
        const AxisConfig *m = axis_of(report, moving), *c = axis_of(report, other);
        if (simple && g > 3)
            wrong(report, report.line(moving_row, l) + ": N2600 #0 has three pairs only");
        if (!m || m->channel != l)
            wrong(report, report.line(moving_row, l) + ": no axis of L" + std::to_string(l));
        if (!c || c->channel != l)
            wrong(report, report.line(other_row, l) + ": no axis of L" + std::to_string(l));
        if (m && c && m == c)
            wrong(report, report.line(other_row, l) + ": the axis would compensate itself");
        if (!m || (simple && g > 3)) continue;
        if (simple) {
            for (unsigned n = 1; n < 4; ++n) {
                const auto low = kStraightAt[(g - 1) * 4 + n - 1],
                           high = kStraightAt[(g - 1) * 4 + n];
                if (!(get(report.table, low, l) < get(report.table, high, l)))
                    wrong(report, report.line(low, l) + " not below " + report.line(high, l));
            }
            continue;
        }
        const auto a = static_cast<unsigned>(moving);
        const auto first = get(report.table, n2503_primary_smallest_cell_no, a),
                   last = get(report.table, n2504_primary_largest_cell_no, a);
        const auto begin_row = nth(n2613_smallest_cell_no_of_moving_axis_1, g);
        const auto begin = get(report.table, begin_row, l);
        if (!(first < last))
            wrong(report, report.line(moving_row, l) + ": the axis has no cells, " +
                              report.line(n2503_primary_smallest_cell_no, a) + ", " +
                              report.line(n2504_primary_largest_cell_no, a));
        else if (begin < kFirstCell || begin + last - first > kLastCell)
            wrong(report, report.line(begin_row, l) + ": the table does not fit into the cells");
        if (!(get(report.table, n2501_primary_interval, a) > 0))
            wrong(report, report.line(n2501_primary_interval, a) + ": must be above 0");
    }
}

void check_grid(Report& report, unsigned l) {
    for (unsigned n = 0; n < 3; ++n) {
        const auto number = get(report.table, kGridAxis[n], l);
        if (number == 0) continue;
        const AxisConfig* axis = axis_of(report, number);
        if (!axis || axis->channel != l)
            wrong(report, report.line(kGridAxis[n], l) + ": no axis of L" + std::to_string(l));
        else if (axis->rotary)
            wrong(report, report.line(kGridAxis[n], l) + ": the grid has linear axes only");
        for (unsigned k = 0; k < n; ++k)
            if (get(report.table, kGridAxis[k], l) == number)
                wrong(report, report.line(kGridAxis[n], l) + ": is " +
                                  report.line(kGridAxis[k], l) + " already");
        const auto points = get(report.table, kGridPoints[n], l),
                   zero = get(report.table, kGridZero[n], l);
        if (points < 2)
            wrong(report, report.line(kGridPoints[n], l) + ": two points at least");
        else if (zero < 0 || zero >= points)
            wrong(report, report.line(kGridZero[n], l) + ": machine zero lies outside the grid");
        if (!(get(report.table, kGridInterval[n], l) > 0))
            wrong(report, report.line(kGridInterval[n], l) + ": must be above 0");
    }
}

void check_gradient(Report& report, unsigned a) {
    if (!bit(report.table, n2800_gradient_comp_contr, a, 0)) return;
    for (unsigned n = 1; n < 4; ++n)
        if (!(get(report.table, kPosition[n - 1], a) < get(report.table, kPosition[n], a)))
            wrong(report,
                  report.line(kPosition[n - 1], a) + " not below " + report.line(kPosition[n], a));
    if (!bit(report.table, n2800_gradient_comp_contr, a, 1)) return;
    if (get(report.table, n2801_position_a, a) != 0)
        wrong(report, report.line(n2801_position_a, a) +
                          ": a repeating compensation begins at machine zero");
    if (get(report.table, n2805_gradient_value_a, a) != 0)
        wrong(report,
              report.line(n2805_gradient_value_a, a) + ": a repeating compensation begins with 0");
    const double cycle = get(report.table, n2506_distance_of_cycle, a);
    if (!(cycle > 0) || get(report.table, n2804_position_d, a) > cycle)
        wrong(report, report.line(n2506_distance_of_cycle, a) + ": ends before " +
                          report.line(n2804_position_d, a));
}

void check_gear(Report& report, unsigned l) {
    const auto master = get(report.table, n1801_egb_master, l),
               slave = get(report.table, n1802_egb_slave, l),
               helix = get(report.table, n1803_helical_comp_axis, l);
    if (master != 0 && (master > static_cast<std::int64_t>(kMaxSpindles) ||
                        !report.machine.spindle(static_cast<std::size_t>(master)).exists()))
        report.add(Alarm::ConfigSpindleMissing,
                   report.line(n1801_egb_master, l) + ": that spindle does not exist");
    const AxisConfig* follower = axis_of(report, slave);
    if (slave != 0 && !follower)
        report.add(Alarm::ConfigAxisReference,
                   report.line(n1802_egb_slave, l) + ": that axis does not exist");
    else if (follower && !follower->rotary)
        report.add(Alarm::ConfigCoupling,
                   report.line(n1802_egb_slave, l) + ": the workpiece axis must be rotary");
    if (helix != 0 && !axis_of(report, helix))
        report.add(Alarm::ConfigAxisReference,
                   report.line(n1803_helical_comp_axis, l) + ": that axis does not exist");
}

void check_spindle_master(Report& report, unsigned s) {
    auto master = get(report.table, pt_spindle_master, s);
    if (master == 0) return;
    if (master > static_cast<std::int64_t>(kMaxSpindles) ||
        !report.machine.spindle(static_cast<std::size_t>(master)).exists())
        return report.add(Alarm::ConfigSpindleMissing,
                          report.line(pt_spindle_master, s) + ": that spindle does not exist");
    for (std::size_t steps = 0; master != 0 && steps < kMaxSpindles; ++steps) {
        if (master == static_cast<std::int64_t>(s))
            return report.add(Alarm::ConfigCoupling, report.line(pt_spindle_master, s) +
                                                         ": the spindle would follow itself");
        master = get(report.table, pt_spindle_master, static_cast<unsigned>(master));
    }
}

}  // namespace

void check_compensation(Report& report) {
    for (const ChannelConfig& c : report.machine.channels) {
        if (!c.exists()) continue;
        check_straightness(report, c.number);
        check_grid(report, c.number);
        check_gear(report, c.number);
    }
    for (const AxisConfig& x : report.machine.axes)
        if (x.exists()) check_gradient(report, x.number);
    for (unsigned s = 1; s <= kMaxSpindles; ++s)
        if (report.machine.spindle(s).exists()) check_spindle_master(report, s);
}

}  // namespace polyturn::config
