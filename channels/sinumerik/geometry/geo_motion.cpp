// Straight lines: end points in Cartesian and polar words, contour lines by their angle, and what
// every contour move of the language has in common (sinumerik_part1 10, part 2 10.9 and 10.12).
#include <algorithm>
#include <cmath>

#include "channels/angles.hpp"
#include "channels/sinumerik/interpreter.hpp"

namespace polyturn::channels::sinumerik {
namespace {

constexpr double kSame = 1e-9;

}  // namespace

std::array<std::size_t, 2> Interpreter::plane_places() {
    int p = -1, q = -1;
    core_.plane_axes(p, q);
    return {static_cast<std::size_t>(std::max(p, 0)), static_cast<std::size_t>(std::max(q, 0))};
}

bool Interpreter::needs_plane() {
    int p = -1, q = -1;
    core_.plane_axes(p, q);
    return (p >= 0 && q >= 0) || fail(Alarm::PlaneAxisMissing);
}

// Group 9 puts frames and zeros away for one block: G53 the programmable and the settable one, G153
// also the basic one, SUPA also the external zero and what PRESETON has set.
bool Interpreter::driven(const std::function<bool()>& drive) {
    const GCode* code = block_.coded[9];
    if (!code) return drive();
    const Zeros kept = core_.zeros();
    Zeros none;
    if (code->name != "SUPA") {
        none.external = kept.external;
        none.preset = kept.preset;
    }
    if (code->name == "G53") none.frame = modal_.geo.basic;
    core_.set_zeros(none);
    const bool done = drive();
    core_.set_zeros(kept);
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

bool Interpreter::corner_words(bool contour) {
    const GeoModal& geo = modal_.geo;
    const Word* said = nullptr;
    corners::Call call;
    for (const std::string_view name : {"CHF", "CHR", "RND"})
        if (const Word* w = word(name)) {
            if (said)
                return fail_word(Alarm::CodesContradict, *w,
                                 std::string(name) + ", " + std::string(said->address->name));
            if (w->number() < 0) return fail_word(Alarm::NegativeSign, *w, std::string(name));
            said = w;
            call.shape = name == "CHF"   ? corners::Shape::ChamferLength
                         : name == "CHR" ? corners::Shape::ChamferLeg
                                         : corners::Shape::Rounding;
            call.size = w->number() * unit();
        }
    const Word* own = word("FRC");
    if (own && own->number() <= 0)
        return fail_word(Alarm::ValueOutOfRange, *own, "FRC", own->number());
    if (modal_.corner_feed_stale && !own && contour && (said || geo.rounding > 0))
        return fail(Alarm::CornerFeedStale);
    const double feed = own ? own->number() * feed_unit() : geo.corner_feed;
    if (core_.reads_ahead()) core_.corner_feed(feed);
    if (!contour) return true;
    if (!said) call.size = geo.rounding;
    if (call.size <= 0) return true;
    call.size *= plane_scale(core_);
    call.from_next = !settings_.corner_from_this;
    call.feed = call.from_next ? 0.0 : feed;
    if (has("FB")) call.block_feed = core_.path.feed;
    call.reduce = !settings_.corner_alarm;
    call.idle_blocks = static_cast<unsigned>(settings_.corner_idle_blocks);
    return core_.corner(call);
}

bool Interpreter::go_line(const AxisValues& wanted, bool rapid) {
    if (modal_.curve) return curve_point(wanted);
    AxisValues target = modal_.trails.empty() ? wanted : trailed(wanted);
    const AxisValues whole = target;
    if (!limited_travel(target)) return false;
    const bool cut = target != whole;
    if (!tangential_line(target)) return false;
    if (!within_areas(target)) return false;
    if (bool taken = false; modal_.geo.approach) {
        if (!finish_approach(target, nullptr, taken)) return false;
        if (taken) return true;
    }
    const AxisValues from = core_.path.programmed;
    for (const std::string_view name : {"MEAS", "MEAW"})
        if (const Word* probe = word(name)) return measuring_line(target, *probe, name == "MEAW");
    for (const std::string_view name : {"MEASA", "MEAWA"})
        // MEASA[axis]=(mode, event): the axis alone moves, so its way to go is the path's
        if (const Word* probe = word(name)) {
            Word event = *probe;
            if (probe->number() != 1 || probe->further.size() != 1)
                return fail_word(Alarm::NotBuilt, *probe, std::string(name) + ": mode, events");
            if (probe->axis < 0 || axis_words() != AxisSet{1} << probe->axis)
                return fail_word(Alarm::NotBuilt, *probe, std::string(name));
            event.value = probe->further.front();
            return measuring_line(target, event, name == "MEAWA");
        }
    // RNDM: where a way is deleted, reading stops and there is no corner of the contour
    if (!corner_words(!cut)) return false;
    std::vector<AxisValues> bends;
    if (!modal_.trails.empty() && !bends_on_the_way(wanted, bends)) return false;
    for (const AxisValues& bend : bends)
        if (!within_areas(bend) || (rapid && !core_.rapid(bend))) return false;
    if (!(rapid           ? core_.rapid(target)
          : bends.empty() ? core_.linear(target)
                          : core_.curve(target, bends)))
        return false;
    note_tangent(from, target);
    if (!rapid) modal_.geo.last_feed = core_.path.feed;
    return true;
}

// MEAS=1, 2, MEASA: the probe's signal comes and ends the move; -1, -2: it goes (sinumerik_part3
// 5.3). MEAW, MEAWA: no way is deleted, the move goes on to its end.
bool Interpreter::measuring_line(const AxisValues& target, const Word& probe, bool passes) {
    const double input = std::fabs(probe.number());
    if (input != 1 && input != 2)
        return fail_word(Alarm::ValueOutOfRange, probe, std::string(probe.address->name),
                         probe.number());
    if (has("FXS"))
        return fail_word(Alarm::CodesContradict, probe, "FXS, " + std::string(probe.address->name));
    if (core_.compensating()) return fail_word(Alarm::CompReference, probe);
    modal_.measured_to = target;
    modal_.travel_limited = passes;
    if (passes) modal_.travel_left = {};
    return core_.measure(target, input == 1 ? "1" : "2", probe.number() < 0, passes);
}

void Interpreter::note_tangent(const AxisValues& from, const AxisValues& to) {
    const MachineView& view = core_.view();
    Point3 way{};
    static constexpr PlaneRole kRoles[] = {PlaneRole::BasicX, PlaneRole::BasicY, PlaneRole::BasicZ};
    double length = 0.0;
    for (std::size_t k = 0; k < 3; ++k)
        if (const int place = view.axis_by_role(kRoles[k]); place >= 0) {
            way[k] = to[static_cast<std::size_t>(place)] - from[static_cast<std::size_t>(place)];
            length += way[k] * way[k];
        }
    if (length > kSame * kSame) modal_.geo.tangent = way;
}

// --- polar words

bool Interpreter::polar_ahead() const { return has("AP") || has("RP"); }

// u = pole + RP cos AP, v = pole + RP sin AP. The rest of the target is what the axis words say.
bool Interpreter::polar_target(AxisValues& target) {
    if (!needs_plane()) return false;
    GeoModal& geo = modal_.geo;
    const auto [p, q] = plane_places();
    for (const Word& w : block_.words)
        if (w.address->name == "axis" &&
            (static_cast<std::size_t>(w.axis) == p || static_cast<std::size_t>(w.axis) == q))
            return fail_word(Alarm::CodesContradict, w, axis_name(w.axis) + ", AP RP");
    for (const std::string_view name : {"I", "J", "K"})
        if (const Word* w = word(name))
            return fail_word(Alarm::CodesContradict, *w, std::string(name) + ", AP RP");
    const double now_p = core_.path.programmed[p] - geo.pole[0],
                 now_q = core_.path.programmed[q] - geo.pole[1];
    const Word* angle = word("AP");
    const Word* radius = word("RP");
    if (angle) {
        if (std::fabs(angle->number()) > 360)
            return fail_word(Alarm::ValueOutOfRange, *angle, "AP", angle->number());
        geo.polar_angle_deg =
            is_incremental(*angle) ? geo.polar_angle_deg + angle->number() : angle->number();
    }
    if (radius && radius->number() != 0) {
        if (radius->number() < 0) return fail_word(Alarm::NegativeSign, *radius, "RP");
        geo.polar_radius =
            (radius->mode == Mode::IC ? geo.polar_radius : 0.0) + radius->number() * unit();
    } else {  // the distance of the tool's position
        const double distance = std::hypot(now_p, now_q);
        if (distance < 1e-7 && radius) return fail_word(Alarm::PolarRadiusNone, *radius);
        geo.polar_radius = distance;
        if (distance < 1e-7) geo.polar_radius = 0.0;
    }
    target[p] = geo.pole[0] + geo.polar_radius * std::cos(geo.polar_angle_deg * kDegree);
    target[q] = geo.pole[1] + geo.polar_radius * std::sin(geo.polar_angle_deg * kDegree);
    return true;
}

// G110 from the last point, G111 from the zero, G112 from the last pole; G90 and G91 do not matter.
bool Interpreter::geo_pole(const GCode& code) {
    if (!needs_plane()) return false;
    GeoModal& geo = modal_.geo;
    const auto [p, q] = plane_places();
    std::array<double, 2> from{};
    if (code.name == "G110")
        from = {core_.path.programmed[p], core_.path.programmed[q]};
    else if (code.name == "G112")
        from = geo.pole;
    if (polar_ahead()) {
        const Word* angle = word("AP");
        const Word* radius = word("RP");
        if (!angle || !radius) return fail(Alarm::ReturnValueMissing, angle ? "RP" : "AP");
        if (radius->number() < 0) return fail_word(Alarm::NegativeSign, *radius, "RP");
        from[0] += radius->number() * unit() * std::cos(angle->number() * kDegree);
        from[1] += radius->number() * unit() * std::sin(angle->number() * kDegree);
    }
    for (const Word& w : block_.words) {
        if (w.address->name != "axis") continue;
        const auto i = static_cast<std::size_t>(w.axis);
        if (i != p && i != q) continue;  // the pole lies in the plane
        if (polar_ahead())
            return fail_word(Alarm::CodesContradict, w, axis_name(w.axis) + ", AP RP");
        from[i == p ? 0 : 1] += length_mm(w, w.axis, false);
    }
    geo.pole = from;
    geo.polar_angle_deg = geo.polar_radius = 0.0;
    return true;
}

// --- G0, G1

bool Interpreter::geo_motion(const GCode& code) {
    return driven([&] {
        AxisValues target{};
        AxisSet named = 0;
        if (!read_axis_words(target, named)) return false;
        if (polar_ahead()) {
            if (!polar_target(target)) return false;
            named |= 1u;
        }
        if (has("ANG")) return angle_line(target, named, code.number == 1);
        if (modal_.geo.open_line && named) return fail(Alarm::ContourLineOpen);
        if (!named) return corner_words(false);
        if (block_.coded[7]) complete_plane(target);
        return go_line(target, code.number == 1);
    });
}

// A block that switches compensation moves both axes of the plane; the one without a word stays
// where it was programmed.
void Interpreter::complete_plane(AxisValues& target) {
    const auto [p, q] = plane_places();
    for (const std::size_t i : {p, q})
        if (!(axis_words() >> i & 1u)) target[i] = core_.path.programmed[i];
}

// --- straight lines by their angle

// 10.9.5: no axis of the plane: first of two lines; one: the other follows; two: second of two
// lines.
bool Interpreter::angle_line(AxisValues target, AxisSet named, bool rapid) {
    if (!needs_plane()) return false;
    const auto [p, q] = plane_places();
    GeoModal& geo = modal_.geo;
    const Word& angle = *word("ANG");
    const bool with_p = named >> p & 1u, with_q = named >> q & 1u;
    if (geo.open_line) return second_line(target, angle);
    if (with_p && with_q) return fail_word(Alarm::ContourAngleIllegal, angle);
    if (!with_p && !with_q) return open_line(angle, rapid);
    const double c = std::cos(angle.number() * kDegree), s = std::sin(angle.number() * kDegree);
    const auto [known, wanted] = with_p ? std::pair{p, q} : std::pair{q, p};
    const double share = with_p ? c : s, other = with_p ? s : c,
                 way = target[known] - core_.path.programmed[known];
    // the line never gets there
    if (std::fabs(share) < 1e-12) return fail_word(Alarm::ContourAngleIllegal, angle);
    target[wanted] = core_.path.programmed[wanted] + way / share * other;
    return go_line(target, rapid);
}

// What the block says holds for its line; the line itself waits for the next one.
bool Interpreter::open_line(const Word& angle, bool rapid) {
    OpenLine line;
    line.angle_deg = angle.number();
    line.at = core_.at;
    line.feed = core_.path.feed;
    line.rapid = rapid;
    for (const std::string_view name : {"RND", "CHR", "CHF"})
        if (const Word* w = word(name)) {
            if (w->number() < 0) return fail_word(Alarm::NegativeSign, *w, std::string(name));
            line.corner_size = w->number() * unit();
            line.corner_shape =
                static_cast<std::uint8_t>(name == "RND"   ? corners::Shape::Rounding
                                          : name == "CHR" ? corners::Shape::ChamferLeg
                                                          : corners::Shape::ChamferLength);
        }
    if (line.corner_size == 0) line.corner_size = modal_.geo.rounding;
    if (const Word* own = word("FRC"))
        line.corner_feed = own->number() * feed_unit();
    else
        line.corner_feed = modal_.geo.corner_feed;
    modal_.geo.open_line = line;
    return core_.reserve_move();
}

//   start + t (cos a1, sin a1) = end - s (cos a2, sin a2),  t > 0
bool Interpreter::second_line(const AxisValues& target, const Word& angle) {
    const auto [p, q] = plane_places();
    const OpenLine line = *modal_.geo.open_line;
    modal_.geo.open_line.reset();
    const AxisValues from = core_.path.programmed;
    const double c1 = std::cos(line.angle_deg * kDegree), s1 = std::sin(line.angle_deg * kDegree);
    const double c2 = std::cos(angle.number() * kDegree), s2 = std::sin(angle.number() * kDegree);
    const double sine = c1 * s2 - s1 * c2, dp = target[p] - from[p], dq = target[q] - from[q];
    // the end is the start: only what is perpendicular to the plane moves (10.9.5)
    if (std::hypot(dp, dq) <= kSame) {
        core_.insert_reserved([] {});
        return go_line(target, modal_.active[1] == 1);
    }
    if (std::fabs(sine) < 1e-9) return fail_word(Alarm::ContourLinesParallel, angle);
    const double t = (dp * s2 - dq * c2) / sine;
    if (t <= kSame) return fail_word(Alarm::ContourLinesParallel, angle);
    AxisValues corner = from;
    corner[p] += t * c1;
    corner[q] += t * s1;
    if (!within_areas(corner)) return false;
    bool made = true;
    core_.insert_reserved([&] {
        const BlockContext here = core_.at;
        const double feed = core_.path.feed;
        core_.at = line.at;
        core_.path.feed = line.feed;
        if (core_.reads_ahead()) core_.corner_feed(line.corner_feed);
        corners::Call call;
        call.shape = static_cast<corners::Shape>(line.corner_shape);
        call.size = line.corner_size;
        call.from_next = !settings_.corner_from_this;
        call.feed = call.from_next ? 0.0 : line.corner_feed;
        call.reduce = !settings_.corner_alarm;
        call.idle_blocks = static_cast<unsigned>(settings_.corner_idle_blocks);
        made = (call.size <= 0 || core_.corner(call)) &&
               (line.rapid ? core_.rapid(corner) : core_.linear(corner));
        core_.at = here;
        core_.path.feed = feed;
    });
    return made && go_line(target, modal_.active[1] == 1);
}

// --- addresses that hold from block to block

bool Interpreter::a_geometry(const Word& word) {
    GeoModal& geo = modal_.geo;
    const std::string_view name = word.address->name;
    if (name == "RNDM") {
        if (word.number() < 0) return fail_word(Alarm::NegativeSign, word, "RNDM");
        geo.rounding = word.number() * unit();
    } else if (name == "FRCM") {
        if (word.number() < 0) return fail_word(Alarm::NegativeSign, word, "FRCM");
        geo.corner_feed = word.number() * feed_unit();
        modal_.corner_feed_stale = false;
    } else if (name == "OFFN") {
        geo.allowance = word.number() * unit();
        apply_tool();
    } else if (name == "DISC") {
        if (word.number() < 0 || word.number() > 100)
            return fail_word(Alarm::ValueOutOfRange, word, "DISC", word.number());
        geo.disc = word.number();
        return update_compensation();
    } else if (name == "SF") {
        if (word.number() < 0 || word.number() >= 360)
            return fail_word(Alarm::ValueOutOfRange, word, "SF", word.number());
        geo.thread_angle = word.number();
    } else if (name == "DILF") {
        // a distance: ALF has the direction
        if (word.number() < 0) return fail_word(Alarm::NegativeSign, word, "DILF");
        geo.lift_mm = word.number() * unit();
    } else if (name == "ALF") {
        if (word.number() < 0 || word.number() > 8 || word.number() != std::floor(word.number()))
            return fail_word(Alarm::ValueOutOfRange, word, "ALF", word.number());
        geo.lift_angle = static_cast<unsigned>(word.number());
    }
    state_changed_ = true;
    return true;
}

bool Interpreter::a_without_effect(const Word& word) {
    // F2 to F7
    const std::string number =
        word.address->name == "F" && word.index >= 0 ? std::to_string(word.index) : std::string();
    return without_effect(std::string(word.address->name) + number, word.column, word.length);
}

bool Interpreter::without_effect(std::string name, std::size_t column, std::size_t length) {
    std::vector<std::string>& told = modal_.told;
    if (std::find(told.begin(), told.end(), name) != told.end()) return true;
    core_.mark_emitted();
    core_.sink().alarm({Alarm::WordWithoutEffect,
                        {files_->path(levels_.back().file), core_.at.line,
                         static_cast<std::uint32_t>(column), static_cast<std::uint32_t>(length)},
                        {},
                        name},
                       core_.at);
    told.push_back(std::move(name));
    return state_changed_ = true;
}

}  // namespace polyturn::channels::sinumerik
