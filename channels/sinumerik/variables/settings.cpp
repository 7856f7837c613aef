#include "channels/sinumerik/variables/settings.hpp"

namespace polyturn::channels::sinumerik {

Settings read_settings(const params::Table& table, const MachineView& view) {
    using namespace params;
    const unsigned l = view.channel;
    Settings s;
    for (unsigned g = 0; g < 64; ++g) {
        s.g_reset[g] = static_cast<std::uint8_t>(get(table, md20150, l, g));
        s.g_keep[g] = get(table, md20152, l, g) != 0;
    }
    s.metric_base = get(table, md10240) != 0;
    const std::int64_t number = get(table, md20100, l);  // 0: the X of the planes, as on a lathe
    if (number == 0)
        s.diameter_axis = view.axis_by_role(PlaneRole::BasicX);
    else if (number <= static_cast<std::int64_t>(view.axis_count))
        s.diameter_axis = static_cast<int>(number - 1);
    s.tool_by_m6 = get(table, md22550, l) != 0;
    s.tool_change_m = get(table, md22560, l);
    s.default_edge = static_cast<int>(get(table, md20270, l));
    s.tool_checked_late = (get(table, md22562, l) & 0x80) != 0;
    s.frames = static_cast<int>(get(table, md28080, l));
    s.r_parameters = static_cast<int>(get(table, md28050, l));
    s.length_const = static_cast<int>(get(table, sd42940, l));
    s.length_type = static_cast<int>(get(table, sd42950, l));
    s.zero_travels = get(table, sd42440, l) != 0;
    s.tool_travels = get(table, sd42442, l) != 0;
    s.circle_error_mm = get(table, md21000, l);
    s.circle_error_factor = get(table, md21010, l);
    s.mirror_toggle = get(table, md10612) != 0;
    s.corner_alarm = (get(table, md11411) & 16) != 0;
    s.corner_idle_blocks = static_cast<int>(get(table, md20200, l));
    s.corner_from_this = (get(table, md20201, l) & 1) != 0;
    s.corner_limit_deg = get(table, md20210, l);
    s.comp_idle_blocks = static_cast<int>(get(table, md20250, l));
    s.comp_known_blocks = static_cast<int>(get(table, md20240, l));
    s.highest_disc = static_cast<double>(get(table, md20220, l));
    s.comp_closed_start = get(table, sd42496, l) != 0;
    s.euler_angles = get(table, md10600) == 0;
    s.fine_translation = get(table, md24000, l) != 0;
    for (unsigned i = 0; i < view.axis_count; ++i) {
        const unsigned a = view.axes[i].machine_axis;
        s.area_plus[a] = get(table, sd43400, a + 1) != 0;
        s.area_minus[a] = get(table, sd43410, a + 1) != 0;
        s.area_high[a] = get(table, sd43420, a + 1);
        s.area_low[a] = get(table, sd43430, a + 1);
    }
    s.thread_start_deg = get(table, sd42000, l);
    s.involute_error_mm = get(table, md21015, l);
    s.approach_slack_mm = get(table, md20204, l);
    s.lift_distance_mm = get(table, md21200, l);
    s.area_with_radius = get(table, md21020, l) != 0;
    s.mirror_reference = static_cast<int>(get(table, md10610));
    s.dwell_cycle_s = (get(table, md10280) & 16) != 0 ? get(table, md10071) : 0.0;
    s.corner_names = {std::string(get_text(table, md10652)), std::string(get_text(table, md10654)),
                      std::string(get_text(table, md10656))};
    return s;
}

}  // namespace polyturn::channels::sinumerik
