#include "kernel/protection/guard.hpp"

#include <algorithm>
#include <cmath>

namespace polyturn::kernel {
namespace p = params;
namespace {
constexpr std::size_t kSamples = 8;  // of a braking distance
constexpr double kReserve = 1.1;     // of it: the planner brakes a little later than a parabola
constexpr double kTowards = 1e-7;    // mm: nearer than that in one tick is no approach
constexpr double kFarAway = 1e9;

// Of two rectangles, the second moved by (dx, dz): negative when they overlap.
double gap_of(double x_first_above, double x_second_above, double z_first_above,
              double z_second_above, double dx, double dz) noexcept {
    const double x = std::max(x_first_above - dx, x_second_above + dx),
                 z = std::max(z_first_above - dz, z_second_above + dz);
    return x > 0 && z > 0 ? std::sqrt(x * x + z * z) : std::max(x, z);
}
}  // namespace

void Guard::take_room(const Room& room, const MachineConfig& machine) {
    room_ = room;
    machine_ = machine;
    has_room_ = true;
}

void Guard::configure(const p::Table& t, const KernelConfig& config) {
    body_count_ = 0;
    distance_ = p::get(t, p::pt_guard_distance);
    set_.body_count = set_.box_count = set_.left_out = 0;
    set_.watched = false;
    if (!has_room_) return;
    BodyFacts facts;
    for (std::size_t l = 0; l < kMaxChannels; ++l) {
        facts.channel[l] = config.channels[l].exists;
        facts.inch[l] = config.channels[l].inch;
    }
    for (std::size_t a = 0; a < kMaxAxes; ++a) {
        facts.axis_channel[a] = config.axes[a].exists ? config.axes[a].channel : 0;
        facts.rotary[a] = machine_.axis(a + 1).rotary || config.axes[a].rotary;
    }
    set_.configure(room_, t, facts, shapes_, false);
    body_count_ = set_.body_count;
    for (std::size_t n = 0; n < body_count_; ++n) {
        bodies_[n] = {};
        static_cast<RoomBodies::Body&>(bodies_[n]) = set_.bodies[n];
    }
}

void Guard::take_tool(std::uint32_t channel,
                      const std::array<double, kChannelAxes>& shift) noexcept {
    Tool& tool = tools_[channel - 1];
    if (!has_room_ || std::all_of(shift.begin(), shift.end(), [](double one) { return one == 0; }))
        return;
    tool.known = true;
    tool.tip = tip_of(room_, machine_, channel, shift);
}

bool Guard::carries(std::uint32_t body, std::uint32_t axis) const noexcept {
    const Body& b = bodies_[body];
    return std::find(b.axis.begin(), b.axis.begin() + static_cast<std::ptrdiff_t>(b.carriers),
                     axis) != b.axis.begin() + static_cast<std::ptrdiff_t>(b.carriers);
}

ChannelSet Guard::movers(const Core& core, std::uint32_t index) const noexcept {
    ChannelSet set = 0;
    const Body& body = bodies_[index];
    for (std::size_t i = 0; i < body.carriers; ++i)
        if (const std::uint32_t owner = core.axes[body.axis[i]].owner;
            owner && core.axes[body.axis[i]].target() != core.axes[body.axis[i]].command())
            set |= ChannelSet{1} << (owner - 1);
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
        const double rise =
            std::isfinite(config.jerk) && config.jerk > 0 ? config.acceleration / config.jerk : 0.0;
        if (u != 0) time = std::max(time, std::fabs(u) / config.acceleration + rise);
    }
    body.at = at;
    body.moving = v.x != 0 || v.z != 0;
    const double speed2 = v.x * v.x + v.z * v.z;
    const double way = kReserve * (time / 2 + core.config.tick_s);
    body.rest = {v.x * way, v.z * way};
    body.bend = {};
    if (body.moving && speed2 > 0) {  // the path bends: v^2 times curvature, across it
        const double ax = (v.x - body.velocity.x) / core.config.tick_s,
                     az = (v.z - body.velocity.z) / core.config.tick_s;
        const double along = (ax * v.x + az * v.z) / speed2;
        body.bend = {(ax - along * v.x) * way * way / 2, (az - along * v.z) * way * way / 2};
    }
    body.velocity = v;
    body.travel_left = std::sqrt(body.rest.x * body.rest.x + body.rest.z * body.rest.z) +
                       std::sqrt(body.bend.x * body.bend.x + body.bend.z * body.bend.z);
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

// The turret's position: as its PLC reports it; before that, as the program has commanded it.
// Worked out anew only when that changes.
void Guard::turn_tools(const Core& core, Body& body) noexcept {
    std::int64_t index = core.signals.plc(signals::cp_actt(body.channel));
    if (index <= 0)
        index = static_cast<std::int64_t>(std::max<std::uint32_t>(station_[body.channel - 1], 1));
    const bool turns = core.signals.plc(signals::cp_turretopen(body.channel)) != 0;
    if (body.turned_for == (turns ? 0 : index)) return;
    body.turned_for = turns ? 0 : index;
    for (std::size_t i = body.first; i < body.first + body.count; ++i)
        if (set_.boxes[i].station)
            turned_[i] = RoomBodies::turned(
                body, set_.boxes[i],
                static_cast<double>(set_.boxes[i].station) - static_cast<double>(index), turns);
}

// The boxes that count now, where they are now, and what is around all of them.
void Guard::show(const Core& core, Body& body) noexcept {
    if (body.stations && body.channel) turn_tools(core, body);
    body.shown = shown_count_;
    body.shown_count = 0;
    body.outline = {kFarAway, -kFarAway, kFarAway, -kFarAway, 0};
    for (std::size_t i = body.first; i < body.first + body.count; ++i) {
        const Box& own = set_.boxes[i];
        Vector at = body.at;
        // The called tool too is anywhere on its circle until the turret is at standstill.
        const bool turns = body.stations != 0 && body.turned_for == 0;
        if (own.station && body.channel && (turns || own.station != station_[body.channel - 1])) {
            if (body.stations == 0) continue;
            const Box& off = turned_[i];
            const Box box{off.x_low + at.x, off.x_high + at.x, off.z_low + at.z, off.z_high + at.z,
                          own.station};
            body.outline = {std::min(body.outline.x_low, box.x_low),
                            std::max(body.outline.x_high, box.x_high),
                            std::min(body.outline.z_low, box.z_low),
                            std::max(body.outline.z_high, box.z_high), 0};
            shown_[shown_count_++] = box;
            ++body.shown_count;
            continue;
        }
        if (own.goes && body.channel && tools_[body.channel - 1].known)
            at = {at.x + tools_[body.channel - 1].tip.x - own.tip.x,
                  at.z + tools_[body.channel - 1].tip.z - own.tip.z};
        const Box box{own.x_low + at.x, own.x_high + at.x, own.z_low + at.z, own.z_high + at.z,
                      own.station};
        body.outline = {
            std::min(body.outline.x_low, box.x_low), std::max(body.outline.x_high, box.x_high),
            std::min(body.outline.z_low, box.z_low), std::max(body.outline.z_high, box.z_high), 0};
        shown_[shown_count_++] = box;
        ++body.shown_count;
    }
}

// The distance now, and in `then` that of each point checked, but only of what may come nearer
// than kept: `reach` is what both displacements and PT_GUARD_DISTANCE allow.
double Guard::gaps(const Body& a, const Body& b, double reach, const Relative& way,
                   std::array<double, 8>& then) const noexcept {
    const bool flat = !a.in_z || !b.in_z;  // Z does not separate them
    const auto z_gap = [flat](double gap) { return flat ? -kFarAway : gap; };
    const auto outside = [&](const Box& p, const Box& q) {
        return gap_of(p.x_low - q.x_high, q.x_low - p.x_high, z_gap(p.z_low - q.z_high),
                      z_gap(q.z_low - p.z_high), 0, 0);
    };
    // Of b, only what lies near enough to all of a.
    std::array<std::uint16_t, kBoxes> near;
    std::size_t near_count = 0;
    double now = kFarAway;
    for (std::size_t k = b.shown; k < b.shown + b.shown_count; ++k)
        if (const double least = outside(a.outline, shown_[k]);
            least <= reach || least < nearest_.distance)
            near[near_count++] = static_cast<std::uint16_t>(k);
    for (std::size_t i = a.shown; i < a.shown + a.shown_count; ++i) {
        const Box& p = shown_[i];
        if (const double least = outside(p, b.outline); least > reach && least >= now) continue;
        for (std::size_t n = 0; n < near_count; ++n) {
            const Box& q = shown_[near[n]];
            const double x1 = p.x_low - q.x_high, x2 = q.x_low - p.x_high,
                         z1 = z_gap(p.z_low - q.z_high), z2 = z_gap(q.z_low - p.z_high);
            const double gap = gap_of(x1, x2, z1, z2, 0, 0);
            now = std::min(now, gap);
            if (gap > reach) continue;
            for (std::size_t s = 0; s < kSamples; ++s)
                then[s] = std::min(then[s], gap_of(x1, x2, z1, z2, way.x[s], way.z[s]));
        }
    }
    return now;
}

// The PLC opens barriers for the channel whose carrier comes near.
bool Guard::off(const Core& core, const Body& a, const Body& b) const noexcept {
    const std::uint32_t channel = std::max(a.channel, b.channel);
    if ((a.kind == Kind::Chuck || b.kind == Kind::Chuck) &&
        core.signals.plc(signals::cp_chuckoff(channel)))
        return true;
    return (a.kind == Kind::Tailstock || b.kind == Kind::Tailstock) &&
           core.signals.plc(signals::cp_tailoff(channel));
}

Guard::Finding Guard::step(const Core& core) noexcept {
    nearest_ = {kNone, kNone, kFarAway};
    Finding found{kNone, kNone, 0};
    if (!any()) return found;
    // Tool management has reported the tool's station; without it T is the station.
    for (std::uint32_t l = 0; l < kMaxChannels; ++l) {
        const bool managed = core.signals.nc(signals::cn_mgzno(l + 1)) != 0;
        const auto station = static_cast<std::uint32_t>(std::max(
            core.signals.nc(managed ? signals::cn_potno(l + 1) : signals::cn_tcode(l + 1)), 0));
        // another tool: it counts as it is drawn until its offset is in use
        if (station != station_[l]) tools_[l].known = false;
        station_[l] = station;
    }
    shown_count_ = 0;
    for (std::size_t i = 0; i < body_count_; ++i) {
        place(core, bodies_[i]);
        show(core, bodies_[i]);
    }
    for (std::uint32_t i = 0; i < body_count_; ++i) {
        const Body& a = bodies_[i];
        for (std::uint32_t k = i + 1; k < body_count_; ++k) {
            const Body& b = bodies_[k];
            if ((!a.moving && !b.moving) || !a.watched || !b.watched || (!a.channel && !b.channel))
                continue;
            const double reach = a.travel_left + b.travel_left + distance_;
            const bool flat = !a.in_z || !b.in_z;
            const Box &p = a.outline, &q = b.outline;
            const double outside = gap_of(p.x_low - q.x_high, q.x_low - p.x_high,
                                          flat ? -kFarAway : p.z_low - q.z_high,
                                          flat ? -kFarAway : q.z_low - p.z_high, 0, 0);
            if ((outside > reach && outside >= nearest_.distance) || off(core, a, b)) continue;
            Relative way;
            const Vector rest{b.rest.x - a.rest.x, b.rest.z - a.rest.z},
                bend{b.bend.x - a.bend.x, b.bend.z - a.bend.z};
            for (std::size_t n = 0; n < kSamples; ++n) {
                const double s = static_cast<double>(n + 1) / kSamples;
                way.x[n] = s * rest.x + s * s * bend.x;
                way.z[n] = s * rest.z + s * s * bend.z;
            }
            std::array<double, 8> then;
            then.fill(kFarAway);
            const double now = gaps(a, b, reach, way, then);
            if (now < nearest_.distance) nearest_ = {i, k, now};
            const bool meets = std::any_of(then.begin(), then.end(), [&](double gap) {
                return gap < distance_ && gap < now - kTowards;
            });
            if (meets && (found.first == kNone || now < found.distance)) found = {i, k, now};
        }
    }
    return found;
}

bool Guard::protects(std::uint32_t channel) const noexcept {
    return std::any_of(
        bodies_.begin(), bodies_.begin() + static_cast<std::ptrdiff_t>(body_count_),
        [&](const Body& b) { return b.kind == Kind::Carrier && b.channel == channel; });
}

bool Guard::circle_is_free(std::uint32_t channel,
                           const std::array<double, kMaxAxes>& left) const noexcept {
    const Body* const end = bodies_.data() + body_count_;
    const Body* const own = std::find_if(bodies_.data(), end, [&](const Body& b) {
        return b.kind == Kind::Carrier && b.channel == channel;
    });
    if (own == end || !own->watched || own->stations == 0) return false;
    Vector way;
    for (std::size_t i = 0; i < own->carriers; ++i) {
        way.x += own->way[i].x * left[own->axis[i]];
        way.z += own->way[i].z * left[own->axis[i]];
    }
    for (std::size_t i = own->first; i < own->first + own->count; ++i) {
        if (set_.boxes[i].station == 0) continue;  // the turret's body stays as it is
        const Box t = RoomBodies::turned(*own, set_.boxes[i], 0, true);
        const double x = own->at.x, z = own->at.z;
        const Box swept{t.x_low + x + std::min(way.x, 0.0), t.x_high + x + std::max(way.x, 0.0),
                        t.z_low + z + std::min(way.z, 0.0), t.z_high + z + std::max(way.z, 0.0), 0};
        for (const Body* other = bodies_.data(); other != end; ++other) {
            if (other == own) continue;
            if (!other->known) return false;
            const bool flat = !own->in_z || !other->in_z;
            const auto free_of = [&](const Box& q) {
                return gap_of(swept.x_low - q.x_high, q.x_low - swept.x_high,
                              flat ? -kFarAway : swept.z_low - q.z_high,
                              flat ? -kFarAway : q.z_low - swept.z_high, 0,
                              0) > distance_ + other->travel_left;
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
        std::copy(body.name.begin(), body.name.end(),
                  out.names.begin() + static_cast<std::ptrdiff_t>(n) * 32);
        for (std::size_t i = body.shown;
             i < body.shown + body.shown_count && out.count < out.boxes.size(); ++i)
            out.boxes[out.count++] = {
                shown_[i].x_low, shown_[i].x_high, shown_[i].z_low, shown_[i].z_high, n, 0};
    }
}

}  // namespace polyturn::kernel
