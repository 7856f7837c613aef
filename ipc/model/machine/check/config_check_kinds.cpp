// What an axis or spindle is said to be, and what that kind needs: distances of indexed and
// periodic axes, referencing, tandem and dual position loops, addresses of positioned spindles.
#include <string>

#include "ipc/model/machine/check/config_report.hpp"

namespace polyturn::config {
namespace {

using namespace params;

void check_distances(Report& report, unsigned a) {
    if (bit(report.table, n0106_axis_properties, a, 3) &&
        get(report.table, n0110_indexing_amount, a) <= 0)
        report.add(Alarm::ConfigIndex, report.line(n0106_axis_properties, a) + " is indexed with " +
                                           report.line(n0110_indexing_amount, a));
}

// 10.2: a search without a distance ends before it begins; coded marks need both their distances.
void check_homing(Report& report, unsigned a) {
    const AxisConfig& axis = report.machine.axis(a);
    if (axis.measured_only || axis.hypothetical) return;
    const auto has = [&](unsigned n) { return bit(report.table, n0900_reference_type, a, n); };
    if (has(3)) return;  // absolute: nothing is searched
    const std::string type = report.line(n0900_reference_type, a);
    if (has(0) && !has(2) && get(report.table, n0901_reference_distance, a) == 0)
        report.add(Alarm::ConfigHoming,
                   type + " with a switch, but " + report.line(n0901_reference_distance, a));
    if ((has(1) || has(2)) && get(report.table, n0904_zerodis, a) <= 0)
        report.add(Alarm::ConfigHoming, type + ", but " + report.line(n0904_zerodis, a));
    if (has(2) && get(report.table, n0905_basdist, a) <= 0)
        report.add(Alarm::ConfigHoming,
                   type + " with coded marks, but " + report.line(n0905_basdist, a));
}

// A gantry's slave gets its reference point with its master's: one that must have it needs a master
// that is homed.
void check_homing_order(Report& report, unsigned a) {
    const auto order = get(report.table, pt_ref_order, a);
    const auto master = get(report.table, n2101_synchronous_master, a);
    const bool gantry = bit(report.table, n2102_synchron_config, a, 4);
    if (gantry && master >= 1 && master <= static_cast<std::int64_t>(kMaxAxes) &&
        master != static_cast<std::int64_t>(a)) {
        const auto other = get(report.table, pt_ref_order, static_cast<unsigned>(master));
        if (order != 0 && other == 0)
            report.add(Alarm::ConfigHoming,
                       report.line(pt_ref_order, a) + ", but its master's " +
                           report.line(pt_ref_order, static_cast<unsigned>(master)));
    }
}

// 7.9: two loops on one encoder would fight; a direct measuring device never gives commands.
void check_loops(Report& report, unsigned a) {
    const auto other = [&](const auto& handle) {
        const auto number = get(report.table, handle, a);
        return number > 0 && number <= static_cast<std::int64_t>(kMaxAxes) && number != a &&
                       report.machine.axis(static_cast<std::size_t>(number)).exists()
                   ? static_cast<unsigned>(number)
                   : 0u;
    };
    if (other(n0533_tandem_master) && !bit(report.table, n0514_servo_control, a, 7))
        report.add(Alarm::ConfigLoop, report.line(n0533_tandem_master, a) + " with " +
                                          report.line(n0514_servo_control, a) +
                                          ": its loop is closed");
    if (const unsigned device = other(n0534_dual_position_axis_number)) {
        const std::string line = report.line(n0534_dual_position_axis_number, a);
        if (!bit(report.table, n0106_axis_properties, device, 4))
            report.add(Alarm::ConfigLoop, line + ": " + report.line(n0106_axis_properties, device) +
                                              " is not virtual");
        else if (get(report.table, n0503_axis_output_address, device) != 0)
            report.add(Alarm::ConfigLoop,
                       line + ": " + report.line(n0503_axis_output_address, device));
    }
}

std::string address_of(const Report& report, unsigned s) {
    std::string name;
    for (const auto code : {get(report.table, n0817_spindle_axis_name1, s),
                            get(report.table, n0818_spindle_axis_name2, s),
                            get(report.table, n0819_spindle_axis_name3, s)}) {
        if (code <= 0 || code > 127) break;
        name += static_cast<char>(code);
    }
    return name;
}

// 9: a positioned spindle has an address that no axis has.
void check_spindle_address(Report& report, unsigned s) {
    const auto first = get(report.table, n0817_spindle_axis_name1, s);
    if (first == 0) return;
    const std::string line = report.line(n0817_spindle_axis_name1, s);
    if (first < 'A' || first > 'C')
        return report.add(Alarm::ConfigSpindleName, line + ": not A, B or C");
    const std::string name = address_of(report, s);
    for (const AxisConfig& axis : report.machine.axes)
        if (axis.exists() && axis.name_text() == name)
            return report.add(
                Alarm::ConfigSpindleName,
                line + ": " + name + " is the name of axis A" + std::to_string(axis.number));
    for (unsigned k = 1; k < s; ++k)
        if (report.machine.spindle(k).exists() && address_of(report, k) == name)
            report.add(Alarm::ConfigSpindleName, report.line(n0817_spindle_axis_name1, k) +
                                                     " and " + line + ": both are " + name);
}

// 8.1: a name of two or three characters belongs to one spindle; those that are only S are meant by
// N0604 and the PLC.
void check_spindle_name(Report& report, unsigned s) {
    const auto second = get(report.table, n0605_spindle_name2, s),
               third = second > 0 ? get(report.table, n0606_spindle_name3, s) : 0;
    if (second <= 0) return;
    for (unsigned k = 1; k < s; ++k) {
        if (!report.machine.spindle(k).exists() ||
            get(report.table, n0605_spindle_name2, k) != second)
            continue;
        if (get(report.table, n0606_spindle_name3, k) == third)
            report.add(Alarm::ConfigSpindleName, report.line(n0605_spindle_name2, k) + " and " +
                                                     report.line(n0605_spindle_name2, s) +
                                                     ": two spindles of one name");
    }
}

}  // namespace

void check_kinds(Report& report) {
    for (const AxisConfig& x : report.machine.axes) {
        if (!x.exists()) continue;
        check_distances(report, x.number);
        check_homing(report, x.number);
        check_homing_order(report, x.number);
        check_loops(report, x.number);
    }
    for (const SpindleConfig& s : report.machine.spindles)
        if (s.exists()) {
            check_spindle_address(report, s.number);
            check_spindle_name(report, s.number);
        }
}

}  // namespace polyturn::config
