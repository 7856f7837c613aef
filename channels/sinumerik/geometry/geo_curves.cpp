// Curves that are no arcs in a plane of the machine: involutes, circles that lie obliquely in
// space, ellipses. They are made of points so close together that the straight lines between them
// stay within kSagitta of the curve (sinumerik_part1 10.6.6, 10.8).
#include <cmath>
#include <numbers>

#include "channels/angles.hpp"
#include "channels/sinumerik/interpreter.hpp"

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

}  // namespace

// The curve itself; `tangent` is its direction at the end. Axes that follow others do so from point
// to point.
bool Interpreter::go_curve(const AxisValues& wanted, const std::vector<AxisValues>& points,
                           const Point3& tangent) {
    const bool leads = !modal_.trails.empty();
    const AxisValues target = leads ? trailed(wanted) : wanted;
    std::vector<AxisValues> followed;
    for (std::size_t i = 0; leads && i < points.size(); ++i) followed.push_back(trailed(points[i]));
    const std::vector<AxisValues>& between = leads ? followed : points;
    for (const AxisValues& point : between)
        if (!within_areas(point)) return false;
    if (!within_areas(target)) return false;
    if (modal_.geo.approach) return fail(Alarm::ApproachNoEnd);
    if (modal_.geo.open_line) return fail(Alarm::ContourLineOpen);
    if (!corner_words(false)) return false;
    if (core_.compensating())
        return fail(Alarm::CurveUnderCompensation,
                    find_g(1, modal_.active[1]) ? std::string(find_g(1, modal_.active[1])->name)
                                                : std::string());
    if (!core_.curve(target, between)) return false;
    modal_.geo.tangent = tangent;
    modal_.geo.last_feed = core_.path.feed;
    return true;
}

