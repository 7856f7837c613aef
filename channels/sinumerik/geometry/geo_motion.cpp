// Straight lines: end points in Cartesian and polar words, contour lines by their angle, and what
// every contour move of the language has in common (sinumerik_part1 10, part 2 10.9 and 10.12).
#include "channels/sinumerik/geometry/geo_motion.hpp"

#include <algorithm>
#include <cmath>

#include "channels/angles.hpp"
#include "channels/sinumerik/actions/delete_way.hpp"
#include "channels/sinumerik/axes/axis_names.hpp"
#include "channels/sinumerik/axes/axis_words.hpp"
#include "channels/sinumerik/coupling/coupled_axes.hpp"
#include "channels/sinumerik/coupling/tangential_axis.hpp"
#include "channels/sinumerik/curve_tables/curve_table_commands.hpp"
#include "channels/sinumerik/execution.hpp"
#include "channels/sinumerik/faults.hpp"
#include "channels/sinumerik/geometry/geo_approach.hpp"
#include "channels/sinumerik/geometry/geo_compensation.hpp"
#include "channels/sinumerik/geometry/travel_limits.hpp"
#include "channels/sinumerik/geometry/units.hpp"
#include "channels/sinumerik/grammar/words.hpp"
#include "channels/sinumerik/tools/tools.hpp"

