// Axes: whom they belong to, what they are called, whether they can move.
#include <array>
#include <string>

#include "ipc/model/machine/check/config_report.hpp"

namespace polyturn::config {
namespace {

using namespace params;

constexpr std::int64_t kMeasuredOnly = 99;

std::string channel_text(std::size_t number) { return "L" + std::to_string(number); }

bool first_letter(std::int64_t code) {
    return code > 0 && code < 128 &&
           std::string_view("XYZABCUVW").find(static_cast<char>(code)) != std::string_view::npos;
}
bool further_character(std::int64_t code) {
    return (code >= '0' && code <= '9') || (code >= 'A' && code <= 'Z');
}

// The channel that N0002 names must exist. True when the axis is one.
bool check_owner(Report& report, unsigned a) {
    const auto owner = get(report.table, n0002_axis_assign, a);
    if (owner == 0) return false;
    if (owner == kMeasuredOnly) return true;
    if (owner > static_cast<std::int64_t>(kMaxChannels)) {
        report.add(Alarm::ConfigAxisChannel, report.line(n0002_axis_assign, a) +
                                                 ": channels are L1 to L" +
                                                 std::to_string(kMaxChannels));
        return false;
    }
    if (!report.machine.channel(static_cast<std::size_t>(owner)).exists()) {
        report.add(Alarm::ConfigAxisChannel,
                   report.line(n0002_axis_assign, a) + ": " +
                       report.line(n0000_machine_group, static_cast<unsigned>(owner)));
        return false;
    }
    return true;
}

void check_name(Report& report, unsigned a) {
    const auto first = get(report.table, n0100_axis_name1, a),
               second = get(report.table, n0101_axis_name2, a),
               third = get(report.table, n0102_axis_name3, a);
    if (first == 0) return;  // an axis without a name belongs to the PLC
    if (!first_letter(first)) report.add(Alarm::ConfigAxisName, report.line(n0100_axis_name1, a));
    if (second != 0 && !further_character(second))
        report.add(Alarm::ConfigAxisName, report.line(n0101_axis_name2, a));
    if (second != 0 && third != 0 && !further_character(third))
        report.add(Alarm::ConfigAxisName, report.line(n0102_axis_name3, a));
}

void check_limits(Report& report, unsigned a) {
    const AxisConfig& axis = report.machine.axis(a);
    if (axis.measured_only || axis.hypothetical) return;
    if (axis.limits.rapid_mm_s <= 0)
        report.add(Alarm::ConfigMotionLimit, report.line(n0304_rapid, a));
    if (axis.limits.max_feed_mm_s <= 0)
        report.add(Alarm::ConfigMotionLimit, report.line(n0305_max_feed, a));
    if (axis.limits.accel_mm_s2 <= 0)
        report.add(Alarm::ConfigMotionLimit, report.line(n0400_acceleration, a));
    if (axis.position_gain_1_s <= 0)
        report.add(Alarm::ConfigMotionLimit, report.line(n0504_position_gain, a));
}

void check_range(Report& report, unsigned a, const auto& positive, const auto& negative) {
    if (get(report.table, positive, a) <= get(report.table, negative, a))
        report.add(Alarm::ConfigStroke,
                   report.line(positive, a) + " with " + report.line(negative, a));
}

void check_strokes(Report& report, unsigned a) {
    if (bit(report.table, n1000_range_enable, a, 0)) {
        check_range(report, a, n1002_range1a_positive, n1003_range1a_negative);
        // Set B left at 0 and 0 was never filled in; it matters only when the PLC selects it.
        if (get(report.table, n1004_range1b_positive, a) != 0 ||
            get(report.table, n1005_range1b_negative, a) != 0)
            check_range(report, a, n1004_range1b_positive, n1005_range1b_negative);
    }
    const AxisConfig& axis = report.machine.axis(a);
    if (bit(report.table, n1000_range_enable, a, 1) && axis.channel != 0 &&
        bit(report.table, n1001_strkcont, axis.channel, 1))
        check_range(report, a, n1006_range2_positive, n1007_range2_negative);
    if (bit(report.table, n1000_range_enable, a, 2))
        check_range(report, a, n1008_range3_positive, n1009_range3_negative);
}

void check_axis(Report& report, unsigned a) {
    check_name(report, a);
    check_limits(report, a);
    check_strokes(report, a);
    if (get(report.table, n0103_axis_to_plane, a) == 4)
        report.add(Alarm::ConfigPlaneRole, report.line(n0103_axis_to_plane, a));
    const AxisConfig& axis = report.machine.axis(a);
    if (axis.rotary && bit(report.table, n0107_rollover_control, a, 0) && axis.rollover_deg <= 0)
        report.add(Alarm::ConfigRollover, report.line(n0107_rollover_control, a) + " with " +
                                              report.line(n0108_rollamount, a));
}

// An axis that only carries the direct measuring device of a dual loop does not count among a
// channel's sixteen.
bool is_direct_device(const Report& report, unsigned number) {
    for (const AxisConfig& x : report.machine.axes)
        if (x.exists() && get(report.table, n0534_dual_position_axis_number, x.number) == number)
            return true;
    return false;
}

void check_channel_axes(Report& report, const ChannelConfig& c) {
    unsigned count = 0;
    std::array<const AxisConfig*, 8> basic{};
    for (const AxisConfig& x : report.machine.axes) {
        if (x.channel != c.number) continue;
        if (!is_direct_device(report, x.number)) ++count;
        if (x.name_text().empty()) continue;
        for (const AxisConfig& y : report.machine.axes) {
            if (y.number >= x.number) break;
            if (y.channel == c.number && y.name_text() == x.name_text())
                report.add(Alarm::ConfigAxisNameTwice, axis_text(y) + " and " + axis_text(x) +
                                                           " of " + channel_text(c.number) + ", " +
                                                           report.line(n0100_axis_name1, x.number));
        }
        if (x.role == PlaneRole::None || x.role > PlaneRole::BasicZ) continue;
        const AxisConfig*& first = basic[static_cast<std::size_t>(x.role)];
        if (first)
            report.add(Alarm::ConfigPlaneRole, report.line(n0103_axis_to_plane, first->number) +
                                                   " and " +
                                                   report.line(n0103_axis_to_plane, x.number) +
                                                   " in " + channel_text(c.number));
        else
            first = &x;
    }
    if (count > kChannelAxes)
        report.add(Alarm::ConfigAxisCount,
                   std::to_string(count) + " axes have N0002=" + std::to_string(c.number));
}

}  // namespace

void check_axes(Report& report) {
    for (unsigned a = 1; a <= kMaxAxes; ++a)
        if (check_owner(report, a)) check_axis(report, a);
    for (const ChannelConfig& c : report.machine.channels)
        if (c.exists()) check_channel_axes(report, c);
}

void check_axis_references(Report& report) {
    for (const AxisConfig& x : report.machine.axes) {
        if (!x.exists()) continue;
        const auto check = [&](const auto& handle) {
            const auto other = get(report.table, handle, x.number);
            if (other == 0) return;
            if (other == x.number)
                report.add(Alarm::ConfigAxisReference,
                           report.line(handle, x.number) + ": the axis itself");
            else if (other > static_cast<std::int64_t>(kMaxAxes) ||
                     !report.machine.axis(static_cast<std::size_t>(other)).exists())
                report.add(Alarm::ConfigAxisReference, report.line(handle, x.number) + ": A" +
                                                           std::to_string(other) +
                                                           " does not exist");
        };
        check(n0533_tandem_master);
        check(n0534_dual_position_axis_number);
        check(n2101_synchronous_master);
        check(n2104_composit_axis);
        check(n2107_superimposed_master);
    }
}

}  // namespace polyturn::config