//   r(t) = R sqrt(1 + t^2),  angle(t) = angle(start) + o (phi(t) - phi(ts)),  o = +1: the curve
//   opens anticlockwise
//
// Outwards t grows, inwards it falls; INVCCW turns anticlockwise on both ways, so o is its sense
// outwards and the other inwards.
bool Interpreter::geo_involute(const GCode& code) {
    return driven([&] {
        AxisValues target{};
        AxisSet named = 0;
        if (!read_axis_words(target, named)) return false;
        const Word* base = word("CR");
        const Word* opening = word("AR");
        ArcCall call;
        bool centred = false;
        if (!needs_plane() || !centre_words(call, centred)) return false;
        if (!named && !opening && !centred) return corner_words(false);
        const auto places = plane_places();
        const std::size_t p = places[0], q = places[1];
        if (!base) return fail(Alarm::ReturnValueMissing, "CR");
        if (base->number() <= 0)
            return fail_word(Alarm::ValueOutOfRange, *base, "CR", base->number());
        const bool in_plane = (named >> p & 1u) || (named >> q & 1u);
        if (opening && in_plane)
            return fail_word(Alarm::CodesContradict, *opening,
                             "AR, " + axis_name(static_cast<int>(named >> p & 1u ? p : q)));
        if (!opening && !in_plane) return fail(Alarm::ArcEndMissing);
        // INVCCW
        const double radius = base->number() * unit(), sense = code.number == 19 ? 1.0 : -1.0;
        const double sp = core_.path.programmed[p] - call.centre_p,
                     sq = core_.path.programmed[q] - call.centre_q;
        const double start = std::hypot(sp, sq), first = std::atan2(sq, sp);
        if (start < radius - 1e-9) return fail(Alarm::InvoluteInside);
        const double ts = std::sqrt(std::fmax(0.0, start * start / (radius * radius) - 1.0));
        double te = 0.0, off = 0.0;  // off: what the end point's angle is beside the curve
        if (opening) {
            const double phi = polar(ts) + opening->number() * kDegree;
            if (phi < -1e-12 || opening->number() == 0)
                return fail_word(Alarm::InvoluteInside, *opening);
            te = roll(std::fmax(0.0, phi));
            const double end = radius * std::sqrt(1 + te * te),
                         angle = first + sense * std::fabs(opening->number()) * kDegree;
            target[p] = call.centre_p + end * std::cos(angle);
            target[q] = call.centre_q + end * std::sin(angle);
        } else {
            const double ep = target[p] - call.centre_p, eq = target[q] - call.centre_q,
                         end = std::hypot(ep, eq);
            if (end < radius - 1e-9) return fail(Alarm::InvoluteInside);
            te = std::sqrt(std::fmax(0.0, end * end / (radius * radius) - 1.0));
            off = std::remainder(
                std::atan2(eq, ep) - first - sense * std::fabs(polar(te) - polar(ts)), kTurn);
            const double there = std::fmax(0.0, polar(te) + (te > ts ? sense : -sense) * off);
            const double t = roll(there), beside = std::fabs(radius * std::sqrt(1 + t * t) - end);
            if (beside > settings_.involute_error_mm + 1e-9)
                return fail(Alarm::InvoluteEndOff, {}, beside, settings_.involute_error_mm);
        }
        const double opens = te > ts ? sense : -sense, whole = te * te - ts * ts;
        const AxisValues from = core_.path.programmed;
        std::vector<AxisValues> between;
        const auto step = [&](double t) {
            return std::fmin(0.05, std::sqrt(8 * kSagitta / (radius * std::fmax(t, 1e-3))));
        };
        for (double t = ts + (te > ts ? step(ts) : -step(ts)); te > ts ? t < te : t > te;
             t += te > ts ? step(t) : -step(t)) {
            if (between.size() == kMostPoints) return fail(Alarm::ValueOutOfRange, "CR");
            const double share = (t * t - ts * ts) / whole;  // of the way
            const double r = radius * std::sqrt(1 + t * t),
                         angle = first + opens * (polar(t) - polar(ts)) + off * share;
            AxisValues point = from;
            for (unsigned i = 0; i < core_.view().axis_count; ++i)
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
        tangent[geometry_index(p)] = outwards * std::cos(angle);
        tangent[geometry_index(q)] = outwards * std::sin(angle);
        return go_curve(target, between, tangent);
    });
}

// Turned out of the planes of the machine (ROT X, sinumerik_part2 13.5), or an ellipse by two
// factors (13.7)?
bool Interpreter::frame_keeps_circles() const {
    if (!core_.path.framed) return true;
    constexpr double kAlike = 1e-9;
    static constexpr GeoAxis kAxes[3][2] = {
        {GeoAxis::X, GeoAxis::Y}, {GeoAxis::Z, GeoAxis::X}, {GeoAxis::Y, GeoAxis::Z}};
    const auto& [first, second] = kAxes[static_cast<std::size_t>(core_.path.plane)];
    const Point3 u = core_.path.frame.axis(first), v = core_.path.frame.axis(second);
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
bool Interpreter::arc_lies_inclined() const {
    if (!core_.frame_inclines()) return false;
    if (core_.inclined() || (!core_.reads_ahead() && modal_.geo.rounding > 0)) return true;
    return !core_.reads_ahead() && (word("RND") || word("CHR") || word("CHF"));
}

// An arc of the workpiece that is none of the machine's: its points go through the frame.
bool Interpreter::drawn_arc(const AxisValues& target, const ArcCall& call) {
    for (const std::string_view name : {"RND", "CHR", "CHF"})
        if (const Word* w = word(name))
            return fail_word(Alarm::NotBuilt, *w,
                             std::string(name) + (leads(target) ? ", TRAILON" : ", ROT, SCALE"));
    const auto places = plane_places();
    const std::size_t p = places[0], q = places[1];
    const AxisValues from = core_.path.programmed;
    const double radius = std::hypot(from[p] - call.centre_p, from[q] - call.centre_q);
    if (radius < kNoRadius ||
        std::hypot(target[p] - call.centre_p, target[q] - call.centre_q) < kNoRadius)
        return fail(Alarm::ArcWithoutRadius);
    const double begin = std::atan2(from[q] - call.centre_q, from[p] - call.centre_p),
                 sense = call.clockwise ? -1.0 : 1.0;
    double sweep = std::fmod(
        (std::atan2(target[q] - call.centre_q, target[p] - call.centre_p) - begin) * sense, kTurn);
    if (sweep < 1e-9) sweep += kTurn;
    sweep += kTurn * call.turns;
    double largest = 1.0;  // the frame may magnify what lies between two points
    for (const GeoAxis axis : {GeoAxis::X, GeoAxis::Y, GeoAxis::Z}) {
        const Point3 image = core_.path.frame.axis(axis);
        largest = std::fmax(
            largest, std::sqrt(image[0] * image[0] + image[1] * image[1] + image[2] * image[2]));
    }
    const auto count =
        static_cast<std::size_t>(std::ceil(sweep / std::sqrt(8 * kSagitta / (radius * largest))));
    if (count > kMostPoints) return fail(Alarm::ValueOutOfRange, "TURN", call.turns);
    std::vector<AxisValues> between;
    for (std::size_t i = 1; i < count; ++i) {
        const double share = static_cast<double>(i) / static_cast<double>(count),
                     angle = begin + sense * sweep * share;
        AxisValues point = from;
        for (unsigned k = 0; k < core_.view().axis_count; ++k)
            point[k] += (target[k] - from[k]) * share;
        point[p] = call.centre_p + radius * std::cos(angle);
        point[q] = call.centre_q + radius * std::sin(angle);
        between.push_back(point);
    }
    Point3 tangent{};
    tangent[geometry_index(p)] = -sense * (target[q] - call.centre_q);
    tangent[geometry_index(q)] = sense * (target[p] - call.centre_p);
    return go_curve(target, between, tangent);
}

std::size_t Interpreter::geometry_index(std::size_t place) {
    const PlaneRole role = core_.view().axes[place].role;
    return role == PlaneRole::BasicX ? 0 : role == PlaneRole::BasicY ? 1 : 2;
}

// The circle from a through b to c in the plane of the three, `turns` more full circles before its
// end.
bool Interpreter::oblique_circle(const Point3& a, const Point3& b, const Point3& c,
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
    const AxisValues from = core_.path.programmed;
    const auto count =
        static_cast<std::size_t>(std::ceil(sweep / std::sqrt(8 * kSagitta / radius)));
    if (count > kMostPoints) return fail(Alarm::ValueOutOfRange, "TURN", turns);
    static constexpr PlaneRole kRoles[] = {PlaneRole::BasicX, PlaneRole::BasicY, PlaneRole::BasicZ};
    std::vector<AxisValues> between;
    for (std::size_t i = 1; i < count; ++i) {
        const double share = static_cast<double>(i) / static_cast<double>(count),
                     angle = sweep * share;
        AxisValues point = from;
        for (unsigned k = 0; k < core_.view().axis_count; ++k)
            point[k] += (target[k] - from[k]) * share;
        for (std::size_t k = 0; k < 3; ++k)
            if (const int place = core_.view().axis_by_role(kRoles[k]); place >= 0)
                point[static_cast<std::size_t>(place)] =
                    centre[k] + radial[k] * std::cos(angle) + across[k] * std::sin(angle);
        between.push_back(point);
    }
    Point3 tangent{};
    for (std::size_t k = 0; k < 3; ++k)
        tangent[k] = across[k] * std::cos(sweep) - radial[k] * std::sin(sweep);
    return go_curve(target, between, tangent);
}

}  // namespace polyturn::channels::sinumerik
