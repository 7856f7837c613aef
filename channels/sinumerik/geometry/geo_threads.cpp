// Threads and taps: G33 G34 G35, G335 G336, G331 G332, G63 (sinumerik_part2 10.10, 10.11).
#include "channels/sinumerik/geometry/geo_threads.hpp"

#include <cmath>

#include "channels/compensation/options.hpp"
#include "channels/sinumerik/axes/axis_words.hpp"
#include "channels/sinumerik/coupling/coupled_axes.hpp"
#include "channels/sinumerik/execution.hpp"
#include "channels/sinumerik/faults.hpp"
#include "channels/sinumerik/geometry/geo_arcs.hpp"
#include "channels/sinumerik/geometry/geo_motion.hpp"
#include "channels/sinumerik/geometry/lifting.hpp"
#include "channels/sinumerik/geometry/travel_limits.hpp"
#include "channels/sinumerik/geometry/units.hpp"
#include "channels/sinumerik/grammar/groups.hpp"
#include "channels/sinumerik/grammar/without_effect.hpp"
#include "channels/sinumerik/grammar/words.hpp"
#include "channels/sinumerik/spindles/spindle_commands.hpp"
#include "channels/sinumerik/variables/changes.hpp"

namespace polyturn::channels::sinumerik {
namespace {

struct PitchName {
    std::string_view name;
    PlaneRole role;
};
constexpr PitchName kPitch[] = {
    {"I", PlaneRole::BasicX}, {"J", PlaneRole::BasicY}, {"K", PlaneRole::BasicZ}};

// I J K: the pitch along X Y Z, whatever AC and IC say; exactly one of them.
bool pitch_word(Execution& x, double& pitch, unsigned& axis, const Word*& said) {
    said = nullptr;
    for (const PitchName& row : kPitch) {
        const Word* w = word(x, row.name);
        if (!w || w->number() == 0) continue;
        if (said)
            return fail_word(x, Alarm::CodesContradict, *w,
                             std::string(said->address->name) + ", " + std::string(row.name));
        const int place = x.core.view().axis_by_role(row.role);
        if (place < 0) return fail_word(x, Alarm::PlaneAxisMissing, *w);
        said = w;
        axis = static_cast<unsigned>(place);
        pitch = w->number() * unit(x);
    }
    return said || fail(x, Alarm::LeadMissing);
}

double thread_start(const Execution& x) {
    return x.modal.geo.thread_angle >= 0 ? x.modal.geo.thread_angle : x.settings.thread_start_deg;
}

// LFOF: a hold acts behind the thread. LFON: the axes leave it by DILF in the direction of ALF,
// 45 degrees a step in the plane (LFWP) or from the tool's direction on (LFTXT), or go to their
// POLF (LFPOS).
bool travel_out(Execution& x, ThreadCall& call, const AxisValues& target) {
    call.own_withdrawal = true;
    if (active(x, 41) != 2) return true;
    std::size_t used = 0;
    const auto leave = [&](std::size_t place, double by) {
        if (used == call.withdraw.size() || std::fabs(by) < 1e-9) return;
        call.withdraw_axis[used] = static_cast<std::int8_t>(place);
        call.withdraw[used++] = by;
    };
    if (active(x, 46) == 3) {
        lift_to_positions(x, leave);
        return true;
    }
    return lift_in_plane(x, call.axis,
                         target[call.axis] < x.core.path.programmed[call.axis] ? -1.0 : 1.0,
                         LiftSide::AgainstInfeed, leave);
}

bool barrel_arc(Execution& x, AxisValues& target, ArcCall& arc) {
    const auto [p, q] = plane_places(x);
    static constexpr std::string_view kNames[3][2] = {{"IR", "JR"}, {"KR", "IR"}, {"JR", "KR"}};
    const auto& names = kNames[static_cast<std::size_t>(x.core.path.plane)];
    const Word* radius = word(x, "CR");
    const Word* opening = word(x, "AR");
    const Word* wp = word(x, names[0]);
    const Word* wq = word(x, names[1]);
    constexpr double kDegree = 3.14159265358979323846 / 180.0;
    arc.centre_p = x.core.path.programmed[p] + (wp ? wp->number() * unit(x) : 0.0);
    arc.centre_q = x.core.path.programmed[q] + (wq ? wq->number() * unit(x) : 0.0);
    if (radius) return centre_by_radius(x, target, radius->number() * unit(x), arc);
    if (opening && !(opening->number() > 0 && opening->number() < 360))
        return fail_word(x, Alarm::ValueOutOfRange, *opening, "AR", opening->number());
    if (opening && (wp || wq)) {
        const double angle = opening->number() * kDegree * (arc.clockwise ? -1.0 : 1.0);
        const double ap = x.core.path.programmed[p] - arc.centre_p,
                     aq = x.core.path.programmed[q] - arc.centre_q;
        target[p] = arc.centre_p + ap * std::cos(angle) - aq * std::sin(angle);
        target[q] = arc.centre_q + ap * std::sin(angle) + aq * std::cos(angle);
        arc.tolerance = 1e-3;
        return true;
    }
    if (opening) {
        const double chord = std::hypot(target[p] - x.core.path.programmed[p],
                                        target[q] - x.core.path.programmed[q]);
        const double r = chord / (2 * std::sin(opening->number() / 2 * kDegree));
        return centre_by_radius(x, target, opening->number() > 180 ? -r : r, arc);
    }
    if (wp || wq) return fit_centre(x, target, arc);
    if (!has(x, "I1") && !has(x, "J1") && !has(x, "K1")) return fail(x, Alarm::ArcWithoutRadius);
    static constexpr std::string_view kBetween[3][2] = {{"I1", "J1"}, {"K1", "I1"}, {"J1", "K1"}};
    const auto& between = kBetween[static_cast<std::size_t>(x.core.path.plane)];
    const auto coordinate = [&](std::string_view name, std::size_t place) {
        const Word* w = word(x, name);
        return w ? w->number() * unit(x) : x.core.path.programmed[place];
    };
    const double ap = x.core.path.programmed[p], aq = x.core.path.programmed[q];
    const double bp = coordinate(between[0], p) - ap, bq = coordinate(between[1], q) - aq,
                 cp = target[p] - ap, cq = target[q] - aq;
    const double d = 2 * (bp * cq - bq * cp);
    if (std::fabs(d) < 1e-9) return fail(x, Alarm::ArcPointsOnLine);
    const double b2 = bp * bp + bq * bq, c2 = cp * cp + cq * cq;
    arc.centre_p = ap + (cq * b2 - bq * c2) / d;
    arc.centre_q = aq + (bp * c2 - cp * b2) / d;
    arc.clockwise = d < 0;
    arc.tolerance = 1e-3;
    return true;
}

}  // namespace

bool geo_thread(Execution& x, const GCode& code) {
    return driven(x, [&] {
        AxisValues target{};
        AxisSet named = 0;
        if (!read_axis_words(x, target, named)) return false;
        if (polar_ahead(x) && !polar_target(x, target)) return false;
        if (!named && !polar_ahead(x)) return true;
        ThreadCall call;
        const Word* said = nullptr;
        unsigned axis = 0;
        if (!pitch_word(x, call.lead, axis, said)) return false;
        call.lead = std::fabs(call.lead);  // the hand is the spindle's direction
        call.by_axis = true;
        call.axis = static_cast<std::uint8_t>(axis);
        call.start_angle = thread_start(x);
        if (!travel_out(x, call, target)) return false;
        if (code.name != "G33") {
            const Word* change = word(x, "F");
            if (!change) return fail(x, Alarm::ReturnValueMissing, "F");
            call.lead_change = change->number() * unit(x) * (code.name == "G34" ? 1.0 : -1.0);
            const double way = std::fabs(target[axis] - x.core.path.programmed[axis]);
            if (call.lead * call.lead + 2 * call.lead_change * way <= 0)
                return fail_word(x, Alarm::LeadRunsOut, *change);
        }
        if (!within_areas(x, target) || !leads_nobody(x, target)) return false;
        const AxisValues from = x.core.path.programmed;
        if (!x.core.thread(target, call)) return false;
        note_tangent(x, from, target);
        return true;
    });
}

// A thread on an arc. The pitch counts along its axis, and that axis must have the larger share of
// the way; up to 60 degrees off it are accepted, since the examples of the specification go beyond
// 45 (part 2, 10.10.5).
bool geo_barrel(Execution& x, const GCode& code) {
    return driven(x, [&] {
        AxisValues target{};
        AxisSet named = 0;
        if (!read_axis_words(x, target, named)) return false;
        if (!named && !has(x, "IR") && !has(x, "JR") && !has(x, "KR")) return true;
        if (!needs_plane(x)) return false;
        ThreadCall call;
        const Word* said = nullptr;
        unsigned axis = 0;
        if (!pitch_word(x, call.lead, axis, said)) return false;
        call.lead = std::fabs(call.lead);
        call.by_axis = true;
        call.axis = static_cast<std::uint8_t>(axis);
        call.start_angle = thread_start(x);
        if (!travel_out(x, call, target)) return false;
        ArcCall arc;
        arc.clockwise = code.name == "G335";
        if (!barrel_arc(x, target, arc)) return false;
        const auto [p, q] = plane_places(x);
        if (axis != p && axis != q)
            return fail_word(x, Alarm::AxisKindWrong, *said, std::string(said->address->name));
        const double along_p = axis == p ? 1.0 : 0.0;
        // tangent: across the radius
        for (const AxisValues& point : {x.core.path.programmed, target}) {
            const double up = point[p] - arc.centre_p, uq = point[q] - arc.centre_q,
                         r = std::hypot(up, uq);
            if (r > 0 && std::fabs(along_p > 0 ? uq : up) / r < 0.5 - 1e-9)
                return fail_word(x, Alarm::ThreadArcTooSteep, *said);
        }
        if (!within_areas(x, target) || !leads_nobody(x, target)) return false;
        call.arc = &arc;
        return x.core.thread(target, call);
    });
}

// G331 cuts with the hand given by the sign of the pitch, G332 returns in the other sense:
// the spindle is led by the axis. Both have the speed S; the overrides do not act.
bool geo_tap(Execution& x, const GCode& code) {
    return driven(x, [&] {
        AxisValues target{};
        AxisSet named = 0;
        if (!read_axis_words(x, target, named)) return false;
        if (!named) return true;
        double pitch = 0.0;
        const Word* said = nullptr;
        unsigned axis = 0;
        if (!pitch_word(x, pitch, axis, said)) return false;
        if (std::fabs(pitch) < 0.001 || std::fabs(pitch) > 2000)
            return fail_word(x, Alarm::ValueOutOfRange, *said, std::string(said->address->name),
                             pitch);
        if (!within_areas(x, target) || !leads_nobody(x, target)) return false;
        PathState& path = x.core.path;
        if (path.spindle.rpm <= 0) return fail(x, Alarm::ThreadSpindleStopped);
        Core::TapLoop loop;
        if (!x.core.rigid_loop(loop, true)) return false;
        if (!spindle_closed(x, path.spindle.spindle)) close_spindle(x, false);  // from its position
        const PathState before = path;
        const double way = x.core.framed(target)[axis] - x.core.framed_now()[axis];
        path.tap_pitch = pitch;
        path.tap_axis = static_cast<std::uint8_t>(axis);
        path.tap_depth_sign = (way < 0) == (code.name == "G331") ? -1.0 : 1.0;
        path.feed_mode = FeedMode::PerMinute;
        path.feed = path.spindle.rpm * std::fabs(pitch);
        path.feed_path = {};
        path.override_locked = true;
        x.core.force_exact_stop();
        const bool done = x.core.linear(target);
        path.tap_pitch = 0.0;
        path.feed_mode = before.feed_mode;
        path.feed = before.feed;
        path.feed_path = before.feed_path;
        path.override_locked = before.override_locked;
        return done;
    });
}

// G63: feed with a compensating chuck; the switches of feed and spindle override do not act.
bool geo_tap_chuck(Execution& x, const GCode&) {
    return driven(x, [&] {
        AxisValues target{};
        AxisSet named = 0;
        if (!read_axis_words(x, target, named)) return false;
        if (!named) return true;
        const bool locked = x.core.path.override_locked;
        x.core.path.override_locked = true;
        const bool done = within_areas(x, target) && x.core.linear(target);
        x.core.path.override_locked = locked;
        return done;
    });
}

// DITS, DITE: -1, 0 or a way; kept as setting data.
bool a_thread_ramp(Execution& x, const Word& word) {
    const double way = word.number();
    if (way < 0 && way != -1)
        return fail_word(x, Alarm::ValueOutOfRange, word, std::string(word.address->name), way);
    params::Table& table = *x.core.view().parameters;
    const params::Row& row = *params::find("SD42010");
    const std::size_t slot = row.first_slot + (x.core.view().channel - 1) * row.array +
                             (word.address->name == "DITE" ? 1 : 0);
    undo(x, [&x, slot, before = table.numbers[slot]] {
        x.core.view().parameters->numbers[slot] = before;
    });
    table.numbers[slot] = way < 0 ? -1.0 : way * unit(x);
    return a_without_effect(x, word);
}
}  // namespace polyturn::channels::sinumerik
