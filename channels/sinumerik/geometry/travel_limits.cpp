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
#include <algorithm>
#include <cmath>

#include "channels/sinumerik/interpreter.hpp"

namespace polyturn::channels::sinumerik {
namespace {

constexpr double kTouchesLimit = 1e-6;  // mm: the start may stand on a limit
constexpr unsigned kAxisLimits = 1, kWorkingArea = 2;

}  // namespace

// Axis, side and kind of a limit that the point violates, as the status has them; 0: none.
int Interpreter::violated_limit(const AxisValues& point, const AxisValues& distance, unsigned kinds,
                                double slack) {
    const MachineView& view = core_.view();
    if (kinds & kAxisLimits) {
        const AxisValues framed = core_.framed(point);
        for (unsigned i = 0; i < view.axis_count; ++i) {
            const ChannelAxis& axis = view.axes[i];
            const double machine = framed[i] + core_.path.turns_deg[i] + core_.path.zero[i] +
                                   core_.path.shift[i] + core_.path.wanted[i];
            if (!axis.limited) continue;
            if (machine + distance[i] > axis.limit_max + slack)
                return static_cast<int>(i + 1) * 1000 + 100 + 1;
            if (machine - distance[i] < axis.limit_min - slack)
                return static_cast<int>(i + 1) * 1000 + 200 + 1;
        }
    }
    if (!(kinds & kWorkingArea)) return 0;
    const auto out = area_fault(point, distance, slack);
    return out ? static_cast<int>(out->axis + 1) * 1000 + (out->upper ? 100 : 200) + 2 : 0;
}

bool Interpreter::f_calcposi(Call& c) {
    static constexpr PlaneRole kRoles[] = {PlaneRole::BasicX, PlaneRole::BasicY, PlaneRole::BasicZ};
    for (std::size_t k = 0; k < 4; ++k) {
        const Argument& argument = c.arguments[k];
        if (!argument.given || argument.reference.variable->cells.size() < 3 ||
            !argument.reference.cell().is_number())
            return fail(Alarm::FunctionArgument, "CALCPOSI", static_cast<double>(k + 1));
    }
    if (core_.transformed()) return fail(Alarm::TransformCode, "CALCPOSI");
    const auto numbers = [&](std::size_t k, std::size_t g) {
        return c.arguments[k].reference.variable->cells[g].number;
    };
    const double length = c.number(4) != 0 ? (settings_.metric_base ? 1.0 : 25.4) : unit();
    const unsigned kinds = c.has(5) ? static_cast<unsigned>(std::clamp(c.number(5), 0.0, 255.0))
                                    : kAxisLimits | kWorkingArea;
    AxisValues from = core_.path.programmed, way{}, distance{};
    double status = 0.0;
    for (std::size_t g = 0; g < 3; ++g) {
        if (numbers(2, g) < 0) status = -1;
        const int place = core_.view().axis_by_role(kRoles[g]);
        if (place < 0) continue;
        const auto i = static_cast<unsigned>(place);
        from[i] = numbers(0, g) * length * (counts_diameter(i, false) ? 0.5 : 1.0);
        way[i] = numbers(1, g) * length * (counts_diameter(i, true) ? 0.5 : 1.0);
        distance[i] = numbers(2, g) * length;
    }
    const auto violated = [&](double t, double slack) {
        AxisValues point = from;
        for (std::size_t i = 0; i < point.size(); ++i) point[i] += t * way[i];
        return violated_limit(point, distance, kinds, slack);
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
        store({result, g, false}, Value::of_real(numbers(1, g) * t + 0.0));
    c.result = Value::of_int(status);
    return true;
}

}  // namespace polyturn::channels::sinumerik