namespace polyturn::channels::sinumerik {
namespace {

constexpr double kSame = 1e-9;

bool open_line(Execution& x, const Word& angle, bool rapid);
bool second_line(Execution& x, const AxisValues& target, const Word& angle);

// MEAS=1, 2, MEASA: the probe's signal comes and ends the move; -1, -2: it goes (sinumerik_part3
// 5.3). MEAW, MEAWA: no way is deleted, the move goes on to its end.
bool measuring_line(Execution& x, const AxisValues& target, const Word& probe, bool passes) {
    const double input = std::fabs(probe.number());
    if (input != 1 && input != 2)
        return fail_word(x, Alarm::ValueOutOfRange, probe, std::string(probe.address->name),
                         probe.number());
    if (has(x, "FXS"))
        return fail_word(x, Alarm::CodesContradict, probe,
                         "FXS, " + std::string(probe.address->name));
    if (x.core.compensating()) return fail_word(x, Alarm::CompReference, probe);
    x.modal.measured_to = target;
    x.modal.travel_limited = passes;
    if (passes) x.modal.travel_left = {};
    return x.core.measure(target, input == 1 ? "1" : "2", probe.number() < 0, passes);
}

// A block that switches compensation moves both axes of the plane; the one without a word stays
// where it was programmed.
void complete_plane(Execution& x, AxisValues& target) {
    const auto [p, q] = plane_places(x);
    for (const std::size_t i : {p, q})
        if (!(axis_words(x) >> i & 1u)) target[i] = x.core.path.programmed[i];
}

// 10.9.5: no axis of the plane: first of two lines; one: the other follows; two: second of two
// lines.
bool angle_line(Execution& x, AxisValues target, AxisSet named, bool rapid) {
    if (!needs_plane(x)) return false;
    const auto [p, q] = plane_places(x);
    GeoModal& geo = x.modal.geo;
    const Word& angle = *word(x, "ANG");
    const bool with_p = named >> p & 1u, with_q = named >> q & 1u;
    if (geo.open_line) return second_line(x, target, angle);
    if (with_p && with_q) return fail_word(x, Alarm::ContourAngleIllegal, angle);
    if (!with_p && !with_q) return open_line(x, angle, rapid);
    const double c = std::cos(angle.number() * kDegree), s = std::sin(angle.number() * kDegree);
    const auto [known, wanted] = with_p ? std::pair{p, q} : std::pair{q, p};
    const double share = with_p ? c : s, other = with_p ? s : c,
                 way = target[known] - x.core.path.programmed[known];
    // the line never gets there
    if (std::fabs(share) < 1e-12) return fail_word(x, Alarm::ContourAngleIllegal, angle);
    target[wanted] = x.core.path.programmed[wanted] + way / share * other;
    return go_line(x, target, rapid);
}

// What the block says holds for its line; the line itself waits for the next one.
bool open_line(Execution& x, const Word& angle, bool rapid) {
    OpenLine line;
    line.angle_deg = angle.number();
    line.at = x.core.at;
    line.feed = x.core.path.feed;
    line.rapid = rapid;
    for (const std::string_view name : {"RND", "CHR", "CHF"})
        if (const Word* w = word(x, name)) {
            if (w->number() < 0) return fail_word(x, Alarm::NegativeSign, *w, std::string(name));
            line.corner_size = w->number() * unit(x);
            line.corner_shape =
                static_cast<std::uint8_t>(name == "RND"   ? corners::Shape::Rounding
                                          : name == "CHR" ? corners::Shape::ChamferLeg
                                                          : corners::Shape::ChamferLength);
        }
    if (line.corner_size == 0) line.corner_size = x.modal.geo.rounding;
    if (const Word* own = word(x, "FRC"))
        line.corner_feed = own->number() * feed_unit(x);
    else
        line.corner_feed = x.modal.geo.corner_feed;
    x.modal.geo.open_line = line;
    return x.core.reserve_move();
}

//   start + t (cos a1, sin a1) = end - s (cos a2, sin a2),  t > 0
bool second_line(Execution& x, const AxisValues& target, const Word& angle) {
    const auto [p, q] = plane_places(x);
    const OpenLine line = *x.modal.geo.open_line;
    x.modal.geo.open_line.reset();
    const AxisValues from = x.core.path.programmed;
    const double c1 = std::cos(line.angle_deg * kDegree), s1 = std::sin(line.angle_deg * kDegree);
    const double c2 = std::cos(angle.number() * kDegree), s2 = std::sin(angle.number() * kDegree);
    const double sine = c1 * s2 - s1 * c2, dp = target[p] - from[p], dq = target[q] - from[q];
    // the end is the start: only what is perpendicular to the plane moves (10.9.5)
    if (std::hypot(dp, dq) <= kSame) {
        x.core.insert_reserved([] {});
        return go_line(x, target, x.modal.active[1] == 1);
    }
    if (std::fabs(sine) < 1e-9) return fail_word(x, Alarm::ContourLinesParallel, angle);
    const double t = (dp * s2 - dq * c2) / sine;
    if (t <= kSame) return fail_word(x, Alarm::ContourLinesParallel, angle);
    AxisValues corner = from;
    corner[p] += t * c1;
    corner[q] += t * s1;
    if (!within_areas(x, corner)) return false;
    bool made = true;
    x.core.insert_reserved([&] {
        const BlockContext here = x.core.at;
        const double feed = x.core.path.feed;
        x.core.at = line.at;
        x.core.path.feed = line.feed;
        if (x.core.reads_ahead()) x.core.corner_feed(line.corner_feed);
        corners::Call call;
        call.shape = static_cast<corners::Shape>(line.corner_shape);
        call.size = line.corner_size;
        call.from_next = !x.settings.corner_from_this;
        call.feed = call.from_next ? 0.0 : line.corner_feed;
        call.reduce = !x.settings.corner_alarm;
        call.idle_blocks = static_cast<unsigned>(x.settings.corner_idle_blocks);
        made = (call.size <= 0 || x.core.corner(call)) &&
               (line.rapid ? x.core.rapid(corner) : x.core.linear(corner));
        x.core.at = here;
        x.core.path.feed = feed;
    });
    return made && go_line(x, target, x.modal.active[1] == 1);
}

}  // namespace

std::array<std::size_t, 2> plane_places(Execution& x) {
    int p = -1, q = -1;
    x.core.plane_axes(p, q);
    return {static_cast<std::size_t>(std::max(p, 0)), static_cast<std::size_t>(std::max(q, 0))};
}

bool needs_plane(Execution& x) {
    int p = -1, q = -1;
    x.core.plane_axes(p, q);
    return (p >= 0 && q >= 0) || fail(x, Alarm::PlaneAxisMissing);
}

// Group 9 puts frames and zeros away for one block: G53 the programmable and the settable one, G153
// also the basic one, SUPA also the external zero and what PRESETON has set.
bool driven(Execution& x, const std::function<bool()>& drive) {
    const GCode* code = x.block.coded[9];
    if (!code) return drive();
    const Zeros kept = x.core.zeros();
    Zeros none;
    if (code->name != "SUPA") {
        none.external = kept.external;
        none.preset = kept.preset;
    }
    if (code->name == "G53") none.frame = x.modal.geo.basic;
    x.core.set_zeros(none);
    const bool done = drive();
    x.core.set_zeros(kept);
    return done;
}

// --- every move of a contour

// CHF, CHR, RND, else RNDM: the element at the end of this block. The feed of an element that takes
// its technology from the next block is output with that one.
namespace {

// SCALE takes a corner along with its contour, as it does the radius of an arc; 1 where both axes
// differ (13.7).
double plane_scale(const Core& core) {
    if (!core.path.framed) return 1.0;
    static constexpr GeoAxis kAxes[3][2] = {
        {GeoAxis::X, GeoAxis::Y}, {GeoAxis::Z, GeoAxis::X}, {GeoAxis::Y, GeoAxis::Z}};
    const auto& [first, second] = kAxes[static_cast<std::size_t>(core.path.plane)];
    const auto length = [](const Point3& v) {
        return std::sqrt(v[0] * v[0] + v[1] * v[1] + v[2] * v[2]);
    };
    const double a = length(core.path.frame.axis(first)), b = length(core.path.frame.axis(second));
    return std::fabs(a - b) < 1e-9 ? a : 1.0;
}

}  // namespace

bool corner_words(Execution& x, bool contour) {
    const GeoModal& geo = x.modal.geo;
    const Word* said = nullptr;
    corners::Call call;
    for (const std::string_view name : {"CHF", "CHR", "RND"})
        if (const Word* w = word(x, name)) {
            if (said)
                return fail_word(x, Alarm::CodesContradict, *w,
                                 std::string(name) + ", " + std::string(said->address->name));
            if (w->number() < 0) return fail_word(x, Alarm::NegativeSign, *w, std::string(name));
            said = w;
            call.shape = name == "CHF"   ? corners::Shape::ChamferLength
                         : name == "CHR" ? corners::Shape::ChamferLeg
                                         : corners::Shape::Rounding;
            call.size = w->number() * unit(x);
        }
    const Word* own = word(x, "FRC");
    if (own && own->number() <= 0)
        return fail_word(x, Alarm::ValueOutOfRange, *own, "FRC", own->number());
    if (x.modal.corner_feed_stale && !own && contour && (said || geo.rounding > 0))
        return fail(x, Alarm::CornerFeedStale);
    const double feed = own ? own->number() * feed_unit(x) : geo.corner_feed;
    if (x.core.reads_ahead()) x.core.corner_feed(feed);
    if (!contour) return true;
    if (!said) call.size = geo.rounding;
    if (call.size <= 0) return true;
    call.size *= plane_scale(x.core);
    call.from_next = !x.settings.corner_from_this;
    call.feed = call.from_next ? 0.0 : feed;
    if (has(x, "FB")) call.block_feed = x.core.path.feed;
    call.reduce = !x.settings.corner_alarm;
    call.idle_blocks = static_cast<unsigned>(x.settings.corner_idle_blocks);
    return x.core.corner(call);
}

bool go_line(Execution& x, const AxisValues& wanted, bool rapid) {
    if (x.modal.curve) return curve_point(x, wanted);
    AxisValues target = x.modal.trails.empty() ? wanted : trailed(x, wanted);
    const AxisValues whole = target;
    if (!limited_travel(x, target)) return false;
    const bool cut = target != whole;
    if (!tangential_line(x, target)) return false;
    if (!within_areas(x, target)) return false;
    if (bool taken = false; x.modal.geo.approach) {
        if (!finish_approach(x, target, nullptr, taken)) return false;
        if (taken) return true;
    }
    const AxisValues from = x.core.path.programmed;
    for (const std::string_view name : {"MEAS", "MEAW"})
        if (const Word* probe = word(x, name))
            return measuring_line(x, target, *probe, name == "MEAW");
    for (const std::string_view name : {"MEASA", "MEAWA"})
        // MEASA[axis]=(mode, event): the axis alone moves, so its way to go is the path's
        if (const Word* probe = word(x, name)) {
            Word event = *probe;
            if (probe->number() != 1 || probe->further.size() != 1)
                return fail_word(x, Alarm::NotBuilt, *probe, std::string(name) + ": mode, events");
            if (probe->axis < 0 || axis_words(x) != AxisSet{1} << probe->axis)
                return fail_word(x, Alarm::NotBuilt, *probe, std::string(name));
            event.value = probe->further.front();
            return measuring_line(x, target, event, name == "MEAWA");
        }
    // RNDM: where a way is deleted, reading stops and there is no corner of the contour
    if (!corner_words(x, !cut)) return false;
    std::vector<AxisValues> bends;
    if (!x.modal.trails.empty() && !bends_on_the_way(x, wanted, bends)) return false;
    for (const AxisValues& bend : bends)
        if (!within_areas(x, bend) || (rapid && !x.core.rapid(bend))) return false;
    if (!(rapid           ? x.core.rapid(target)
          : bends.empty() ? x.core.linear(target)
                          : x.core.curve(target, bends)))
        return false;
    note_tangent(x, from, target);
    if (!rapid) x.modal.geo.last_feed = x.core.path.feed;
    return true;
}

void note_tangent(Execution& x, const AxisValues& from, const AxisValues& to) {
    const MachineView& view = x.core.view();
    Point3 way{};
    static constexpr PlaneRole kRoles[] = {PlaneRole::BasicX, PlaneRole::BasicY, PlaneRole::BasicZ};
    double length = 0.0;
    for (std::size_t k = 0; k < 3; ++k)
        if (const int place = view.axis_by_role(kRoles[k]); place >= 0) {
            way[k] = to[static_cast<std::size_t>(place)] - from[static_cast<std::size_t>(place)];
            length += way[k] * way[k];
        }
    if (length > kSame * kSame) x.modal.geo.tangent = way;
}

// --- polar words

bool polar_ahead(const Execution& x) { return has(x, "AP") || has(x, "RP"); }

// u = pole + RP cos AP, v = pole + RP sin AP. The rest of the target is what the axis words say.
bool polar_target(Execution& x, AxisValues& target) {
    if (!needs_plane(x)) return false;
    GeoModal& geo = x.modal.geo;
    const auto [p, q] = plane_places(x);
    for (const Word& w : x.block.words)
        if (w.address->name == "axis" &&
            (static_cast<std::size_t>(w.axis) == p || static_cast<std::size_t>(w.axis) == q))
            return fail_word(x, Alarm::CodesContradict, w, axis_name(x, w.axis) + ", AP RP");
    for (const std::string_view name : {"I", "J", "K"})
        if (const Word* w = word(x, name))
            return fail_word(x, Alarm::CodesContradict, *w, std::string(name) + ", AP RP");
    const double now_p = x.core.path.programmed[p] - geo.pole[0],
                 now_q = x.core.path.programmed[q] - geo.pole[1];
    const Word* angle = word(x, "AP");
    const Word* radius = word(x, "RP");
    if (angle) {
        if (std::fabs(angle->number()) > 360)
            return fail_word(x, Alarm::ValueOutOfRange, *angle, "AP", angle->number());
        geo.polar_angle_deg =
            is_incremental(x, *angle) ? geo.polar_angle_deg + angle->number() : angle->number();
    }
    if (radius && radius->number() != 0) {
        if (radius->number() < 0) return fail_word(x, Alarm::NegativeSign, *radius, "RP");
        geo.polar_radius =
            (radius->mode == Mode::IC ? geo.polar_radius : 0.0) + radius->number() * unit(x);
    } else {  // the distance of the tool's position
        const double distance = std::hypot(now_p, now_q);
        if (distance < 1e-7 && radius) return fail_word(x, Alarm::PolarRadiusNone, *radius);
        geo.polar_radius = distance;
        if (distance < 1e-7) geo.polar_radius = 0.0;
    }
    target[p] = geo.pole[0] + geo.polar_radius * std::cos(geo.polar_angle_deg * kDegree);
    target[q] = geo.pole[1] + geo.polar_radius * std::sin(geo.polar_angle_deg * kDegree);
    return true;
}

// G110 from the last point, G111 from the zero, G112 from the last pole; G90 and G91 do not matter.
bool geo_pole(Execution& x, const GCode& code) {
    if (!needs_plane(x)) return false;
    GeoModal& geo = x.modal.geo;
    const auto [p, q] = plane_places(x);
    std::array<double, 2> from{};
    if (code.name == "G110")
        from = {x.core.path.programmed[p], x.core.path.programmed[q]};
    else if (code.name == "G112")
        from = geo.pole;
    if (polar_ahead(x)) {
        const Word* angle = word(x, "AP");
        const Word* radius = word(x, "RP");
        if (!angle || !radius) return fail(x, Alarm::ReturnValueMissing, angle ? "RP" : "AP");
        if (radius->number() < 0) return fail_word(x, Alarm::NegativeSign, *radius, "RP");
        from[0] += radius->number() * unit(x) * std::cos(angle->number() * kDegree);
        from[1] += radius->number() * unit(x) * std::sin(angle->number() * kDegree);
    }
    for (const Word& w : x.block.words) {
        if (w.address->name != "axis") continue;
        const auto i = static_cast<std::size_t>(w.axis);
        if (i != p && i != q) continue;  // the pole lies in the plane
        if (polar_ahead(x))
            return fail_word(x, Alarm::CodesContradict, w, axis_name(x, w.axis) + ", AP RP");
        from[i == p ? 0 : 1] += length_mm(x, w, w.axis, false);
    }
    geo.pole = from;
    geo.polar_angle_deg = geo.polar_radius = 0.0;
    return true;
}

// --- G0, G1

bool geo_motion(Execution& x, const GCode& code) {
    return driven(x, [&] {
        AxisValues target{};
        AxisSet named = 0;
        if (!read_axis_words(x, target, named)) return false;
        if (polar_ahead(x)) {
            if (!polar_target(x, target)) return false;
            named |= 1u;
        }
        if (has(x, "ANG")) return angle_line(x, target, named, code.number == 1);
        if (x.modal.geo.open_line && named) return fail(x, Alarm::ContourLineOpen);
        if (!named) return corner_words(x, false);
        if (x.block.coded[7]) complete_plane(x, target);
        return go_line(x, target, code.number == 1);
    });
}

// --- straight lines by their angle

// --- addresses that hold from block to block

bool a_geometry(Execution& x, const Word& word) {
    GeoModal& geo = x.modal.geo;
    const std::string_view name = word.address->name;
    if (name == "RNDM") {
        if (word.number() < 0) return fail_word(x, Alarm::NegativeSign, word, "RNDM");
        geo.rounding = word.number() * unit(x);
    } else if (name == "FRCM") {
        if (word.number() < 0) return fail_word(x, Alarm::NegativeSign, word, "FRCM");
        geo.corner_feed = word.number() * feed_unit(x);
        x.modal.corner_feed_stale = false;
    } else if (name == "OFFN") {
        geo.allowance = word.number() * unit(x);
        apply_tool(x);
    } else if (name == "DISC") {
        if (word.number() < 0 || word.number() > 100)
            return fail_word(x, Alarm::ValueOutOfRange, word, "DISC", word.number());
        geo.disc = word.number();
        return update_compensation(x);
    } else if (name == "SF") {
        if (word.number() < 0 || word.number() >= 360)
            return fail_word(x, Alarm::ValueOutOfRange, word, "SF", word.number());
        geo.thread_angle = word.number();
    } else if (name == "DILF") {
        // a distance: ALF has the direction
        if (word.number() < 0) return fail_word(x, Alarm::NegativeSign, word, "DILF");
        geo.lift_mm = word.number() * unit(x);
    } else if (name == "ALF") {
        if (word.number() < 0 || word.number() > 8 || word.number() != std::floor(word.number()))
            return fail_word(x, Alarm::ValueOutOfRange, word, "ALF", word.number());
        geo.lift_angle = static_cast<unsigned>(word.number());
    }
    x.run.state_changed = true;
    return true;
}

}  // namespace polyturn::channels::sinumerik
