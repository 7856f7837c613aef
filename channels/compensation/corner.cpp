#include "channels/compensation/corner.hpp"

#include <numbers>

namespace polyturn::channels::compensation {
namespace {

// sine of the turn below which two elements go on straight
constexpr double kTangent = 1e-9;
constexpr double kRightAngle = 1e-9;  // cosine: 90 degrees counts as obtuse
constexpr double kOneDegree = std::numbers::pi / 180.0;
constexpr double kHalfTurnDeg = 180.0;
// degrees: where the contour opens by more than 120 the arc hardly leaves it
// (sinumerik_part2 11.3); 120 itself is not more, but for rounding
constexpr double kRoundedBelowDeg = 120.0 + 1e-9;
constexpr double kSharpest = 0.995;  // of the overshoot that a conic can make

Vec first_normal(const Element& a) { return a.nose * a.normal_at_end(); }
Vec second_normal(const Element& b) { return b.nose * b.normal_at_start(); }

void add_extended(Vectors& list, const Element& a, const Element& b) {
    if (a.arc) list.add(first_normal(a));
    list.add(first_normal(a) + a.nose * a.end_dir);
    list.add(second_normal(b) - b.nose * b.start_dir);
    if (b.arc) list.add(second_normal(b));
}

// Tangents instead of equidistants: outer equidistants of small arcs may not meet.
void add_outer_tangents(Vectors& list, const Element& a, const Element& b) {
    const Vec na = a.normal_at_end(), nb = b.normal_at_start();
    if (a.arc) list.add(first_normal(a));
    list.add((a.nose / (1.0 + dot(na, nb))) * (na + nb));
    if (b.arc) list.add(second_normal(b));
}

// Degrees between the elements on the workpiece's side of an outer corner.
double opening_deg(const Element& a, const Element& b) {
    return kHalfTurnDeg -
           std::fabs(std::atan2(cross(a.end_dir, b.start_dir), dot(a.end_dir, b.start_dir))) /
               kOneDegree;
}

void add_outer(Vectors& list, const Element& a, const Element& b, Turn turn,
               const Options& options) {
    if (options.corner == Corner::Arc ||
        (options.arc_below_deg > 0 && opening_deg(a, b) < options.arc_below_deg) ||
        (options.corner == Corner::Intersection &&
         opening_deg(a, b) < options.intersection_from_deg)) {
        const double over = options.corner == Corner::Arc && turn != Turn::Reversal &&
                                    opening_deg(a, b) <= kRoundedBelowDeg
                                ? options.overshoot
                                : 0.0;
        if (over >= 1.0) {
            if (const auto v = meeting_point(a, b))
                list.add(*v);
            else
                add_outer_tangents(list, a, b);
            return;
        }
        list.add(first_normal(a));
        list.add(second_normal(b), true, std::fmin(over, kSharpest));
    } else if (turn == Turn::Obtuse ||
               (options.corner == Corner::Intersection && turn != Turn::Reversal)) {
        // Where sharper corners get an arc, the others are joined by straight lines only: arcs are
        // lengthened along their tangents (fagor_8037t part 1, 8.2.5, COMPMODE 0).
        const bool straight_lines =
            options.corner == Corner::Extended && options.arc_below_deg > 0 && (a.arc || b.arc);
        if (const auto v = straight_lines ? std::nullopt : meeting_point(a, b))
            list.add(*v);
        else
            add_outer_tangents(list, a, b);
    } else {
        add_extended(list, a, b);
    }
}

}  // namespace

Turn classify(const Element& a, const Element& b) {
    const double t = cross(a.end_dir, b.start_dir), straight = dot(a.end_dir, b.start_dir);
    if (std::fabs(t) < kTangent && straight > 0) return Turn::Inner;
    if (std::fabs(t) >= kTangent && t * b.side > 0) return Turn::Inner;
    if (straight >= -kRightAngle) return Turn::Obtuse;
    if (!a.arc && !b.arc && std::fabs(t) <= std::sin(kOneDegree)) return Turn::Reversal;
    return Turn::Acute;
}

namespace {

// Approach to or retract from a contour at its corner P, for a tool at `outside` behind the
// contour's tangent: the tangent u from there to the circle about P, and along the circle to (from)
// the normal of the contour; Corner::Intersection: the two tangents.
//   V = side * r * left(u),   u turned from the line to P by asin(r / distance)
void add_tangent(Vectors& list, const Element& contour, Vec corner, Vec normal, Vec along,
                 Vec outside, bool entering, const Options& options) {
    const double r = contour.nose, side = contour.side;
    const Vec way = entering ? corner - outside : outside - corner;
    const double distance = length(way);
    const bool in_front = dot(outside - corner, normal) >= 0;
    if (in_front || distance <= r || r <= 0) {
        list.add(normal);
        return;
    }
    const double turn = (entering ? side : -side) * std::asin(r / distance), c = std::cos(turn),
                 s = std::sin(turn);
    const Vec d = unit(way), u{c * d.p - s * d.q, s * d.p + c * d.q};
    const Vec touch = side * r * left_of(u);
    const double between =
        std::fabs(std::atan2(cross(touch, normal), dot(touch, normal))) / kOneDegree;
    if (options.corner == Corner::Intersection &&
        kHalfTurnDeg - between >= options.intersection_from_deg) {
        const double sine = cross(u, along);
        const Vec meeting =
            std::fabs(sine) < kTangent ? normal : touch + (cross(normal - touch, along) / sine) * u;
        if (entering) {
            list.add(meeting);
            list.add(normal);
        } else {
            list.add(normal);
            list.add(meeting);
        }
        return;
    }
    if (entering) {
        list.add(touch);
        list.add(normal, true);
    } else {
        list.add(normal);
        list.add(touch, true);
    }
}

}  // namespace

CornerResult start_corner(const Element& a, const Element& next, const Options& options) {
    // a radius that changes with the contour's first element is reached at its end
    Element b = next;
    b.nose = a.nose;
    Element entry = a;  // the beginning is treated as if it were compensated like the contour
    entry.side = b.side;
    const Turn turn = classify(entry, b);
    CornerResult result;
    Vectors& list = result.vectors;
    if (options.entry == Entry::Tangent) {
        add_tangent(list, b, b.start, second_normal(b), b.start_dir, a.start, true, options);
        list.of_first = list.count;
        return result;
    }
    if (turn == Turn::Inner || turn == Turn::Reversal || options.entry == Entry::Direct ||
        options.entry >= Entry::Smooth) {
        list.add(second_normal(b));
        return result;
    }
    list.add(first_normal(entry));
    add_outer(list, entry, b, turn, options);
    if (turn == Turn::Obtuse && options.corner == Corner::Extended) list.of_first = list.count;
    return result;
}

CornerResult offset_corner(const Element& a, const Element& next, const Options& options) {
    // A radius that changes here counts behind the corner; only vectors that belong to the next
    // block have it already.
    Element b = next;
    if (classify(a, b) == Turn::Inner || classify(a, b) == Turn::Obtuse) b.nose = a.nose;
    CornerResult result;
    Vectors& list = result.vectors;
    const double t = cross(a.end_dir, b.start_dir);
    const bool straight_on = std::fabs(t) < kTangent && dot(a.end_dir, b.start_dir) > 0;
    if (a.side != b.side) {  // the nose crosses the contour: inner and outer mean nothing here
        const auto v = meeting_point(a, b);
        if (options.sides_meet_on_paths &&
            !(v && on_nose_path(a, a.end + *v) && on_nose_path(b, b.start + *v))) {
            list.add(first_normal(a));
            list.add(second_normal(next));
            return result;
        }
        list.add(v ? *v : second_normal(b));
        return result;
    }
    if (straight_on) {
        list.add(first_normal(a));
        return result;
    }
    const Turn turn = classify(a, b);
    if (turn != Turn::Inner) {
        add_outer(list, a, b, turn, options);
        return result;
    }
    if (const auto v = closed_meeting_point(a, b, options.closed_meets_at_start))
        list.add(*v);
    else if (const auto near = meeting_point(a, b))
        list.add(*near);
    else
        result.fault = CornerFault::NoIntersection;
    return result;
}

CornerResult cancel_corner(const Element& a, const Element& b, const Options& options) {
    Element leave = b;
    leave.side = a.side;
    leave.nose = a.nose;
    const Turn turn = classify(a, leave);
    CornerResult result;
    Vectors& list = result.vectors;
    if (options.entry == Entry::Tangent) {
        add_tangent(list, a, a.end, first_normal(a), a.end_dir, b.end, false, options);
        list.of_first = list.count;
        return result;
    }
    if (turn == Turn::Inner || turn == Turn::Reversal || options.entry == Entry::Direct ||
        options.entry >= Entry::Smooth || options.leaves_direct) {
        list.add(first_normal(a));
        return result;
    }
    add_outer(list, a, leave, turn, options);
    if (!list.by_arc[list.count - 1]) list.add(second_normal(leave));
    return result;
}

CornerResult retract_corner(const Element& a, Vec wish) {
    Element on = line(a.end, a.end + unit(wish));
    on.side = a.side;
    on.nose = a.nose;
    const auto v = meeting_point(a, on);
    return {Vectors::one(v ? *v : first_normal(a)), CornerFault::None};
}

void drop_small(Vectors& list, double limit, bool keep_last) {
    constexpr double kSame = 1e-7;  // mm: rounding of the corner's geometry
    const double close = limit > kSame ? limit : kSame;
    unsigned kept = 1;
    for (unsigned i = 1; i < list.count; ++i) {
        const Vec step = list.at[i] - list.at[kept - 1];
        const bool small = std::fabs(step.p) <= close && std::fabs(step.q) <= close;
        // less is no vector of its own
        const bool needed = keep_last && i + 1 == list.count && length(step) > kTangentialMm;
        if (small && !needed) {
            if (i < list.of_first) --list.of_first;
            continue;
        }
        list.at[kept] = list.at[i];
        list.overshoot[kept] = list.overshoot[i];
        list.by_arc[kept++] = list.by_arc[i];
    }
    list.count = kept;
    if (list.of_first > list.count) list.of_first = list.count;
}

}  // namespace polyturn::channels::compensation
