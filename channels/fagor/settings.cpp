#include "channels/fagor/settings.hpp"

#include "ipc/model/languages/fagor_diameter.hpp"

namespace polyturn::channels::fagor {

using namespace params;

Settings read_settings(const Table& t, unsigned l) {
    Settings s;
    const auto on = [&](auto handle) { return get(t, handle, l) != 0; };
    const auto whole = [&](auto handle) { return static_cast<std::int32_t>(get(t, handle, l)); };
    s.g17 = !on(fg_iplane);
    s.inch = on(fg_inches);
    s.incremental = on(fg_isystem);
    s.g1 = on(fg_imove);
    s.per_revolution = on(fg_ifeed);
    s.round_corner = on(fg_icorner);
    s.polar_origin_moves = on(fg_porgmove);
    s.homing_subroutine = whole(fg_refpsub);
    s.arc_tolerance = get(t, fg_cirinerr, l);
    s.offsets = whole(fg_ntoffset);
    s.change_by_m06 = on(fg_toffm06);
    s.geometry_by_offset = on(fg_geomtype);
    s.comp_mode = whole(fg_compmode);
    s.comp_every_plane = on(fg_placom);
    s.probe_override = on(fg_fovrg75);
    s.probe_error = on(fg_proberr);
    for (unsigned n = 0; n < 4; ++n) {
        static constexpr decltype(fg_int1sub) kSubs[] = {fg_int1sub, fg_int2sub, fg_int3sub,
                                                         fg_int4sub};
        s.interrupt_subroutine[n] = whole(kSubs[n]);
    }
    s.look_ahead_kind = whole(fg_lookatyp);
    s.interpolation_period = whole(fg_ipotime);
    s.inclined_axis = whole(fg_angaxna);
    s.orthogonal_axis = whole(fg_ortaxna);
    s.inclined_deg = get(t, fg_angantr, l);
    s.inclined_origin = get(t, fg_offangax, l);
    s.override_max = static_cast<double>(get(t, fg_maxfovr, l));
    for (unsigned n = 0; n < fg_mfun.array; ++n) {
        const auto code = static_cast<std::int32_t>(get(t, fg_mfun, l, n));
        if (code < 0) continue;
        const auto flags = static_cast<unsigned>(get(t, fg_mflags, l, n));
        s.m_table.push_back({code, static_cast<std::int32_t>(get(t, fg_msub, l, n)),
                             (flags & 2u) != 0, (flags & 4u) != 0, (flags & 8u) != 0,
                             (flags & 1u) != 0});
    }
    if (const auto spindle = static_cast<unsigned>(get(t, n0604_default_spindle, l));
        spindle >= 1 && spindle <= kMaxSpindles) {
        s.thread_angle = get(t, fg_m19type, spindle) != 0;
        s.gear_automatic = get(t, fg_autogear, spindle) != 0;
        static constexpr decltype(fg_maxgear1) kGears[] = {fg_maxgear1, fg_maxgear2, fg_maxgear3,
                                                           fg_maxgear4};
        for (std::size_t n = 0; n < 4; ++n) s.gear_max[n] = get(t, kGears[n], spindle);
        s.spindle_override_min = static_cast<double>(get(t, fg_minsovr, spindle));
        s.spindle_override_max = static_cast<double>(get(t, fg_maxsovr, spindle));
    }
    return s;
}

void prepare_axes(MachineView& view) {
    view.tables_in_radius = true;
    for (unsigned i = 0; i < view.axis_count; ++i) {
        ChannelAxis& axis = view.axes[i];
        const unsigned a = axis.machine_axis + 1u;
        axis.diameter = fagor_shows_diameter(view.table(), a, axis.diameter);
        if (!axis.rotary || !axis.rollover) continue;
        const auto type = get(view.table(), fg_axistype, a);
        // positioning axes and Hirth: the shortest way
        axis.rollover_shortest = type >= 3;
        // otherwise the sign is the direction (3.7)
        axis.rollover_sign_is_direction = type < 3;
        axis.rollover_reduces_increments = false;
    }
}

}  // namespace polyturn::channels::fagor
