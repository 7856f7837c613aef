#include "ipc/model/machine/check/config_check.hpp"

#include "ipc/model/machine/check/config_report.hpp"

namespace polyturn {
namespace config {
namespace {

using namespace params;

constexpr std::int64_t kMostOffsets = 999;  // of all channels together (part 1, 15.1)

void check_tick(Report& report) {  // part 1, 2: Auto (0), 1000, 2000, 5000
    const auto tick_us = get(report.table, n0005_nc_cycle_time);
    if (tick_us != 0 && tick_us != 1000 && tick_us != 2000 && tick_us != 5000)
        report.add(Alarm::ConfigTick, report.line(n0005_nc_cycle_time));
}

// Codes up to 99 have meanings of their own (M0 M1 M2 M3 M30 M98 M99), which a waiting code would
// hide.
void check_wait_codes(Report& report) {
    const auto low = get(report.table, n2201_waiting_m_codes_min),
               high = get(report.table, n2202_waiting_m_codes_max);
    if (low == 0 && high == 0) return;
    const std::string both =
        report.line(n2201_waiting_m_codes_min) + ", " + report.line(n2202_waiting_m_codes_max);
    if (low > high)
        report.add(Alarm::ConfigWaitCodes, both + ": the smallest is above the largest");
    else if (low <= 99)
        report.add(Alarm::ConfigWaitCodes, both + ": overlaps M0 to M99");
}

void check_offset_count(Report& report) {
    std::int64_t sum = 0;
    std::string lines;
    for (const ChannelConfig& c : report.machine.channels) {
        if (!c.exists()) continue;
        sum += c.offset_count;
        lines += (lines.empty() ? "" : ", ") + report.line(n1400_no_of_tool_offsets, c.number);
    }
    if (sum > kMostOffsets)
        report.add(Alarm::ConfigOffsets, lines + ": " + std::to_string(sum) + " together");
}

// A letter that is passed to the PLC as an auxiliary function cannot at the same time move an axis.
void check_auxiliary_letters(Report& report, const ChannelConfig& c) {
    for (unsigned n = 1; n <= 3; ++n) {
        const auto handle = nth(n1333_aux_fu_addr1, n);
        const auto code = get(report.table, handle, c.number);
        if (code < 'A' || code > 'Z') continue;
        const char letter = static_cast<char>(code);
        if (const AxisConfig* axis =
                find_axis(report.machine, c.number, std::string_view(&letter, 1)))
            report.add(Alarm::ConfigAuxAddress, report.line(handle, c.number) + " is " + letter +
                                                    ", as axis " + axis_text(*axis));
    }
}

void check_default_spindle(Report& report, const ChannelConfig& c) {
    if (get(report.table, n0604_default_spindle, c.number) == 0 || c.default_spindle != 0) return;
    report.add(Alarm::ConfigSpindleMissing,
               report.line(n0604_default_spindle, c.number) + ": that spindle does not exist");
}

void check_surface_speed_axis(Report& report, const ChannelConfig& c) {
    const auto number = get(report.table, n0687_default_g96_axis, c.number);
    if (number == 0) return;
    if (c.surface_speed_axis != static_cast<std::uint16_t>(number))
        report.add(Alarm::ConfigSurfaceAxis, report.line(n0687_default_g96_axis, c.number) +
                                                 ": not an axis of L" + std::to_string(c.number));
    else if (report.machine.axis(c.surface_speed_axis).rotary)
        report.add(Alarm::ConfigSurfaceAxis, report.line(n0687_default_g96_axis, c.number) +
                                                 ": a rotary axis has no diameter");
}

}  // namespace

void check_channels(Report& report) {
    check_tick(report);
    check_wait_codes(report);
    check_offset_count(report);
    if (report.machine.channel_count == 0)
        report.add(Alarm::ConfigNoChannel, "N0000 is 0 for every channel");
    for (const ChannelConfig& c : report.machine.channels) {
        if (!c.exists()) continue;
        check_default_spindle(report, c);
        check_surface_speed_axis(report, c);
        check_auxiliary_letters(report, c);
        if (bit(report.table, n0421_acc_contr, c.number, 0) &&
            bit(report.table, n1337_execution_config, c.number, 0))
            report.add(Alarm::ConfigRapidOverlap,
                       report.line(n0421_acc_contr, c.number) + " with " +
                           report.line(n1337_execution_config, c.number));
    }
}

}  // namespace config

std::vector<Diagnosis> check_machine_config(const params::Table& table) {
    const MachineConfig machine = derive_machine_config(table);
    config::Report report(table, machine);
    config::check_channels(report);
    config::check_axes(report);
    config::check_axis_references(report);
    config::check_couplings(report);
    config::check_drives(report);
    config::check_spindles(report);
    config::check_pitch_tables(report);
    config::check_compensation(report);
    config::check_codes(report);
    config::check_values(report);
    config::check_switches(report);
    config::check_kinds(report);
    config::check_together(report);
    config::check_effects(report);
    return std::move(report.diagnoses);
}

}  // namespace polyturn
