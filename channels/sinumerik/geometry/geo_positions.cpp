// Positions of the machine and limits of the working area: G4, G74, G75, G25, G26, WALCS
// (sinumerik_part2 15).
#include <cmath>
#include <numbers>

#include "channels/sinumerik/interpreter.hpp"
#include "ipc/params/registry.hpp"
#include "ipc/params/table.hpp"

namespace polyturn::channels::sinumerik {
namespace {

constexpr double kOnLimit = 1e-6;  // mm: exactly on the limit is inside

}  // namespace

// G4 F seconds, G4 S revolutions of the master spindle, G4 S2= of another one.
bool Interpreter::geo_dwell(const GCode&) {
    const Word* seconds = word("F");
    const Word* turns = word("S");
    if (seconds && turns) return fail_word(Alarm::CodesContradict, *turns, "F, S");
    if (seconds) {  // MD10280: whole interpolation cycles
        const double cycle = settings_.dwell_cycle_s, value = seconds->number();
        return core_.dwell(cycle > 0 ? std::ceil(value / cycle - 1e-9) * cycle : value, false);
    }
    if (!turns) return fail(Alarm::ReturnValueMissing, "F, S");
    return with_spindle(turns->index > 0 ? static_cast<std::uint16_t>(turns->index) : 0,
                        [&] { return core_.dwell(turns->number(), true); });
}

bool Interpreter::geo_reference(const GCode&) {
    const AxisSet which = axis_words();
    if (!which) return true;
    if (core_.compensating()) return fail(Alarm::CompReference);
    // sinumerik_part2 15.4, 15.5
    if (core_.transformed()) return fail(Alarm::TransformCode, "G74, G75");
    AxisValues machine = core_.path.machine;
    for (unsigned i = 0; i < core_.view().axis_count; ++i)
        if (which >> i & 1u) machine[i] = core_.view().axes[i].reference_mm[0];
    if (!core_.reference(machine, which, MoveKind::Reference)) return false;
    stop_reading();
    return true;
}

// FP=1..4: MD30600, machine coordinates; frames, zeros and tool count for nothing in this block.
bool Interpreter::geo_fixed_point(const GCode&) {
    const AxisSet which = axis_words();
    const Word* fp = word("FP");
    int n = 1;
    if (fp && fp->number() != 0) {
        if (fp->number() != std::floor(fp->number()) || fp->number() < 1)
            return fail_word(Alarm::ValueOutOfRange, *fp, "FP", fp->number());
        n = static_cast<int>(std::fmin(fp->number(), 100.0));
    }
    if (!which) return true;
    if (core_.compensating()) return fail(Alarm::CompReference);
    // sinumerik_part2 15.4, 15.5
    if (core_.transformed()) return fail(Alarm::TransformCode, "G74, G75");
    AxisValues machine = core_.path.machine;
    for (unsigned i = 0; i < core_.view().axis_count; ++i) {
        if (!(which >> i & 1u)) continue;
        const unsigned number = core_.view().axes[i].machine_axis + 1u;
        if (n > static_cast<int>(params::get(core_.view().table(), params::md30610, number)))
            return fail(Alarm::FixedPointMissing, core_.view().axes[i].name, n);
        machine[i] = params::get(core_.view().table(), params::md30600, number,
                                 static_cast<unsigned>(n - 1));
    }
    core_.force_exact_stop();
    if (!core_.machine_rapid(machine, which)) return false;
    stop_reading();
    return true;
}

// G25 lower, G26 upper limits in the basic system; S: limits of spindle speeds.
bool Interpreter::geo_limits(const GCode& code) {
    const bool high = code.name == "G26";
    GeoModal& geo = modal_.geo;
    unsigned count = 0;
    for (const Word& w : block_.words) {
        if (w.address->name == "S") {
            if (++count > 3) return fail_word(Alarm::FunctionsTooMany, w, "S");
            if (w.number() < 0.1 || w.number() > 9'999'999.9)
                return fail_word(Alarm::ValueOutOfRange, w, "S", w.number());
            if (!limit_speed(w, high)) return false;
        }
        if (w.axis < 0 || w.address->name != "axis") continue;
        const auto i = static_cast<std::size_t>(w.axis);
        const double limit = length_mm(w, w.axis, false);
        (high ? geo.high : geo.low)[i] = limit;
        keep_axis_data(high ? "SD43420" : "SD43430", i, limit);
        (high ? geo.area_high : geo.area_low) |= 1u << i;
    }
    state_changed_ = true;
    return true;
}

// Setting data of an axis, as a program writes them.
void Interpreter::keep_axis_data(std::string_view name, std::size_t place, double value) {
    const params::Row& row = *params::find(name);
    const std::size_t slot = row.first_slot + core_.view().axes[place].machine_axis * row.array;
    params::Table& table = *core_.view().parameters;
    undo([this, slot, before = table.numbers[slot]] {
        core_.view().parameters->numbers[slot] = before;
    });
    table.numbers[slot] = value;
}

// A limit that acts and that the point violates: WALIMON those of G25, G26 in the basic system,
// WALCS its group's. `distance` must be left to it on each axis.
std::optional<Interpreter::AreaFault> Interpreter::area_fault(const AxisValues& target,
                                                              const AxisValues& distance,
                                                              double slack) {
    const GeoModal& geo = modal_.geo;
    const bool basic = active(28) == 1, group = active(60) > 1;
    if (!basic && !group) return std::nullopt;
    const MachineView& view = core_.view();
    const AxisValues basic_point = core_.framed(target), settable = programmable(target);
    for (unsigned i = 0; i < view.axis_count; ++i) {
        const PlaneRole role = view.axes[i].role;
        const bool round =
            settings_.area_with_radius &&
            (role == PlaneRole::BasicX || role == PlaneRole::BasicY || role == PlaneRole::BasicZ);
        // MD21020: what is looked at is the same in both areas (15.3.2)
        const double reach = (round ? std::fabs(core_.path.tool.nose_radius) : 0.0) + distance[i];
        if (basic) {
            const double value = basic_point[i] + core_.path.zero[i];
            const bool plus = settings_.area_plus[view.axes[i].machine_axis],
                       minus = settings_.area_minus[view.axes[i].machine_axis];
            const double high = geo.area_high >> i & 1u
                                    ? geo.high[i]
                                    : settings_.area_high[view.axes[i].machine_axis];
            const double low =
                geo.area_low >> i & 1u ? geo.low[i] : settings_.area_low[view.axes[i].machine_axis];
            if (plus && value + reach > high + slack)
                return AreaFault{i, value + reach, high, true};
            if (minus && value - reach < low - slack)
                return AreaFault{i, value - reach, low, false};
        }
        if (!group) continue;
        const AreaGroup& area = geo.areas[active(60) - 2];
        const double value = area.workpiece ? target[i] : settable[i];
        if (area.plus >> i & 1u && value + reach > area.high[i] + slack)
            return AreaFault{i, value + reach, area.high[i], true};
        if (area.minus >> i & 1u && value - reach < area.low[i] - slack)
            return AreaFault{i, value - reach, area.low[i], false};
    }
    return std::nullopt;
}

bool Interpreter::within_areas(const AxisValues& target) {
    const auto out = area_fault(target, {}, kOnLimit);
    if (!out) return true;
    const MachineView& view = core_.view();
    return fail(Alarm::WorkingAreaLeft, view.axes[out->axis].name,
                view.to_shown(out->axis, out->value), view.to_shown(out->axis, out->limit));
}

// Between its ends an arc comes farthest where it is parallel to an axis; a turned frame has those
// places elsewhere: then it is looked at all along.
bool Interpreter::arc_within_areas(const AxisValues& target, const ArcCall& call) {
    if (!within_areas(target)) return false;
    if (active(28) != 1 && active(60) <= 1) return true;
    const auto [p, q] = plane_places();
    constexpr double kTurn = 2.0 * std::numbers::pi;
    const AxisValues& from = core_.path.programmed;
    const double radius = std::hypot(from[p] - call.centre_p, from[q] - call.centre_q);
    const double begin = std::atan2(from[q] - call.centre_q, from[p] - call.centre_p);
    const double sense = call.clockwise ? -1.0 : 1.0;
    const auto behind_begin = [&](double angle) {
        const double way = std::fmod((angle - begin) * sense, kTurn);
        return way < 0 ? way + kTurn : way;
    };
    double sweep = behind_begin(std::atan2(target[q] - call.centre_q, target[p] - call.centre_p));
    if (sweep < 1e-9 || call.turns > 0) sweep = kTurn;
    const int steps = core_.path.framed ? 72 : 4;
    for (int k = 0; k < steps; ++k) {
        const double angle = kTurn * k / steps;
        if (behind_begin(angle) >= sweep) continue;
        AxisValues point = target;
        point[p] = call.centre_p + radius * std::cos(angle);
        point[q] = call.centre_q + radius * std::sin(angle);
        if (!within_areas(point)) return false;
    }
    return true;
}

}  // namespace polyturn::channels::sinumerik
