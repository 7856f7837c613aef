#include "channels/fanuc/settings.hpp"

#include <cmath>

namespace polyturn::channels::fanuc {

using namespace params;

// What fanuc and nct read from the same N parameters: the machine is its parameters, whatever
// language a channel speaks.
void common_settings(Settings& s, const Table& t, unsigned l) {
    s.power_on_g1 = bit(t, n1300_defaultg1, l, 0);
    const bool g18 = bit(t, n1300_defaultg1, l, 1), g19 = bit(t, n1300_defaultg1, l, 2);
    s.power_on_plane = g18 ? 1 : g19 ? 2 : 0;
    s.power_on_inch = bit(t, n1300_defaultg1, l, 3);
    s.power_on_incremental = bit(t, n1300_defaultg1, l, 7);
    s.power_on_per_revolution = bit(t, n1301_defaultg2, l, 0);
    s.arc_tolerance =
        get(t, n1339_radius_diff, l) * (bit(t, n0104_unit_of_measure, l, 0) ? 25.4 : 1.0);
    for (unsigned n = 1; n <= 10; ++n) {
        const auto code = static_cast<double>(get(t, nth(n1307_m_suppr_b1, n), l));
        if (code > 0) s.draining_m.emplace_back(code, code);
    }
    for (unsigned n = 1; n <= 8; ++n) {
        const auto low = static_cast<double>(get(t, nth(n1317_m_gr_low_suppr_b1, n), l));
        const auto high = static_cast<double>(get(t, nth(n1325_m_gr_high_suppr_b1, n), l));
        if (high > 0) s.draining_m.emplace_back(low, high);
    }
    for (unsigned spindle = 1; spindle <= kMaxSpindles; ++spindle) {
        const auto first = static_cast<double>(get(t, n0820_start_m_of_spnd_pos, spindle));
        const auto angle = static_cast<double>(get(t, n0822_basic_angle_of_spnd_pos, spindle));
        if (first <= 0 || angle <= 0 || !bit(t, n0607_spindle_config, spindle, 0) ||
            bit(t, n0607_spindle_config, spindle, 3))
            continue;
        s.indexing.push_back({spindle, first,
                              static_cast<double>(get(t, n0821_no_of_m_code_for_spnd_pos, spindle)),
                              bit(t, n0607_spindle_config, spindle, 7) ? -angle : angle});
    }
    for (unsigned spindle = 1; spindle <= kMaxSpindles; ++spindle) {
        const auto second = get(t, n0605_spindle_name2, spindle),
                   third = get(t, n0606_spindle_name3, spindle);
        if (second <= 0 || !bit(t, n0607_spindle_config, spindle, 0)) continue;
        s.spindle_names.push_back(
            {std::string("S") + static_cast<char>(second) +
                 (third > 0 ? std::string(1, static_cast<char>(third)) : std::string()),
             spindle});
    }
    for (unsigned spindle = 1; spindle <= kMaxSpindles; ++spindle) {
        const auto letter = get(t, n0817_spindle_axis_name1, spindle);
        if (letter < 'A' || letter > 'C' || !bit(t, n0607_spindle_config, spindle, 0)) continue;
        std::string name(1, static_cast<char>(letter));
        for (const auto code : {get(t, n0818_spindle_axis_name2, spindle),
                                get(t, n0819_spindle_axis_name3, spindle)}) {
            if (code <= 0) break;
            name += static_cast<char>(code);
        }
        s.spindle_addresses.push_back({std::move(name), spindle});
    }
    s.parts_made = get(t, n2307_no_of_machined_parts, l);
    s.parts_wanted = get(t, n2308_no_of_parts_reqrd, l);
    s.part_code = get(t, n2305_part_count_m, l);
    s.s_drains = bit(t, n1336_funct_suppr_b, l, 0);
    s.t_drains = bit(t, n1336_funct_suppr_b, l, 1);
    for (unsigned n = 0; n < 3; ++n) s.aux_drains[n] = bit(t, n1336_funct_suppr_b, l, 2 + n);
    for (unsigned n = 1; n <= 3; ++n)
        s.aux_letters[n - 1] = static_cast<char>(get(t, nth(n1333_aux_fu_addr1, n), l));
    for (unsigned n = 1; n <= 16; ++n) {
        const auto low = static_cast<double>(get(t, nth(n1341_m_gr_low_1, n), l)),
                   high = static_cast<double>(get(t, nth(n1357_m_gr_high_1, n), l));
        if (low != 0 || high != 0) s.m_groups.emplace_back(low, high);
    }
}

Settings fanuc_settings(const Table& t, unsigned l) {
    Settings s;
    common_settings(s, t, l);
    s.system = bit(t, f3401, l, 7) ? kC : bit(t, f3401, l, 6) ? kB : kA;
    s.point_means_nothing = bit(t, f3401, l, 0);
    s.series15 = bit(t, f0001, l, 1);
    s.tool.offset_digits = bit(t, f5002, l, 0) ? 1 : 2;
    s.tool.geometry_by_tool = bit(t, f5002, l, 1);
    s.tool.geometry_travels = bit(t, f5002, l, 4);
    s.tool.zero_cancels_geometry = bit(t, f5002, l, 5);
    s.tool.with_next_move = bit(t, f5002, l, 6);
    s.tool.tip_from_wear = bit(t, f5002, l, 7);
    s.needs_end_code = !bit(t, f3404, l, 6);
    s.stops_at_macros = bit(t, f6000, l, 5);
    s.drill_axis_by_plane = bit(t, f5101, l, 0);
    s.peck_full = bit(t, f5101, l, 2);
    s.r_absolute = s.series15 && bit(t, f5102, l, 6) && !bit(t, f5102, l, 3);
    s.r_in_diameter = s.series15 && bit(t, f5102, l, 7) && !bit(t, f5102, l, 3);
    s.chip_break_return = s.peck_clearance = static_cast<double>(get(t, f5114, l));
    s.compensation.entry =
        bit(t, f5003, l, 0) ? compensation::Entry::Around : compensation::Entry::Direct;
    s.compensation.resume_at_intersection = bit(t, f5003, l, 2);
    s.compensation.small_vector = std::fmax(get(t, f5010, l), compensation::kTangentialMm);
    s.measure_by_decimal = bit(t, f3405, l, 3);
    s.measure_feed = static_cast<double>(get(t, f6241, l));
    const auto or_x = [](double z, double x) { return z > 0 ? z : x; };
    const auto rapid_x = static_cast<double>(get(t, f6251, l)),
               range_x = static_cast<double>(get(t, f6254, l));
    s.measure_rapid = {rapid_x, rapid_x, or_x(static_cast<double>(get(t, f6252, l)), rapid_x)};
    s.measure_range = {range_x, range_x, or_x(static_cast<double>(get(t, f6255, l)), range_x)};
    s.angle_positive = !bit(t, f6004, l, 0);
    s.interrupt.at_block_end = bit(t, f6003, l, 2);
    s.interrupt.by_level = bit(t, f6003, l, 3);
    s.interrupt.own_locals = !bit(t, f6003, l, 5);
    if (bit(t, f6003, l, 4)) {
        if (const auto on = static_cast<double>(get(t, f6033, l)); on > 0) s.interrupt.on = on;
        if (const auto off = static_cast<double>(get(t, f6034, l)); off > 0) s.interrupt.off = off;
    }
    s.keeps_common = bit(t, f6001, l, 6);
    s.keeps_locals = bit(t, f6001, l, 7);
    s.keeps_offset = bit(t, f5003, l, 6);
    s.shows_tool_vector = !bit(t, f3104, l, 6);
    s.shows_nose = !bit(t, f3104, l, 7);
    s.shared_100 = get(t, f6036, l);
    s.shared_500 = get(t, f6037, l);
    s.print_compact = bit(t, f6001, l, 1);
    if (const auto device = get(t, f0020, l); device <= 2)
        s.print_line_end = bit(t,
                               device == 0   ? f0103
                               : device == 1 ? f0113
                                             : f0123,
                               l, 3)
                               ? "\n\r"
                               : "\n";
    s.managed_tools = s.group_calls = bit(t, n2900_tool_m_config, 0);
    s.t_calls = bit(t, f6001, l, 5);
    if (s.t_calls) s.letter_calls.push_back({'T', 9000, 149});
    for (unsigned n = 0; n < 10; ++n) {
        const auto g = static_cast<std::int32_t>(get(t, nth(f6050, n + 1), l));
        if (g != 0)
            s.g_calls.push_back({(g < 0 ? -g : g) * 10, static_cast<std::int32_t>(9010 + n), true,
                                 g < 0 ? std::uint8_t{1} : std::uint8_t{0}});
        const auto sub = static_cast<std::int32_t>(get(t, nth(f6070, n + 1), l));
        if (sub > 0) s.m_calls.push_back({sub, static_cast<std::int32_t>(9000 + n), false, 0});
        const auto macro = static_cast<std::int32_t>(get(t, nth(f6080, n + 1), l));
        if (macro > 0) s.m_calls.push_back({macro, static_cast<std::int32_t>(9020 + n), true, 0});
        const auto drain = static_cast<double>(get(t, nth(f3411, n + 1), l));
        if (drain > 0) s.draining_m.emplace_back(drain, drain);
    }
    s.common_last = 199;
    return s;
}

namespace {

// F8250 = 3: one B axis that several channels command (fanuc_lathe 10.4.5). It belongs to one of
// them (N0002), and is the last axis of the others.
void share_b_axis(MachineView& view) {
    const Table& t = view.table();
    if (get(t, f8250, view.channel) != 3) return;
    for (unsigned number = 1; number <= view.machine.last_axis && view.axis_by_name("B") < 0;
         ++number) {
        const AxisConfig& axis = view.machine.axis(number);
        if (axis.exists() && axis.name_text() == "B" && axis.channel >= 1 &&
            axis.channel != view.channel && get(t, f8250, axis.channel) == 3)
            add_axis(view, number);
    }
    if (const int b = view.axis_by_name("B"); b >= 0) view.own_programs = AxisSet{1} << b;
}

}  // namespace

void fanuc_axes(MachineView& view) {
    share_b_axis(view);
    fanuc_rollover(view);
}

// F1008, F1260: roll-over as a fanuc machine is set up for it (fanuc_lathe 10.2); N0107 is the nct
// control's. What a transformation or a factor has taken from an axis for its time stays taken.
void fanuc_rollover(MachineView& view) {
    const Table& t = view.table();
    for (unsigned i = 0; i < view.axis_count; ++i) {
        ChannelAxis& axis = view.axes[i];
        const unsigned a = axis.machine_axis + 1u;
        if (!axis.rotary || axis.turns || axis.counts_on) continue;
        axis.rollover = bit(t, f1008, a, 0);
        if (!axis.rollover) continue;
        axis.rollover_shortest = !bit(t, f1008, a, 1);
        // RAB: the sign gives the direction, the target is the word modulo F1260 all the same
        axis.rollover_sign_is_direction = false;
        axis.rollover_reduces_increments = false;
        if (const auto period = static_cast<double>(get(t, f1260, a)); period > 0)
            axis.rollover_deg = period;
    }
}

}  // namespace polyturn::channels::fanuc
