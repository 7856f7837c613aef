// Ways away from the contour: of a held thread, of an interrupted block.
#include "channels/sinumerik/geometry/lifting.hpp"

#include <cmath>

#include "channels/compensation/options.hpp"
#include "channels/sinumerik/axes/axis_names.hpp"
#include "channels/sinumerik/axes/axis_words.hpp"
#include "channels/sinumerik/execution.hpp"
#include "channels/sinumerik/faults.hpp"
#include "channels/sinumerik/geometry/geo_motion.hpp"
#include "channels/sinumerik/geometry/travel_limits.hpp"
#include "channels/sinumerik/grammar/groups.hpp"
#include "ipc/image/interrupt_inputs.hpp"

namespace polyturn::channels::sinumerik {
namespace {

// Which way of this axis leads from the cutting edge into the tool, and so off the workpiece: the
// position of the edge (DP2) says where its point lies seen from the middle of the nose (part 1,
// 6.4; part 2, 11.1), in the axes of G18 as they are without a frame. 0: it does not tell, or a
// frame turns the axis aside.
double away_from_edge(const Execution& x, std::size_t across) {
    const std::int32_t position = x.core.path.tool.tip;
    if (x.core.path.plane != Plane::ZX || position < 1 || position > 8) return 0.0;
    const auto& [along_z, along_x] = compensation::kTips[static_cast<std::size_t>(position)];
    const double off = -(x.core.view().axes[across].role == PlaneRole::BasicZ ? along_z : along_x);
    AxisValues ahead = x.core.path.programmed;
    ahead[across] += 1.0;
    const AxisValues here = x.core.framed(x.core.path.programmed), there = x.core.framed(ahead);
    for (unsigned i = 0; i < x.core.view().axis_count; ++i)
        if (i != across && std::fabs(there[i] - here[i]) > 1e-6) return 0.0;
    return there[across] < here[across] ? -off : off;
}

}  // namespace

// LIFTFAST: before the routine the tool leaves the contour in rapid, with the words of the thread's
// retraction (sinumerik_part2 10.10.4): DILF, ALF, LFTXT, LFWP, or to POLF by LFPOS. `begin`: where
// the interrupted block began, which gives the tangent.
bool lift_from_contour(Execution& x, const AxisValues& begin) {
    AxisValues target = x.core.path.programmed;
    const auto leave = [&](std::size_t place, double by) { target[place] += by; };
    if (active(x, 46) == 3) {
        lift_to_positions(x, leave);
    } else {
        const auto [p, q] = plane_places(x);
        const double by_p = target[p] - begin[p], by_q = target[q] - begin[q];
        const bool along_p = std::fabs(by_p) >= std::fabs(by_q);
        if (!lift_in_plane(x, along_p ? p : q, (along_p ? by_p : by_q) < 0 ? -1.0 : 1.0,
                           LiftSide::FromEdge, leave))
            return false;
    }
    if (target == x.core.path.programmed) return true;
    x.names.system["$AC_LIFTFAST"] = Value::of_int(1);
    return within_areas(x, target) && x.core.rapid(target);
}
void lift_to_positions(const Execution& x, const LeaveBy& leave) {
    const GeoModal& geo = x.modal.geo;
    for (unsigned i = 0; i < x.core.view().axis_count; ++i)
        if (geo.lift_axes & geo.lift_set & 1u << i)
            leave(i, geo.lift_incremental >> i & 1u ? geo.lift_to[i]
                                                    : geo.lift_to[i] - x.core.path.programmed[i]);
}

// `along`: the axis of the plane that the path follows, in the direction `on`.
bool lift_in_plane(Execution& x, std::size_t along, double on, LiftSide side,
                   const LeaveBy& leave) {
    const GeoModal& geo = x.modal.geo;
    if (geo.lift_angle == 0 || !needs_plane(x)) return geo.lift_angle == 0;
    const auto [p, q] = plane_places(x);
    const double way = geo.lift_mm >= 0 ? geo.lift_mm : x.settings.lift_distance_mm;
    const double angle = (geo.lift_angle - 1.0) * 45.0 * 3.14159265358979323846 / 180.0;
    if (active(x, 46) == 2) {  // from the first axis of the plane towards the second
        leave(p, way * std::cos(angle));
        leave(q, way * std::sin(angle));
        return true;
    }
    const std::size_t across = along == p ? q : p;
    // a thread: back against the infeed
    double away = x.core.path.last_travel[across] > 0 ? -1.0 : 1.0;
    if (side == LiftSide::FromEdge) {
        // On a contour the last way of that axis may have led along a shoulder, away from the work.
        away = away_from_edge(x, across);
        if (away == 0.0)
            return fail(x, Alarm::NotBuilt,
                        "LIFTFAST LFTXT: $TC_DP2=" + std::to_string(x.core.path.tool.tip));
    }
    leave(across, away * way * std::cos(angle));
    leave(along, on * way * std::sin(angle));
    return true;
}
// POLF[axis]: where it goes when a thread is held; workpiece coordinates, or the way with IC.
bool a_lift_position(Execution& x, const Word& word) {
    GeoModal& geo = x.modal.geo;
    const auto i = static_cast<std::size_t>(word.axis);
    const bool incremental = is_incremental(x, word);
    geo.lift_to[i] = length_mm(x, word, word.axis, incremental);
    geo.lift_set |= 1u << i;
    geo.lift_incremental =
        incremental ? geo.lift_incremental | 1u << i : geo.lift_incremental & ~(1u << i);
    return true;
}
bool p_lift_axes(Execution& x, Call& c) {  // POLFMASK, POLFMLIN
    const std::string_view name = x.block.procedures.front().first->name;
    x.modal.geo.lift_axes = 0;
    for (std::size_t k = 0; k < c.arguments.size(); ++k) {
        std::size_t place = 0;
        if (!axis_argument(x, c, k, name, place)) return false;
        x.modal.geo.lift_axes |= 1u << place;
    }
    return true;
}
}  // namespace polyturn::channels::sinumerik
