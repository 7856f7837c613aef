// Curves that are no arcs in a plane of the machine: involutes, circles that lie obliquely in
// space, ellipses. They are made of points so close together that the straight lines between them
// stay within kSagitta of the curve (sinumerik_part1 10.6.6, 10.8).
#include "channels/sinumerik/geometry/geo_curves.hpp"

#include <cmath>
#include <numbers>

#include "channels/angles.hpp"
#include "channels/sinumerik/axes/axis_names.hpp"
#include "channels/sinumerik/axes/axis_words.hpp"
#include "channels/sinumerik/coupling/coupled_axes.hpp"
#include "channels/sinumerik/execution.hpp"
#include "channels/sinumerik/faults.hpp"
#include "channels/sinumerik/geometry/geo_arcs.hpp"
#include "channels/sinumerik/geometry/geo_motion.hpp"
#include "channels/sinumerik/geometry/travel_limits.hpp"
#include "channels/sinumerik/geometry/units.hpp"
#include "channels/sinumerik/grammar/words.hpp"

namespace polyturn::channels::sinumerik {
namespace {

constexpr double kTurn = 2.0 * std::numbers::pi;
constexpr double kSagitta = 0.0005;  // mm
constexpr double kNoRadius = 1e-9;   // mm
constexpr std::size_t kMostPoints = 20'000;

// phi(t) = t - atan t: the polar angle of an involute from its foot, t the roll angle.
double polar(double t) { return t - std::atan(t); }

// The roll angle of a polar angle >= 0. phi grows without bound and is convex: bisection between 0
// and a bound.
double roll(double phi) {
    double low = 0.0, high = phi + std::numbers::pi / 2 + 1.0;  // atan t < pi/2
    for (int i = 0; i < 200 && high - low > 1e-15 * high; ++i) {
        const double mid = (low + high) / 2;
        (polar(mid) < phi ? low : high) = mid;
    }
    return (low + high) / 2;
}

// The curve itself; `tangent` is its direction at the end. Axes that follow others do so from point
// to point.
bool go_curve(Execution& x, const AxisValues& wanted, const std::vector<AxisValues>& points,
              const Point3& tangent) {
    const bool leads = !x.modal.trails.empty();
    const AxisValues target = leads ? trailed(x, wanted) : wanted;
    std::vector<AxisValues> followed;
    for (std::size_t i = 0; leads && i < points.size(); ++i)
        followed.push_back(trailed(x, points[i]));
    const std::vector<AxisValues>& between = leads ? followed : points;
    for (const AxisValues& point : between)
        if (!within_areas(x, point)) return false;
    if (!within_areas(x, target)) return false;
    if (x.modal.geo.approach) return fail(x, Alarm::ApproachNoEnd);
    if (x.modal.geo.open_line) return fail(x, Alarm::ContourLineOpen);
    if (!corner_words(x, false)) return false;
    if (x.core.compensating())
        return fail(x, Alarm::CurveUnderCompensation,
                    find_g(1, x.modal.active[1]) ? std::string(find_g(1, x.modal.active[1])->name)
                                                 : std::string());
    if (!x.core.curve(target, between)) return false;
    x.modal.geo.tangent = tangent;
    x.modal.geo.last_feed = x.core.path.feed;
    return true;
}

std::size_t geometry_index(Execution& x, std::size_t place) {
    const PlaneRole role = x.core.view().axes[place].role;
    return role == PlaneRole::BasicX ? 0 : role == PlaneRole::BasicY ? 1 : 2;
}

}  // namespace

//   r(t) = R sqrt(1 + t^2),  angle(t) = angle(start) + o (phi(t) - phi(ts)),  o = +1: the curve
//   opens anticlockwise
//
// Outwards t grows, inwards it falls; INVCCW turns anticlockwise on both ways, so o is its sense
// outwards and the other inwards.
bool geo_involute(Execution& x, const GCode& code) {
    return driven(x, [&] {
        AxisValues target{};
        AxisSet named = 0;
        if (!read_axis_words(x, target, named)) return false;
        const Word* base = word(x, "CR");
        const Word* opening = word(x, "AR");
        ArcCall call;
        bool centred = false;
        if (!needs_plane(x) || !centre_words(x, call, centred)) return false;
        if (!named && !opening && !centred) return corner_words(x, false);
        const auto places = plane_places(x);
        const std::size_t p = places[0], q = places[1];
        if (!base) return fail(x, Alarm::ReturnValueMissing, "CR");
        if (base->number() <= 0)
            return fail_word(x, Alarm::ValueOutOfRange, *base, "CR", base->number());
        const bool in_plane = (named >> p & 1u) || (named >> q & 1u);
        if (opening && in_plane)
            return fail_word(x, Alarm::CodesContradict, *opening,
                             "AR, " + axis_name(x, static_cast<int>(named >> p & 1u ? p : q)));
        if (!opening && !in_plane) return fail(x, Alarm::ArcEndMissing);
        // INVCCW
        const double radius = base->number() * unit(x), sense = code.number == 19 ? 1.0 : -1.0;
        const double sp = x.core.path.programmed[p] - call.centre_p,
                     sq = x.core.path.programmed[q] - call.centre_q;
        const double start = std::hypot(sp, sq), first = std::atan2(sq, sp);
        if (start < radius - 1e-9) return fail(x, Alarm::InvoluteInside);
        const double ts = std::sqrt(std::fmax(0.0, start * start / (radius * radius) - 1.0));
        double te = 0.0, off = 0.0;  // off: what the end point's angle is beside the curve
        if (opening) {
            const double phi = polar(ts) + opening->number() * kDegree;
            if (phi < -1e-12 || opening->number() == 0)
                return fail_word(x, Alarm::InvoluteInside, *opening);
            te = roll(std::fmax(0.0, phi));
            const double end = radius * std::sqrt(1 + te * te),
                         angle = first + sense * std::fabs(opening->number()) * kDegree;
            target[p] = call.centre_p + end * std::cos(angle);
            target[q] = call.centre_q + end * std::sin(angle);
        } else {
            const double ep = target[p] - call.centre_p, eq = target[q] - call.centre_q,
                         end = std::hypot(ep, eq);
            if (end < radius - 1e-9) return fail(x, Alarm::InvoluteInside);
            te = std::sqrt(std::fmax(0.0, end * end / (radius * radius) - 1.0));
            off = std::remainder(
                std::atan2(eq, ep) - first - sense * std::fabs(polar(te) - polar(ts)), kTurn);
            const double there = std::fmax(0.0, polar(te) + (te > ts ? sense : -sense) * off);
            const double t = roll(there), beside = std::fabs(radius * std::sqrt(1 + t * t) - end);
            if (beside > x.settings.involute_error_mm + 1e-9)
                return fail(x, Alarm::InvoluteEndOff, {}, beside, x.settings.involute_error_mm);
        }
        const double opens = te > ts ? sense : -sense, whole = te * te - ts * ts;
        const AxisValues from = x.core.path.programmed;
        std::vector<AxisValues> between;
        const auto step = [&](double t) {
            return std::fmin(0.05, std::sqrt(8 * kSagitta / (radius * std::fmax(t, 1e-3))));
        };
        for (double t = ts + (te > ts ? step(ts) : -step(ts)); te > ts ? t < te : t > te;
             t += te > ts ? step(t) : -step(t)) {
            if (between.size() == kMostPoints) return fail(x, Alarm::ValueOutOfRange, "CR");
            const double share = (t * t - ts * ts) / whole;  // of the way
            const double r = radius * std::sqrt(1 + t * t),
                         angle = first + opens * (polar(t) - polar(ts)) + off * share;
            AxisValues point = from;
            for (unsigned i = 0; i < x.core.view().axis_count; ++i)
                point[i] += (target[i] - from[i]) * share;
            point[p] = call.centre_p + r * std::cos(angle);
            point[q] = call.centre_q + r * std::sin(angle);
            between.push_back(point);
        }
        // The tangent of an involute is the normal of its base circle's tangent: radius direction
        // of the roll angle.
        const double angle = first + opens * (polar(te) - polar(ts)) + opens * std::atan(te),
                     outwards = te > ts ? 1.0 : -1.0;
        Point3 tangent{};
        tangent[geometry_index(x, p)] = outwards * std::cos(angle);
        tangent[geometry_index(x, q)] = outwards * std::sin(angle);
        return go_curve(x, target, between, tangent);
    });
}

// Turned out of the planes of the machine (ROT X, sinumerik_part2 13.5), or an ellipse by two
// factors (13.7)?
bool frame_keeps_circles(const Execution& x) {
    if (!x.core.path.framed) return true;
    constexpr double kAlike = 1e-9;
    static constexpr GeoAxis kAxes[3][2] = {
        {GeoAxis::X, GeoAxis::Y}, {GeoAxis::Z, GeoAxis::X}, {GeoAxis::Y, GeoAxis::Z}};
    const auto& [first, second] = kAxes[static_cast<std::size_t>(x.core.path.plane)];
    const Point3 u = x.core.path.frame.axis(first), v = x.core.path.frame.axis(second);
    const auto dot = [](const Point3& a, const Point3& b) {
        return a[0] * b[0] + a[1] * b[1] + a[2] * b[2];
    };
    const double size = dot(u, u);
    if (std::fabs(size - dot(v, v)) > kAlike * size || std::fabs(dot(u, v)) > kAlike * size)
        return false;
    double upright = 0.0;  // of the plane's normal along one axis of the machine
    for (std::size_t k = 0; k < 3; ++k)
        upright = std::fmax(
            upright, std::fabs(u[(k + 1) % 3] * v[(k + 2) % 3] - u[(k + 2) % 3] * v[(k + 1) % 3]));
    return upright > (1 - kAlike) * size;
}

// An arc in a plane that the frame inclines, which has an element at an end or is compensated:
// those know circles.
bool arc_lies_inclined(const Execution& x) {
    if (!x.core.frame_inclines()) return false;
    if (x.core.inclined() || (!x.core.reads_ahead() && x.modal.geo.rounding > 0)) return true;
    return !x.core.reads_ahead() && (word(x, "RND") || word(x, "CHR") || word(x, "CHF"));
}

// An arc of the workpiece that is none of the machine's: its points go through the frame.
bool drawn_arc(Execution& x, const AxisValues& target, const ArcCall& call) {
    for (const std::string_view name : {"RND", "CHR", "CHF"})
        if (const Word* w = word(x, name))
            return fail_word(x, Alarm::NotBuilt, *w,
                             std::string(name) + (leads(x, target) ? ", TRAILON" : ", ROT, SCALE"));
    const auto places = plane_places(x);
    const std::size_t p = places[0], q = places[1];
    const AxisValues from = x.core.path.programmed;
    const double radius = std::hypot(from[p] - call.centre_p, from[q] - call.centre_q);
    if (radius < kNoRadius ||
        std::hypot(target[p] - call.centre_p, target[q] - call.centre_q) < kNoRadius)
        return fail(x, Alarm::ArcWithoutRadius);
    const double begin = std::atan2(from[q] - call.centre_q, from[p] - call.centre_p),
                 sense = call.clockwise ? -1.0 : 1.0;
    double sweep = std::fmod(
        (std::atan2(target[q] - call.centre_q, target[p] - call.centre_p) - begin) * sense, kTurn);
    if (sweep < 1e-9) sweep += kTurn;
    sweep += kTurn * call.turns;
    double largest = 1.0;  // the frame may magnify what lies between two points
    for (const GeoAxis axis : {GeoAxis::X, GeoAxis::Y, GeoAxis::Z}) {
        const Point3 image = x.core.path.frame.axis(axis);
        largest = std::fmax(
            largest, std::sqrt(image[0] * image[0] + image[1] * image[1] + image[2] * image[2]));
    }
    const auto count =
        static_cast<std::size_t>(std::ceil(sweep / std::sqrt(8 * kSagitta / (radius * largest))));
    if (count > kMostPoints) return fail(x, Alarm::ValueOutOfRange, "TURN", call.turns);
    std::vector<AxisValues> between;
    for (std::size_t i = 1; i < count; ++i) {
        const double share = static_cast<double>(i) / static_cast<double>(count),
                     angle = begin + sense * sweep * share;
        AxisValues point = from;
        for (unsigned k = 0; k < x.core.view().axis_count; ++k)
            point[k] += (target[k] - from[k]) * share;
        point[p] = call.centre_p + radius * std::cos(angle);
        point[q] = call.centre_q + radius * std::sin(angle);
        between.push_back(point);
    }
    Point3 tangent{};
    tangent[geometry_index(x, p)] = -sense * (target[q] - call.centre_q);
    tangent[geometry_index(x, q)] = sense * (target[p] - call.centre_p);
    return go_curve(x, target, between, tangent);
}

// The circle from a through b to c in the plane of the three, `turns` more full circles before its
// end.
bool oblique_circle(Execution& x, const Point3& a, const Point3& b, const Point3& c,
                    const AxisValues& target, std::int32_t turns) {
    const auto minus = [](const Point3& u, const Point3& v) {
        return Point3{u[0] - v[0], u[1] - v[1], u[2] - v[2]};
    };
    const auto dot = [](const Point3& u, const Point3& v) {
        return u[0] * v[0] + u[1] * v[1] + u[2] * v[2];
    };
    const auto cross = [](const Point3& u, const Point3& v) {
        return Point3{u[1] * v[2] - u[2] * v[1], u[2] * v[0] - u[0] * v[2],
                      u[0] * v[1] - u[1] * v[0]};
    };
    const Point3 ab = minus(b, a), ac = minus(c, a), n = cross(ab, ac);
    const double n2 = dot(n, n), b2 = dot(ab, ab), c2 = dot(ac, ac);
    // Centre = a + (c2 (ab x ac) x ab + b2 ac x (ab x ac)) / (2 |ab x ac|^2)
    const Point3 u = cross(n, ab), v = cross(ac, n);
    Point3 centre{}, radial{}, across{};
    for (std::size_t k = 0; k < 3; ++k) centre[k] = a[k] + (c2 * u[k] + b2 * v[k]) / (2 * n2);
    radial = minus(a, centre);
    const double radius = std::sqrt(dot(radial, radial));
    // direction of travel at a, since n points to the side of a -> b -> c
    const Point3 left = cross(n, radial);
    for (std::size_t k = 0; k < 3; ++k) across[k] = left[k] / std::sqrt(n2);
    const Point3 end = minus(c, centre);
    double sweep = std::atan2(dot(end, across), dot(end, radial));
    if (sweep < 1e-12) sweep += kTurn;
    sweep += kTurn * turns;
    const AxisValues from = x.core.path.programmed;
    const auto count =
        static_cast<std::size_t>(std::ceil(sweep / std::sqrt(8 * kSagitta / radius)));
    if (count > kMostPoints) return fail(x, Alarm::ValueOutOfRange, "TURN", turns);
    static constexpr PlaneRole kRoles[] = {PlaneRole::BasicX, PlaneRole::BasicY, PlaneRole::BasicZ};
    std::vector<AxisValues> between;
    for (std::size_t i = 1; i < count; ++i) {
        const double share = static_cast<double>(i) / static_cast<double>(count),
                     angle = sweep * share;
        AxisValues point = from;
        for (unsigned k = 0; k < x.core.view().axis_count; ++k)
            point[k] += (target[k] - from[k]) * share;
        for (std::size_t k = 0; k < 3; ++k)
            if (const int place = x.core.view().axis_by_role(kRoles[k]); place >= 0)
                point[static_cast<std::size_t>(place)] =
                    centre[k] + radial[k] * std::cos(angle) + across[k] * std::sin(angle);
        between.push_back(point);
    }
    Point3 tangent{};
    for (std::size_t k = 0; k < 3; ++k)
        tangent[k] = across[k] * std::cos(sweep) - radial[k] * std::sin(sweep);
    return go_curve(x, target, between, tangent);
}

}  // namespace polyturn::channels::sinumerik
