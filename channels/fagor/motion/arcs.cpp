#include "channels/fagor/motion/arcs.hpp"

#include <cmath>
#include <numbers>

#include "channels/fagor/execution.hpp"
#include "channels/fagor/frames/plane.hpp"
#include "channels/fagor/motion/corners.hpp"
#include "channels/fagor/motion/feed.hpp"
#include "channels/fagor/motion/lengths.hpp"
#include "channels/fagor/motion/lines.hpp"
#include "channels/fagor/motion/loop_scan.hpp"
#include "channels/fagor/motion/points.hpp"
#include "channels/fagor/tools/spindle.hpp"

namespace polyturn::channels::fagor {
namespace {

constexpr double kSame = 1e-7;  // mm

bool drive_arc(Execution& x, const AxisValues& programmed, double cp, double cq, bool clockwise) {
    unsigned p = 0, q = 0;
    if (!plane_places(x, p, q)) return false;
    AxisValues target = programmed;
    const bool left_out = !x.loops.plans.empty() && leave_out(x, target);
    if (!left_out && !ends_sharp(x) && !element_at_end(x, false)) return false;
    ArcCall call;
    call.clockwise = clockwise;
    call.centre_p = cp;
    call.centre_q = cq;
    call.tolerance = x.settings.arc_tolerance;
    if (x.modal.feed_code == 32 && x.modal.feed_inverse > 0) {
        const AxisValues& now = x.core.path.programmed;
        const double a0 = std::atan2(now[q] - cq, now[p] - cp),
                     a1 = std::atan2(target[q] - cq, target[p] - cp), turn = 2 * std::numbers::pi;
        double sweep = clockwise ? a0 - a1 : a1 - a0;
        sweep -= std::floor(sweep / turn) * turn;
        if (std::hypot(target[p] - now[p], target[q] - now[q]) < kSame) sweep = turn;
        x.core.path.feed = x.modal.feed_inverse;
        x.core.path.feed_mode = FeedMode::InverseTime;
        x.core.path.feed_path.active = false;
        x.modal.feed_of_block =
            x.modal.feed_inverse * sweep * std::hypot(now[p] - cp, now[q] - cq) * x.modal.scale;
        // An axis would be too fast: its limit is the feed, as on a line (6.15).
        if (const double most = largest_feed_on_arc(x, a0, clockwise ? -sweep : sweep, p, q);
            most > 0 && x.modal.feed_of_block > most) {
            x.modal.feed_of_block = most;
            x.core.path.feed = most;
            x.core.path.feed_mode = FeedMode::PerMinute;
            x.core.path.feed_path.active = true;
        }
    } else if (!set_feed(x, target)) {
        return false;
    }
    if (left_out ? !drive_left_out(x, target, false) : !x.core.arc(target, call)) return false;
    if (!x.loops.plans.empty())
        x.core.path.programmed = programmed;  // the way may have ended elsewhere
    const double rp = programmed[p] - cp, rq = programmed[q] - cq;
    note_direction(x, clockwise ? rq : -rq, clockwise ? -rp : rp);
    if (x.settings.polar_origin_moves) set_polar_origin(x, cp, cq);
    return true;
}

// G08: the circle through the end point that leaves the path before it without a bend.
bool tangent_arc(Execution& x, const AxisValues& target) {
    unsigned p = 0, q = 0;
    if (!plane_places(x, p, q)) return false;
    if (x.words.letters & letter_set("IJK")) return x.fail(Alarm::AddressIllegal, 'I', "I J K");
    double tp = 0, tq = 0;
    if (!end_direction(x, tp, tq)) return x.fail(Alarm::FagorTangential, 'G', "G08");
    const AxisValues& now = x.core.path.programmed;
    const double dp = target[p] - now[p], dq = target[q] - now[q], chord2 = dp * dp + dq * dq;
    if (chord2 < kSame * kSame) return x.fail(Alarm::FagorFullCircle, 'G', "G08");
    const double aside = dq * tp - dp * tq;  // (E - P) . left normal of t
    if (std::fabs(aside) < kSame) {
        if (dp * tp + dq * tq <= 0) return x.fail(Alarm::FagorThreePoints, 'G', "G08");
        return drive_line(x, target, false);  // straight on is the circle of infinite radius
    }
    const double k = chord2 / (2 * aside);
    return drive_arc(x, target, now[p] - k * tq, now[q] + k * tp, k < 0);
}

// Centre of an arc from I, J, K: relative to the start (true distances), or from part zero with
// G06. Letters belong to axes.
char centre_letter(const Execution& x, unsigned place) {
    const std::string& name = x.core.view().axes[place].name;
    switch (name[0]) {
        case 'X':
        case 'U':
        case 'A':
            return 'I';
        case 'Y':
        case 'V':
        case 'B':
            return 'J';
        default:
            return 'K';
    }
}

bool three_point_arc(Execution& x, const AxisValues& target) {
    unsigned p = 0, q = 0;
    if (!plane_places(x, p, q)) return false;
    const char lp = centre_letter(x, p), lq = centre_letter(x, q);
    if (!x.words.has(lp) && !x.words.has(lq))
        return x.fail(Alarm::FagorMotionWord, 'G', std::string{lp, ' ', lq}, 9);
    const AxisValues& now = x.core.path.programmed;
    const double mp = x.words.has(lp) ? length(x, x.words.number(lp), static_cast<int>(p)) : now[p],
                 mq = x.words.has(lq) ? length(x, x.words.number(lq), static_cast<int>(q)) : now[q];
    const double ap = mp - now[p], aq = mq - now[q], bp = target[p] - now[p],
                 bq = target[q] - now[q];
    const double cross = ap * bq - aq * bp;
    const double a2 = ap * ap + aq * aq, b2 = bp * bp + bq * bq,
                 c2 = (ap - bp) * (ap - bp) + (aq - bq) * (aq - bq);
    if (a2 < kSame * kSame || b2 < kSame * kSame || c2 < kSame * kSame ||
        std::fabs(cross) < 1e-9 * std::sqrt(a2 * b2))
        return x.fail(Alarm::FagorThreePoints, 'G', "G09");
    const double cp = (bq * a2 - aq * b2) / (2 * cross), cq = (ap * b2 - bp * a2) / (2 * cross);
    // from the start through the middle to the end: that way round
    return drive_arc(x, target, now[p] + cp, now[q] + cq, cross < 0);
}

bool arc_centre(Execution& x, bool absolute, double& cp, double& cq) {
    unsigned p = 0, q = 0;
    if (!plane_places(x, p, q)) return false;
    const char lp = centre_letter(x, p), lq = centre_letter(x, q);
    const Word* wp = x.words.word(lp);
    const Word* wq = x.words.word(lq);
    // the plane X U: the first word belongs to the axis that is first in the order of axes
    if (lp == lq) {
        const bool p_first =
            axis_number(x.core.view().axes[p].name[0]) < axis_number(x.core.view().axes[q].name[0]);
        wp = p_first ? wp : x.words.second_centre;
        wq = p_first ? x.words.second_centre : x.words.word(lq);
    }
    for (const char letter : {'I', 'J', 'K'})
        if (x.words.has(letter) && letter != lp && letter != lq)
            return x.fail_word(*x.words.word(letter), Alarm::FagorNotInPlane,
                               std::string(1, letter));
    const AxisValues& now = x.core.path.programmed;
    if (absolute) {
        cp = wp ? length(x, wp->value, static_cast<int>(p)) : 0.0;
        cq = wq ? length(x, wq->value, static_cast<int>(q)) : 0.0;
    } else {
        cp = now[p] + (wp ? wp->value * x.modal.unit() : 0.0);
        cq = now[q] + (wq ? wq->value * x.modal.unit() : 0.0);
    }
    return true;
}

}  // namespace

bool g_arc(Execution& x, const GCode& row) {
    unsigned p = 0, q = 0;
    if (!plane_places(x, p, q)) return false;
    follow_spindle(x, false);
    AxisValues target;
    AxisSet named = 0;
    const bool by_centre_angle = (row.number == 2 || row.number == 3) && x.words.has('Q');
    if (by_centre_angle) {
        target = x.core.path.programmed;
        for (unsigned i = 0; i < x.core.view().axis_count; ++i)
            if (x.words.axis[i])
                return x.fail_word(*x.words.axis[i], Alarm::AddressIllegal,
                                   std::string(1, x.words.axis[i]->letter));
    } else if (row.number >= 8 && (x.words.has('Q') || x.words.has('R'))) {
        target = x.core.path.programmed;
        if (x.words.axis[p] || x.words.axis[q])
            return x.fail(Alarm::AddressIllegal, x.words.has('R') ? 'R' : 'Q',
                          x.words.has('R') ? "R" : "Q");
        if (!polar_point(x, target)) return false;
    } else if (!read_point(x, target, &named)) {
        return false;
    }
    for (unsigned i = 0; i < x.core.view().axis_count; ++i)
        if (x.words.axis[i] && i != p && i != q && !x.core.view().axes[i].rotary)
            return x.fail_word(*x.words.axis[i], Alarm::FagorNotInPlane,
                               std::string(1, x.words.axis[i]->letter));
    if (x.words.in_machine) x.core.suspend_for(named);
    if (row.number == 8) return tangent_arc(x, target);
    if (row.number == 9) return three_point_arc(x, target);
    const AxisValues& now = x.core.path.programmed;
    const bool clockwise = row.number == 2;
    const bool absolute = x.words.has(GGroup::Modifier);  // G06
    const bool centre_given = (x.words.letters & letter_set("IJK")) != 0;
    if (by_centre_angle) {
        double cp = 0, cq = 0;
        if (centre_given || absolute) {
            if (!arc_centre(x, absolute, cp, cq)) return false;
        } else {
            polar_origin(x, cp, cq);
        }
        const double radius =
            x.words.has('R') ? distance(x, 'R') : std::hypot(now[p] - cp, now[q] - cq);
        const double degree = std::numbers::pi / 180.0;
        double angle = std::fmod(x.words.number('Q'), 360.0) * degree;
        if (!x.modal.absolute) angle += std::atan2(now[q] - cq, now[p] - cp);
        target[p] = cp + radius * std::cos(angle);
        target[q] = cq + radius * std::sin(angle);
        return drive_arc(x, target, cp, cq, clockwise);
    }
    if (x.words.has('R')) {
        if (centre_given) return x.fail(Alarm::AddressIllegal, 'R', "R");
        const double radius = distance(x, 'R');
        const double chord = std::hypot(target[p] - now[p], target[q] - now[q]);
        if (chord < kSame) return x.fail(Alarm::FagorFullCircle, 'R', "R");
        if (radius == 0.0) return x.fail(Alarm::ArcRadiusIllegal, 'R');
        const double half = chord / 2, r = std::fabs(radius);
        if (half - r > x.settings.arc_tolerance)
            return x.fail(Alarm::RadiusTooSmall, 'R', {}, half - r);
        const double height = r > half ? std::sqrt((r - half) * (r + half)) : 0.0;
        // left of the chord: short and anticlockwise, or long and clockwise
        const double side = (clockwise != (radius < 0)) ? -1.0 : 1.0;
        return drive_arc(
            x, target, (now[p] + target[p]) / 2 - side * height * (target[q] - now[q]) / chord,
            (now[q] + target[q]) / 2 + side * height * (target[p] - now[p]) / chord, clockwise);
    }
    if (!centre_given && !absolute) return x.fail(Alarm::ArcWithoutRadius, 'G');
    double cp = 0, cq = 0;
    return arc_centre(x, absolute, cp, cq) && drive_arc(x, target, cp, cq, clockwise);
}

}  // namespace polyturn::channels::fagor
