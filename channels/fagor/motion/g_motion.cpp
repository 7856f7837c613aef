// G00 G01 G02 G03 G06 G08 G09 G33 G34 G52 G53 and what surrounds a move: feed, work zones.
#include <cmath>
#include <numbers>

#include "channels/fagor/interpreter.hpp"
#include "ipc/params/table.hpp"

namespace polyturn::channels::fagor {
namespace {

constexpr double kSame = 1e-7;  // mm

}  // namespace

// The largest feed on the way to a target: no axis faster than it can (F0, or F never programmed).
double Interpreter::largest_feed(const AxisValues& target) const {
    const MachineView& view = core_.view();
    const AxisValues from = core_.framed(core_.path.programmed), to = core_.framed(target);
    double length2 = 0.0, seconds = 0.0, slowest = 0.0;
    for (unsigned i = 0; i < view.axis_count; ++i) {
        const double way = std::fabs(to[i] - from[i]), can = view.axes[i].max_feed_mm_min;
        length2 += way * way;
        if (can > 0) seconds = std::fmax(seconds, way / can);
        if (can > 0 && (slowest == 0.0 || can < slowest) && !view.axes[i].rotary) slowest = can;
    }
    const double length = std::sqrt(length2);
    return seconds > 0 ? length / seconds : slowest > 0 ? slowest : 1.0;
}

// The largest feed on a circle from the angle `from` by `sweep` (radians, signed): of either axis
// what is largest of its share.
double Interpreter::largest_feed_on_arc(double from, double sweep, unsigned p, unsigned q) const {
    constexpr double kQuarter = std::numbers::pi / 2;
    const double low = std::fmin(from, from + sweep), high = std::fmax(from, from + sweep);
    double most = 0.0;
    // The share of the abscissa is |sin|, whole at odd quarters; that of the ordinate |cos|, whole
    // at even ones.
    const auto limit = [&](unsigned axis, double at_begin, double at_end, bool odd) {
        const double can = core_.view().axes[axis].max_feed_mm_min;
        double share = std::fmax(std::fabs(at_begin), std::fabs(at_end));
        for (double k = std::ceil(low / kQuarter - 1e-9); k * kQuarter <= high + 1e-9; k += 1.0)
            if ((std::fmod(std::fabs(k), 2.0) == 1.0) == odd) share = 1.0;
        if (can > 0 && share > 1e-12 && (most == 0.0 || can / share < most)) most = can / share;
    };
    limit(p, std::sin(low), std::sin(high), true);
    limit(q, std::cos(low), std::cos(high), false);
    return most;
}

// The modal feed becomes that of the next move.
bool Interpreter::set_feed(const AxisValues& target) {
    PathState& path = core_.path;
    // An override of the program goes before that of the panel (11.2.6).
    path.feed_path.scale = modal_.override_program > 0 ? modal_.override_program / 100.0 : 1.0;
    path.override_locked = modal_.override_program > 0;
    // Degrees count as millimetres; an axis that is positioned only arrives together with the
    // others (5.2.1, 6.2).
    path.feed_path.counted = 0;
    path.feed_path.weight.fill(1.0);
    for (unsigned i = 0; i < core_.view().axis_count; ++i) {
        const int type = get_axis_type(i);
        if (type != 1 && type < 3) path.feed_path.counted |= 1u << i;
    }
    const double feed = modal_.feed_code == 94   ? modal_.feed_minute
                        : modal_.feed_code == 95 ? modal_.feed_revolution
                                                 : modal_.feed_inverse;
    if (feed > 0) {
        path.feed = feed;
        path.feed_mode = modal_.feed_code == 94   ? FeedMode::PerMinute
                         : modal_.feed_code == 95 ? FeedMode::PerRevolution
                                                  : FeedMode::InverseTime;
    } else {
        path.feed = largest_feed(target);
        path.feed_mode = FeedMode::PerMinute;
    }
    path.feed_path.active = path.feed_mode != FeedMode::InverseTime;
    if (modal_.feed_code == 32 && feed > 0) {
        const AxisValues from = core_.framed(path.programmed), to = core_.framed(target);
        double length2 = 0.0;
        for (unsigned i = 0; i < core_.view().axis_count; ++i)
            length2 += (to[i] - from[i]) * (to[i] - from[i]);
        modal_.feed_of_block = feed * std::sqrt(length2);
        const double most = largest_feed(target);
        // an axis would be too fast: its limit is the feed
        if (length2 > 0 && modal_.feed_of_block > most) {
            modal_.feed_of_block = most;
            path.feed = most;
            path.feed_mode = FeedMode::PerMinute;
            path.feed_path.active = true;
        }
    }
    return true;
}

// A thread or a tap turns at 100 %, whatever PRGSSO says (5.3; part 2, 9.6.3, 9.9.6); the next
// other move has its share again.
void Interpreter::follow_spindle(bool thread) {
    const double share = modal_.spindle_override_program;
    spindles_.set(thread || share <= 0 ? 1.0 : share / 100.0, core_.at);
}

// All that moves are axes that are positioned only: "always G00" (3.7). With others they arrive
// together (6.2).
bool Interpreter::only_positions(const AxisValues& target) const {
    bool any = false;
    for (unsigned i = 0; i < core_.view().axis_count; ++i) {
        if (target[i] == core_.path.programmed[i]) continue;
        const int type = get_axis_type(i);
        if (type != 1 && type < 3) return false;
        any = true;
    }
    return any;
}

bool Interpreter::straight(const AxisValues& target, bool rapid) {
    if (rapid || only_positions(target)) return core_.rapid(target);
    return set_feed(target) && core_.linear(target);
}

// G53: the block's coordinates are the machine's; compensation and the tool's lengths rest for it.
bool Interpreter::begin_machine_block() {
    if (!has_axes()) {
        if (letters_ & ~letter_set("FSTDM")) return true;
        core_.clear_preset();
        for (unsigned i = 0; i < core_.view().axis_count; ++i) core_.local_zero(i, 0.0);
        core_.select_zero(kZeroNone);
        modal_.zero = modal_.zero_added = 0;
        refresh_zero();
        return true;
    }
    if (modal_.motion > 3) return core_.fail(Alarm::FagorIncompatible, 'G', "G53 and a thread");
    in_machine_ = true;
    return true;
}

bool Interpreter::g_linear(const GCode& row) {
    AxisSet named = 0;
    follow_spindle(false);
    if (!read_point(target_, &named)) return false;
    if (in_machine_) core_.suspend_for(named);
    slide(target_, named);
    return drive_line(target_, row.number == 0);
}

bool Interpreter::drive_line(const AxisValues& programmed, bool rapid) {
    const AxisValues from = core_.path.programmed;
    AxisValues target = programmed;
    if (!loops_.empty() && leave_out(target)) {
        if (!drive_left_out(target, rapid)) return false;
    } else {
        if ((!ends_sharp() && !element_at_end(true)) || !straight(target, rapid)) return false;
        // the way may have ended elsewhere
        if (!loops_.empty()) core_.path.programmed = programmed;
    }
    int p = -1, q = -1;
    core_.plane_axes(p, q);
    if (p >= 0 && q >= 0)
        note_direction(programmed[static_cast<std::size_t>(p)] - from[static_cast<std::size_t>(p)],
                       programmed[static_cast<std::size_t>(q)] - from[static_cast<std::size_t>(q)]);
    return true;
}

bool Interpreter::g_arc(const GCode& row) {
    unsigned p = 0, q = 0;
    if (!plane_places(p, q)) return false;
    follow_spindle(false);
    AxisValues target;
    AxisSet named = 0;
    const bool by_centre_angle = (row.number == 2 || row.number == 3) && has('Q');
    if (by_centre_angle) {
        target = core_.path.programmed;
        for (unsigned i = 0; i < core_.view().axis_count; ++i)
            if (axis_words_[i])
                return fail_word(*axis_words_[i], Alarm::AddressIllegal,
                                 std::string(1, axis_words_[i]->letter));
    } else if (row.number >= 8 && (has('Q') || has('R'))) {
        target = core_.path.programmed;
        if (axis_words_[p] || axis_words_[q])
            return core_.fail(Alarm::AddressIllegal, has('R') ? 'R' : 'Q', has('R') ? "R" : "Q");
        if (!polar_point(target)) return false;
    } else if (!read_point(target, &named)) {
        return false;
    }
    for (unsigned i = 0; i < core_.view().axis_count; ++i)
        if (axis_words_[i] && i != p && i != q && !core_.view().axes[i].rotary)
            return fail_word(*axis_words_[i], Alarm::FagorNotInPlane,
                             std::string(1, axis_words_[i]->letter));
    if (in_machine_) core_.suspend_for(named);
    if (row.number == 8) return tangent_arc(target);
    if (row.number == 9) return three_point_arc(target);
    const AxisValues& now = core_.path.programmed;
    const bool clockwise = row.number == 2;
    const bool absolute = coded(GGroup::Modifier);  // G06
    const bool centre_given = (letters_ & letter_set("IJK")) != 0;
    if (by_centre_angle) {
        double cp = 0, cq = 0;
        if (centre_given || absolute) {
            if (!arc_centre(target, absolute, cp, cq)) return false;
        } else {
            polar_origin(cp, cq);
        }
        const double radius = has('R') ? distance('R') : std::hypot(now[p] - cp, now[q] - cq);
        const double degree = std::numbers::pi / 180.0;
        double angle = std::fmod(number('Q'), 360.0) * degree;
        if (!modal_.absolute) angle += std::atan2(now[q] - cq, now[p] - cp);
        target[p] = cp + radius * std::cos(angle);
        target[q] = cq + radius * std::sin(angle);
        return drive_arc(target, cp, cq, clockwise);
    }
    if (has('R')) {
        if (centre_given) return core_.fail(Alarm::AddressIllegal, 'R', "R");
        const double radius = distance('R');
        const double chord = std::hypot(target[p] - now[p], target[q] - now[q]);
        if (chord < kSame) return core_.fail(Alarm::FagorFullCircle, 'R', "R");
        if (radius == 0.0) return core_.fail(Alarm::ArcRadiusIllegal, 'R');
        const double half = chord / 2, r = std::fabs(radius);
        if (half - r > settings_.arc_tolerance)
            return core_.fail(Alarm::RadiusTooSmall, 'R', {}, half - r);
        const double height = r > half ? std::sqrt((r - half) * (r + half)) : 0.0;
        // left of the chord: short and anticlockwise, or long and clockwise
        const double side = (clockwise != (radius < 0)) ? -1.0 : 1.0;
        return drive_arc(
            target, (now[p] + target[p]) / 2 - side * height * (target[q] - now[q]) / chord,
            (now[q] + target[q]) / 2 + side * height * (target[p] - now[p]) / chord, clockwise);
    }
    if (!centre_given && !absolute) return core_.fail(Alarm::ArcWithoutRadius, 'G');
    double cp = 0, cq = 0;
    return arc_centre(target, absolute, cp, cq) && drive_arc(target, cp, cq, clockwise);
}

bool Interpreter::drive_arc(const AxisValues& programmed, double cp, double cq, bool clockwise) {
    unsigned p = 0, q = 0;
    if (!plane_places(p, q)) return false;
    AxisValues target = programmed;
    const bool left_out = !loops_.empty() && leave_out(target);
    if (!left_out && !ends_sharp() && !element_at_end(false)) return false;
    ArcCall call;
    call.clockwise = clockwise;
    call.centre_p = cp;
    call.centre_q = cq;
    call.tolerance = settings_.arc_tolerance;
    if (modal_.feed_code == 32 && modal_.feed_inverse > 0) {
        const AxisValues& now = core_.path.programmed;
        const double a0 = std::atan2(now[q] - cq, now[p] - cp),
                     a1 = std::atan2(target[q] - cq, target[p] - cp), turn = 2 * std::numbers::pi;
        double sweep = clockwise ? a0 - a1 : a1 - a0;
        sweep -= std::floor(sweep / turn) * turn;
        if (std::hypot(target[p] - now[p], target[q] - now[q]) < kSame) sweep = turn;
        core_.path.feed = modal_.feed_inverse;
        core_.path.feed_mode = FeedMode::InverseTime;
        core_.path.feed_path.active = false;
        modal_.feed_of_block =
            modal_.feed_inverse * sweep * std::hypot(now[p] - cp, now[q] - cq) * modal_.scale;
        // An axis would be too fast: its limit is the feed, as on a line (6.15).
        if (const double most = largest_feed_on_arc(a0, clockwise ? -sweep : sweep, p, q);
            most > 0 && modal_.feed_of_block > most) {
            modal_.feed_of_block = most;
            core_.path.feed = most;
            core_.path.feed_mode = FeedMode::PerMinute;
            core_.path.feed_path.active = true;
        }
    } else if (!set_feed(target)) {
        return false;
    }
    if (left_out ? !drive_left_out(target, false) : !core_.arc(target, call)) return false;
    if (!loops_.empty()) core_.path.programmed = programmed;  // the way may have ended elsewhere
    const double rp = programmed[p] - cp, rq = programmed[q] - cq;
    note_direction(clockwise ? rq : -rq, clockwise ? -rp : rp);
    if (settings_.polar_origin_moves) set_polar_origin(cp, cq);
    return true;
}

// G08: the circle through the end point that leaves the path before it without a bend.
bool Interpreter::tangent_arc(const AxisValues& target) {
    unsigned p = 0, q = 0;
    if (!plane_places(p, q)) return false;
    if (letters_ & letter_set("IJK")) return core_.fail(Alarm::AddressIllegal, 'I', "I J K");
    double tp = 0, tq = 0;
    if (!end_direction(tp, tq)) return core_.fail(Alarm::FagorTangential, 'G', "G08");
    const AxisValues& now = core_.path.programmed;
    const double dp = target[p] - now[p], dq = target[q] - now[q], chord2 = dp * dp + dq * dq;
    if (chord2 < kSame * kSame) return core_.fail(Alarm::FagorFullCircle, 'G', "G08");
    const double aside = dq * tp - dp * tq;  // (E - P) . left normal of t
    if (std::fabs(aside) < kSame) {
        if (dp * tp + dq * tq <= 0) return core_.fail(Alarm::FagorThreePoints, 'G', "G08");
        return drive_line(target, false);  // straight on is the circle of infinite radius
    }
    const double k = chord2 / (2 * aside);
    return drive_arc(target, now[p] - k * tq, now[q] + k * tp, k < 0);
}

bool Interpreter::three_point_arc(const AxisValues& target) {
    unsigned p = 0, q = 0;
    if (!plane_places(p, q)) return false;
    const char lp = centre_letter(p), lq = centre_letter(q);
    if (!has(lp) && !has(lq))
        return core_.fail(Alarm::FagorMotionWord, 'G', std::string{lp, ' ', lq}, 9);
    const AxisValues& now = core_.path.programmed;
    const double mp = has(lp) ? length(number(lp), static_cast<int>(p)) : now[p],
                 mq = has(lq) ? length(number(lq), static_cast<int>(q)) : now[q];
    const double ap = mp - now[p], aq = mq - now[q], bp = target[p] - now[p],
                 bq = target[q] - now[q];
    const double cross = ap * bq - aq * bp;
    const double a2 = ap * ap + aq * aq, b2 = bp * bp + bq * bq,
                 c2 = (ap - bp) * (ap - bp) + (aq - bq) * (aq - bq);
    if (a2 < kSame * kSame || b2 < kSame * kSame || c2 < kSame * kSame ||
        std::fabs(cross) < 1e-9 * std::sqrt(a2 * b2))
        return core_.fail(Alarm::FagorThreePoints, 'G', "G09");
    const double cp = (bq * a2 - aq * b2) / (2 * cross), cq = (ap * b2 - bp * a2) / (2 * cross);
    // from the start through the middle to the end: that way round
    return drive_arc(target, now[p] + cp, now[q] + cq, cross < 0);
}

bool Interpreter::g_thread(const GCode& row) {
    if (!has_axes())
        return core_.fail(Alarm::CoordinateAxisNone, 'G', row.number == 33 ? "G33" : "G34");
    if (has('Q') && !settings_.thread_angle) return core_.fail(Alarm::FagorThreadAngle, 'Q');
    if (std::fabs(number('Q')) >= 360.0)
        return core_.fail(Alarm::FagorValueRange, 'Q', "Q", number('Q'));
    if (!read_point_without_polar(target_)) return false;
    double lead = has('L') ? distance('L') : modal_.lead;
    double change = row.number == 34 ? distance('K') : 0.0;
    if (lead < 0) return core_.fail(Alarm::NegativeSign, 'L', "L");
    const bool joined = core_.path.after_thread && modal_.corner == 5;
    // only the first one has an angle (6.11)
    if (joined && has('Q')) return core_.fail(Alarm::FagorThreadJoin, 'Q', "Q");
    if (joined && row.number == 33 && modal_.lead_varies)
        return core_.fail(Alarm::FagorThreadJoin, 'G', "G34 G33");
    if (row.number == 34) {
        if (joined && modal_.lead_varies && change != 0.0)
            return core_.fail(Alarm::FagorThreadJoin, 'G', "G34 G34");
        // L0 K0: on with the pitch reached
        if (joined && modal_.lead_varies && lead == 0.0)
            lead = modal_.end_lead;
        else if (joined && !modal_.lead_varies && change != 0.0 &&
                 std::fabs(lead - modal_.end_lead) > 1e-6)
            return core_.fail(Alarm::FagorThreadJoin, 'L', "L");
    }
    double length = 0.0, along = 0.0;
    thread_travel(target_, length, along);
    if (lead == 0.0) return core_.fail(Alarm::LeadMissing, 'L');
    // pitch after the way s: v^2 = L^2 + 2 K s
    const double square = lead * lead + 2 * change * along;
    if (square <= 0) return core_.fail(Alarm::FagorCyclePitch, 'K');
    if (!joined) core_.path.after_thread = false;  // only G05 joins threads
    ThreadCall call;
    call.lead = lead;
    call.lead_change = change;
    call.start_angle = has('Q') ? number('Q') : 0.0;
    if (modal_.withdraws) {  // G233: at most three axes leave the thread
        std::size_t slot = 0;
        for (unsigned i = 0; i < core_.view().axis_count && slot < call.withdraw.size(); ++i) {
            if (modal_.withdrawal[i] == 0.0) continue;
            call.withdraw_axis[slot] = static_cast<std::int8_t>(i);
            call.withdraw[slot++] = modal_.withdrawal[i];
        }
    }
    follow_spindle(true);
    if (!core_.thread(target_, call)) return false;
    modal_.lead = lead;
    modal_.end_lead = std::sqrt(square);
    modal_.lead_varies = change != 0.0;
    return true;
}

// Length of the way, and its part along the axis that travels most.
void Interpreter::thread_travel(const AxisValues& target, double& length, double& along) const {
    const AxisValues from = core_.framed(core_.path.programmed), to = core_.framed(target);
    double square = 0.0;
    for (unsigned i = 0; i < core_.view().axis_count; ++i) {
        const double way = std::fabs(to[i] - from[i]);
        square += way * way;
        along = std::fmax(along, way);
    }
    length = std::sqrt(square);
}

bool Interpreter::read_point_without_polar(AxisValues& target) {
    const Word* q = std::exchange(by_letter_['Q' - 'A'], nullptr);
    const std::uint32_t letters = std::exchange(letters_, letters_ & ~letter_set("QR"));
    const bool good = read_point(target, nullptr);
    by_letter_['Q' - 'A'] = q;
    letters_ = letters;
    return good;
}

// G233: how far the axes leave a thread that is stopped.
bool Interpreter::g_withdrawal(const GCode&) {
    modal_.withdrawal = {};
    modal_.withdraws = false;
    for (unsigned i = 0; i < core_.view().axis_count; ++i) {
        if (!axis_words_[i]) continue;
        modal_.withdrawal[i] = axis_words_[i]->value * unit();  // a true distance
        modal_.withdraws = modal_.withdraws || axis_words_[i]->value != 0.0;
    }
    return true;
}

// G52: towards the target until the axis meets something; G01 and G40 hold behind it.
bool Interpreter::g_hard_stop(const GCode&) {
    if (!has_axes()) return core_.fail(Alarm::CoordinateAxisNone, 'G', "G52");
    if (modal_.comp != 40) return core_.fail(Alarm::FagorIncompatible, 'G', "G52 G41");
    if (modal_.inclined) return core_.fail(Alarm::FagorInclined, 'G', "G52");
    if (!read_point(target_, nullptr) || !set_feed(target_)) return false;
    modal_.motion = 1;
    // Its drives get only the torque of PT_STOP_TORQUE on the way; what is pressed is let go behind
    // it.
    for (unsigned i = 0; i < core_.view().axis_count; ++i)
        if (std::fabs(target_[i] - core_.path.programmed[i]) > 1e-9)
            core_.limit_torque(
                i,
                static_cast<double>(params::get(core_.view().table(), params::pt_stop_torque,
                                                core_.view().axes[i].machine_axis + 1u)),
                0.0);
    return start_probe("HARDSTOP", 52);
}

}  // namespace polyturn::channels::fagor
