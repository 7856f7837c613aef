// Soft approach and retract, G147 to G348: lines and circles tangential to the contour
// (sinumerik_part2 11.4.1).
//
//   P0 ----> P1     w1, DISRP          P0 start    P4 begin of the contour, t its direction there, n towards the tool
//            |                         line        P3 = P4 - (r + DISR) t
//            P2     w2, DISCL          quarter     P3 = P4 + R n - R t       R = DISR + r: the tool's centre is driven
//            |                         half        P3 = P4 + 2 R n               on a radius of DISR
//   P3 ------'  G341; with G340 P3 is P2 and the curve comes down by itself
//
// What is made here are programmed moves; compensation acts on them as behind any other move.
#include "channels/sinumerik/geometry/geo_approach.hpp"

#include <cmath>

#include "channels/sinumerik/axes/axis_words.hpp"
#include "channels/sinumerik/execution.hpp"
#include "channels/sinumerik/faults.hpp"
#include "channels/sinumerik/geometry/geo_compensation.hpp"
#include "channels/sinumerik/geometry/geo_motion.hpp"
#include "channels/sinumerik/geometry/travel_limits.hpp"
#include "channels/sinumerik/geometry/units.hpp"
#include "channels/sinumerik/grammar/groups.hpp"
#include "channels/sinumerik/grammar/words.hpp"

