// What single parameters allow and together cannot be (nct_parameters_part1 3 to 14, part 2 23,
// 24): kinds of axes that exclude each other, encoders that cannot count, strokes without room,
// codes with two meanings. One line of the check for each rule.
#include <array>
#include <cmath>
#include <string>

#include "ipc/model/machine/check/config_report.hpp"

namespace polyturn::config {
namespace {

using namespace params;

constexpr double kMostRounds = 62;  // bits of an encoder of which rounds are counted

bool digit_or_capital(std::int64_t code) {
    return (code >= '0' && code <= '9') || (code >= 'A' && code <= 'Z');
}

// 3.4 to 3.7. DIA of a rotary axis and REN of a linear one say nothing (3.4, 3.5): a line without
// scope sets them everywhere.
void check_axis_kind(Report& report, unsigned a) {
    const AxisConfig& axis = report.machine.axis(a);
    const auto is = [&](unsigned n) { return bit(report.table, n0106_axis_properties, a, n); };
    const std::string properties = report.line(n0106_axis_properties, a);
    const auto wrong = [&](std::string detail) {
        report.add(Alarm::ConfigIndex, std::move(detail));
    };
    if (is(4) && is(7))
        wrong(properties +
              ": virtual and hypothetical; one has an encoder only, the other nothing at all");
    if (is(4) && get(report.table, n0503_axis_output_address, a) != 0)
        wrong(properties + " is virtual, but " + report.line(n0503_axis_output_address, a));
    if (!is(1) && get(report.table, n0217_polar_intp_comp_amount, a) != 0)
        wrong(report.line(n0217_polar_intp_comp_amount, a) + ": belongs to the rotary axis, " +
              properties);
    const bool own_table = bit(report.table, n2500_pitch_comp_contr, a, 3);  // its period is N2510
    if (is(2) && !own_table && get(report.table, n0109_peramount, a) <= 0)
        report.add(Alarm::ConfigIndex,
                   properties + " is periodic with " + report.line(n0109_peramount, a));
    if (is(3) && !axis.hypothetical && get(report.table, n0110_indexing_amount, a) > 0 &&
        get(report.table, n0516_inpos, a) >= 0.5 * get(report.table, n0110_indexing_amount, a))
        report.add(Alarm::ConfigIndex, report.line(n0516_inpos, a) +
                                           ": it would be at an index everywhere, " +
                                           report.line(n0110_indexing_amount, a));
}

// 10: what excludes each other in N0900, and an encoder whose rounds are to be counted.
void check_reference(Report& report, unsigned a) {
    const AxisConfig& axis = report.machine.axis(a);
    if (axis.measured_only || axis.hypothetical) return;
    const auto has = [&](unsigned n) { return bit(report.table, n0900_reference_type, a, n); };
    const bool by_switch = has(0), by_pulse = has(1), coded = has(2), absolute = has(3),
               floating = has(4), rounds = has(6), on_switch = has(7);
    const std::string type = report.line(n0900_reference_type, a);
    const auto wrong = [&](std::string detail) {
        report.add(Alarm::ConfigHoming, std::move(detail));
    };
    if (absolute && (by_switch || by_pulse))
        wrong(type + ": an absolute encoder is not searched for");
    if (floating && (by_switch || by_pulse || coded))
        wrong(type + ": floating, and searched for as well");
    if (coded && (by_switch || by_pulse))
        wrong(type + ": coded marks need neither switch nor zero pulse");
    if (on_switch && !(by_switch && by_pulse))
        wrong(type + ": GOS needs a switch and a zero pulse");
    if (rounds && !absolute) wrong(type + ": CIR counts the rounds of an absolute encoder");
    const auto bits = static_cast<double>(get(report.table, n0524_endat_resolution, a));
    if (rounds && absolute && (bits == 0 || bits > kMostRounds))
        wrong(type + " counts rounds, but " + report.line(n0524_endat_resolution, a));
    if (rounds && absolute && !axis.rotary)
        wrong(type + ": CIR is for rotary axes, " + report.line(n0106_axis_properties, a));
    const bool moves = (by_switch || by_pulse || coded) && !absolute && !floating;
    if (moves && get(report.table, n0303_ref_feed, a) <= 0)
        wrong(type + ", but " + report.line(n0303_ref_feed, a));
    if (by_switch && moves && get(report.table, n0302_ref_rapid, a) <= 0)
        wrong(type + ", but " + report.line(n0302_ref_rapid, a));
    if (by_switch && moves && get(report.table, n0902_switch_length, a) <= 0)
        wrong(type + ", but " + report.line(n0902_switch_length, a));
}

// 7.1, 7.9: who drives whom.
void check_loop(Report& report, unsigned a) {
    const auto wrong = [&](std::string detail) {
        report.add(Alarm::ConfigLoop, std::move(detail));
    };
    const auto master = get(report.table, n0533_tandem_master, a);
    if (master >= 1 && master <= static_cast<std::int64_t>(kMaxAxes) &&
        master != static_cast<std::int64_t>(a) &&
        get(report.table, n0533_tandem_master, static_cast<unsigned>(master)) != 0)
        wrong(report.line(n0533_tandem_master, a) + ": that axis is a tandem slave itself");
    if (const auto device = get(report.table, n0534_dual_position_axis_number, a); device != 0) {
        for (unsigned other = 1; other < a; ++other)
            if (report.machine.axis(other).exists() &&
                get(report.table, n0534_dual_position_axis_number, other) == device)
                wrong(report.line(n0534_dual_position_axis_number, other) + " and " +
                      report.line(n0534_dual_position_axis_number, a) +
                      ": one measuring device for two axes");
        const double most = get(report.table, n0537_dual_position_maximum_value, a),
                     least = get(report.table, n0538_dual_position_minimum_value, a);
        if (most > 0 && least >= most)
            wrong(report.line(n0538_dual_position_minimum_value, a) + " not below " +
                  report.line(n0537_dual_position_maximum_value, a));
    }
    const AxisConfig& axis = report.machine.axis(a);
    const auto address = get(report.table, n0503_axis_output_address, a);
    if (address == 0 || axis.rotary || axis.hypothetical) return;
    for (const SpindleConfig& s : report.machine.spindles)
        if (s.exists() && get(report.table, n0603_spindle_output_address, s.number) == address)
            report.add(Alarm::ConfigOutputShared,
                       report.line(n0503_axis_output_address, a) + " and " +
                           report.line(n0603_spindle_output_address, s.number) +
                           ": only a rotary axis shares a spindle's drive");
}

struct Interval {
    double low, high;
    bool holds(const Interval& other) const { return low <= other.low && other.high <= high; }
    bool meets(const Interval& other) const { return low <= other.high && other.low <= high; }
};

// 11: ranges that leave no room. Range 3 is the product of its axes: a channel has none left when
// it covers range 1 of all of them.
void check_room(Report& report, const ChannelConfig& c) {
    unsigned watched = 0, covered = 0;
    std::string lines;
    for (const AxisConfig& x : report.machine.axes) {
        if (!x.exists() || x.channel != c.number) continue;
        const unsigned a = x.number;
        const auto on = [&](unsigned n) { return bit(report.table, n1000_range_enable, a, n); };
        const Interval first{get(report.table, n1003_range1a_negative, a),
                             get(report.table, n1002_range1a_positive, a)};
        const Interval second{get(report.table, n1007_range2_negative, a),
                              get(report.table, n1006_range2_positive, a)};
        const Interval third{get(report.table, n1009_range3_negative, a),
                             get(report.table, n1008_range3_positive, a)};
        const bool outer = bit(report.table, n1001_strkcont, c.number, 0),
                   second_on = bit(report.table, n1001_strkcont, c.number, 1) && on(1);
        if (on(0) && second_on && outer && first.low < first.high && second.low < second.high &&
            !first.meets(second))
            report.add(Alarm::ConfigStroke, report.line(n1006_range2_positive, a) + ", " +
                                                report.line(n1007_range2_negative, a) +
                                                ": nothing of range 1 lies within");
        if (!on(2)) continue;
        ++watched;
        covered += on(0) && first.low < first.high && third.holds(first);
        lines += (lines.empty() ? "" : ", ") + report.line(n1008_range3_positive, a);
    }
    if (watched > 0 && covered == watched)
        report.add(Alarm::ConfigStroke, lines + ": range 3 forbids all that range 1 allows");
}

// 8, 9.
void check_spindle(Report& report, unsigned s) {
    const auto wrong = [&](Alarm alarm, std::string detail) {
        report.add(alarm, std::move(detail));
    };
    const auto character = [&](const auto& handle) {
        const auto code = get(report.table, handle, s);
        if (code != 0 && !digit_or_capital(code))
            wrong(Alarm::ConfigSpindleName,
                  report.line(handle, s) + ": neither a digit nor a capital letter");
    };
    character(n0605_spindle_name2);
    if (get(report.table, n0605_spindle_name2, s) != 0) character(n0606_spindle_name3);
    const auto is = [&](unsigned n) { return bit(report.table, n0607_spindle_config, s, n); };
    if (get(report.table, n0817_spindle_axis_name1, s) != 0) {
        character(n0818_spindle_axis_name2);
        if (get(report.table, n0818_spindle_axis_name2, s) != 0)
            character(n0819_spindle_axis_name3);
    }
    if (bit(report.table, n0609_spindle_encoder_config, s, 3) &&
        bit(report.table, n0609_spindle_encoder_config, s, 4))
        wrong(Alarm::ConfigSpindleSpeed, report.line(n0609_spindle_encoder_config, s) +
                                             ": oriented by the probe and by the PLC's switch");
    // The builder's states of a spindle are in addition to M3, M4, M5 and M19.
    const auto low = get(report.table, n0689_spindle_m_low, s),
               high = get(report.table, n0690_spindle_m_high, s);
    for (const std::int64_t code : {3, 4, 5, 19})
        if (high > 0 && low <= code && code <= high) {
            wrong(Alarm::ConfigCodes, report.line(n0689_spindle_m_low, s) + ", " +
                                          report.line(n0690_spindle_m_high, s) + ": M" +
                                          std::to_string(code) + " is among them");
            break;
        }
    // M codes that index.
    const auto first = get(report.table, n0820_start_m_of_spnd_pos, s),
               count = get(report.table, n0821_no_of_m_code_for_spnd_pos, s);
    if (first == 0 || count == 0 || get(report.table, n0822_basic_angle_of_spnd_pos, s) == 0)
        return;
    const std::string codes = report.line(n0820_start_m_of_spnd_pos, s) + ", " +
                              report.line(n0821_no_of_m_code_for_spnd_pos, s);
    if (!is(2))
        wrong(Alarm::ConfigCodes, codes + ", but " + report.line(n0607_spindle_config, s) +
                                      ": its loop cannot be closed");
    const auto wait_low = get(report.table, n2201_waiting_m_codes_min),
               wait_high = get(report.table, n2202_waiting_m_codes_max);
    if (wait_high > 0 && first <= wait_high && wait_low <= first + count - 1)
        wrong(Alarm::ConfigCodes, codes + ": waiting codes are among them, " +
                                      report.line(n2201_waiting_m_codes_min) + ", " +
                                      report.line(n2202_waiting_m_codes_max));
    for (const std::int64_t code : {0, 1, 2, 3, 4, 5, 19, 30, 98, 99})
        if (first <= code && code < first + count) {
            wrong(Alarm::ConfigCodes,
                  codes + ": M" + std::to_string(code) + " has a meaning of its own");
            break;
        }
}

// 14.3, 14.7, part 2 23 and 24.
void check_channel(Report& report, const ChannelConfig& c) {
    const unsigned l = c.number;
    for (unsigned n = 1; n <= 3; ++n) {
        const auto handle = nth(n1333_aux_fu_addr1, n);
        const auto code = get(report.table, handle, l);
        if (code == 0) continue;
        if (code < 0 || code > 'Z' ||
            std::string_view("ABCUVW").find(static_cast<char>(code)) == std::string_view::npos)
            report.add(Alarm::ConfigAuxAddress, report.line(handle, l) + ": A B C U V or W");
        for (const SpindleConfig& s : report.machine.spindles)
            if (s.exists() && get(report.table, n0817_spindle_axis_name1, s.number) == code &&
                get(report.table, n0818_spindle_axis_name2, s.number) == 0)
                report.add(Alarm::ConfigAuxAddress,
                           report.line(handle, l) + " and " +
                               report.line(n0817_spindle_axis_name1, s.number) + ": one letter");
    }
    const auto wait_low = get(report.table, n2201_waiting_m_codes_min),
               wait_high = get(report.table, n2202_waiting_m_codes_max);
    const std::string waits =
        report.line(n2201_waiting_m_codes_min) + ", " + report.line(n2202_waiting_m_codes_max);
    if (wait_high > 0 && wait_low <= wait_high) {
        for (unsigned n = 1; n <= 16; ++n) {
            const auto low = nth(n1341_m_gr_low_1, n), high = nth(n1357_m_gr_high_1, n);
            const auto from = get(report.table, low, l), to = get(report.table, high, l);
            if (to > 0 && from <= to && from <= wait_high && wait_low <= to)
                report.add(Alarm::ConfigCodes, report.line(low, l) + ", " + report.line(high, l) +
                                                   ": waiting codes are among them, " + waits);
        }
        if (const double code = get(report.table, n2305_part_count_m, l);
            code != 0 && code >= static_cast<double>(wait_low) &&
            code <= static_cast<double>(wait_high))
            report.add(Alarm::ConfigCodes,
                       report.line(n2305_part_count_m, l) + ": a waiting code, " + waits);
    }
    if (c.default_spindle != 0) {
        double fastest = 0;
        for (const GearRange& range : report.machine.spindle(c.default_spindle).range)
            fastest = std::max(fastest, range.max_rpm);
        if (static_cast<double>(get(report.table, n0688_min_spindle_speed_g96, l)) > fastest)
            report.add(Alarm::ConfigSpindleSpeed, report.line(n0688_min_spindle_speed_g96, l) +
                                                      ": S" + std::to_string(c.default_spindle) +
                                                      " is never that fast");
    }
    const auto input = [&](const auto& one, const auto& other) {
        if (get(report.table, one, l) != 0 &&
            get(report.table, one, l) == get(report.table, other, l))
            report.add(Alarm::ConfigSwitch, report.line(one, l) + " and " + report.line(other, l) +
                                                ": one input for two probes");
    };
    input(n3012_sensor_input_of_tool_setter_s1, n3013_sensor_input_of_tool_setter_s2);
}

}  // namespace

void check_together(Report& report) {
    for (const AxisConfig& x : report.machine.axes) {
        if (!x.exists()) continue;
        check_axis_kind(report, x.number);
        check_reference(report, x.number);
        check_loop(report, x.number);
    }
    for (const SpindleConfig& s : report.machine.spindles)
        if (s.exists()) check_spindle(report, s.number);
    for (const ChannelConfig& c : report.machine.channels)
        if (c.exists()) {
            check_room(report, c);
            check_channel(report, c);
        }
}

}  // namespace polyturn::config
