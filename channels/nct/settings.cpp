#include "channels/nct/settings.hpp"

#include <cmath>
#include <cstdlib>

#include "ipc/model/compensation/compensation_tables.hpp"

namespace polyturn::channels::nct {

using namespace params;

namespace {

// A run of codes that call a run of programs; a negative start makes the calls modal.
void add_run(std::vector<fanuc::CodeCall>& calls, double start, std::int64_t program,
             std::int64_t count, std::int32_t scale, std::int32_t step, bool macro,
             std::uint8_t modal) {
    for (std::int64_t k = 0; k < count && k < 1000; ++k)
        calls.push_back(
            {static_cast<std::int32_t>(std::llround(std::fabs(start) * scale) + k * step),
             static_cast<std::int32_t>(program + k), macro, start < 0 ? modal : std::uint8_t{0}});
}

fanuc::Policy nct_policy() {
    fanuc::Policy p;
    p.words.systems_by_bits = false;
    p.words.g183_is_g83_1 = true;
    p.words.rounds_codes = p.words.rounds_to_increment = false;
    p.words.whole_factors = p.words.whole_rotation = p.words.whole_dwell =
        p.words.whole_start_angle = p.words.dwell_with_point = true;
    p.macro.variable_names = p.macro.short_constants = p.macro.pattern_data = false;
    p.macro.codes_lead_calls = p.macro.alarms_to_200 = p.macro.inputs_ahead = false;
    p.macro.arguments_anywhere = p.macro.letters_keep_theirs = true;
    p.macro.alarm_of_macro_depth = p.macro.groups_of_nct = true;
    p.macro.last_output = 1131;
    p.macro.last_wide_output = 1135;
    p.program.recalls = p.program.interrupts_ahead = p.program.counts_before_number = false;
    p.program.b_axis = p.program.life_groups = false;
    p.program.keeps_groups = p.program.starts_away = p.program.interrupted_by_mint = true;
    p.motion.lathe_corners = p.motion.corners_at_right_angles = p.motion.loose_arcs = false;
    p.motion.side_at_begin = false;
    p.motion.arc_radius_of_any_sign = p.motion.polar_not_in_yz = true;
    p.motion.g30_counts_further = p.motion.diameter_by_axis = true;
    p.measuring.decimal_codes = p.measuring.nose_centre = false;
    p.measuring.torque_by_q = p.measuring.along_y = p.measuring.input_by_number =
        p.measuring.distances_of_mills = true;
    p.cycles.divisions_with_point = false;
    p.cycles.first_block_once = p.cycles.goes_on_with_contour = p.cycles.taper_by_centre =
        p.cycles.first_pocket_by_n1611 = p.cycles.divides_by_passes = true;
    p.drilling = {.along_plane = true,
                  .every_cycle = true,
                  .own_words = true,
                  .retract_word = true,
                  .bores_back = true,
                  .r_by_distance = true,
                  .repeats_by_l = true,
                  .pecks_by_code = true,
                  .rigid_by_code = true,
                  .dwells_at_r = false};
    p.spindles.polygon_holds_axis = p.spindles.polygon_alone = false;
    p.spindles.surface_axis_of_machine = p.spindles.watch_seconds = true;
    p.spindles.watch_limit = 'D';
    p.spindles.foreign_limit = 'I';
    p.tools.nose_needs_offset = p.tools.radius_by_c = p.tools.offsets_by_digits = false;
    p.tools.zero_keeps_tool = p.tools.offsets_of_mills = true;
    p.tools.parameters = 'N';
    p.tools.last_cell = kLastCell;
    p.tools.parameters_in_increments = p.tools.rollover_by_f1008 = false;
    p.tools.parameter_with_point = p.tools.stroke_by_n1000 = true;
    return p;
}

}  // namespace

fanuc::Settings nct_settings(const Table& t, unsigned l) {
    fanuc::Settings s;
    fanuc::common_settings(s, t, l);
    s.system = fanuc::kN;
    s.dialect = Dialect::Nct;
    s.policy = nct_policy();
    // the examples of nct part 1 3.5, part 2 22.2 and 22.4: B380, Z5, X-30 are whole degrees and
    // millimetres
    s.point_means_nothing = true;
    s.tool.offset_digits =
        static_cast<unsigned>(get(t, n1413_no_of_digits_of_offs_no_in_t_code, l));
    s.tool.geometry_by_tool = bit(t, n1414_comp_config_on_lathes, l, 1);
    s.tool.tip_from_wear = s.tool.geometry_by_tool && !bit(t, n1414_comp_config_on_lathes, l, 2);
    s.tool.zero_cancels_geometry = bit(t, n1414_comp_config_on_lathes, l, 3);
    s.tool.wear_travels = false;
    s.tool.with_next_move = true;
    s.centre_absolute = bit(t, n1337_execution_config, l, 2);
    s.dwell_by_feed_mode = !bit(t, n1337_execution_config, l, 1);
    s.dwell_p_milliseconds = false;
    s.helix_in_plane = !bit(t, n1337_execution_config, l, 3);
    s.shifts_when_away = bit(t, n1337_execution_config, l, 5);
    s.skip_sign_drains = !bit(t, n1337_execution_config, l, 4);
    const double unit = bit(t, n0104_unit_of_measure, l, 0) ? 25.4 : 1.0;
    s.compensation.look_back_blocks = static_cast<unsigned>(get(t, n1404_bk_no_interf, l));
    s.compensation.check = !bit(t, n1403_interference, l, 0)  ? compensation::Check::Off
                           : bit(t, n1403_interference, l, 1) ? compensation::Check::Alarm
                                                              : compensation::Check::Correct;
    s.compensation.small_vector =
        std::fmax(get(t, n1405_deltv, l) * unit, compensation::kTangentialMm);
    s.compensation.corner_feed = {get(t, n1407_decdist, l) * unit, get(t, n1408_accdist, l) * unit,
                                  get(t, n1409_cornangle, l), get(t, n1410_cornover, l)};
    s.compensation.inner_arc_feed_from = get(t, n1406_circover, l);
    s.chip_break_return = get(t, n1500_return_val_g73, l) * unit;
    s.peck_clearance = get(t, n1501_clearance_val_g83, l) * unit;
    if (const auto percent = static_cast<double>(get(t, n1502_extraction_override_in_g85_g89, l));
        percent > 0)
        s.bore_out_factor = percent / 100.0;
    if (bit(t, n3001_g31_config, l, 0)) s.skip_feed = get(t, n0311_g31_feed, l) * unit;
    if (bit(t, n3003_g36_g37_config, l, 0)) s.measure_feed = get(t, n0312_g37_feed, l) * unit;
    s.measure_to_wear = bit(t, n3003_g36_g37_config, l, 1);
    s.measure_added = bit(t, n3003_g36_g37_config, l, 2);
    s.measure_input = static_cast<int>(get(t, n3002_sensor_input_of_g36_g37, l));
    for (unsigned n = 0; n < 3; ++n) {
        static constexpr auto kRapid = {n3006_rapid_distance_x, n3008_rapid_distance_y,
                                        n3010_rapid_distance_z};
        static constexpr auto kRange = {n3007_alarm_distance_x, n3009_alarm_distance_y,
                                        n3011_alarm_distance_z};
        s.measure_rapid[n] = get(t, kRapid.begin()[n], l) * unit;
        s.measure_range[n] = get(t, kRange.begin()[n], l) * unit;
    }
    s.feed_per_minute = get(t, n0300_default_f_g94, l) * unit;
    s.feed_per_revolution = get(t, n0301_default_f_g95, l) * unit;
    s.surface_speed = static_cast<double>(get(t, n0686_default_surf_speed, l)) *
                      (bit(t, n0104_unit_of_measure, l, 0) ? 0.3048 : 1.0);
    if (const auto first = get(t, n1702_write_prt_low, l); first >= 500) {
        s.protected_first = first;
        s.protected_last = get(t, n1703_write_prt_hig, l);
    }
    const bool mill = get(t, n0001_control_type, l) == 1;
    // where G43 and G44 exist
    const bool lengths = mill || (bit(t, n1414_comp_config_on_lathes, l, 0) &&
                                  bit(t, n1414_comp_config_on_lathes, l, 6));
    if (lengths)
        s.power_on_length = bit(t, n1300_defaultg1, l, 5)   ? 430
                            : bit(t, n1300_defaultg1, l, 6) ? 440
                                                            : 0;
    s.offsets_by_g = mill || bit(t, n1414_comp_config_on_lathes, l, 0);
    s.keeps_offset = !bit(t, n1414_comp_config_on_lathes, l, 5);
    s.offsets_turn = !bit(t, n1414_comp_config_on_lathes, l, 7);
    s.second_geometry = bit(t, n1414_comp_config_on_lathes, l, 4);
    s.milling_drills = mill && !bit(t, n1503_drilling_cycles_config, l, 0) &&
                       !bit(t, n1611_turning_cyc_config, l, 0);
    s.tapping.orients = bit(t, n1503_drilling_cycles_config, l, 1);
    s.tapping.feedforward = bit(t, n1503_drilling_cycles_config, l, 2);
    s.tapping.own_acceleration_out = bit(t, n1503_drilling_cycles_config, l, 6);
    s.tapping.leaves_hole = bit(t, n1503_drilling_cycles_config, l, 3);
    s.tapping.chip_break = get(t, n1504_return_val_in_tapping, l) * unit;
    s.tapping.clearance = get(t, n1505_clearance_val_in_tapping, l) * unit;
    const auto share = [](double percent) { return percent > 0 ? percent / 100.0 : 1.0; };
    s.tapping.word_i = bit(t, n1503_drilling_cycles_config, l, 4);
    if (s.tapping.word_i)
        s.tapping.out_factor =
            share(static_cast<double>(get(t, n1506_extraction_override_in_tapping, l)));
    if (bit(t, n1503_drilling_cycles_config, l, 5))
        s.tapping.return_factor =
            share(static_cast<double>(get(t, n1507_return_override_in_tapping, l)));
    if (const auto spindle = static_cast<unsigned>(get(t, n0604_default_spindle, l));
        spindle >= 1 && spindle <= kMaxSpindles)
        s.tapping.code = static_cast<double>(get(t, n0823_m_code_for_closing_s_loop, spindle));
    if (!bit(t, n1758_intrrt_contr, l, 0)) {
        s.interrupt.on = s.interrupt.off = -1;
    } else if (bit(t, n1758_intrrt_contr, l, 4)) {
        s.interrupt.on = static_cast<double>(get(t, n1759_m_code_mi_on, l));
        s.interrupt.off = static_cast<double>(get(t, n1760_m_code_mi_off, l));
    }
    s.interrupt.own_locals = !bit(t, n1758_intrrt_contr, l, 1);
    s.interrupt.at_block_end = bit(t, n1758_intrrt_contr, l, 2);
    s.interrupt.by_level = !bit(t, n1758_intrrt_contr, l, 3);
    s.shared_100 = get(t, n1700_no_of_common_100);
    s.shared_500 = get(t, n1701_no_of_common_500);
    s.print_compact = bit(t, n1757_print_contr, l, 0);
    s.print_parity = true;
    s.managed_tools = bit(t, n2900_tool_m_config, 0);
    s.managed_offset_code = s.managed_tools ? get(t, n2923_no_of_offset_code, l) : 0;
    s.place_code = s.managed_tools ? get(t, n2924_m_code_of_particular_t, l) : 0;
    s.sub_levels = 16;
    s.common_last = 499;
    s.angle_positive = false;
    const std::uint8_t modal = bit(t, n1755_macro_contr, l, 0) ? 2 : 1;
    s.nested_calls = bit(t, n1755_macro_contr, l, 1);
    s.stops_at_macros = bit(t, n1755_macro_contr, l, 2);
    s.positions_programmed = bit(t, n1755_macro_contr, l, 5);
    s.positions_with_length = !bit(t, n1755_macro_contr, l, 6);
    s.hidden_programs =
        (bit(t, n1756_list_contr, l, 0) ? 0u : 1u) | (bit(t, n1756_list_contr, l, 1) ? 0u : 2u);
    for (unsigned n = 0; n < 10; ++n) {
        const auto g = get(t, nth(n1704_g_9010, n + 1), l);
        if (g != 0)
            s.g_calls.push_back(
                {static_cast<std::int32_t>(std::llabs(g) == 1000 ? 0 : std::llabs(g) * 10),
                 static_cast<std::int32_t>(9010 + n), true, g < 0 ? modal : std::uint8_t{0}});
        const auto sub = get(t, nth(n1720_m_9000, n + 1), l);
        if (sub > 0)
            s.m_calls.push_back(
                {static_cast<std::int32_t>(sub), static_cast<std::int32_t>(9000 + n), false, 0});
        const auto macro = get(t, nth(n1733_m_9020, n + 1), l);
        if (macro > 0)
            s.m_calls.push_back(
                {static_cast<std::int32_t>(macro), static_cast<std::int32_t>(9020 + n), true, 0});
    }
    add_run(s.g_calls, static_cast<double>(get(t, n1714_start_g_macro, l)),
            get(t, n1715_start_prg_no, l), get(t, n1716_no_of_g_codes, l), 10, 10, true, modal);
    add_run(s.g_calls, static_cast<double>(get(t, n1717_start_dec_g_macro, l)),
            get(t, n1718_start_prg_no_dec_g, l), get(t, n1719_no_of_dec_g_codes, l), 10, 1, true,
            modal);
    add_run(s.m_calls, static_cast<double>(get(t, n1730_start_m_subp, l)),
            get(t, n1731_start_prg_no_m_subp, l), get(t, n1732_no_of_m_codes, l), 1, 1, false, 0);
    add_run(s.m_calls, static_cast<double>(get(t, n1743_start_m_macro, l)),
            get(t, n1744_start_prg_no_m_macro, l), get(t, n1745_no_of_m_macro_codes, l), 1, 1, true,
            0);
    static constexpr char kLetters[] = {'A', 'B', 'C', 'S', 'T'};
    for (unsigned n = 0; n < 5; ++n)
        if (bit(t, n1746_abcst, l, n))
            s.letter_calls.push_back({kLetters[n], static_cast<std::int32_t>(9030 + n),
                                      static_cast<std::int32_t>(195 + n)});
    for (unsigned n = 0; n < 4; ++n) {
        const auto letter = get(t, nth(n1747_ascii_code_subp1, n + 1), l);
        const auto program = get(t, nth(n1751_prg_no_ascii_call1, n + 1), l);
        if (letter >= 'A' && letter <= 'Z' && program > 0)
            s.letter_calls.push_back({static_cast<char>(letter), static_cast<std::int32_t>(program),
                                      static_cast<std::int32_t>(191 + n)});
    }
    return s;
}

}  // namespace polyturn::channels::nct
