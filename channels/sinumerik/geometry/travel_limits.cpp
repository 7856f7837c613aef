// CALCPOSI: how far a straight way can be travelled before a limit ends it (sinumerik_part3 9.8).
//
//   start, way   in the workpiece system, as axis words count (diameter, unit)
//   distances    that must be left to the limits, of the geometry axes 1 to 3
//   result       the way that can be travelled: the given one times t, 0 <= t <= 1
//   unit         TRUE: the machine's (MD10240) instead of that of group 13
//   kinds        bit 0 limits of the axes, bit 1 G25 G26 and WALCS; both without it
//
// The source says that a status comes back, not its meaning. It is the control's own: 0 all of
// the way, -1 a distance below 0, else
//   1000 * axis + (100 upper, 200 lower limit) + (10 the start is outside, 20 the way leaves) + (1
//   limit of an axis, 2 working area)
// Each limit bounds a coordinate that is linear in t, so the t inside all of them are one interval
// from 0 on: halving finds its end.
#include "channels/sinumerik/geometry/travel_limits.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "channels/sinumerik/axes/axis_words.hpp"
#include "channels/sinumerik/execution.hpp"
#include "channels/sinumerik/faults.hpp"
#include "channels/sinumerik/frames/settable_frames.hpp"
#include "channels/sinumerik/geometry/geo_motion.hpp"
#include "channels/sinumerik/geometry/units.hpp"
#include "channels/sinumerik/grammar/groups.hpp"
#include "channels/sinumerik/variables/variables.hpp"

