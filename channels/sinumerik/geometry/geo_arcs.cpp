// Arcs: by centre, radius, opening angle, polar words, intermediate point, tangent; helices
// (sinumerik_part1 10.6, 10.7).
#include <cmath>

#include "channels/angles.hpp"
#include "channels/sinumerik/interpreter.hpp"

namespace polyturn::channels::sinumerik {
namespace {

constexpr double kSameArc = 1e-9;
// by plane: XY ZX YZ
constexpr std::string_view kCentre[3][2] = {{"I", "J"}, {"K", "I"}, {"J", "K"}};

}  // namespace

// Every arc of the language comes by here; its centre is in workpiece coordinates.
bool Interpreter::go_arc(const AxisValues& wanted, const ArcCall& call) {
    AxisValues target = wanted;
    if (!arc_within_areas(target, call) || !tangential_arc(target, call)) return false;
    if (leads(target) != nullptr || (!frame_keeps_circles() && !arc_lies_inclined()))
        return drawn_arc(target, call);
    const auto [p, q] = plane_places();
    if (bool taken = false; modal_.geo.approach) {
        if (!finish_approach(target, &call, taken)) return false;
        // an arc does not say where the contour begins
        if (taken) return fail(Alarm::ApproachNoEnd);
    }
    if (!corner_words(true) || !core_.arc(target, call)) return false;
    const double up = target[p] - call.centre_p, uq = target[q] - call.centre_q;
    const double turn = call.clockwise ? -1.0 : 1.0;
    const auto geo = [&](std::size_t place) -> std::size_t {
        const PlaneRole role = core_.view().axes[place].role;
        return role == PlaneRole::BasicX ? 0 : role == PlaneRole::BasicY ? 1 : 2;
    };
    Point3 tangent{};
    tangent[geo(p)] = -turn * uq;
    tangent[geo(q)] = turn * up;
    modal_.geo.tangent = tangent;
    modal_.geo.last_feed = core_.path.feed;
    return true;
}

bool Interpreter::full_turns(ArcCall& call) {
    const Word* turns = word("TURN");
    if (!turns) return true;
    if (turns->number() < 0 || turns->number() > 999 ||
        turns->number() != std::floor(turns->number()))
        return fail_word(Alarm::ValueOutOfRange, *turns, "TURN", turns->number());
    call.turns = static_cast<std::int32_t>(turns->number());
    return true;
}

// I J K of the plane: from the start point as a radius, or AC() from the zero as the axis counts.
bool Interpreter::centre_words(ArcCall& call, bool& any) {
    const auto [p, q] = plane_places();
    const auto plane = static_cast<std::size_t>(core_.path.plane);
    any = false;
    const std::size_t places[2] = {p, q};
    double* const centre[2] = {&call.centre_p, &call.centre_q};
    for (std::size_t k = 0; k < 2; ++k) {
        const double here = core_.path.programmed[places[k]];
        const Word* w = word(kCentre[plane][k]);
        *centre[k] = here;
        if (!w) continue;
        any = true;
        if (w->mode == Mode::AC || w->mode == Mode::DAC || w->mode == Mode::RAC)
            *centre[k] = length_mm(*w, static_cast<int>(places[k]), false);
        else
            *centre[k] = here + w->number() * unit() * (w->mode == Mode::DIC ? 0.5 : 1.0);
    }
    for (const std::string_view name : {"I", "J", "K"})
        if (const Word* w = word(name); w && name != kCentre[plane][0] && name != kCentre[plane][1])
            return fail_word(Alarm::AddressIllegal, *w, std::string(name));
    return true;
}

// The end point is exact: within the tolerance the centre moves onto the perpendicular bisector of
// start and end (10.6.2).
bool Interpreter::fit_centre(const AxisValues& target, ArcCall& call) {
    const auto [p, q] = plane_places();
    const double sp = core_.path.programmed[p], sq = core_.path.programmed[q], ep = target[p],
                 eq = target[q];
    const double rs = std::hypot(sp - call.centre_p, sq - call.centre_q),
                 re = std::hypot(ep - call.centre_p, eq - call.centre_q);
    const double tolerance =
        std::fmax(settings_.circle_error_mm, settings_.circle_error_factor * std::fmax(rs, re));
    if (std::fabs(rs - re) > tolerance + kSameArc)
        return fail(Alarm::ArcRadiusDiffers, {}, std::fabs(rs - re), tolerance);
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
bool Interpreter::centre_by_radius(const AxisValues& target, double radius, ArcCall& call) {
    const auto [p, q] = plane_places();
    const double sp = core_.path.programmed[p], sq = core_.path.programmed[q], ep = target[p],
                 eq = target[q];
    const double chord = std::hypot(ep - sp, eq - sq), r = std::fabs(radius);
    if (r < kSameArc) return fail(Alarm::ArcRadiusIllegal);
    if (chord < 1e-7) return fail(Alarm::ArcEndMissing);
    const double short_by = chord / 2 - r;
    if (short_by > std::fmax(settings_.circle_error_mm, settings_.circle_error_factor * r))
        return fail(Alarm::RadiusTooSmall, {}, short_by);
    const double height = short_by < 0 ? std::sqrt((r - chord / 2) * (r + chord / 2)) : 0.0;
    const double side = call.clockwise != (radius < 0) ? -1.0 : 1.0;
    call.centre_p = (sp + ep) / 2 - side * height * (eq - sq) / chord;
    call.centre_q = (sq + eq) / 2 + side * height * (ep - sp) / chord;
    call.tolerance = 1e-3;
    return true;
}

// A circle outside the selected plane: the two axes of its end point tell which (not with AR or
// TURN).
Plane Interpreter::arc_plane() const {
    const Plane active = core_.path.plane;
    if (has("AR") || has("TURN") || polar_ahead()) return active;
    const MachineView& view = core_.view();
    bool x = false, y = false, z = false;
    for (const Word& w : block_.words) {
        if (w.address->name != "axis") continue;
        const PlaneRole role = view.axes[static_cast<std::size_t>(w.axis)].role;
        x |= role == PlaneRole::BasicX;
        y |= role == PlaneRole::BasicY;
        z |= role == PlaneRole::BasicZ;
    }
    if (x && y && z) return active;
    const bool centred = has("I") || has("J") || has("K");
    const auto fits = [&](bool i, bool j, bool k) {
        return !centred || ((!has("I") || i) && (!has("J") || j) && (!has("K") || k));
    };
    if (x && y && fits(true, true, false)) return Plane::XY;
    if (z && x && fits(true, false, true)) return Plane::ZX;
    if (y && z && fits(false, true, true)) return Plane::YZ;
    return active;
}

bool Interpreter::geo_arc(const GCode& code) {
    return driven([&] {
        AxisValues target{};
        AxisSet named = 0;
        if (!read_axis_words(target, named)) return false;
        const bool centred = has("I") || has("J") || has("K");
        if (!named && !centred && !polar_ahead() && !has("CR") && !has("AR"))
            return corner_words(false);
        if (modal_.geo.open_line) return fail(Alarm::ContourLineOpen);
        const Plane active = core_.path.plane;
        core_.path.plane = arc_plane();
        const bool done = needs_plane() && arc_by_words(code.number == 3, target, named);
        core_.path.plane = active;
        return done;
    });
}

bool Interpreter::arc_by_words(bool clockwise, AxisValues target, AxisSet named) {
    const auto [p, q] = plane_places();
    ArcCall call;
    call.clockwise = clockwise;
    if (!full_turns(call)) return false;
    const Word* radius = word("CR");
    const Word* opening = word("AR");
    const bool in_plane = named >> p & 1u || named >> q & 1u;
    bool centred = false;
    if (!centre_words(call, centred)) return false;
    if (polar_ahead()) {
        if (radius || opening)
            return fail_word(Alarm::CodesContradict, radius ? *radius : *opening, "AP RP, CR AR");
        if (!polar_target(target)) return false;
        call.centre_p = modal_.geo.pole[0];
        call.centre_q = modal_.geo.pole[1];
        return fit_centre(target, call) && go_arc(target, call);
    }
    if (radius) {
        if (centred || opening) return fail_word(Alarm::CodesContradict, *radius, "CR, I J K AR");
        return centre_by_radius(target, radius->number() * unit(), call) && go_arc(target, call);
    }
    if (opening) {
        const double degrees = opening->number();
        if (!(degrees > 0 && degrees < 360))
            return fail_word(Alarm::ValueOutOfRange, *opening, "AR", degrees);
        if (centred && in_plane) return fail_word(Alarm::CodesContradict, *opening, "AR, I J K");
        if (!centred) {
            const double chord = std::hypot(target[p] - core_.path.programmed[p],
                                            target[q] - core_.path.programmed[q]);
            const double r = chord / (2 * std::sin(degrees / 2 * kDegree));
            return centre_by_radius(target, degrees > 180 ? -r : r, call) && go_arc(target, call);
        }
        const double angle = degrees * kDegree * (clockwise ? -1.0 : 1.0);
        const double ap = core_.path.programmed[p] - call.centre_p,
                     aq = core_.path.programmed[q] - call.centre_q;
        target[p] = call.centre_p + ap * std::cos(angle) - aq * std::sin(angle);
        target[q] = call.centre_q + ap * std::sin(angle) + aq * std::cos(angle);
        return go_arc(target, call);
    }
    if (!centred) return fail(Alarm::ArcWithoutRadius);
    return fit_centre(target, call) && go_arc(target, call);
}

// --- CIP: start, intermediate point, end

bool Interpreter::geo_cip(const GCode&) {
    return driven([&] {
        AxisValues target{};
        AxisSet named = 0;
        if (!read_axis_words(target, named)) return false;
        const bool between = has("I1") || has("J1") || has("K1");
        if (!named && !between) return corner_words(false);
        if (!between) return fail(Alarm::ReturnValueMissing, "I1 J1 K1");
        const MachineView& view = core_.view();
        static constexpr PlaneRole kRoles[] = {PlaneRole::BasicX, PlaneRole::BasicY,
                                               PlaneRole::BasicZ};
        static constexpr std::string_view kNames[] = {"I1", "J1", "K1"};
        Point3 start{}, middle{}, end{};
        std::array<int, 3> places{};
        for (std::size_t k = 0; k < 3; ++k) {
            places[k] = view.axis_by_role(kRoles[k]);
            const Word* w = word(kNames[k]);
            if (places[k] < 0) {
                if (w) return fail_word(Alarm::PlaneAxisMissing, *w);
                continue;
            }
            const auto i = static_cast<std::size_t>(places[k]);
            start[k] = core_.path.programmed[i];
            end[k] = target[i];
            // Always a radius; from the start of the arc where it is incremental.
            middle[k] = w ? w->number() * unit() + (is_incremental(*w) ? start[k] : 0.0) : start[k];
        }
        return arc_through(start, middle, end, target);
    });
}

bool Interpreter::arc_through(const Point3& a, const Point3& b, const Point3& c,
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
        if (c2 > 1e-14 && dot(ab, ac) > 0 && b2 < c2 && !has("TURN")) return go_line(target, false);
        return fail(Alarm::ArcPointsOnLine);
    }
    std::size_t upright = 3;
    for (std::size_t k = 0; k < 3; ++k)
        if (n[k] * n[k] > (1 - 1e-12) * n2) upright = k;
    if (upright == 3) {  // not in a plane of the machine
        ArcCall turns;
        return full_turns(turns) && oblique_circle(a, b, c, target, turns.turns);
    }
    // Centre: a + (c2 (ab x ac) x ... ) written out for the plane.
    const std::size_t p = (upright + 1) % 3, q = (upright + 2) % 3;
    const double d = 2 * (ab[p] * ac[q] - ab[q] * ac[p]);
    ArcCall call;
    call.clockwise = d < 0;
    call.centre_p = a[p] + (ac[q] * b2 - ab[q] * c2) / d;
    call.centre_q = a[q] + (ab[p] * c2 - ac[p] * b2) / d;
    call.tolerance = 1e-3;
    if (!full_turns(call)) return false;
    const Plane active = core_.path.plane;
    static constexpr Plane kPlanes[] = {Plane::YZ, Plane::ZX, Plane::XY};
    core_.path.plane = kPlanes[upright];
    const bool done = go_arc(target, call);
    core_.path.plane = active;
    return done;
}

// --- CT: tangential to what was driven last

bool Interpreter::geo_ct(const GCode&) {
    return driven([&] {
        AxisValues target{};
        AxisSet named = 0;
        if (!read_axis_words(target, named)) return false;
        if (polar_ahead() && !polar_target(target)) return false;
        if (!named && !polar_ahead()) return corner_words(false);
        if (!needs_plane()) return false;
        const auto [p, q] = plane_places();
        const auto geo = [&](std::size_t place) -> std::size_t {
            const PlaneRole role = core_.view().axes[place].role;
            return role == PlaneRole::BasicX ? 0 : role == PlaneRole::BasicY ? 1 : 2;
        };
        const Point3& last = modal_.geo.tangent;
        double tp = last[geo(p)], tq = last[geo(q)];
        const double length = std::hypot(tp, tq);
        if (length < 1e-12) return fail(Alarm::TangentMissing);
        tp /= length;
        tq /= length;
        const double dp = target[p] - core_.path.programmed[p],
                     dq = target[q] - core_.path.programmed[q];
        // d.n with n left of the tangent
        const double across = tp * dq - tq * dp, d2 = dp * dp + dq * dq;
        ArcCall call;
        if (!full_turns(call)) return false;
        if (std::fabs(across) < 1e-9 * std::sqrt(d2)) {
            if (call.turns > 0)
                return fail_word(Alarm::ValueOutOfRange, *word("TURN"), "TURN", call.turns);
            return go_line(target, false);
        }
        const double radius = d2 / (2 * across);  // positive: the centre lies left, anticlockwise
        call.clockwise = radius < 0;
        call.centre_p = core_.path.programmed[p] - radius * tq;
        call.centre_q = core_.path.programmed[q] + radius * tp;
        call.tolerance = std::fmax(1e-3, 1e-9 * std::fabs(radius));
        return go_arc(target, call);
    });
}

}  // namespace polyturn::channels::sinumerik
