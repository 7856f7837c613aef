#include "kernel/cyclic/guard.hpp"

#include <algorithm>
#include <cmath>
#include <cstdio>

namespace polyturn::kernel {
namespace p = params;
namespace {
constexpr std::size_t kSamples = 8;      // of a braking way
constexpr double kReserve = 1.1;         // of it: the planner brakes a little later than a parabola
constexpr double kTowards = 1e-7;        // mm: nearer than that in one tick is no approach
constexpr double kBehindFace = 1000;     // mm of spindle head behind a chuck's face
constexpr double kFarAway = 1e9;
constexpr double kMmPerInch = 25.4;

// Of two rectangles, the second moved by (dx, dz): negative when they overlap.
double gap_of(double x_first_above, double x_second_above, double z_first_above, double z_second_above, double dx, double dz) noexcept {
    const double x = std::max(x_first_above - dx, x_second_above + dx), z = std::max(z_first_above - dz, z_second_above + dz);
    return x > 0 && z > 0 ? std::sqrt(x * x + z * z) : std::max(x, z);
}
}  // namespace

void Guard::take_room(const Room& room, const MachineConfig& machine) {
    room_ = room;
    machine_ = machine;
    has_room_ = true;
}

Guard::Body& Guard::add_body(std::string_view name, Kind kind) {
    const bool room = body_count_ < kBodies;
    if (!room) ++left_out_;
    Body& body = room ? bodies_[body_count_] : spare_;
    body = {};
    std::copy_n(name.begin(), std::min(name.size(), body.name.size() - 1), body.name.begin());
    body.kind = kind;
    body.first = box_count_;
    if (room) ++body_count_;
    return body;
}

Guard::Box* Guard::add_box(Body& body, const Box& box) {
    if (box_count_ == kBoxes) return ++left_out_, nullptr;
    ++body.count;
    return &(boxes_[box_count_++] = box);
}

void Guard::add_carrier(Body& body, unsigned number) {
    const auto found = room_.axes.find(number);
    if (found == room_.axes.end() || body.carriers == kCarriers || machine_.axis(number).rotary) return;
    const RoomPlace& place = found->second;
    body.axis[body.carriers] = number - 1;
    body.way[body.carriers++] = {place.direction.x, place.direction.z};
    body.origin.x += place.origin.x;
    body.origin.z += place.origin.z;
}

void Guard::configure(const p::Table& t, const KernelConfig& config) {
    body_count_ = box_count_ = left_out_ = 0;
    watched_ = false;
    distance_ = p::get(t, p::pt_guard_distance);
    if (!has_room_) return;
    for (unsigned l = 1; l <= kMaxChannels; ++l) {
        if (!config.channels[l - 1].exists) continue;
        const double unit = config.channels[l - 1].inch ? kMmPerInch : 1.0;
        const auto length = [&](auto handle) { return p::get(t, handle, l) * unit; };
        char name[32];
        if (p::bit(t, p::n2000_check_config, l, 0)) {
            const auto turret = room_.turrets.find(l);
            std::snprintf(name, sizeof name, "tool carrier of L%u", l);
            Body& body = add_body(name, Kind::Carrier);
            body.channel = l;
            body.in_z = p::bit(t, p::n2000_check_config, l, 1);
            body.without_tool = p::bit(t, p::n2000_check_config, l, 2);
            body.by_hand = p::bit(t, p::n2000_check_config, l, 3);
            for (unsigned a = 1; a <= kMaxAxes; ++a)
                if (config.axes[a - 1].exists && config.axes[a - 1].channel == l && !config.axes[a - 1].rotary) add_carrier(body, a);
            // N2002, N2003 move the shape: in the room, or along the carrier's own axes.
            double dx = length(p::n2002_tool_holder_position_x), dz = length(p::n2003_tool_holder_position_z);
            if (p::get(t, p::n2001_coord_type, l) == 1)
                for (std::size_t i = 0; i < body.carriers; ++i) {
                    if (std::fabs(body.way[i].x) > 0.5) dx = std::copysign(1.0, body.way[i].x) * length(p::n2002_tool_holder_position_x);
                    if (std::fabs(body.way[i].z) > 0.5) dz = std::copysign(1.0, body.way[i].z) * length(p::n2003_tool_holder_position_z);
                }
            const auto add = [&](const RoomBox& b, std::uint32_t station) { return add_box(body, {b.x_low + dx, b.x_high + dx, b.z_low + dz, b.z_high + dz, station}); };
            if (turret != room_.turrets.end()) {
                const RoomTurret& r = turret->second;
                body.looks_along_x = std::fabs(r.direction.x) > 0.5;
                if (r.reach > 0 && r.stations > 1 && (body.looks_along_x || std::fabs(r.direction.z) > 0.5)) {
                    body.stations = r.stations;
                    body.outwards = (body.looks_along_x ? r.direction.x : r.direction.z) < 0 ? -1.0 : 1.0;
                    body.axis_at = (body.looks_along_x ? dx : dz) - body.outwards * r.reach;
                }
                for (const RoomBox& b : turret->second.body) (void)add(b, 0);
                for (const auto& [station, boxes] : turret->second.tools)
                    for (const RoomBox& b : boxes) {
                        if (shapes_.has(l, station)) continue;
                        Box* drawn = add(b, station);
                        if (const auto tip = turret->second.tips.find(station); drawn && tip != turret->second.tips.end())
                            drawn->goes = true, drawn->tip = {tip->second.x, tip->second.z};
                    }
            }
            for (std::size_t i = 0; i < shapes_.count; ++i)
                if (const ToolShape& s = shapes_.shapes[i]; s.channel == l) (void)add({s.x_low, s.x_high, s.z_low, s.z_high}, s.station);
            if (body.count == 0) (void)add({-1e-6, 1e-6, -1e-6, 1e-6}, 0);   // the tool carrier's point itself
            watched_ = true;
        }
        // Barriers of the channel, in machine coordinates of its X and Z: into the room by where these axes point.
        double x_origin = 0, z_origin = 0, x_way = 1, z_way = 1;
        for (unsigned a = 1; a <= kMaxAxes; ++a) {
            const auto at = room_.axes.find(a);
            if (at == room_.axes.end() || !config.axes[a - 1].exists || config.axes[a - 1].channel != l) continue;
            const RoomPlace& axis = at->second;
            if (std::fabs(axis.direction.x) > 0.5) x_origin = axis.origin.x, x_way = axis.direction.x;
            if (std::fabs(axis.direction.z) > 0.5) z_origin = axis.origin.z, z_way = axis.direction.z;
        }
        const auto barrier = [&](Body& body, double z_from, double z_to, double half, double centre) {
            if (!(half > 0) || z_from == z_to) return;
            const double x0 = x_origin + x_way * (centre - half), x1 = x_origin + x_way * (centre + half);
            const double z0 = z_origin + z_way * z_from, z1 = z_origin + z_way * z_to;
            (void)add_box(body, {std::min(x0, x1), std::max(x0, x1), std::min(z0, z1), std::max(z0, z1), 0});
        };
        const double jaws = length(p::n1901_l1_length_of_jaws), width = length(p::n1902_w1_width_of_jaws);
        if (jaws > 0 && width > 0) {
            std::snprintf(name, sizeof name, "chuck of L%u", l);
            Body& body = add_body(name, Kind::Chuck);
            const double face = length(p::n1906_chuck_position_z), centre = length(p::n1905_chuck_position_x);
            // Jaws that hold a part by its outside are around it: seen from the side, their grip is as wide as they are.
            const bool outside = p::bit(t, p::n1900_chuck_config, l, 0);
            const double grip = length(p::n1903_l2_holding_length_of_jaws), held = outside ? std::max(width, length(p::n1904_w2_holding_width_of_jaws)) : length(p::n1904_w2_holding_width_of_jaws);
            barrier(body, face - kBehindFace, face, width, centre);
            barrier(body, face, face + jaws, width, centre);
            if (grip > 0) barrier(body, face + jaws, face + jaws + grip, held, centre);
            body.watched = true;
        }
        const double l1 = length(p::n1907_l1_length_of_tailstock), d1 = length(p::n1908_d1_diameter_of_tailstock);
        if (l1 > 0 && d1 > 0) {
            std::snprintf(name, sizeof name, "tailstock of L%u", l);
            Body& body = add_body(name, Kind::Tailstock);
            const double tip = length(p::n1914_tailstock_position_z), l2 = length(p::n1909_l2_length_of_tailstock), l3 = length(p::n1911_l3_length_of_tailstock);
            const double centre = length(p::n1905_chuck_position_x);
            barrier(body, tip, tip + l3, length(p::n1912_d3_diameter_of_tailstock) / 2, centre);
            barrier(body, tip + l3, tip + l3 + l2, length(p::n1910_d2_diameter_of_tailstock) / 2, centre);
            barrier(body, tip + l3 + l2, tip + l3 + l2 + l1, std::max(d1, length(p::n1913_d4_diameter_of_tailstock)) / 2, centre);
        }
    }
    if (!watched_) {
        left_out_ = 0;
        return;
    }
    left_out_ += shapes_.left_out;
    for (const auto& [s, chuck] : room_.chucks) {
        if (!(chuck.diameter > 0)) continue;
        char name[32];
        std::snprintf(name, sizeof name, "chuck of S%u", s);
        Body& body = add_body(name, Kind::Chuck);
        const double sense = chuck.direction.z < 0 ? -1.0 : 1.0;
        const double back = chuck.origin.z - sense * chuck.length, front = chuck.origin.z + sense * chuck.jaws;
        (void)add_box(body, {chuck.origin.x - chuck.diameter / 2, chuck.origin.x + chuck.diameter / 2, std::min(back, front), std::max(back, front), 0});
        if (chuck.carried_by) {
            const Vector stood = body.origin;
            add_carrier(body, chuck.carried_by);
            body.origin = stood;   // its place is told for machine coordinate 0 of that axis
        }
    }
    for (const auto& [n, tail] : room_.tailstocks) {
        if (!(tail.diameter > 0)) continue;
        char name[32];
        std::snprintf(name, sizeof name, "tailstock %u", n);
        Body& body = add_body(name, Kind::Tailstock);
        const double sense = tail.direction.z < 0 ? -1.0 : 1.0, back = tail.origin.z - sense * tail.length;
        (void)add_box(body, {tail.origin.x - tail.diameter / 2, tail.origin.x + tail.diameter / 2, std::min(back, tail.origin.z), std::max(back, tail.origin.z), 0});
    }
}

void Guard::take_tool(std::uint32_t channel, const std::array<double, kChannelAxes>& shift) noexcept {
    Tool& tool = tools_[channel - 1];
    if (!has_room_ || std::all_of(shift.begin(), shift.end(), [](double one) { return one == 0; })) return;
    Vector tip;
    const auto& own = machine_.channel(channel);
    for (std::size_t i = 0; i < own.axis_count; ++i) {
        const auto place = room_.axes.find(own.axes[i]);
        if (place == room_.axes.end() || machine_.axis(own.axes[i]).rotary) continue;
        tip.x -= place->second.direction.x * shift[i];
        tip.z -= place->second.direction.z * shift[i];
    }
    tool.known = true;
    tool.tip = tip;
}

bool Guard::carries(std::uint32_t body, std::uint32_t axis) const noexcept {
    const Body& b = bodies_[body];
    return std::find(b.axis.begin(), b.axis.begin() + static_cast<std::ptrdiff_t>(b.carriers), axis) != b.axis.begin() + static_cast<std::ptrdiff_t>(b.carriers);
}

ChannelSet Guard::movers(const Core& core, std::uint32_t index) const noexcept {
    ChannelSet set = 0;
    const Body& body = bodies_[index];
    for (std::size_t i = 0; i < body.carriers; ++i)
        if (const std::uint32_t owner = core.axes[body.axis[i]].owner; owner && core.axes[body.axis[i]].target() != core.axes[body.axis[i]].command()) set |= ChannelSet{1} << (owner - 1);
    return set;
}

// Where it is at this tick's end, how fast, and where it would come to rest.
void Guard::place(const Core& core, Body& body) noexcept {
    Vector at = body.origin, v;
    double time = 0;
    bool known = true;
    for (std::size_t i = 0; i < body.carriers; ++i) {
        const AxisUnit& axis = core.axes[body.axis[i]];
        const AxisConfig& config = core.config.axes[body.axis[i]];
        known = known && axis.exists() && axis.referenced && !axis.detached;
        const double u = (axis.target() - axis.command()) / core.config.tick_s;
        at.x += body.way[i].x * axis.target();
        at.z += body.way[i].z * axis.target();
        v.x += body.way[i].x * u;
        v.z += body.way[i].z * u;
        const double rise = std::isfinite(config.jerk) && config.jerk > 0 ? config.acceleration / config.jerk : 0.0;
        if (u != 0) time = std::max(time, std::fabs(u) / config.acceleration + rise);
    }
    body.at = at;
    body.moving = v.x != 0 || v.z != 0;
    const double speed2 = v.x * v.x + v.z * v.z;
    const double way = kReserve * (time / 2 + core.config.tick_s);
    body.rest = {v.x * way, v.z * way};
    body.bend = {};
    if (body.moving && speed2 > 0) {   // the path bends: v^2 times curvature, across it
        const double ax = (v.x - body.velocity.x) / core.config.tick_s, az = (v.z - body.velocity.z) / core.config.tick_s;
        const double along = (ax * v.x + az * v.z) / speed2;
        body.bend = {(ax - along * v.x) * way * way / 2, (az - along * v.z) * way * way / 2};
    }
    body.velocity = v;
    body.way_left = std::sqrt(body.rest.x * body.rest.x + body.rest.z * body.rest.z) + std::sqrt(body.bend.x * body.bend.x + body.bend.z * body.bend.z);
    const bool carrier = body.channel != 0;
    bool watched = known;
    if (carrier) {
        const bool jogging = (core.jogging >> (body.channel - 1) & 1u) != 0;
        if (jogging && !body.by_hand) watched = false;
        if (!body.without_tool && station_[body.channel - 1] == 0) watched = false;
    }
    body.known = known;
    body.watched = watched;
}

// Of a station that is `steps` away from the one in work; anywhere: on its whole circle.
Guard::Box Guard::turned(const Body& body, const Box& own, double steps, bool anywhere) noexcept {
    constexpr double kTurn = 2 * 3.14159265358979323846;
    const double low = body.looks_along_x ? own.x_low : own.z_low, high = body.looks_along_x ? own.x_high : own.z_high;
    const double across = (body.looks_along_x ? own.z_high - own.z_low : own.x_high - own.x_low) / 2;
    const double u1 = body.outwards * (low - body.axis_at), u2 = body.outwards * (high - body.axis_at);
    const double angle = kTurn * steps / body.stations, c = std::cos(angle), wide = across * std::fabs(std::sin(angle));
    const double most = std::hypot(std::max(std::fabs(u1), std::fabs(u2)), across);
    const double from = anywhere ? -most : std::min(u1 * c, u2 * c) - wide, to = anywhere ? most : std::max(u1 * c, u2 * c) + wide;
    const double a = body.axis_at + body.outwards * from, b = body.axis_at + body.outwards * to;
    Box box = own;
    if (body.looks_along_x) box.x_low = std::min(a, b), box.x_high = std::max(a, b);
    else box.z_low = std::min(a, b), box.z_high = std::max(a, b);
    return box;
}

// Where the turret stands: as its PLC says; before that, as the program has told it. Worked out anew only when that changes.
void Guard::turn_tools(const Core& core, Body& body) noexcept {
    std::int64_t index = core.signals.plc(signals::cp_actt(body.channel));
    if (index <= 0) index = static_cast<std::int64_t>(std::max<std::uint32_t>(station_[body.channel - 1], 1));
    const bool turns = core.signals.plc(signals::cp_turretopen(body.channel)) != 0;
    if (body.turned_for == (turns ? 0 : index)) return;
    body.turned_for = turns ? 0 : index;
    for (std::size_t i = body.first; i < body.first + body.count; ++i)
        if (boxes_[i].station) turned_[i] = turned(body, boxes_[i], static_cast<double>(boxes_[i].station) - static_cast<double>(index), turns);
}

// The boxes that count now, where they are now, and what is around all of them.
void Guard::show(const Core& core, Body& body) noexcept {
    if (body.stations && body.channel) turn_tools(core, body);
    body.shown = shown_count_;
    body.shown_count = 0;
    body.outline = {kFarAway, -kFarAway, kFarAway, -kFarAway, 0};
    for (std::size_t i = body.first; i < body.first + body.count; ++i) {
        const Box& own = boxes_[i];
        Vector at = body.at;
        // The called tool too is anywhere on its circle until the turret stands.
        const bool turns = body.stations != 0 && body.turned_for == 0;
        if (own.station && body.channel && (turns || own.station != station_[body.channel - 1])) {
            if (body.stations == 0) continue;
            const Box& off = turned_[i];
            const Box box{off.x_low + at.x, off.x_high + at.x, off.z_low + at.z, off.z_high + at.z, own.station};
            body.outline = {std::min(body.outline.x_low, box.x_low), std::max(body.outline.x_high, box.x_high), std::min(body.outline.z_low, box.z_low), std::max(body.outline.z_high, box.z_high), 0};
            shown_[shown_count_++] = box;
            ++body.shown_count;
            continue;
        }
        if (own.goes && body.channel && tools_[body.channel - 1].known) at = {at.x + tools_[body.channel - 1].tip.x - own.tip.x, at.z + tools_[body.channel - 1].tip.z - own.tip.z};
        const Box box{own.x_low + at.x, own.x_high + at.x, own.z_low + at.z, own.z_high + at.z, own.station};
        body.outline = {std::min(body.outline.x_low, box.x_low), std::max(body.outline.x_high, box.x_high), std::min(body.outline.z_low, box.z_low), std::max(body.outline.z_high, box.z_high), 0};
        shown_[shown_count_++] = box;
        ++body.shown_count;
    }
}

// The distance now, and in `then` that of each point looked at, but only of what may come nearer than kept: `reach` is as far as
// both ways and PT_GUARD_DISTANCE lead.
double Guard::gaps(const Body& a, const Body& b, double reach, const Relative& way, std::array<double, 8>& then) const noexcept {
    const bool flat = !a.in_z || !b.in_z;   // Z does not separate them
    const auto z_gap = [flat](double gap) { return flat ? -kFarAway : gap; };
    const auto outside = [&](const Box& p, const Box& q) { return gap_of(p.x_low - q.x_high, q.x_low - p.x_high, z_gap(p.z_low - q.z_high), z_gap(q.z_low - p.z_high), 0, 0); };
    // Of b, only what lies near enough to all of a.
    std::array<std::uint16_t, kBoxes> near;
    std::size_t near_count = 0;
    double now = kFarAway;
    for (std::size_t k = b.shown; k < b.shown + b.shown_count; ++k)
        if (const double least = outside(a.outline, shown_[k]); least <= reach || least < nearest_.distance) near[near_count++] = static_cast<std::uint16_t>(k);
    for (std::size_t i = a.shown; i < a.shown + a.shown_count; ++i) {
        const Box& p = shown_[i];
        if (const double least = outside(p, b.outline); least > reach && least >= now) continue;
        for (std::size_t n = 0; n < near_count; ++n) {
            const Box& q = shown_[near[n]];
            const double x1 = p.x_low - q.x_high, x2 = q.x_low - p.x_high, z1 = z_gap(p.z_low - q.z_high), z2 = z_gap(q.z_low - p.z_high);
            const double gap = gap_of(x1, x2, z1, z2, 0, 0);
            now = std::min(now, gap);
            if (gap > reach) continue;
            for (std::size_t s = 0; s < kSamples; ++s) then[s] = std::min(then[s], gap_of(x1, x2, z1, z2, way.x[s], way.z[s]));
        }
    }
    return now;
}

// The PLC takes barriers away for the channel whose carrier comes near.
bool Guard::off(const Core& core, const Body& a, const Body& b) const noexcept {
    const std::uint32_t channel = std::max(a.channel, b.channel);
    if ((a.kind == Kind::Chuck || b.kind == Kind::Chuck) && core.signals.plc(signals::cp_chuckoff(channel))) return true;
    return (a.kind == Kind::Tailstock || b.kind == Kind::Tailstock) && core.signals.plc(signals::cp_tailoff(channel));
}

Guard::Finding Guard::step(const Core& core) noexcept {
    nearest_ = {kNone, kNone, kFarAway};
    Finding found{kNone, kNone, 0};
    if (!any()) return found;
    // Tool management has said where the tool stands; without it T is the station.
    for (std::uint32_t l = 0; l < kMaxChannels; ++l) {
        const bool managed = core.signals.nc(signals::cn_mgzno(l + 1)) != 0;
        const auto station = static_cast<std::uint32_t>(std::max(core.signals.nc(managed ? signals::cn_potno(l + 1) : signals::cn_tcode(l + 1)), 0));
        if (station != station_[l]) tools_[l].known = false;   // another tool: it counts as it is drawn until its offset is in use
        station_[l] = station;
    }
    shown_count_ = 0;
    for (std::size_t i = 0; i < body_count_; ++i) place(core, bodies_[i]), show(core, bodies_[i]);
    for (std::uint32_t i = 0; i < body_count_; ++i) {
        const Body& a = bodies_[i];
        for (std::uint32_t k = i + 1; k < body_count_; ++k) {
            const Body& b = bodies_[k];
            if ((!a.moving && !b.moving) || !a.watched || !b.watched || (!a.channel && !b.channel)) continue;
            const double reach = a.way_left + b.way_left + distance_;
            const bool flat = !a.in_z || !b.in_z;
            const Box &p = a.outline, &q = b.outline;
            const double outside = gap_of(p.x_low - q.x_high, q.x_low - p.x_high, flat ? -kFarAway : p.z_low - q.z_high, flat ? -kFarAway : q.z_low - p.z_high, 0, 0);
            if ((outside > reach && outside >= nearest_.distance) || off(core, a, b)) continue;
            Relative way;
            const Vector rest{b.rest.x - a.rest.x, b.rest.z - a.rest.z}, bend{b.bend.x - a.bend.x, b.bend.z - a.bend.z};
            for (std::size_t n = 0; n < kSamples; ++n) {
                const double s = static_cast<double>(n + 1) / kSamples;
                way.x[n] = s * rest.x + s * s * bend.x;
                way.z[n] = s * rest.z + s * s * bend.z;
            }
            std::array<double, 8> then;
            then.fill(kFarAway);
            const double now = gaps(a, b, reach, way, then);
            if (now < nearest_.distance) nearest_ = {i, k, now};
            const bool meets = std::any_of(then.begin(), then.end(), [&](double gap) { return gap < distance_ && gap < now - kTowards; });
            if (meets && (found.first == kNone || now < found.distance)) found = {i, k, now};
        }
    }
    return found;
}

bool Guard::protects(std::uint32_t channel) const noexcept {
    return std::any_of(bodies_.begin(), bodies_.begin() + static_cast<std::ptrdiff_t>(body_count_), [&](const Body& b) { return b.kind == Kind::Carrier && b.channel == channel; });
}

bool Guard::circle_is_free(std::uint32_t channel, const std::array<double, kMaxAxes>& left) const noexcept {
    const Body* const end = bodies_.data() + body_count_;
    const Body* const own = std::find_if(bodies_.data(), end, [&](const Body& b) { return b.kind == Kind::Carrier && b.channel == channel; });
    if (own == end || !own->watched || own->stations == 0) return false;
    Vector way;
    for (std::size_t i = 0; i < own->carriers; ++i) way.x += own->way[i].x * left[own->axis[i]], way.z += own->way[i].z * left[own->axis[i]];
    for (std::size_t i = own->first; i < own->first + own->count; ++i) {
        if (boxes_[i].station == 0) continue;   // the turret's body stays as it is
        const Box t = turned(*own, boxes_[i], 0, true);
        const double x = own->at.x, z = own->at.z;
        const Box swept{t.x_low + x + std::min(way.x, 0.0), t.x_high + x + std::max(way.x, 0.0), t.z_low + z + std::min(way.z, 0.0), t.z_high + z + std::max(way.z, 0.0), 0};
        for (const Body* other = bodies_.data(); other != end; ++other) {
            if (other == own) continue;
            if (!other->known) return false;
            const bool flat = !own->in_z || !other->in_z;
            const auto free_of = [&](const Box& q) {
                return gap_of(swept.x_low - q.x_high, q.x_low - swept.x_high, flat ? -kFarAway : swept.z_low - q.z_high, flat ? -kFarAway : q.z_low - swept.z_high, 0, 0) > distance_ + other->way_left;
            };
            if (free_of(other->outline)) continue;
            const Box* const q = shown_.data() + other->shown;
            if (!std::all_of(q, q + other->shown_count, free_of)) return false;
        }
    }
    return true;
}

void Guard::publish(GuardStatus& out) const noexcept {
    out.bodies = static_cast<std::uint32_t>(body_count_);
    out.count = 0;
    out.first = nearest_.first;
    out.second = nearest_.second;
    out.distance = nearest_.distance;
    for (std::uint32_t n = 0; n < body_count_; ++n) {
        const Body& body = bodies_[n];
        std::copy(body.name.begin(), body.name.end(), out.names.begin() + static_cast<std::ptrdiff_t>(n) * 32);
        for (std::size_t i = body.shown; i < body.shown + body.shown_count && out.count < out.boxes.size(); ++i)
            out.boxes[out.count++] = {shown_[i].x_low, shown_[i].x_high, shown_[i].z_low, shown_[i].z_high, n, 0};
    }
}

}  // namespace polyturn::kernel
