// Threads and taps: G33 G34 G35, G335 G336, G331 G332, G63 (sinumerik_part2 10.10, 10.11).
#include <cmath>

#include "channels/compensation/options.hpp"
#include "channels/sinumerik/interpreter.hpp"

namespace polyturn::channels::sinumerik {
namespace {

struct PitchName {
    std::string_view name;
    PlaneRole role;
};
constexpr PitchName kPitch[] = {
    {"I", PlaneRole::BasicX}, {"J", PlaneRole::BasicY}, {"K", PlaneRole::BasicZ}};

}  // namespace

// I J K: the pitch along X Y Z, whatever AC and IC say; exactly one of them.
bool Interpreter::pitch_word(double& pitch, unsigned& axis, const Word*& said) {
    said = nullptr;
    for (const PitchName& row : kPitch) {
        const Word* w = word(row.name);
        if (!w || w->number() == 0) continue;
        if (said)
            return fail_word(Alarm::CodesContradict, *w,
                             std::string(said->address->name) + ", " + std::string(row.name));
        const int place = core_.view().axis_by_role(row.role);
        if (place < 0) return fail_word(Alarm::PlaneAxisMissing, *w);
        said = w;
        axis = static_cast<unsigned>(place);
        pitch = w->number() * unit();
    }
    return said || fail(Alarm::LeadMissing);
}

double Interpreter::thread_start() const {
    return modal_.geo.thread_angle >= 0 ? modal_.geo.thread_angle : settings_.thread_start_deg;
}

bool Interpreter::geo_thread(const GCode& code) {
    return driven([&] {
        AxisValues target{};
        AxisSet named = 0;
        if (!read_axis_words(target, named)) return false;
        if (polar_ahead() && !polar_target(target)) return false;
        if (!named && !polar_ahead()) return true;
        ThreadCall call;
        const Word* said = nullptr;
        unsigned axis = 0;
        if (!pitch_word(call.lead, axis, said)) return false;
        call.lead = std::fabs(call.lead);  // the hand is the spindle's direction
        call.by_axis = true;
        call.axis = static_cast<std::uint8_t>(axis);
        call.start_angle = thread_start();
        if (!travel_out(call, target)) return false;
        if (code.name != "G33") {
            const Word* change = word("F");
            if (!change) return fail(Alarm::ReturnValueMissing, "F");
            call.lead_change = change->number() * unit() * (code.name == "G34" ? 1.0 : -1.0);
            const double way = std::fabs(target[axis] - core_.path.programmed[axis]);
            if (call.lead * call.lead + 2 * call.lead_change * way <= 0)
                return fail_word(Alarm::LeadRunsOut, *change);
        }
        if (!within_areas(target) || !leads_nobody(target)) return false;
        const AxisValues from = core_.path.programmed;
        if (!core_.thread(target, call)) return false;
        note_tangent(from, target);
        return true;
    });
}

// LFOF: a hold acts behind the thread. LFON: the axes leave it by DILF in the direction of ALF,
// 45 degrees a step in the plane (LFWP) or from the tool's direction on (LFTXT), or go to their
// POLF (LFPOS).
bool Interpreter::travel_out(ThreadCall& call, const AxisValues& target) {
    call.own_withdrawal = true;
    if (active(41) != 2) return true;
    std::size_t used = 0;
    const auto leave = [&](std::size_t place, double by) {
        if (used == call.withdraw.size() || std::fabs(by) < 1e-9) return;
        call.withdraw_axis[used] = static_cast<std::int8_t>(place);
        call.withdraw[used++] = by;
    };
    if (active(46) == 3) {
        lift_to_positions(leave);
        return true;
    }
    return lift_in_plane(call.axis,
                         target[call.axis] < core_.path.programmed[call.axis] ? -1.0 : 1.0,
                         LiftSide::AgainstInfeed, leave);
}

void Interpreter::lift_to_positions(const LeaveBy& leave) const {
    const GeoModal& geo = modal_.geo;
    for (unsigned i = 0; i < core_.view().axis_count; ++i)
        if (geo.lift_axes & geo.lift_set & 1u << i)
            leave(i, geo.lift_incremental >> i & 1u ? geo.lift_to[i]
                                                    : geo.lift_to[i] - core_.path.programmed[i]);
}

// Which way of this axis leads from the cutting edge into the tool, and so off the workpiece: the
// position of the edge (DP2) says where its point lies seen from the middle of the nose (part 1,
// 6.4; part 2, 11.1), in the axes of G18 as they are without a frame. 0: it does not tell, or a
// frame turns the axis aside.
double Interpreter::away_from_edge(std::size_t across) const {
    const std::int32_t position = core_.path.tool.tip;
    if (core_.path.plane != Plane::ZX || position < 1 || position > 8) return 0.0;
    const auto& [along_z, along_x] = compensation::kTips[static_cast<std::size_t>(position)];
    const double off = -(core_.view().axes[across].role == PlaneRole::BasicZ ? along_z : along_x);
    AxisValues ahead = core_.path.programmed;
    ahead[across] += 1.0;
    const AxisValues here = core_.framed(core_.path.programmed), there = core_.framed(ahead);
    for (unsigned i = 0; i < core_.view().axis_count; ++i)
        if (i != across && std::fabs(there[i] - here[i]) > 1e-6) return 0.0;
    return there[across] < here[across] ? -off : off;
}

// `along`: the axis of the plane that the path follows, in the direction `on`.
bool Interpreter::lift_in_plane(std::size_t along, double on, LiftSide side, const LeaveBy& leave) {
    const GeoModal& geo = modal_.geo;
    if (geo.lift_angle == 0 || !needs_plane()) return geo.lift_angle == 0;
    const auto [p, q] = plane_places();
    const double way = geo.lift_mm >= 0 ? geo.lift_mm : settings_.lift_distance_mm;
    const double angle = (geo.lift_angle - 1.0) * 45.0 * 3.14159265358979323846 / 180.0;
    if (active(46) == 2) {  // from the first axis of the plane towards the second
        leave(p, way * std::cos(angle));
        leave(q, way * std::sin(angle));
        return true;
    }
    const std::size_t across = along == p ? q : p;
    // a thread: back against the infeed
    double away = core_.path.last_travel[across] > 0 ? -1.0 : 1.0;
    if (side == LiftSide::FromEdge) {
        // On a contour the last way of that axis may have led along a shoulder, away from the work.
        away = away_from_edge(across);
        if (away == 0.0)
            return fail(Alarm::NotBuilt,
                        "LIFTFAST LFTXT: $TC_DP2=" + std::to_string(core_.path.tool.tip));
    }
    leave(across, away * way * std::cos(angle));
    leave(along, on * way * std::sin(angle));
    return true;
}

// A thread on an arc. The pitch counts along its axis, and that axis must have the larger share of
// the way; up to 60 degrees off it are accepted, since the examples of the specification go beyond
// 45 (part 2, 10.10.5).
bool Interpreter::geo_barrel(const GCode& code) {
    return driven([&] {
        AxisValues target{};
        AxisSet named = 0;
        if (!read_axis_words(target, named)) return false;
        if (!named && !has("IR") && !has("JR") && !has("KR")) return true;
        if (!needs_plane()) return false;
        ThreadCall call;
        const Word* said = nullptr;
        unsigned axis = 0;
        if (!pitch_word(call.lead, axis, said)) return false;
        call.lead = std::fabs(call.lead);
        call.by_axis = true;
        call.axis = static_cast<std::uint8_t>(axis);
        call.start_angle = thread_start();
        if (!travel_out(call, target)) return false;
        ArcCall arc;
        arc.clockwise = code.name == "G335";
        if (!barrel_arc(target, arc)) return false;
        const auto [p, q] = plane_places();
        if (axis != p && axis != q)
            return fail_word(Alarm::AxisKindWrong, *said, std::string(said->address->name));
        const double along_p = axis == p ? 1.0 : 0.0;
        // tangent: across the radius
        for (const AxisValues& point : {core_.path.programmed, target}) {
            const double up = point[p] - arc.centre_p, uq = point[q] - arc.centre_q,
                         r = std::hypot(up, uq);
            if (r > 0 && std::fabs(along_p > 0 ? uq : up) / r < 0.5 - 1e-9)
                return fail_word(Alarm::ThreadArcTooSteep, *said);
        }
        if (!within_areas(target) || !leads_nobody(target)) return false;
        call.arc = &arc;
        return core_.thread(target, call);
    });
}

bool Interpreter::barrel_arc(AxisValues& target, ArcCall& arc) {
    const auto [p, q] = plane_places();
    static constexpr std::string_view kNames[3][2] = {{"IR", "JR"}, {"KR", "IR"}, {"JR", "KR"}};
    const auto& names = kNames[static_cast<std::size_t>(core_.path.plane)];
    const Word* radius = word("CR");
    const Word* opening = word("AR");
    const Word* wp = word(names[0]);
    const Word* wq = word(names[1]);
    constexpr double kDegree = 3.14159265358979323846 / 180.0;
    arc.centre_p = core_.path.programmed[p] + (wp ? wp->number() * unit() : 0.0);
    arc.centre_q = core_.path.programmed[q] + (wq ? wq->number() * unit() : 0.0);
    if (radius) return centre_by_radius(target, radius->number() * unit(), arc);
    if (opening && !(opening->number() > 0 && opening->number() < 360))
        return fail_word(Alarm::ValueOutOfRange, *opening, "AR", opening->number());
    if (opening && (wp || wq)) {
        const double angle = opening->number() * kDegree * (arc.clockwise ? -1.0 : 1.0);
        const double ap = core_.path.programmed[p] - arc.centre_p,
                     aq = core_.path.programmed[q] - arc.centre_q;
        target[p] = arc.centre_p + ap * std::cos(angle) - aq * std::sin(angle);
        target[q] = arc.centre_q + ap * std::sin(angle) + aq * std::cos(angle);
        arc.tolerance = 1e-3;
        return true;
    }
    if (opening) {
        const double chord =
            std::hypot(target[p] - core_.path.programmed[p], target[q] - core_.path.programmed[q]);
        const double r = chord / (2 * std::sin(opening->number() / 2 * kDegree));
        return centre_by_radius(target, opening->number() > 180 ? -r : r, arc);
    }
    if (wp || wq) return fit_centre(target, arc);
    if (!has("I1") && !has("J1") && !has("K1")) return fail(Alarm::ArcWithoutRadius);
    static constexpr std::string_view kBetween[3][2] = {{"I1", "J1"}, {"K1", "I1"}, {"J1", "K1"}};
    const auto& between = kBetween[static_cast<std::size_t>(core_.path.plane)];
    const auto coordinate = [&](std::string_view name, std::size_t place) {
        const Word* w = word(name);
        return w ? w->number() * unit() : core_.path.programmed[place];
    };
    const double ap = core_.path.programmed[p], aq = core_.path.programmed[q];
    const double bp = coordinate(between[0], p) - ap, bq = coordinate(between[1], q) - aq,
                 cp = target[p] - ap, cq = target[q] - aq;
    const double d = 2 * (bp * cq - bq * cp);
    if (std::fabs(d) < 1e-9) return fail(Alarm::ArcPointsOnLine);
    const double b2 = bp * bp + bq * bq, c2 = cp * cp + cq * cq;
    arc.centre_p = ap + (cq * b2 - bq * c2) / d;
    arc.centre_q = aq + (bp * c2 - cp * b2) / d;
    arc.clockwise = d < 0;
    arc.tolerance = 1e-3;
    return true;
}

// G331 cuts with the hand given by the sign of the pitch, G332 returns in the other sense:
// the spindle is led by the axis. Both have the speed S; the overrides do not act.
bool Interpreter::geo_tap(const GCode& code) {
    return driven([&] {
        AxisValues target{};
        AxisSet named = 0;
        if (!read_axis_words(target, named)) return false;
        if (!named) return true;
        double pitch = 0.0;
        const Word* said = nullptr;
        unsigned axis = 0;
        if (!pitch_word(pitch, axis, said)) return false;
        if (std::fabs(pitch) < 0.001 || std::fabs(pitch) > 2000)
            return fail_word(Alarm::ValueOutOfRange, *said, std::string(said->address->name),
                             pitch);
        if (!within_areas(target) || !leads_nobody(target)) return false;
        PathState& path = core_.path;
        if (path.spindle.rpm <= 0) return fail(Alarm::ThreadSpindleStopped);
        Core::TapLoop loop;
        if (!core_.rigid_loop(loop, true)) return false;
        if (!spindle_closed(path.spindle.spindle)) close_spindle(false);  // from its position
        const PathState before = path;
        const double way = core_.framed(target)[axis] - core_.framed_now()[axis];
        path.tap_pitch = pitch;
        path.tap_axis = static_cast<std::uint8_t>(axis);
        path.tap_depth_sign = (way < 0) == (code.name == "G331") ? -1.0 : 1.0;
        path.feed_mode = FeedMode::PerMinute;
        path.feed = path.spindle.rpm * std::fabs(pitch);
        path.feed_path = {};
        path.override_locked = true;
        core_.force_exact_stop();
        const bool done = core_.linear(target);
        path.tap_pitch = 0.0;
        path.feed_mode = before.feed_mode;
        path.feed = before.feed;
        path.feed_path = before.feed_path;
        path.override_locked = before.override_locked;
        return done;
    });
}

// G63: feed with a compensating chuck; the switches of feed and spindle override do not act.
bool Interpreter::geo_tap_chuck(const GCode&) {
    return driven([&] {
        AxisValues target{};
        AxisSet named = 0;
        if (!read_axis_words(target, named)) return false;
        if (!named) return true;
        const bool locked = core_.path.override_locked;
        core_.path.override_locked = true;
        const bool done = within_areas(target) && core_.linear(target);
        core_.path.override_locked = locked;
        return done;
    });
}

}  // namespace polyturn::channels::sinumerik
