// Arcs: by centre, radius, opening angle, polar words, intermediate point, tangent; helices
// (sinumerik_part1 10.6, 10.7).
#include "channels/sinumerik/geometry/geo_arcs.hpp"

#include <cmath>

#include "channels/angles.hpp"
#include "channels/sinumerik/axes/axis_words.hpp"
#include "channels/sinumerik/coupling/coupled_axes.hpp"
#include "channels/sinumerik/coupling/tangential_axis.hpp"
#include "channels/sinumerik/execution.hpp"
#include "channels/sinumerik/faults.hpp"
#include "channels/sinumerik/geometry/geo_approach.hpp"
#include "channels/sinumerik/geometry/geo_curves.hpp"
#include "channels/sinumerik/geometry/geo_motion.hpp"
#include "channels/sinumerik/geometry/travel_limits.hpp"
#include "channels/sinumerik/geometry/units.hpp"
#include "channels/sinumerik/grammar/words.hpp"

namespace polyturn::channels::sinumerik {
namespace {

constexpr double kSameArc = 1e-9;
// by plane: XY ZX YZ
constexpr std::string_view kCentre[3][2] = {{"I", "J"}, {"K", "I"}, {"J", "K"}};

// Every arc of the language comes by here; its centre is in workpiece coordinates.
bool go_arc(Execution& x, const AxisValues& wanted, const ArcCall& call) {
    AxisValues target = wanted;
    if (!arc_within_areas(x, target, call) || !tangential_arc(x, target, call)) return false;
    if (leads(x, target) != nullptr || (!frame_keeps_circles(x) && !arc_lies_inclined(x)))
        return drawn_arc(x, target, call);
    const auto [p, q] = plane_places(x);
    if (bool taken = false; x.modal.geo.approach) {
        if (!finish_approach(x, target, &call, taken)) return false;
        // an arc does not say where the contour begins
        if (taken) return fail(x, Alarm::ApproachNoEnd);
    }
    if (!corner_words(x, true) || !x.core.arc(target, call)) return false;
    const double up = target[p] - call.centre_p, uq = target[q] - call.centre_q;
    const double turn = call.clockwise ? -1.0 : 1.0;
    const auto geo = [&](std::size_t place) -> std::size_t {
        const PlaneRole role = x.core.view().axes[place].role;
        return role == PlaneRole::BasicX ? 0 : role == PlaneRole::BasicY ? 1 : 2;
    };
    Point3 tangent{};
    tangent[geo(p)] = -turn * uq;
    tangent[geo(q)] = turn * up;
    x.modal.geo.tangent = tangent;
    x.modal.geo.last_feed = x.core.path.feed;
    return true;
}

bool full_turns(Execution& x, ArcCall& call) {
    const Word* turns = word(x, "TURN");
    if (!turns) return true;
    if (turns->number() < 0 || turns->number() > 999 ||
        turns->number() != std::floor(turns->number()))
        return fail_word(x, Alarm::ValueOutOfRange, *turns, "TURN", turns->number());
    call.turns = static_cast<std::int32_t>(turns->number());
    return true;
}

// A circle outside the selected plane: the two axes of its end point tell which (not with AR or
// TURN).
Plane arc_plane(const Execution& x) {
    const Plane active = x.core.path.plane;
    if (has(x, "AR") || has(x, "TURN") || polar_ahead(x)) return active;
    const MachineView& view = x.core.view();
    bool in_x = false, in_y = false, in_z = false;
    for (const Word& w : x.block.words) {
        if (w.address->name != "axis") continue;
        const PlaneRole role = view.axes[static_cast<std::size_t>(w.axis)].role;
        in_x |= role == PlaneRole::BasicX;
        in_y |= role == PlaneRole::BasicY;
        in_z |= role == PlaneRole::BasicZ;
    }
    if (in_x && in_y && in_z) return active;
    const bool centred = has(x, "I") || has(x, "J") || has(x, "K");
    const auto fits = [&](bool i, bool j, bool k) {
        return !centred || ((!has(x, "I") || i) && (!has(x, "J") || j) && (!has(x, "K") || k));
    };
    if (in_x && in_y && fits(true, true, false)) return Plane::XY;
    if (in_z && in_x && fits(true, false, true)) return Plane::ZX;
    if (in_y && in_z && fits(false, true, true)) return Plane::YZ;
    return active;
}

bool arc_by_words(Execution& x, bool clockwise, AxisValues target, AxisSet named) {
    const auto [p, q] = plane_places(x);
    ArcCall call;
    call.clockwise = clockwise;
    if (!full_turns(x, call)) return false;
    const Word* radius = word(x, "CR");
    const Word* opening = word(x, "AR");
    const bool in_plane = named >> p & 1u || named >> q & 1u;
    bool centred = false;
    if (!centre_words(x, call, centred)) return false;
    if (polar_ahead(x)) {
        if (radius || opening)
            return fail_word(x, Alarm::CodesContradict, radius ? *radius : *opening,
                             "AP RP, CR AR");
        if (!polar_target(x, target)) return false;
        call.centre_p = x.modal.geo.pole[0];
        call.centre_q = x.modal.geo.pole[1];
        return fit_centre(x, target, call) && go_arc(x, target, call);
    }
    if (radius) {
        if (centred || opening)
            return fail_word(x, Alarm::CodesContradict, *radius, "CR, I J K AR");
        return centre_by_radius(x, target, radius->number() * unit(x), call) &&
               go_arc(x, target, call);
    }
    if (opening) {
        const double degrees = opening->number();
        if (!(degrees > 0 && degrees < 360))
            return fail_word(x, Alarm::ValueOutOfRange, *opening, "AR", degrees);
        if (centred && in_plane) return fail_word(x, Alarm::CodesContradict, *opening, "AR, I J K");
        if (!centred) {
            const double chord = std::hypot(target[p] - x.core.path.programmed[p],
                                            target[q] - x.core.path.programmed[q]);
            const double r = chord / (2 * std::sin(degrees / 2 * kDegree));
            return centre_by_radius(x, target, degrees > 180 ? -r : r, call) &&
                   go_arc(x, target, call);
        }
        const double angle = degrees * kDegree * (clockwise ? -1.0 : 1.0);
        const double ap = x.core.path.programmed[p] - call.centre_p,
                     aq = x.core.path.programmed[q] - call.centre_q;
        target[p] = call.centre_p + ap * std::cos(angle) - aq * std::sin(angle);
        target[q] = call.centre_q + ap * std::sin(angle) + aq * std::cos(angle);
        return go_arc(x, target, call);
    }
    if (!centred) return fail(x, Alarm::ArcWithoutRadius);
    return fit_centre(x, target, call) && go_arc(x, target, call);
}

bool arc_through(Execution& x, const Point3& a, const Point3& b, const Point3& c,
                 const AxisValues& target) {
    const auto minus = [](const Point3& u, const Point3& v) {
        return Point3{u[0] - v[0], u[1] - v[1], u[2] - v[2]};
    };
    const auto dot = [](const Point3& u, const Point3& v) {
        return u[0] * v[0] + u[1] * v[1] + u[2] * v[2];
    };
    const Point3 ab = minus(b, a), ac = minus(c, a);
    const Point3 n{ab[1] * ac[2] - ab[2] * ac[1], ab[2] * ac[0] - ab[0] * ac[2],
                   ab[0] * ac[1] - ab[1] * ac[0]};
    const double n2 = dot(n, n), b2 = dot(ab, ab), c2 = dot(ac, ac);
    // on a line: driven where the point lies between start and end
    if (n2 < 1e-18 * std::fmax(1.0, b2 * c2)) {
        if (c2 > 1e-14 && dot(ab, ac) > 0 && b2 < c2 && !has(x, "TURN"))
            return go_line(x, target, false);
        return fail(x, Alarm::ArcPointsOnLine);
    }
    std::size_t upright = 3;
    for (std::size_t k = 0; k < 3; ++k)
        if (n[k] * n[k] > (1 - 1e-12) * n2) upright = k;
    if (upright == 3) {  // not in a plane of the machine
        ArcCall turns;
        return full_turns(x, turns) && oblique_circle(x, a, b, c, target, turns.turns);
    }
    // Centre: a + (c2 (ab x ac) x ... ) written out for the plane.
    const std::size_t p = (upright + 1) % 3, q = (upright + 2) % 3;
    const double d = 2 * (ab[p] * ac[q] - ab[q] * ac[p]);
    ArcCall call;
    call.clockwise = d < 0;
    call.centre_p = a[p] + (ac[q] * b2 - ab[q] * c2) / d;
    call.centre_q = a[q] + (ab[p] * c2 - ac[p] * b2) / d;
    call.tolerance = 1e-3;
    if (!full_turns(x, call)) return false;
    const Plane active = x.core.path.plane;
    static constexpr Plane kPlanes[] = {Plane::YZ, Plane::ZX, Plane::XY};
    x.core.path.plane = kPlanes[upright];
    const bool done = go_arc(x, target, call);
    x.core.path.plane = active;
    return done;
}

}  // namespace

// I J K of the plane: from the start point as a radius, or AC() from the zero as the axis counts.
bool centre_words(Execution& x, ArcCall& call, bool& any) {
    const auto [p, q] = plane_places(x);
    const auto plane = static_cast<std::size_t>(x.core.path.plane);
    any = false;
    const std::size_t places[2] = {p, q};
    double* const centre[2] = {&call.centre_p, &call.centre_q};
    for (std::size_t k = 0; k < 2; ++k) {
        const double here = x.core.path.programmed[places[k]];
        const Word* w = word(x, kCentre[plane][k]);
        *centre[k] = here;
        if (!w) continue;
        any = true;
        if (w->mode == Mode::AC || w->mode == Mode::DAC || w->mode == Mode::RAC)
            *centre[k] = length_mm(x, *w, static_cast<int>(places[k]), false);
        else
            *centre[k] = here + w->number() * unit(x) * (w->mode == Mode::DIC ? 0.5 : 1.0);
    }
    for (const std::string_view name : {"I", "J", "K"})
        if (const Word* w = word(x, name);
            w && name != kCentre[plane][0] && name != kCentre[plane][1])
            return fail_word(x, Alarm::AddressIllegal, *w, std::string(name));
    return true;
}

// The end point is exact: within the tolerance the centre moves onto the perpendicular bisector of
// start and end (10.6.2).
bool fit_centre(Execution& x, const AxisValues& target, ArcCall& call) {
    const auto [p, q] = plane_places(x);
    const double sp = x.core.path.programmed[p], sq = x.core.path.programmed[q], ep = target[p],
                 eq = target[q];
    const double rs = std::hypot(sp - call.centre_p, sq - call.centre_q),
                 re = std::hypot(ep - call.centre_p, eq - call.centre_q);
    const double tolerance =
        std::fmax(x.settings.circle_error_mm, x.settings.circle_error_factor * std::fmax(rs, re));
    if (std::fabs(rs - re) > tolerance + kSameArc)
        return fail(x, Alarm::ArcRadiusDiffers, {}, std::fabs(rs - re), tolerance);
    const double dp = ep - sp, dq = eq - sq, chord2 = dp * dp + dq * dq;
    if (chord2 > 1e-12) {
        const double off =
            ((call.centre_p - (sp + ep) / 2) * dp + (call.centre_q - (sq + eq) / 2) * dq) / chord2;
        call.centre_p -= off * dp;
        call.centre_q -= off * dq;
    }
    call.tolerance = 1e-3;
    return true;
}

// Centre of the arc with this radius from the present point to the target; negative: the long way
// round.
bool centre_by_radius(Execution& x, const AxisValues& target, double radius, ArcCall& call) {
    const auto [p, q] = plane_places(x);
    const double sp = x.core.path.programmed[p], sq = x.core.path.programmed[q], ep = target[p],
                 eq = target[q];
    const double chord = std::hypot(ep - sp, eq - sq), r = std::fabs(radius);
    if (r < kSameArc) return fail(x, Alarm::ArcRadiusIllegal);
    if (chord < 1e-7) return fail(x, Alarm::ArcEndMissing);
    const double short_by = chord / 2 - r;
    if (short_by > std::fmax(x.settings.circle_error_mm, x.settings.circle_error_factor * r))
        return fail(x, Alarm::RadiusTooSmall, {}, short_by);
    const double height = short_by < 0 ? std::sqrt((r - chord / 2) * (r + chord / 2)) : 0.0;
    const double side = call.clockwise != (radius < 0) ? -1.0 : 1.0;
    call.centre_p = (sp + ep) / 2 - side * height * (eq - sq) / chord;
    call.centre_q = (sq + eq) / 2 + side * height * (ep - sp) / chord;
    call.tolerance = 1e-3;
    return true;
}

bool geo_arc(Execution& x, const GCode& code) {
    return driven(x, [&] {
        AxisValues target{};
        AxisSet named = 0;
        if (!read_axis_words(x, target, named)) return false;
        const bool centred = has(x, "I") || has(x, "J") || has(x, "K");
        if (!named && !centred && !polar_ahead(x) && !has(x, "CR") && !has(x, "AR"))
            return corner_words(x, false);
        if (x.modal.geo.open_line) return fail(x, Alarm::ContourLineOpen);
        const Plane active = x.core.path.plane;
        x.core.path.plane = arc_plane(x);
        const bool done = needs_plane(x) && arc_by_words(x, code.number == 3, target, named);
        x.core.path.plane = active;
        return done;
    });
}

// --- CIP: start, intermediate point, end

bool geo_cip(Execution& x, const GCode&) {
    return driven(x, [&] {
        AxisValues target{};
        AxisSet named = 0;
        if (!read_axis_words(x, target, named)) return false;
        const bool between = has(x, "I1") || has(x, "J1") || has(x, "K1");
        if (!named && !between) return corner_words(x, false);
        if (!between) return fail(x, Alarm::ReturnValueMissing, "I1 J1 K1");
        const MachineView& view = x.core.view();
        static constexpr PlaneRole kRoles[] = {PlaneRole::BasicX, PlaneRole::BasicY,
                                               PlaneRole::BasicZ};
        static constexpr std::string_view kNames[] = {"I1", "J1", "K1"};
        Point3 start{}, middle{}, end{};
        std::array<int, 3> places{};
        for (std::size_t k = 0; k < 3; ++k) {
            places[k] = view.axis_by_role(kRoles[k]);
            const Word* w = word(x, kNames[k]);
            if (places[k] < 0) {
                if (w) return fail_word(x, Alarm::PlaneAxisMissing, *w);
                continue;
            }
            const auto i = static_cast<std::size_t>(places[k]);
            start[k] = x.core.path.programmed[i];
            end[k] = target[i];
            // Always a radius; from the start of the arc where it is incremental.
            middle[k] =
                w ? w->number() * unit(x) + (is_incremental(x, *w) ? start[k] : 0.0) : start[k];
        }
        return arc_through(x, start, middle, end, target);
    });
}

// --- CT: tangential to what was driven last

bool geo_ct(Execution& x, const GCode&) {
    return driven(x, [&] {
        AxisValues target{};
        AxisSet named = 0;
        if (!read_axis_words(x, target, named)) return false;
        if (polar_ahead(x) && !polar_target(x, target)) return false;
        if (!named && !polar_ahead(x)) return corner_words(x, false);
        if (!needs_plane(x)) return false;
        const auto [p, q] = plane_places(x);
        const auto geo = [&](std::size_t place) -> std::size_t {
            const PlaneRole role = x.core.view().axes[place].role;
            return role == PlaneRole::BasicX ? 0 : role == PlaneRole::BasicY ? 1 : 2;
        };
        const Point3& last = x.modal.geo.tangent;
        double tp = last[geo(p)], tq = last[geo(q)];
        const double length = std::hypot(tp, tq);
        if (length < 1e-12) return fail(x, Alarm::TangentMissing);
        tp /= length;
        tq /= length;
        const double dp = target[p] - x.core.path.programmed[p],
                     dq = target[q] - x.core.path.programmed[q];
        // d.n with n left of the tangent
        const double across = tp * dq - tq * dp, d2 = dp * dp + dq * dq;
        ArcCall call;
        if (!full_turns(x, call)) return false;
        if (std::fabs(across) < 1e-9 * std::sqrt(d2)) {
            if (call.turns > 0)
                return fail_word(x, Alarm::ValueOutOfRange, *word(x, "TURN"), "TURN", call.turns);
            return go_line(x, target, false);
        }
        const double radius = d2 / (2 * across);  // positive: the centre lies left, anticlockwise
        call.clockwise = radius < 0;
        call.centre_p = x.core.path.programmed[p] - radius * tq;
        call.centre_q = x.core.path.programmed[q] + radius * tp;
        call.tolerance = std::fmax(1e-3, 1e-9 * std::fabs(radius));
        return go_arc(x, target, call);
    });
}

}  // namespace polyturn::channels::sinumerik
