#include "channels/fanuc/motion/modes.hpp"

#include "channels/fanuc/execution.hpp"
#include "channels/fanuc/grammar/word_values.hpp"
#include "channels/fanuc/macro/modal_values.hpp"
#include "channels/fanuc/program/faults.hpp"

namespace polyturn::channels::fanuc {

std::uint16_t units_code(const Execution& x, bool inch) {
    return static_cast<std::uint16_t>((x.settings.system == kC ? 700 : 200) + (inch ? 0 : 10));
}

bool g_nothing(Execution& x, const GCode& row) {
    if (row.tenths == 110) {
        x.modal.parameter_input = false;
        x.modal.life = {};
    }
    return true;
}

bool g_units(Execution& x, const GCode& row) {
    const bool inch = row.tenths == units_code(x, true);
    if (inch == x.modal.input.inch) return true;
    x.modal.input.inch = inch;
    x.modal.input.unit = inch ? 25.4 : 1.0;
    return true;
}

bool g_plane(Execution& x, const GCode& row) {
    const Plane before = x.core.path.plane;
    const Plane plane = row.tenths == 170 ? Plane::XY : row.tenths == 180 ? Plane::ZX : Plane::YZ;
    if (plane != before && x.core.compensating()) return x.core.fail(Alarm::CompPlaneChanged, 'G');
    x.core.path.plane = plane;
    if (before != x.core.path.plane) x.core.path.after_thread = false;
    return true;
}

bool g_distance(Execution& x, const GCode& row) {
    x.modal.input.absolute = row.tenths == 900;
    return true;
}

bool g_exact_stop(Execution& x, const GCode& row) {
    x.core.path.exact_stop_mode = row.tenths == 610 || row.tenths == 600;
    // #3004 outlasts G64
    x.core.path.override_locked = row.tenths == 630 || (x.modal.control.automatic & 2) != 0;
    const std::uint32_t before = control_bits(x);
    x.modal.in_force(GGroup::ExactStop) = &row;
    if (control_bits(x) != before) tell_control(x);
    return true;
}

bool g_exact_once(Execution& x, const GCode&) {
    x.core.force_exact_stop();
    return true;
}

// G10.9 X0: X words are radii from here on; X1: diameters. In nct an axis is switched by the
// program or by the PLC (N0106 MGD).
bool g_diameter(Execution& x, const GCode&) {
    if (x.words.axis_count == 0) return x.core.fail(Alarm::CoordinateAxisNone, 'G', "G10.9");
    for (unsigned k = 0; k < x.words.axis_count; ++k) {
        const Word& word = x.block.words[x.words.axes[k]];
        const int place = axis_of(x, word).place;
        if (x.settings.policy.motion.diameter_by_axis &&
            !params::bit(x.core.view().table(), params::n0106_axis_properties,
                         x.core.view().axes[static_cast<std::size_t>(place)].machine_axis + 1u,
                         5)) {
            blame(x, word);
            return x.core.fail(Alarm::AddressIllegal, 0,
                               std::string(text_of(x, word)) + " (N0106 MGD = 0)");
        }
        if (word.value != 0 && word.value != 1)
            return x.core.fail(Alarm::CycleValueIllegal, word.address, std::string(1, word.address),
                               word.value);
        x.core.view().axes[static_cast<std::size_t>(place)].diameter = word.value == 1;
    }
    return true;
}

// G5.1 Q: 0 off, 1 look-ahead, which is always on, 2 and 3 smoothing: runs of short lines become a
// curve within N3104 or N3106 instead of PT_PATH_TOL (channels/path/spline_run.hpp).
bool g_smoothing(Execution& x, const GCode&) {
    std::int64_t kind = 0;
    if (!x.block.has('Q')) return x.core.fail(Alarm::CycleWordMissing, 'G', "Q");
    if (!whole_number(x, 'Q', kind)) return false;
    if (kind > 3) return x.core.fail(Alarm::CycleValueIllegal, 'Q', "Q", static_cast<double>(kind));
    x.core.signal("SMOOTHING", static_cast<double>(kind));
    return true;
}

}  // namespace polyturn::channels::fanuc
