// Positions of the machine and limits of the working area: G4, G74, G75, G25, G26, WALCS
// (sinumerik_part2 15).
#include "channels/sinumerik/geometry/geo_positions.hpp"

#include <cmath>

#include "channels/sinumerik/axes/axis_words.hpp"
#include "channels/sinumerik/execution.hpp"
#include "channels/sinumerik/faults.hpp"
#include "channels/sinumerik/flow/run.hpp"
#include "channels/sinumerik/grammar/words.hpp"
#include "channels/sinumerik/spindles/speed_limits.hpp"
#include "channels/sinumerik/spindles/spindle_commands.hpp"
#include "channels/sinumerik/variables/changes.hpp"
#include "ipc/params/registry.hpp"
#include "ipc/params/table.hpp"

namespace polyturn::channels::sinumerik {
namespace {

// Setting data of an axis, as a program writes them.
void keep_axis_data(Execution& x, std::string_view name, std::size_t place, double value) {
    const params::Row& row = *params::find(name);
    const std::size_t slot = row.first_slot + x.core.view().axes[place].machine_axis * row.array;
    params::Table& table = *x.core.view().parameters;
    undo(x, [&x, slot, before = table.numbers[slot]] {
        x.core.view().parameters->numbers[slot] = before;
    });
    table.numbers[slot] = value;
}

}  // namespace

// G4 F seconds, G4 S revolutions of the master spindle, G4 S2= of another one.
bool geo_dwell(Execution& x, const GCode&) {
    const Word* seconds = word(x, "F");
    const Word* turns = word(x, "S");
    if (seconds && turns) return fail_word(x, Alarm::CodesContradict, *turns, "F, S");
    if (seconds) {  // MD10280: whole interpolation cycles
        const double cycle = x.settings.dwell_cycle_s, value = seconds->number();
        return x.core.dwell(cycle > 0 ? std::ceil(value / cycle - 1e-9) * cycle : value, false);
    }
    if (!turns) return fail(x, Alarm::ReturnValueMissing, "F, S");
    return with_spindle(x, turns->index > 0 ? static_cast<std::uint16_t>(turns->index) : 0,
                        [&] { return x.core.dwell(turns->number(), true); });
}

bool geo_reference(Execution& x, const GCode&) {
    const AxisSet which = axis_words(x);
    if (!which) return true;
    if (x.core.compensating()) return fail(x, Alarm::CompReference);
    // sinumerik_part2 15.4, 15.5
    if (x.core.transformed()) return fail(x, Alarm::TransformCode, "G74, G75");
    AxisValues machine = x.core.path.machine;
    for (unsigned i = 0; i < x.core.view().axis_count; ++i)
        if (which >> i & 1u) machine[i] = x.core.view().axes[i].reference_mm[0];
    if (!x.core.reference(machine, which, MoveKind::Reference)) return false;
    stop_reading(x);
    return true;
}

// FP=1..4: MD30600, machine coordinates; frames, zeros and tool count for nothing in this block.
bool geo_fixed_point(Execution& x, const GCode&) {
    const AxisSet which = axis_words(x);
    const Word* fp = word(x, "FP");
    int n = 1;
    if (fp && fp->number() != 0) {
        if (fp->number() != std::floor(fp->number()) || fp->number() < 1)
            return fail_word(x, Alarm::ValueOutOfRange, *fp, "FP", fp->number());
        n = static_cast<int>(std::fmin(fp->number(), 100.0));
    }
    if (!which) return true;
    if (x.core.compensating()) return fail(x, Alarm::CompReference);
    // sinumerik_part2 15.4, 15.5
    if (x.core.transformed()) return fail(x, Alarm::TransformCode, "G74, G75");
    AxisValues machine = x.core.path.machine;
    for (unsigned i = 0; i < x.core.view().axis_count; ++i) {
        if (!(which >> i & 1u)) continue;
        const unsigned number = x.core.view().axes[i].machine_axis + 1u;
        if (n > static_cast<int>(params::get(x.core.view().table(), params::md30610, number)))
            return fail(x, Alarm::FixedPointMissing, x.core.view().axes[i].name, n);
        machine[i] = params::get(x.core.view().table(), params::md30600, number,
                                 static_cast<unsigned>(n - 1));
    }
    x.core.force_exact_stop();
    if (!x.core.machine_rapid(machine, which)) return false;
    stop_reading(x);
    return true;
}

// G25 lower, G26 upper limits in the basic system; S: limits of spindle speeds.
bool geo_limits(Execution& x, const GCode& code) {
    const bool high = code.name == "G26";
    GeoModal& geo = x.modal.geo;
    unsigned count = 0;
    for (const Word& w : x.block.words) {
        if (w.address->name == "S") {
            if (++count > 3) return fail_word(x, Alarm::FunctionsTooMany, w, "S");
            if (w.number() < 0.1 || w.number() > 9'999'999.9)
                return fail_word(x, Alarm::ValueOutOfRange, w, "S", w.number());
            if (!limit_speed(x, w, high)) return false;
        }
        if (w.axis < 0 || w.address->name != "axis") continue;
        const auto i = static_cast<std::size_t>(w.axis);
        const double limit = length_mm(x, w, w.axis, false);
        (high ? geo.high : geo.low)[i] = limit;
        keep_axis_data(x, high ? "SD43420" : "SD43430", i, limit);
        (high ? geo.area_high : geo.area_low) |= 1u << i;
    }
    x.run.state_changed = true;
    return true;
}

}  // namespace polyturn::channels::sinumerik
