#include "channels/fagor/tools/spindle.hpp"

#include <fmt/format.h>

#include <cmath>

#include "channels/fagor/execution.hpp"
#include "channels/fagor/flow/calls.hpp"
#include "channels/fagor/tools/m_functions.hpp"

namespace polyturn::channels::fagor {
namespace {

// Highest speed of the gear that the block comes to; 0: not limited by the gear.
double gear_limit(const Execution& x) {
    int gear = x.modal.gear;
    for (unsigned k = 0; k < x.words.m_count; ++k)
        if (x.words.m[k]->value >= 41 && x.words.m[k]->value <= 44)
            gear = static_cast<int>(x.words.m[k]->value) - 40;
    return gear ? x.settings.gear_max[static_cast<std::size_t>(gear - 1)] : 0.0;
}

// AUTOGEAR: the gear whose speeds contain this one, reported to the PLC by its M function.
bool spindle_gear(Execution& x, double rpm) {
    int gear = 0, fastest = 0;
    for (int n = 4; n >= 1; --n) {
        const double most = x.settings.gear_max[static_cast<std::size_t>(n - 1)];
        if (most >= rpm) gear = n;
        if (most > 0 &&
            (!fastest || most > x.settings.gear_max[static_cast<std::size_t>(fastest - 1)]))
            fastest = n;
    }
    if (gear == 0) gear = fastest;  // no gear is fast enough: the fastest one, at its limit
    if (gear == 0 || gear == x.modal.gear) return true;
    const MEntry* entry = m_entry(x, 40 + gear);
    if (entry && entry->subroutine) {
        if (x.line.block.count > 1) return x.fail(Alarm::FagorGearAlone, 'S');
        x.modal.gear = gear;
        CallFrame frame;
        frame.m_code = entry->code;
        frame.m_itself = !entry->only_subroutine;
        return call_subroutine(x, entry->subroutine, frame, nullptr);
    }
    x.modal.gear = gear;
    x.core.aux('M', 40 + gear, fmt::format("M{}", 40 + gear), false);
    return true;
}

}  // namespace

bool g_spindle_mode(Execution& x, const GCode& row) {
    if (row.number == 97) return x.core.surface_speed(false) && limit_surface_speed(x);
    bool gear = x.settings.gear_automatic || x.modal.gear != 0;
    for (unsigned k = 0; k < x.words.m_count; ++k)
        if (x.words.m[k]->value >= 41 && x.words.m[k]->value <= 44) gear = true;
    if (!gear) return x.fail(Alarm::FagorGear, 'G', "M41 to M44");
    if (!x.words.has('S') && x.core.path.spindle.surface_m_min <= 0)
        return x.fail(Alarm::FagorGear, 'G', "S");
    return x.core.surface_speed(true) && limit_surface_speed(x);
}

// S: a speed, a cutting speed with G96, an angle with M19.
bool spindle_word(Execution& x) {
    if (!x.words.has('S')) return true;
    const Word& s = *x.words.word('S');
    for (unsigned k = 0; k < x.words.m_count; ++k)
        if (x.words.m[k]->value == 19) return true;  // its angle
    if (s.value < 0) return x.fail_word(s, Alarm::NegativeSign, "S");
    if (x.modal.motion >= 33 && x.words.has_axes())
        return x.fail_word(s, Alarm::FagorIncompatible, "S in a thread");
    double value = s.value;
    if (x.core.path.spindle.mode == SpindleModeCode::SurfaceSpeed) {
        if (x.modal.inch) value *= 0.3048;
    } else {
        // G92 S: none above it is taken
        if (x.modal.speed_limit > 0) value = std::fmin(value, x.modal.speed_limit);
        if (x.settings.gear_automatic && !spindle_gear(x, value)) return false;
        if (const double most = gear_limit(x); most > 0) value = std::fmin(value, most);
    }
    return x.core.spindle_speed(value);
}

// Constant surface speed keeps to G92 S and to the gear (5.3.1); otherwise S words are what they
// clamp.
// `said`: by G92 S itself, which is told even where nothing changes here: the spindle may have been
// commanded without a limit since.
bool limit_surface_speed(Execution& x, bool said) {
    const bool surface = x.core.path.spindle.mode == SpindleModeCode::SurfaceSpeed;
    const double gear = surface ? gear_limit(x) : 0.0;
    const double limit = gear > 0 && (x.modal.speed_limit <= 0 || gear < x.modal.speed_limit)
                             ? gear
                             : x.modal.speed_limit;
    return (!said && limit == x.core.path.spindle.limit_rpm) || x.core.spindle_limit(limit);
}

// A thread or a tap turns at 100 %, whatever PRGSSO says (5.3; part 2, 9.6.3, 9.9.6); the next
// other move has its share again.
void follow_spindle(Execution& x, bool thread) {
    const double share = x.modal.spindle_override_program;
    x.out.spindles.set(thread || share <= 0 ? 1.0 : share / 100.0, x.core.at);
}

}  // namespace polyturn::channels::fagor
