#include "ipc/model/bodies/room_bodies.hpp"

#include <algorithm>
#include <cmath>
#include <cstdio>

#include "polyturn/parameter_handles.hpp"

namespace polyturn {
namespace p = params;
namespace {
constexpr double kBehindFace = 1000;  // mm of spindle head behind a chuck's face
constexpr double kMmPerInch = 25.4;
// mm: half of a carrier whose size is not given
constexpr double kPoint = 1e-6;
}  // namespace

BodyFacts body_facts(const MachineConfig& machine) {
    BodyFacts out;
    for (unsigned l = 1; l <= machine.last_channel; ++l) {
        out.channel[l - 1] = machine.channel(l).exists();
        out.inch[l - 1] = machine.channel(l).inch;
    }
    for (unsigned l = 1; l <= machine.last_channel; ++l)
        for (const std::uint16_t a : machine.channel(l).axis_numbers())
            if (machine.axis(a).exists()) out.axis_channel[a - 1u] = l;
    for (unsigned a = 1; a <= machine.last_axis; ++a) out.rotary[a - 1] = machine.axis(a).rotary;
    return out;
}

RoomBodies::Body& RoomBodies::add_body(std::string_view name, Kind kind,
                                       std::uint32_t number) noexcept {
    const bool room = body_count < kBodies;
    if (!room) ++left_out;
    Body& body = room ? bodies[body_count] : spare_;
    body = {};
    std::copy_n(name.begin(), std::min(name.size(), body.name.size() - 1), body.name.begin());
    body.kind = kind;
    body.number = number;
    body.first = box_count;
    if (room) ++body_count;
    return body;
}

RoomBodies::Box* RoomBodies::add_box(Body& body, const Box& box) noexcept {
    if (box_count == kBoxes) {
        ++left_out;
        return nullptr;
    }
    ++body.count;
    return &(boxes[box_count++] = box);
}

void RoomBodies::add_carrier(Body& body, const Room& room, const BodyFacts& facts,
                             unsigned number) noexcept {
    const auto found = room.axes.find(number);
    if (found == room.axes.end() || body.carriers == kCarriers || facts.rotary[number - 1]) return;
    const RoomPlace& place = found->second;
    body.axis[body.carriers] = number - 1;
    body.way[body.carriers++] = {place.direction.x, place.direction.z};
    body.origin.x += place.origin.x;
    body.origin.z += place.origin.z;
}

void RoomBodies::add_tool_carrier(unsigned l, bool guarded, const Room& room, const p::Table& t,
                                  const BodyFacts& facts, const ToolShapes& shapes,
                                  double unit) noexcept {
    const auto length = [&](auto handle) { return p::get(t, handle, l) * unit; };
    const auto turret = room.turrets.find(l);
    char name[32];
    std::snprintf(name, sizeof name, "tool carrier of L%u", l);
    Body& body = add_body(name, Kind::Carrier, l);
    body.channel = l;
    body.guarded = guarded;
    body.in_z = p::bit(t, p::n2000_check_config, l, 1);
    body.without_tool = p::bit(t, p::n2000_check_config, l, 2);
    body.by_hand = p::bit(t, p::n2000_check_config, l, 3);
    for (unsigned a = 1; a <= kMaxAxes; ++a)
        if (facts.axis_channel[a - 1] == l && !facts.rotary[a - 1])
            add_carrier(body, room, facts, a);
    // N2002, N2003 move the shape: in the work area, or along the carrier's own axes.
    double dx = length(p::n2002_tool_holder_position_x),
           dz = length(p::n2003_tool_holder_position_z);
    if (p::get(t, p::n2001_coord_type, l) == 1)
        for (std::size_t i = 0; i < body.carriers; ++i) {
            if (std::fabs(body.way[i].x) > 0.5)
                dx = std::copysign(1.0, body.way[i].x) * length(p::n2002_tool_holder_position_x);
            if (std::fabs(body.way[i].z) > 0.5)
                dz = std::copysign(1.0, body.way[i].z) * length(p::n2003_tool_holder_position_z);
        }
    const auto add = [&](const RoomBox& b, std::uint32_t station) {
        return add_box(body, {b.x_low + dx, b.x_high + dx, b.z_low + dz, b.z_high + dz, station});
    };
    if (turret != room.turrets.end()) {
        const RoomTurret& r = turret->second;
        body.looks_along_x = std::fabs(r.direction.x) > 0.5;
        if (r.reach > 0 && r.stations > 1 &&
            (body.looks_along_x || std::fabs(r.direction.z) > 0.5)) {
            body.stations = r.stations;
            body.reach = r.reach;
            body.outwards = (body.looks_along_x ? r.direction.x : r.direction.z) < 0 ? -1.0 : 1.0;
            body.axis_at = (body.looks_along_x ? dx : dz) - body.outwards * r.reach;
        }
        for (const RoomBox& b : r.body) (void)add(b, 0);
        for (const auto& [station, of_station] : r.tools)
            for (const RoomBox& b : of_station) {
                if (shapes.has(l, station)) continue;
                Box* drawn = add(b, station);
                if (const auto tip = r.tips.find(station); drawn && tip != r.tips.end()) {
                    drawn->goes = true;
                    drawn->tip = {tip->second.x, tip->second.z};
                }
            }
    }
    for (std::size_t i = 0; i < shapes.count; ++i)
        if (const ToolShape& s = shapes.shapes[i]; s.channel == l)
            (void)add({s.x_low, s.x_high, s.z_low, s.z_high}, s.station);
    // the tool carrier's point itself
    if (body.count == 0) (void)add({-kPoint, kPoint, -kPoint, kPoint}, 0);
}

// Barriers of the channel, in machine coordinates of its X and Z: into the work area by where these
// axes point.
void RoomBodies::add_barriers(unsigned l, const Room& room, const p::Table& t,
                              const BodyFacts& facts, double unit) noexcept {
    const auto length = [&](auto handle) { return p::get(t, handle, l) * unit; };
    char name[32];
    double x_origin = 0, z_origin = 0, x_way = 1, z_way = 1;
    for (unsigned a = 1; a <= kMaxAxes; ++a) {
        const auto at = room.axes.find(a);
        if (at == room.axes.end() || facts.axis_channel[a - 1] != l) continue;
        const RoomPlace& axis = at->second;
        if (std::fabs(axis.direction.x) > 0.5) {
            x_origin = axis.origin.x;
            x_way = axis.direction.x;
        }
        if (std::fabs(axis.direction.z) > 0.5) {
            z_origin = axis.origin.z;
            z_way = axis.direction.z;
        }
    }
    const auto barrier = [&](Body& body, double z_from, double z_to, double half, double centre) {
        if (!(half > 0) || z_from == z_to) return;
        const double x0 = x_origin + x_way * (centre - half),
                     x1 = x_origin + x_way * (centre + half);
        const double z0 = z_origin + z_way * z_from, z1 = z_origin + z_way * z_to;
        (void)add_box(body,
                      {std::min(x0, x1), std::max(x0, x1), std::min(z0, z1), std::max(z0, z1), 0});
    };
    const double jaws = length(p::n1901_l1_length_of_jaws),
                 width = length(p::n1902_w1_width_of_jaws);
    if (jaws > 0 && width > 0) {
        std::snprintf(name, sizeof name, "chuck of L%u", l);
        Body& body = add_body(name, Kind::Chuck, l);
        body.of_channel = l;
        const double face = length(p::n1906_chuck_position_z),
                     centre = length(p::n1905_chuck_position_x);
        // Jaws that hold a part by its outside are around it: seen from the side, their grip is as
        // wide as they are.
        const bool outside = p::bit(t, p::n1900_chuck_config, l, 0);
        const double grip = length(p::n1903_l2_holding_length_of_jaws),
                     held = outside ? std::max(width, length(p::n1904_w2_holding_width_of_jaws))
                                    : length(p::n1904_w2_holding_width_of_jaws);
        barrier(body, face - kBehindFace, face, width, centre);
        barrier(body, face, face + jaws, width, centre);
        if (grip > 0) barrier(body, face + jaws, face + jaws + grip, held, centre);
    }
    const double l1 = length(p::n1907_l1_length_of_tailstock),
                 d1 = length(p::n1908_d1_diameter_of_tailstock);
    if (l1 > 0 && d1 > 0) {
        std::snprintf(name, sizeof name, "tailstock of L%u", l);
        Body& body = add_body(name, Kind::Tailstock, l);
        body.of_channel = l;
        const double tip = length(p::n1914_tailstock_position_z),
                     l2 = length(p::n1909_l2_length_of_tailstock),
                     l3 = length(p::n1911_l3_length_of_tailstock);
        const double centre = length(p::n1905_chuck_position_x);
        barrier(body, tip, tip + l3, length(p::n1912_d3_diameter_of_tailstock) / 2, centre);
        barrier(body, tip + l3, tip + l3 + l2, length(p::n1910_d2_diameter_of_tailstock) / 2,
                centre);
        barrier(body, tip + l3 + l2, tip + l3 + l2 + l1,
                std::max(d1, length(p::n1913_d4_diameter_of_tailstock)) / 2, centre);
    }
}

void RoomBodies::configure(const Room& room, const p::Table& t, const BodyFacts& facts,
                           const ToolShapes& shapes, bool all) noexcept {
    body_count = box_count = left_out = 0;
    watched = false;
    for (unsigned l = 1; l <= kMaxChannels; ++l) {
        if (!facts.channel[l - 1]) continue;
        const double unit = facts.inch[l - 1] ? kMmPerInch : 1.0;
        const bool guarded = p::bit(t, p::n2000_check_config, l, 0);
        watched |= guarded;
        if (guarded || all) add_tool_carrier(l, guarded, room, t, facts, shapes, unit);
        add_barriers(l, room, t, facts, unit);
    }
    if (!watched) left_out = 0;
    if (!watched && !all) return;
    left_out += shapes.left_out;
    for (const auto& [s, chuck] : room.chucks) {
        if (!(chuck.diameter > 0)) continue;
        char name[32];
        std::snprintf(name, sizeof name, "chuck of S%u", s);
        Body& body = add_body(name, Kind::Chuck, s);
        const double sense = chuck.direction.z < 0 ? -1.0 : 1.0;
        const double back = chuck.origin.z - sense * chuck.length,
                     front = chuck.origin.z + sense * chuck.jaws;
        (void)add_box(body,
                      {chuck.origin.x - chuck.diameter / 2, chuck.origin.x + chuck.diameter / 2,
                       std::min(back, front), std::max(back, front), 0});
        if (chuck.carried_by) {
            const Vector stood = body.origin;
            add_carrier(body, room, facts, chuck.carried_by);
            body.origin = stood;  // its position is given for machine coordinate 0 of that axis
        }
    }
    for (const auto& [n, tail] : room.tailstocks) {
        if (!(tail.diameter > 0)) continue;
        char name[32];
        std::snprintf(name, sizeof name, "tailstock %u", n);
        Body& body = add_body(name, Kind::Tailstock, n);
        const double sense = tail.direction.z < 0 ? -1.0 : 1.0,
                     back = tail.origin.z - sense * tail.length;
        (void)add_box(body, {tail.origin.x - tail.diameter / 2, tail.origin.x + tail.diameter / 2,
                             std::min(back, tail.origin.z), std::max(back, tail.origin.z), 0});
    }
}

RoomBodies::Vector RoomBodies::point(const Body& body, const double* axes) noexcept {
    Vector at = body.origin;
    for (std::size_t i = 0; i < body.carriers; ++i) {
        at.x += body.way[i].x * axes[body.axis[i]];
        at.z += body.way[i].z * axes[body.axis[i]];
    }
    return at;
}

RoomBodies::Box RoomBodies::turned(const Body& body, const Box& own, double steps,
                                   bool anywhere) noexcept {
    constexpr double kTurn = 2 * 3.14159265358979323846;
    const double low = body.looks_along_x ? own.x_low : own.z_low,
                 high = body.looks_along_x ? own.x_high : own.z_high;
    const double across =
        (body.looks_along_x ? own.z_high - own.z_low : own.x_high - own.x_low) / 2;
    const double u1 = body.outwards * (low - body.axis_at),
                 u2 = body.outwards * (high - body.axis_at);
    const double angle = kTurn * steps / body.stations, c = std::cos(angle),
                 wide = across * std::fabs(std::sin(angle));
    const double most = std::hypot(std::max(std::fabs(u1), std::fabs(u2)), across);
    const double from = anywhere ? -most : std::min(u1 * c, u2 * c) - wide,
                 to = anywhere ? most : std::max(u1 * c, u2 * c) + wide;
    const double a = body.axis_at + body.outwards * from, b = body.axis_at + body.outwards * to;
    Box box = own;
    if (body.looks_along_x) {
        box.x_low = std::min(a, b);
        box.x_high = std::max(a, b);
    } else {
        box.z_low = std::min(a, b);
        box.z_high = std::max(a, b);
    }
    return box;
}

bool RoomBodies::placed(const Body& body, const Box& own, Vector at, const Turret& turret,
                        Box& out) noexcept {
    Box box = own;
    // The called tool too is anywhere on its circle until the turret is at standstill.
    if (own.station && body.channel &&
        ((turret.turns && body.stations != 0) || own.station != turret.station)) {
        if (body.stations == 0) return false;
        box = turned(body, own,
                     static_cast<double>(own.station) - static_cast<double>(turret.stands_at),
                     turret.turns);
    } else if (own.goes && body.channel && turret.tip_known) {
        at = {at.x + turret.tip.x - own.tip.x, at.z + turret.tip.z - own.tip.z};
    }
    out = {box.x_low + at.x, box.x_high + at.x, box.z_low + at.z, box.z_high + at.z, own.station};
    return true;
}

RoomBodies::Vector tip_of(const Room& room, const MachineConfig& machine, unsigned channel,
                          const std::array<double, kChannelAxes>& shift) noexcept {
    RoomBodies::Vector tip;
    const auto& own = machine.channel(channel);
    const AxisConfig* along = find_axis(machine, channel, PlaneRole::BasicZ);
    const auto z = along ? room.axes.find(along->number) : room.axes.end();
    for (std::size_t i = 0; i < own.axis_count; ++i) {
        const auto place = room.axes.find(own.axes[i]);
        const AxisConfig& axis = machine.axis(own.axes[i]);
        if (place == room.axes.end() || axis.rotary) continue;
        RoomVector way = place->second.direction;
        // An inclined X slide: programs and offsets count at right angles to Z.
        if (axis.role == PlaneRole::BasicX && z != room.axes.end()) {
            const RoomVector& of = z->second.direction;
            const double part = way.x * of.x + way.z * of.z, x = way.x - part * of.x,
                         length = std::hypot(x, way.z - part * of.z);
            if (std::fabs(part) > 1e-6 && length > 1e-6) {
                way.x = x / length;
                way.z = (way.z - part * of.z) / length;
            }
        }
        tip.x -= way.x * shift[i];
        tip.z -= way.z * shift[i];
    }
    return tip;
}

}  // namespace polyturn
