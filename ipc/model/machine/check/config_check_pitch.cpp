// Pitch error tables (part 2, section 26): cells numbered 10000 to 29999, laid over the axis by
// interval and zero cell.
//
//   primary     N2503 ........ N2502 ........ N2504      cells; N2501 apart
//               smallest       machine zero   largest    cyclic: (N2504 - N2503) * N2501 = N2506
//   secondary   N2508 ........ N2509                      N2507 apart; one period:
//                                                         (N2509 - N2508) * N2507 = N2510
#include <cmath>
#include <string>

#include "ipc/model/machine/check/config_report.hpp"
#include "ipc/model/compensation/compensation_tables.hpp"
#include "ipc/model/machine/shortest_text.hpp"

namespace polyturn::config {
namespace {

using namespace params;

bool alike(double a, double b) { return std::abs(a - b) <= 1e-9 * std::max(1.0, std::abs(b)); }

void check_cell(Report& report, unsigned a, const auto& handle) {
    const auto cell = get(report.table, handle, a);
    if (cell < kFirstCell || cell > kLastCell)
        report.add(Alarm::ConfigPitch, report.line(handle, a) + ": no cell of the table");
}

void check_order(Report& report, unsigned a, const auto& first, const auto& last) {
    if (get(report.table, first, a) >= get(report.table, last, a))
        report.add(Alarm::ConfigPitch,
                   report.line(first, a) + " not below " + report.line(last, a));
}

void check_interval(Report& report, unsigned a, const auto& interval) {
    if (get(report.table, interval, a) <= 0)
        report.add(Alarm::ConfigPitch, report.line(interval, a) + ": must be above 0");
}

void check_span(Report& report, unsigned a, const auto& first, const auto& last,
                const auto& interval, const auto& length) {
    const double span =
        static_cast<double>(get(report.table, last, a) - get(report.table, first, a)) *
        get(report.table, interval, a);
    if (!alike(span, get(report.table, length, a)))
        report.add(Alarm::ConfigPitch, report.line(length, a) + ", but the table spans " +
                                           shortest_text(span) + " (" + report.line(first, a) +
                                           ", " + report.line(last, a) + ", " +
                                           report.line(interval, a) + ")");
}

void check_primary(Report& report, unsigned a) {
    check_interval(report, a, n2501_primary_interval);
    check_cell(report, a, n2503_primary_smallest_cell_no);
    check_cell(report, a, n2504_primary_largest_cell_no);
    check_order(report, a, n2503_primary_smallest_cell_no, n2504_primary_largest_cell_no);
    const auto zero = get(report.table, n2502_cell_no_of_mach_zero, a);
    if (zero < get(report.table, n2503_primary_smallest_cell_no, a) ||
        zero > get(report.table, n2504_primary_largest_cell_no, a))
        report.add(Alarm::ConfigPitch, report.line(n2502_cell_no_of_mach_zero, a) +
                                           ": machine zero lies outside the table");
    if (bit(report.table, n2500_pitch_comp_contr, a, 1)) {
        check_cell(report, a, n2505_primary_smallest_cell_no_both_dir);
        // The table of the other direction is as long as the first one, and a cell has one value.
        const auto first = get(report.table, n2503_primary_smallest_cell_no, a),
                   last = get(report.table, n2504_primary_largest_cell_no, a),
                   second = get(report.table, n2505_primary_smallest_cell_no_both_dir, a);
        if (second + last - first > kLastCell)
            report.add(Alarm::ConfigPitch, report.line(n2505_primary_smallest_cell_no_both_dir, a) +
                                               ": the second table does not fit into the cells");
        else if (second <= last && first <= second + last - first)
            report.add(Alarm::ConfigPitch, report.line(n2505_primary_smallest_cell_no_both_dir, a) +
                                               ": the second table lies over the first one");
    }
    if (bit(report.table, n2500_pitch_comp_contr, a, 2))
        check_span(report, a, n2503_primary_smallest_cell_no, n2504_primary_largest_cell_no,
                   n2501_primary_interval, n2506_distance_of_cycle);
}

void check_secondary(Report& report, unsigned a) {
    if (!bit(report.table, n0106_axis_properties, a, 2))
        report.add(Alarm::ConfigPitch,
                   report.line(n2500_pitch_comp_contr, a) +
                       ": periodic compensation, but N0106 #2 of the axis is 0");
    check_interval(report, a, n2507_secondary_interval);
    check_cell(report, a, n2508_secondary_smallest_cell_no);
    check_cell(report, a, n2509_secondary_largest_cell_no);
    check_order(report, a, n2508_secondary_smallest_cell_no, n2509_secondary_largest_cell_no);
    check_span(report, a, n2508_secondary_smallest_cell_no, n2509_secondary_largest_cell_no,
               n2507_secondary_interval, n2510_distance_of_period);
}

}  // namespace

void check_pitch_tables(Report& report) {
    for (const AxisConfig& x : report.machine.axes) {
        if (!x.exists()) continue;
        if (bit(report.table, n2500_pitch_comp_contr, x.number, 0)) check_primary(report, x.number);
        if (bit(report.table, n2500_pitch_comp_contr, x.number, 3))
            check_secondary(report, x.number);
    }
}

}  // namespace polyturn::config
