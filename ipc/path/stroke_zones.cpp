#include "ipc/path/stroke_zones.hpp"

#include <algorithm>

namespace polyturn {
namespace {

constexpr double kMmPerInch = 25.4;

bool inside(const AxisZone& zone, unsigned box, double x) noexcept {
    return x > zone.box[box].low + kOnLimit && x < zone.box[box].high - kOnLimit;
}

bool box_exists(const StrokeZones& zones, unsigned box) noexcept {
    for (unsigned i = 0; i < zones.count; ++i)
        if (zones.axes[i].in_box[box]) return true;
    return false;
}

}  // namespace

AxisStroke read_axis_stroke(const params::Table& t, unsigned a) noexcept {
    using namespace params;
    AxisStroke s;
    const auto channel = get(t, n0002_axis_assign, a);
    const bool owned = channel >= 1 && channel <= static_cast<std::int64_t>(kMaxChannels);
    const bool inch = owned && !bit(t, n0106_axis_properties, a, 1) &&
                      bit(t, n0104_unit_of_measure, static_cast<unsigned>(channel), 0);
    const double unit = inch ? kMmPerInch : 1.0;
    s.range1 = bit(t, n1000_range_enable, a, 0);
    s.range2 = bit(t, n1000_range_enable, a, 1);
    s.range3 = bit(t, n1000_range_enable, a, 2);
    s.a = {get(t, n1003_range1a_negative, a) * unit, get(t, n1002_range1a_positive, a) * unit};
    s.b = {get(t, n1005_range1b_negative, a) * unit, get(t, n1004_range1b_positive, a) * unit};
    s.second = {get(t, n1007_range2_negative, a) * unit, get(t, n1006_range2_positive, a) * unit};
    // millimetres, as all parameters F
    if (const double fanuc = get(t, f1322, a); fanuc != 0) s.second.high = fanuc;
    s.third = {get(t, n1009_range3_negative, a) * unit, get(t, n1008_range3_positive, a) * unit};
    return s;
}

ChannelStroke read_channel_stroke(const params::Table& t, unsigned l) noexcept {
    using namespace params;
    return {bit(t, n1001_strkcont, l, 0), bit(t, n1001_strkcont, l, 1),
            bit(t, n1001_strkcont, l, 2), bit(t, n1001_strkcont, l, 3),
            bit(t, n1001_strkcont, l, 4)};
}

bool AxisZone::operator==(const AxisZone& o) const noexcept {
    const auto same = [](const StrokeInterval& x, const StrokeInterval& y) {
        return x.low == y.low && x.high == y.high;
    };
    return same(allowed, o.allowed) && in_box[0] == o.in_box[0] && in_box[1] == o.in_box[1] &&
           same(box[0], o.box[0]) && same(box[1], o.box[1]);
}

AxisZone zone_of(const AxisStroke& axis, const ChannelStroke& channel,
                 const StrokeFlags& flags) noexcept {
    AxisZone zone;
    if (axis.range1 && !flags.first_off) {
        const bool high_b = channel.by_channel ? flags.channel_b : flags.positive_b;
        const bool low_b = channel.by_channel ? flags.channel_b : flags.negative_b;
        zone.allowed = {low_b ? axis.b.low : axis.a.low, high_b ? axis.b.high : axis.a.high};
    }
    if (axis.range2 && channel.second_watched && !flags.second_off) {
        if (channel.second_outside) {
            zone.allowed.low = std::max(zone.allowed.low, axis.second.low);
            zone.allowed.high = std::min(zone.allowed.high, axis.second.high);
        } else {
            zone.in_box[0] = true;
            zone.box[0] = axis.second;
        }
    }
    if (axis.range3 && !flags.third_off) {
        zone.in_box[1] = true;
        zone.box[1] = axis.third;
    }
    return zone;
}

bool forbidden(const StrokeZones& zones, const double* x, std::uint32_t moved,
               StrokeFault& fault) noexcept {
    for (unsigned i = 0; i < zones.count; ++i) {
        if (!(moved >> i & 1u)) continue;
        const StrokeInterval& allowed = zones.axes[i].allowed;
        if (x[i] > allowed.high + kOnLimit) {
            fault = {i, allowed.high, true};
            return true;
        }
        if (x[i] < allowed.low - kOnLimit) {
            fault = {i, allowed.low, false};
            return true;
        }
    }
    for (unsigned box = 0; box < 2; ++box) {
        if (!box_exists(zones, box)) continue;
        bool in = true, asked = false;
        unsigned nearest = 0;
        for (unsigned i = 0; i < zones.count && in; ++i) {
            if (!zones.axes[i].in_box[box]) continue;
            in = inside(zones.axes[i], box, x[i]);
            if (moved >> i & 1u) {
                asked = true;
                nearest = i;
            }
        }
        if (!in || !asked) continue;
        const StrokeInterval& b = zones.axes[nearest].box[box];
        const bool upper = b.high - x[nearest] < x[nearest] - b.low;
        fault = {nearest, upper ? b.high : b.low, !upper};
        return true;
    }
    return false;
}

double free_part(const StrokeZones& zones, const double* from, const double* to,
                 StrokeFault& fault) noexcept {
    double free = 1.0;
    const auto nearer = [&](double part, unsigned axis, double limit, bool positive) {
        if (part < free) {
            free = std::max(part, 0.0);
            fault = {axis, limit, positive};
        }
    };
    for (unsigned i = 0; i < zones.count; ++i) {
        const double d = to[i] - from[i];
        const StrokeInterval& allowed = zones.axes[i].allowed;
        // Who is outside already may come back, but not go further.
        if (d > 0 && to[i] > allowed.high + kOnLimit)
            nearer((std::max(allowed.high, from[i]) - from[i]) / d, i, allowed.high, true);
        if (d < 0 && to[i] < allowed.low - kOnLimit)
            nearer((std::min(allowed.low, from[i]) - from[i]) / d, i, allowed.low, false);
    }
    for (unsigned box = 0; box < 2; ++box) {
        if (!box_exists(zones, box)) continue;
        // The part of the line in which every axis lies inside: an intersection of intervals.
        double enter = -1.0, leave = 1.0;
        unsigned door = 0;
        bool missed = false, positive = true;
        for (unsigned i = 0; i < zones.count && !missed; ++i) {
            if (!zones.axes[i].in_box[box]) continue;
            const double low = zones.axes[i].box[box].low + kOnLimit,
                         high = zones.axes[i].box[box].high - kOnLimit, d = to[i] - from[i];
            if (d == 0) {
                missed = from[i] <= low || from[i] >= high;
                continue;
            }
            const double in = ((d > 0 ? low : high) - from[i]) / d,
                         out = ((d > 0 ? high : low) - from[i]) / d;
            if (in > enter) {
                enter = in;
                door = i;
                positive = d > 0;
            }
            leave = std::min(leave, out);
        }
        // An axis that is inside already (the box was switched on around it) may leave it.
        if (missed || enter < 0 || enter >= leave || enter >= 1.0) continue;
        nearer(enter, door,
               positive ? zones.axes[door].box[box].low : zones.axes[door].box[box].high, positive);
    }
    return free;
}

std::uint32_t closed_sides(const StrokeZones& zones, const double* x, unsigned axis) noexcept {
    const AxisZone& own = zones.axes[axis];
    std::uint32_t sides = (x[axis] >= own.allowed.high - kOnLimit ? 1u : 0u) |
                          (x[axis] <= own.allowed.low + kOnLimit ? 2u : 0u);
    for (unsigned box = 0; box < 2; ++box) {
        if (!own.in_box[box]) continue;
        bool others = true;
        for (unsigned i = 0; i < zones.count; ++i)
            if (i != axis && zones.axes[i].in_box[box] && !inside(zones.axes[i], box, x[i]))
                others = false;
        if (!others) continue;
        if (x[axis] >= own.box[box].low - kOnLimit && x[axis] < own.box[box].high - 2 * kOnLimit)
            sides |= 1u;
        if (x[axis] <= own.box[box].high + kOnLimit && x[axis] > own.box[box].low + 2 * kOnLimit)
            sides |= 2u;
    }
    return sides;
}

}  // namespace polyturn
