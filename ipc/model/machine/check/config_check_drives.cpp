// Drives and spindles: one owner each, speeds that fit one another.
#include <map>
#include <string>

#include "ipc/model/machine/check/config_report.hpp"

namespace polyturn::config {

using namespace params;

// One motor may be a spindle and a C axis in turn; two axes or two spindles on one motor would move
// each other's work.
void check_drives(Report& report) {
    std::map<std::int64_t, std::string> axis_line, spindle_line;
    const auto take = [&](std::map<std::int64_t, std::string>& owners, std::int64_t address,
                          std::string line) {
        if (address == 0) return;
        const auto [found, fresh] = owners.emplace(address, line);
        if (!fresh) report.add(Alarm::ConfigOutputShared, found->second + " and " + line);
    };
    for (const AxisConfig& x : report.machine.axes)
        if (x.exists() && !x.hypothetical)
            take(axis_line, get(report.table, n0503_axis_output_address, x.number),
                 report.line(n0503_axis_output_address, x.number));
    for (const SpindleConfig& s : report.machine.spindles)
        if (s.exists())
            take(spindle_line, get(report.table, n0603_spindle_output_address, s.number),
                 report.line(n0603_spindle_output_address, s.number));
}

void check_spindles(Report& report) {
    for (const SpindleConfig& s : report.machine.spindles) {
        if (!s.exists()) continue;
        for (unsigned n = 1; n <= s.range.size(); ++n) {
            const GearRange& range = s.range[n - 1];
            const auto low = nth(n0642_r1_s_min, n), high = nth(n0650_r1_s_max, n);
            const auto full = nth(n0634_r1_s_calibration, n);
            if (range.min_rpm > range.max_rpm)
                report.add(Alarm::ConfigSpindleSpeed,
                           report.line(low, s.number) + " above " + report.line(high, s.number));
            // Ranges that were never filled in keep their defaults; only a range that somebody
            // described is compared.
            const bool described = range.max_rpm != rows()[high.row].default_number() ||
                                   range.full_scale_rpm != rows()[full.row].default_number();
            if (described && range.max_rpm > range.full_scale_rpm)
                report.add(Alarm::ConfigSpindleSpeed,
                           report.line(high, s.number) + " above " + report.line(full, s.number));
        }
    }
}

}  // namespace polyturn::config
