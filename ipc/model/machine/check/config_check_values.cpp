// Values of a channel or a spindle that another of its values limits (nct_parameters part 1 8.4,
// part 2 30.6, 32, 33).
#include <cmath>
#include <cstdlib>

#include "ipc/model/machine/check/config_report.hpp"

namespace polyturn::config {
namespace {

using namespace params;

// N3107: what is smoothed without regard to corners must lie within what the end points may be
// moved.
void check_smoothing(Report& report, unsigned l) {
    if (get(report.table, n3107_dist_cancelling_of_angular_calc_in_smooth2, l) >
        2.0 * get(report.table, n3106_tolerance_of_smooth2, l) + 1e-9)
        report.add(Alarm::ParamRange,
                   report.line(n3107_dist_cancelling_of_angular_calc_in_smooth2, l) +
                       " is more than twice " + report.line(n3106_tolerance_of_smooth2, l));
}

// A rotary axis about X, Y or Z is not inclined.
template <class Direction, class Angle>
void check_inclination(Report& report, unsigned l, Direction direction, Angle angle) {
    if (get(report.table, direction, l) <= 3 && get(report.table, angle, l) != 0)
        report.add(Alarm::ParamRange,
                   report.line(angle, l) + " must be 0 with " + report.line(direction, l));
}

// N2923 stands where a T code has its offset number, which calls the geometry too.
void check_managed_offset(Report& report, unsigned l) {
    const auto code = get(report.table, n2923_no_of_offset_code, l);
    const auto digits = get(report.table, n1413_no_of_digits_of_offs_no_in_t_code, l);
    const bool turning = get(report.table, n0001_control_type, l) == 0;
    if (code == 0 || !turning) return;
    if (std::to_string(code).size() != static_cast<std::size_t>(digits))
        report.add(Alarm::ParamRange,
                   report.line(n2923_no_of_offset_code, l) + " has not as many digits as " +
                       report.line(n1413_no_of_digits_of_offs_no_in_t_code, l) + " says");
    if (get(report.table, n1414_comp_config_on_lathes, l) & 2)
        report.add(Alarm::ParamRange, report.line(n2923_no_of_offset_code, l) +
                                          ": the tool number calls the geometry, N1414#1 L" +
                                          std::to_string(l) + "=1");
}

// N2904 chooses among tools by a column that N2903 must have added (part 2, 30.4).
void check_life_column(Report& report) {
    bool asked = false;
    for (const ChannelConfig& c : report.machine.channels)
        asked = asked || (c.exists() && bit(report.table, n2901_search_config, c.number, 0));
    if (asked && get(report.table, n2904_custom_life_column_no) >
                     get(report.table, n2903_no_of_custom_columns))
        report.add(Alarm::ParamRange, report.line(n2904_custom_life_column_no) + " above " +
                                          report.line(n2903_no_of_custom_columns));
}

}  // namespace

void check_values(Report& report) {
    check_life_column(report);
    // A simulation is begun as one; a controller never takes itself for one (part 2, 35).
    if (params::get_text(report.table, n5000_nc_mode) != "Real Run")
        report.add(Alarm::ParamRange, report.line(n5000_nc_mode) + ": Real Run");
    for (const ChannelConfig& c : report.machine.channels) {
        if (!c.exists()) continue;
        check_smoothing(report, c.number);
        check_inclination(report, c.number, n3205_direction_of_the_first_rot_ax,
                          n3206_inclination_angle_of_the_first_rot_ax);
        check_inclination(report, c.number, n3209_direction_of_the_second_rot_ax,
                          n3210_inclination_angle_of_the_second_rot_ax);
        check_managed_offset(report, c.number);
    }
    for (const SpindleConfig& s : report.machine.spindles) {
        const double volts =
            s.exists() ? get(report.table, n0682_spindle_analog_adjust, s.number) : 0.0;
        if (volts > 0 && volts < 10)
            report.add(Alarm::ParamRange,
                       report.line(n0682_spindle_analog_adjust, s.number) + ": 10 or more, or 0");
    }
}

}  // namespace polyturn::config