namespace polyturn::channels::sinumerik {
namespace {

constexpr double kSameApproach = 1e-9;

int applicate(const MachineView& view, Plane plane) {
    // XY ZX YZ
    static constexpr PlaneRole kRoles[] = {PlaneRole::BasicZ, PlaneRole::BasicY, PlaneRole::BasicX};
    return view.axis_by_role(kRoles[static_cast<std::size_t>(plane)]);
}

bool approach_words(Execution& x, const GCode& code, SoftApproach& soft) {
    soft = {};
    soft.form = static_cast<std::uint8_t>(code.name[1] == '1' ? 0 : code.name[1] == '2' ? 1 : 2);
    soft.in_plane = active(x, 44) == 2;
    soft.side = static_cast<std::uint8_t>(active(x, 43));
    const GCode* comp = x.block.coded[7];
    // a retract that ends it still has it
    soft.comp = static_cast<std::uint8_t>(comp && comp->number == 1 ? x.modal.geo.side_before
                                                                    : active(x, 7));
    const Word* radius = word(x, "DISR");
    if (!radius) return fail(x, Alarm::ApproachRadius);
    soft.radius = radius->number() * unit(x);
    if (soft.form != 0 && soft.radius <= 0) return fail_word(x, Alarm::ApproachRadius, *radius);
    const auto level = [&](std::string_view name, double& value, bool& has_it, bool& absolute) {
        const Word* w = word(x, name);
        has_it = w != nullptr;
        if (!w) return;
        value = w->number() * unit(x);
        absolute = w->mode == Mode::AC;
    };
    level("DISCL", soft.safety, soft.has_safety, soft.safety_absolute);
    level("DISRP", soft.retract, soft.has_retract, soft.retract_absolute);
    if (const Word* w = word(x, "FAD")) {
        if (w->number() <= 0) return fail_word(x, Alarm::ValueOutOfRange, *w, "FAD", w->number());
        soft.infeed = w->number() * feed_unit(x);
        soft.infeed_mode = w->mode == Mode::PM ? 1 : w->mode == Mode::PR ? 2 : 0;
    }
    soft.has_feed = has(x, "F");
    soft.feed = x.core.path.feed;
    soft.rapid = x.modal.active[1] == 1;
    soft.at = x.core.at;
    soft.from = x.core.path.programmed;
    return needs_plane(x);
}

// The tool's side of the contour: +1 left, -1 right; 0 none.
int approach_side(const SoftApproach& soft, double tp, double tq, double op, double oq) {
    switch (soft.side) {
        case 2:
            return 1;  // G141
        case 3:
            return -1;  // G142
        case 4:
            return tp * oq - tq * op >= 0 ? 1 : -1;  // G143: where the other end lies
        default:
            return soft.comp == 2 ? 1 : soft.comp == 3 ? -1 : 0;  // G140: that of G41, G42
    }
}

// One straight part of it; nothing moves where the point is reached already.
bool approach_line(Execution& x, const AxisValues& to, bool rapid, double feed, std::uint8_t mode) {
    PathState& path = x.core.path;
    const double kept = path.feed;
    const FeedMode kept_mode = path.feed_mode;
    path.feed = feed;
    if (mode == 1) path.feed_mode = FeedMode::PerMinute;
    if (mode == 2) path.feed_mode = FeedMode::PerRevolution;
    const bool done = within_areas(x, to) && (rapid ? x.core.rapid(to) : x.core.linear(to));
    path.feed = kept;
    path.feed_mode = kept_mode;
    return done;
}

// The path between P3 and P4 in the plane, from the tool's position; entering or leaving.
bool approach_curve(Execution& x, const SoftApproach& soft, const AxisValues& to, int side,
                    const std::array<double, 2>& centre, double feed, std::uint8_t mode) {
    if (soft.form == 0) return approach_line(x, to, false, feed, mode);
    PathState& path = x.core.path;
    const double kept = path.feed;
    const FeedMode kept_mode = path.feed_mode;
    path.feed = feed;
    if (mode == 1) path.feed_mode = FeedMode::PerMinute;
    if (mode == 2) path.feed_mode = FeedMode::PerRevolution;
    ArcCall arc;
    arc.clockwise = side < 0;  // tangential to the contour on both ways
    arc.centre_p = centre[0];
    arc.centre_q = centre[1];
    arc.tolerance = 1e-3;
    const bool done = arc_within_areas(x, to, arc) && x.core.arc(to, arc);
    path.feed = kept;
    path.feed_mode = kept_mode;
    return done;
}

}  // namespace

bool geo_approach(Execution& x, const GCode& code) {
    SoftApproach soft;
    if (x.modal.geo.approach) return fail(x, Alarm::ApproachTwice);
    if (!approach_words(x, code, soft)) return false;
    soft.target = x.core.path.programmed;
    if (!read_axis_words(x, soft.target, soft.named)) return false;
    const auto [p, q] = plane_places(x);
    soft.complete = (soft.named >> p & 1u) || (soft.named >> q & 1u);
    x.modal.geo.approach = soft;
    if (!x.core.reserve_move()) return false;
    // what the next block counts from; put right before anything moves
    if (soft.complete) x.core.path.programmed = soft.target;
    return true;
}

// The contour's first block is known. taken: the block only gave the point where the contour
// begins.
bool finish_approach(Execution& x, const AxisValues& target, const ArcCall* arc, bool& taken) {
    taken = false;
    SoftApproach soft = *x.modal.geo.approach;
    const auto places = plane_places(x);
    // no structured binding: a lambda below takes them
    const std::size_t p = places[0], q = places[1];
    const int w = applicate(x.core.view(), x.core.path.plane);
    if (!soft.complete) {
        for (unsigned i = 0; i < x.core.view().axis_count; ++i)
            if (!(soft.named >> i & 1u)) soft.target[i] = target[i];
        soft.complete = taken = true;
        x.modal.geo.approach = soft;
        x.core.path.programmed = soft.target;
        return true;
    }
    x.modal.geo.approach.reset();
    x.modal.geo.approach_serial = soft.at.serial;
    x.core.path.programmed = soft.from;
    const AxisValues p4 = soft.target;
    double tp = target[p] - p4[p], tq = target[q] - p4[q];
    if (arc) {
        const double turn = arc->clockwise ? -1.0 : 1.0;
        tp = -turn * (p4[q] - arc->centre_q);
        tq = turn * (p4[p] - arc->centre_p);
    }
    const double length = std::hypot(tp, tq);
    if (length < kSameApproach) return fail(x, Alarm::ApproachNoEnd);
    tp /= length;
    tq /= length;
    const int side = approach_side(soft, tp, tq, soft.from[p] - p4[p], soft.from[q] - p4[q]);
    if (side == 0 && soft.form != 0) return fail(x, Alarm::ApproachNoSide);
    const double nose =
        soft.comp > 1 ? x.core.path.tool.nose_radius + x.core.path.tool.allowance : 0.0;
    const double way = soft.form == 0
                           ? soft.radius + std::fmax(nose, 0.0)
                           : soft.radius + (side == (soft.comp == 2 ? 1 : -1) ? nose : -nose);
    if (way <= kSameApproach) return fail(x, Alarm::ApproachRadius);
    const double np = -side * tq, nq = side * tp;
    AxisValues p3 = p4;
    if (soft.form == 0) {
        p3[p] -= way * tp;
        p3[q] -= way * tq;
    } else if (soft.form == 1) {
        p3[p] += way * (np - tp);
        p3[q] += way * (nq - tq);
    } else {
        p3[p] += 2 * way * np;
        p3[q] += 2 * way * nq;
    }
    AxisValues p1 = p3, p2 = p3;
    if (w >= 0) {
        const auto k = static_cast<std::size_t>(w);
        const double up = soft.from[k] >= p4[k] ? 1.0 : -1.0;
        p2[k] = soft.has_safety ? (soft.safety_absolute ? soft.safety : p4[k] + up * soft.safety)
                                : p4[k];
        // without DISRP first parallel to the plane
        p1[k] = soft.has_retract
                    ? (soft.retract_absolute ? soft.retract : p4[k] + up * soft.retract)
                    : soft.from[k];
        const double down[] = {(soft.from[k] - p1[k]) * up, (p1[k] - p2[k]) * up,
                               (p2[k] - p4[k]) * up};
        for (const double step : down)
            if (step < -x.settings.approach_slack_mm) return fail(x, Alarm::ApproachReversal);
        if (!soft.in_plane) p3[k] = p2[k];
        // DISCL=0: P1 P2 P3 are one
        if (!soft.in_plane && soft.has_safety && !soft.has_retract &&
            std::fabs(p2[k] - p4[k]) < kSameApproach)
            p1[k] = p2[k];
    }
    x.modal.geo.approach_known = true;
    // $P_APR and $P_AEP are points of the compensated path (11.4.1: P4 lies on it); without
    // compensation that is the contour's.
    AxisValues start = p3, end = p4;
    const double across = soft.comp == 2 ? nose : -nose, bend = soft.radius;
    end[p] -= across * tq;
    end[q] += across * tp;
    if (soft.form == 0) {
        start[p] -= across * tq;
        start[q] += across * tp;
    } else if (soft.form == 1) {
        start[p] = end[p] + bend * (np - tp);
        start[q] = end[q] + bend * (nq - tq);
    } else {
        start[p] = end[p] + 2 * bend * np;
        start[q] = end[q] + 2 * bend * nq;
    }
    x.modal.geo.approach_start = start;
    x.modal.geo.approach_end = end;
    bool made = true;
    const double slow = soft.infeed > 0 ? soft.infeed : soft.feed;
    const std::uint8_t slow_mode = soft.infeed > 0 ? soft.infeed_mode : 0;
    x.core.insert_reserved([&] {
        const BlockContext here = x.core.at;
        x.core.at = soft.at;
        const std::uint8_t entry = x.modal.active[17];
        x.modal.active[17] = 1;  // onto the perpendicular, whatever KONT says
        update_compensation(x);
        const std::array<double, 2> centre{p4[p] + way * np, p4[q] + way * nq};
        made = approach_line(x, p1, soft.rapid, soft.feed, 0) &&
               approach_line(x, p2, soft.rapid, soft.feed, 0);
        if (made && soft.in_plane) made = approach_line(x, p3, false, slow, slow_mode);
        if (made)
            made = approach_curve(x, soft, p4, side, centre, soft.in_plane ? soft.feed : slow,
                                  soft.in_plane ? std::uint8_t{0} : slow_mode);
        x.modal.active[17] = entry;
        update_compensation(x);
        x.core.at = here;
    });
    return made;
}

bool geo_retract(Execution& x, const GCode& code) {
    SoftApproach soft;
    if (x.modal.geo.approach) return fail(x, Alarm::ApproachTwice);
    if (!approach_words(x, code, soft)) return false;
    AxisValues target = x.core.path.programmed;
    AxisSet named = 0;
    if (!read_axis_words(x, target, named)) return false;
    const auto [p, q] = plane_places(x);
    const int w = applicate(x.core.view(), x.core.path.plane);
    const AxisValues p4 = x.core.path.programmed;
    const auto geo = [&](std::size_t place) -> std::size_t {
        const PlaneRole role = x.core.view().axes[place].role;
        return role == PlaneRole::BasicX ? 0 : role == PlaneRole::BasicY ? 1 : 2;
    };
    double tp = x.modal.geo.tangent[geo(p)], tq = x.modal.geo.tangent[geo(q)];
    const double length = std::hypot(tp, tq);
    if (length < kSameApproach) return fail(x, Alarm::RetractNoMove);
    tp /= length;
    tq /= length;
    const bool in_plane_end = (named >> p & 1u) || (named >> q & 1u),
               upright_end = w >= 0 && (named >> w & 1u);
    const int side = approach_side(soft, tp, tq, target[p] - p4[p], target[q] - p4[q]);
    if (side == 0 && soft.form != 0) return fail(x, Alarm::ApproachNoSide);
    const bool compensated = soft.comp > 1;
    const double nose =
        compensated ? x.core.path.tool.nose_radius + x.core.path.tool.allowance : 0.0;
    const double way = soft.form == 0
                           ? soft.radius + std::fmax(nose, 0.0)
                           : soft.radius + (side == (soft.comp == 2 ? 1 : -1) ? nose : -nose);
    if (way <= kSameApproach) return fail(x, Alarm::ApproachRadius);
    const double np = -side * tq, nq = side * tp;
    AxisValues p3 = p4;
    double ep = tp, eq = tq;  // direction at its end
    if (soft.form == 0) {
        p3[p] += way * tp;
        p3[q] += way * tq;
    } else if (soft.form == 1) {
        p3[p] += way * (np + tp);
        p3[q] += way * (nq + tq);
        ep = np;
        eq = nq;
    } else {
        p3[p] += 2 * way * np;
        p3[q] += 2 * way * nq;
        ep = -tp;
        eq = -tq;
    }
    AxisValues p2 = p3, p1 = p3;
    if (w >= 0) {
        const auto k = static_cast<std::size_t>(w);
        const double up = upright_end && target[k] < p4[k] ? -1.0 : 1.0;
        p2[k] = soft.has_safety ? (soft.safety_absolute ? soft.safety : p4[k] + up * soft.safety)
                                : p4[k];
        p1[k] = soft.has_retract
                    ? (soft.retract_absolute ? soft.retract : p4[k] + up * soft.retract)
                : in_plane_end || upright_end ? target[k]
                                              : p2[k];
        const double rise[] = {(p2[k] - p4[k]) * up, (p1[k] - p2[k]) * up,
                               upright_end ? (target[k] - p1[k]) * up : 0.0};
        for (const double step : rise)
            if (step < -x.settings.approach_slack_mm) return fail(x, Alarm::ApproachReversal);
        if (!soft.in_plane) p3[k] = p2[k];
        if (!upright_end) target[k] = p1[k];
    }
    const double old_feed =
        soft.has_feed && x.modal.geo.last_feed > 0 ? x.modal.geo.last_feed : soft.feed;
    const std::array<double, 2> centre{p4[p] + way * np, p4[q] + way * nq};
    if (!approach_curve(x, soft, p3, side, centre, old_feed, 0)) return false;
    const bool slow = soft.in_plane && soft.infeed > 0;
    if (!approach_line(x, p2, !slow && soft.rapid, slow ? soft.infeed : soft.feed,
                       slow ? soft.infeed_mode : std::uint8_t{0}))
        return false;
    if (!approach_line(x, p1, soft.rapid, soft.feed, 0)) return false;
    const GCode* comp = x.block.coded[7];
    const bool cancels = comp && comp->number == 1 && compensated;
    if (cancels) {
        const std::uint8_t entry = x.modal.active[17];
        x.modal.active[17] = 1;
        update_compensation(x);
        x.core.compensation_off(0.0, 0.0);
        x.modal.active[17] = entry;
    }
    if (!in_plane_end) {
        // Where nothing is programmed in the plane the tool stays where it is, with G40 as the
        // point that is programmed.
        target[p] = p3[p];
        target[q] = p3[q];
        if (cancels) {
            target[p] -= (soft.comp == 2 ? nose : -nose) * eq;
            target[q] += (soft.comp == 2 ? nose : -nose) * ep;
        }
    }
    const bool done = approach_line(x, target, soft.rapid, soft.feed, 0);
    if (cancels) update_compensation(x);
    return done;
}

}  // namespace polyturn::channels::sinumerik
