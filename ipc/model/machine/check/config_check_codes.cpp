// Codes and switches of a channel: ranges of M codes that end before they begin, groups that share
// a code, position switches.
#include <string>
#include <string_view>

#include "ipc/model/machine/check/config_report.hpp"

namespace polyturn::config {
namespace {

using namespace params;

constexpr unsigned kMGroups = 16, kSuppressRanges = 8, kSwitches = 32, kAuxLetters = 3,
                   kCallingLetters = 4;

// N1341 to N1372: two codes of one group in a block are refused, so no code may be in two groups.
void check_groups(Report& report, unsigned l) {
    for (unsigned n = 1; n <= kMGroups; ++n) {
        const auto low = nth(n1341_m_gr_low_1, n), high = nth(n1357_m_gr_high_1, n);
        const auto from = get(report.table, low, l), to = get(report.table, high, l);
        if (from == 0 && to == 0) continue;
        if (from > to) {
            report.add(Alarm::ConfigCodes, report.line(low, l) + " above " + report.line(high, l));
            continue;
        }
        for (unsigned k = 1; k < n; ++k) {
            const auto other_low = nth(n1341_m_gr_low_1, k);
            const auto other_from = get(report.table, other_low, l),
                       other_to = get(report.table, nth(n1357_m_gr_high_1, k), l);
            if ((other_from == 0 && other_to == 0) || other_from > other_to || other_to < from ||
                to < other_from)
                continue;
            report.add(Alarm::ConfigCodes, report.line(other_low, l) + " and " +
                                               report.line(low, l) + ": their groups overlap");
        }
    }
}

void check_suppression(Report& report, unsigned l) {
    for (unsigned n = 1; n <= kSuppressRanges; ++n) {
        const auto low = nth(n1317_m_gr_low_suppr_b1, n), high = nth(n1325_m_gr_high_suppr_b1, n);
        if (get(report.table, low, l) > get(report.table, high, l))
            report.add(Alarm::ConfigCodes, report.line(low, l) + " above " + report.line(high, l));
    }
}

void check_letters(Report& report, unsigned l) {
    for (unsigned n = 2; n <= kAuxLetters; ++n)
        for (unsigned k = 1; k < n; ++k) {
            const auto one = nth(n1333_aux_fu_addr1, k), two = nth(n1333_aux_fu_addr1, n);
            if (get(report.table, one, l) != 0 &&
                get(report.table, one, l) == get(report.table, two, l))
                report.add(
                    Alarm::ConfigAuxAddress,
                    report.line(one, l) + " and " + report.line(two, l) + " are the same letter");
        }
}

// part 2, 18.4: the letters that can call a program; the others have a meaning in the block itself.
void check_calling_letters(Report& report, unsigned l) {
    constexpr std::string_view kMayCall = "DEFHIJKQRUVWXYZ";
    for (unsigned n = 1; n <= kCallingLetters; ++n) {
        const auto letter = nth(n1747_ascii_code_subp1, n);
        const auto code = get(report.table, letter, l);
        if (code != 0 && (code < 'A' || code > 'Z' ||
                          kMayCall.find(static_cast<char>(code)) == std::string_view::npos))
            report.add(Alarm::ParamRange,
                       report.line(letter, l) + ": not one of " + std::string(kMayCall));
    }
}

// part 2, 18.1: what a program may not write lies within #500 to #999.
void check_protected_variables(Report& report, unsigned l) {
    const auto low = get(report.table, n1702_write_prt_low, l),
               high = get(report.table, n1703_write_prt_hig, l);
    if (low == 0 && high == 0) return;
    if (low < 500)
        report.add(Alarm::ParamRange,
                   report.line(n1702_write_prt_low, l) + ": outside #500 to #999");
    else if (low > high)
        report.add(Alarm::ParamRange, report.line(n1702_write_prt_low, l) + " above " +
                                          report.line(n1703_write_prt_hig, l));
}

}  // namespace

void check_codes(Report& report) {
    for (const ChannelConfig& c : report.machine.channels) {
        if (!c.exists()) continue;
        check_groups(report, c.number);
        check_suppression(report, c.number);
        check_letters(report, c.number);
        check_calling_letters(report, c.number);
        check_protected_variables(report, c.number);
    }
    for (const SpindleConfig& s : report.machine.spindles)
        if (s.exists() && get(report.table, n0689_spindle_m_low, s.number) >
                              get(report.table, n0690_spindle_m_high, s.number))
            report.add(Alarm::ConfigCodes, report.line(n0689_spindle_m_low, s.number) + " above " +
                                               report.line(n0690_spindle_m_high, s.number));
}

void check_switches(Report& report) {
    for (unsigned n = 1; n <= kSwitches; ++n) {
        const auto axis = nth(n1101_sw1_axis_number, n);
        const auto low = nth(n1133_sw1_min_pos, n), high = nth(n1165_sw1_max_pos, n);
        const auto number = get(report.table, axis);
        if (number == 0) continue;
        if (number > static_cast<std::int64_t>(kMaxAxes) ||
            !report.machine.axis(static_cast<std::size_t>(number)).exists())
            report.add(Alarm::ConfigSwitch,
                       report.line(axis) + ": A" + std::to_string(number) + " does not exist");
        else if (get(report.table, low) > get(report.table, high))
            report.add(Alarm::ConfigSwitch, report.line(low) + " above " + report.line(high));
    }
}

}  // namespace polyturn::config