namespace polyturn::channels::sinumerik {
namespace {

constexpr double kOnLimit = 1e-6;       // mm: exactly on the limit is inside
constexpr double kTouchesLimit = 1e-6;  // mm: the start may stand on a limit
constexpr unsigned kAxisLimits = 1, kWorkingArea = 2;

// where a point leaves a working area: the axis, by which side
struct AreaFault {
    unsigned axis = 0;
    double value = 0.0, limit = 0.0;
    bool upper = false;
};
std::optional<AreaFault> area_fault(Execution& x, const AxisValues& target,
                                    const AxisValues& distance, double slack);

// Axis, side and kind of a limit that the point violates, as the status has them; 0: none.
int violated_limit(Execution& x, const AxisValues& point, const AxisValues& distance,
                   unsigned kinds, double slack) {
    const MachineView& view = x.core.view();
    if (kinds & kAxisLimits) {
        const AxisValues framed = x.core.framed(point);
        for (unsigned i = 0; i < view.axis_count; ++i) {
            const ChannelAxis& axis = view.axes[i];
            const double machine = framed[i] + x.core.path.turns_deg[i] + x.core.path.zero[i] +
                                   x.core.path.shift[i] + x.core.path.wanted[i];
            if (!axis.limited) continue;
            if (machine + distance[i] > axis.limit_max + slack)
                return static_cast<int>(i + 1) * 1000 + 100 + 1;
            if (machine - distance[i] < axis.limit_min - slack)
                return static_cast<int>(i + 1) * 1000 + 200 + 1;
        }
    }
    if (!(kinds & kWorkingArea)) return 0;
    const auto out = area_fault(x, point, distance, slack);
    return out ? static_cast<int>(out->axis + 1) * 1000 + (out->upper ? 100 : 200) + 2 : 0;
}

// A limit that acts and that the point violates: WALIMON those of G25, G26 in the basic system,
// WALCS its group's. `distance` must be left to it on each axis.
std::optional<AreaFault> area_fault(Execution& x, const AxisValues& target,
                                    const AxisValues& distance, double slack) {
    const GeoModal& geo = x.modal.geo;
    const bool basic = active(x, 28) == 1, group = active(x, 60) > 1;
    if (!basic && !group) return std::nullopt;
    const MachineView& view = x.core.view();
    const AxisValues basic_point = x.core.framed(target), settable = programmable(x, target);
    for (unsigned i = 0; i < view.axis_count; ++i) {
        const PlaneRole role = view.axes[i].role;
        const bool round =
            x.settings.area_with_radius &&
            (role == PlaneRole::BasicX || role == PlaneRole::BasicY || role == PlaneRole::BasicZ);
        // MD21020: what is looked at is the same in both areas (15.3.2)
        const double reach = (round ? std::fabs(x.core.path.tool.nose_radius) : 0.0) + distance[i];
        if (basic) {
            const double value = basic_point[i] + x.core.path.zero[i];
            const bool plus = x.settings.area_plus[view.axes[i].machine_axis],
                       minus = x.settings.area_minus[view.axes[i].machine_axis];
            const double high = geo.area_high >> i & 1u
                                    ? geo.high[i]
                                    : x.settings.area_high[view.axes[i].machine_axis];
            const double low = geo.area_low >> i & 1u
                                   ? geo.low[i]
                                   : x.settings.area_low[view.axes[i].machine_axis];
            if (plus && value + reach > high + slack)
                return AreaFault{i, value + reach, high, true};
            if (minus && value - reach < low - slack)
                return AreaFault{i, value - reach, low, false};
        }
        if (!group) continue;
        const AreaGroup& area = geo.areas[active(x, 60) - 2];
        const double value = area.workpiece ? target[i] : settable[i];
        if (area.plus >> i & 1u && value + reach > area.high[i] + slack)
            return AreaFault{i, value + reach, area.high[i], true};
        if (area.minus >> i & 1u && value - reach < area.low[i] - slack)
            return AreaFault{i, value - reach, area.low[i], false};
    }
    return std::nullopt;
}

}  // namespace

bool f_calcposi(Execution& x, Call& c) {
    static constexpr PlaneRole kRoles[] = {PlaneRole::BasicX, PlaneRole::BasicY, PlaneRole::BasicZ};
    for (std::size_t k = 0; k < 4; ++k) {
        const Argument& argument = c.arguments[k];
        if (!argument.given || argument.reference.variable->cells.size() < 3 ||
            !argument.reference.cell().is_number())
            return fail(x, Alarm::FunctionArgument, "CALCPOSI", static_cast<double>(k + 1));
    }
    if (x.core.transformed()) return fail(x, Alarm::TransformCode, "CALCPOSI");
    const auto numbers = [&](std::size_t k, std::size_t g) {
        return c.arguments[k].reference.variable->cells[g].number;
    };
    const double length = c.number(4) != 0 ? (x.settings.metric_base ? 1.0 : 25.4) : unit(x);
    const unsigned kinds = c.has(5) ? static_cast<unsigned>(std::clamp(c.number(5), 0.0, 255.0))
                                    : kAxisLimits | kWorkingArea;
    AxisValues from = x.core.path.programmed, way{}, distance{};
    double status = 0.0;
    for (std::size_t g = 0; g < 3; ++g) {
        if (numbers(2, g) < 0) status = -1;
        const int place = x.core.view().axis_by_role(kRoles[g]);
        if (place < 0) continue;
        const auto i = static_cast<unsigned>(place);
        from[i] = numbers(0, g) * length * (counts_diameter(x, i, false) ? 0.5 : 1.0);
        way[i] = numbers(1, g) * length * (counts_diameter(x, i, true) ? 0.5 : 1.0);
        distance[i] = numbers(2, g) * length;
    }
    const auto violated = [&](double t, double slack) {
        AxisValues point = from;
        for (std::size_t i = 0; i < point.size(); ++i) point[i] += t * way[i];
        return violated_limit(x, point, distance, kinds, slack);
    };
    double t = status < 0 ? 0.0 : 1.0;
    if (status == 0) {
        if (const int start = violated(0.0, kTouchesLimit); start != 0) {
            status = start + 10;
            t = 0.0;
        } else if (const int end = violated(1.0, kTouchesLimit); end != 0) {
            status = end + 20;
            double inside = 0.0, outside = 1.0;
            while (outside - inside > 1e-12) {
                const double middle = 0.5 * (inside + outside);
                (violated(middle, 0.0) ? outside : inside) = middle;
            }
            // the one that is met first
            if (const int first = violated(outside, 0.0); first != 0) status = first + 20;
            t = inside;
        }
    }
    const std::shared_ptr<Variable> result = c.arguments[3].reference.variable;
    // never -0
    for (std::size_t g = 0; g < 3; ++g)
        store(x, {result, g, false}, Value::of_real(numbers(1, g) * t + 0.0));
    c.result = Value::of_int(status);
    return true;
}

bool within_areas(Execution& x, const AxisValues& target) {
    const auto out = area_fault(x, target, {}, kOnLimit);
    if (!out) return true;
    const MachineView& view = x.core.view();
    return fail(x, Alarm::WorkingAreaLeft, view.axes[out->axis].name,
                view.to_shown(out->axis, out->value), view.to_shown(out->axis, out->limit));
}
// Between its ends an arc comes farthest where it is parallel to an axis; a turned frame has those
// places elsewhere: then it is looked at all along.
bool arc_within_areas(Execution& x, const AxisValues& target, const ArcCall& call) {
    if (!within_areas(x, target)) return false;
    if (active(x, 28) != 1 && active(x, 60) <= 1) return true;
    const auto [p, q] = plane_places(x);
    constexpr double kTurn = 2.0 * std::numbers::pi;
    const AxisValues& from = x.core.path.programmed;
    const double radius = std::hypot(from[p] - call.centre_p, from[q] - call.centre_q);
    const double begin = std::atan2(from[q] - call.centre_q, from[p] - call.centre_p);
    const double sense = call.clockwise ? -1.0 : 1.0;
    const auto behind_begin = [&](double angle) {
        const double way = std::fmod((angle - begin) * sense, kTurn);
        return way < 0 ? way + kTurn : way;
    };
    double sweep = behind_begin(std::atan2(target[q] - call.centre_q, target[p] - call.centre_p));
    if (sweep < 1e-9 || call.turns > 0) sweep = kTurn;
    const int steps = x.core.path.framed ? 72 : 4;
    for (int k = 0; k < steps; ++k) {
        const double angle = kTurn * k / steps;
        if (behind_begin(angle) >= sweep) continue;
        AxisValues point = target;
        point[p] = call.centre_p + radius * std::cos(angle);
        point[q] = call.centre_q + radius * std::sin(angle);
        if (!within_areas(x, point)) return false;
    }
    return true;
}
}  // namespace polyturn::channels::sinumerik
