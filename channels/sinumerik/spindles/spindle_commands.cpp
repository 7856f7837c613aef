// What a block says to spindles: S, M3 to M5, SPOS, M70, and which of them is the master.
#include "channels/sinumerik/spindles/spindle_commands.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <numbers>

#include "channels/sinumerik/act.hpp"
#include "channels/sinumerik/axes/axis_words.hpp"
#include "channels/sinumerik/coordination/functions_ms.hpp"
#include "channels/sinumerik/execution.hpp"
#include "channels/sinumerik/faults.hpp"
#include "channels/sinumerik/geometry/units.hpp"
#include "channels/sinumerik/grammar/groups.hpp"
#include "channels/sinumerik/grammar/without_effect.hpp"
#include "channels/sinumerik/spindles/cutting_speeds.hpp"
#include "channels/sinumerik/spindles/speed_limits.hpp"
#include "ipc/image/interrupt_inputs.hpp"
#include "ipc/params/registry.hpp"
#include "ipc/params/table.hpp"

namespace polyturn::channels::sinumerik {

// Naming an axis makes one of its spindle again that SPOS, M19 or a tap has put under position
// control (8.4): the spindle lets go of the drive, and the block is read again where it is known at
// which angle the axis stands.
bool spindles_to_axes(Execution& x) {
    if (!x.modal.closed_spindles || x.block.coded[3]) return true;  // TRANS C moves nothing
    const MachineView& view = x.core.view();
    AxisSet named = 0;
    for (const Word& w : x.block.words)
        if (names_moved_axis(w)) named |= 1u << w.axis;
    if (named && x.core.transformed() && x.core.path.transformation.rotary_place() >= 0)
        named |= 1u << x.core.path.transformation.rotary_place();
    bool switched = false;
    for (; named; named &= named - 1) {
        const std::uint16_t spindle =
            view.machine
                .axis(view.axes[static_cast<std::size_t>(__builtin_ctz(named))].machine_axis + 1u)
                .on_spindle;
        if (spindle == 0 || !spindle_closed(x, spindle)) continue;
        with_spindle(x, spindle, [&x] {
            spindle_to_axis(x);
            return true;
        });
        switched = true;
    }
    if (switched) x.pass.needs_barrier = true;
    return !switched;
}
// By the PLC's M5, as where a turning spindle stops.
void spindle_to_axis(Execution& x) {
    SpindleState& now = x.core.path.spindle;
    now.turn = SpindleTurn::Stop;
    x.modal.closed_spindles &= ~(1u << (now.spindle - 1));
    Spindle off;
    off.spindle = now.spindle;
    off.mode = SpindleModeCode::Off;
    off.turn_changed = off.silent = true;
    x.core.mark_emitted();
    x.core.sink().spindle(off, x.core.at);
    Aux stop;
    stop.value = 5;
    stop.text = "M5";
    stop.silent = stop.drained = true;
    x.core.sink().aux(stop, x.core.at);
}
// SPCON, SPCOF: position control of a spindle besides what needs it. Here positions, threads and
// couplings close the loop by themselves, so that SPCOF has nothing to open and SPCON no effect.
bool p_spindle_control(Execution& x, Call& c) {
    return p_spindle_speed(x, c) && p_without_effect(x, c);
}
bool p_spindle_speed(Execution& x, Call& c) {
    for (const Argument& argument : c.arguments) {
        const double n = argument.value.number;
        if (!argument.given || !(n >= 1 && n <= kMaxSpindles) ||
            !x.core.view().machine.spindle(static_cast<std::size_t>(n)).exists())
            return fail(x, Alarm::SpindleNumberIllegal, {}, n);
    }
    return true;
}
// SETMS(n): plain S, M3, G95, G96 and G33 mean spindle n from now on.
bool p_setms(Execution& x, Call& c) {
    const double n = c.has(0) ? c.number(0) : x.core.view().config().default_spindle;
    if (!(n >= 1 && n <= kMaxSpindles) ||
        !x.core.view().machine.spindle(static_cast<std::size_t>(n)).exists())
        return fail(x, Alarm::SpindleNumberIllegal, {}, n);
    const auto wanted = static_cast<std::uint16_t>(n);
    if (wanted == x.modal.master_spindle) return true;
    SpindleState& now = x.core.path.spindle;
    // G96 is the master spindle's: the old one goes on as fast as it is, the new one waits for S
    if (now.mode == SpindleModeCode::SurfaceSpeed) {
        if (!x.core.surface_speed(false)) return false;
        x.modal.asked_rpm[now.spindle] = now.rpm;
        if (!x.core.commit_spindle()) return false;
    }
    x.modal.spindles[now.spindle] = now;
    if (const auto kept = x.modal.spindles.find(wanted); kept != x.modal.spindles.end()) {
        now = kept->second;
        x.modal.spindles.erase(kept);
    } else {
        now = {};
        now.spindle = wanted;
    }
    x.modal.master_spindle = wanted;
    return true;
}
bool p_wait_spindle(Execution& x, Call& c) {
    std::uint32_t which = 0;
    for (const Argument& argument : c.arguments) {
        const double n = argument.value.number;
        if (!argument.given || !(n >= 1 && n <= kMaxSpindles) ||
            !x.core.view().machine.spindle(static_cast<std::size_t>(n)).exists())
            return fail(x, Alarm::SpindleNumberIllegal, {}, n);
        which |= 1u << (static_cast<unsigned>(n) - 1);
    }
    if (c.arguments.empty() && x.modal.master_spindle) which = 1u << (x.modal.master_spindle - 1u);
    x.core.arrive(0, which);
    return true;
}
bool with_spindle(Execution& x, std::uint16_t spindle, const std::function<bool()>& act) {
    SpindleState& now = x.core.path.spindle;
    if (spindle == 0 || spindle == now.spindle) return act();
    if (spindle > kMaxSpindles || !x.core.view().machine.spindle(spindle).exists())
        return fail(x, Alarm::SpindleNumberIllegal, {}, spindle);
    const SpindleState master = now;
    if (const auto kept = x.modal.spindles.find(spindle); kept != x.modal.spindles.end())
        now = kept->second;
    else {
        now = {};
        now.spindle = spindle;
    }
    const bool ok = act();
    x.modal.spindles[spindle] = now;
    now = master;
    return ok;
}
// S words and M3 M4 M5, output once for each spindle.
bool spindle_words(Execution& x) {
    const GCode* one_shot = x.block.coded[2];
    const GCode* frame = x.block.coded[3];
    std::vector<std::uint16_t> spindles{x.modal.master_spindle};
    const auto number_of_spindle = [&](const Word& word) {
        return word.index > 0 ? static_cast<std::uint16_t>(word.index) : x.modal.master_spindle;
    };
    const auto speaks = [&](const Word& word) {
        if (word.address->name == "S")
            return !(one_shot && takes(*one_shot, *word.address)) &&
                   !(frame && takes(*frame, *word.address));
        return word.address->name == "M" &&
               is_spindle_function(static_cast<std::int64_t>(word.number()));
    };
    for (const Word& word : x.block.words)
        if (speaks(word) &&
            std::find(spindles.begin(), spindles.end(), number_of_spindle(word)) == spindles.end())
            spindles.push_back(number_of_spindle(word));
    for (const std::uint16_t spindle : spindles) {
        const bool ok = with_spindle(x, spindle, [&] {
            std::int64_t told = 0;  // M3 M4 M5
            for (const Word& word : x.block.words) {
                if (!speaks(word) || number_of_spindle(word) != spindle) continue;
                x.blame.column = word.column;
                x.blame.length = word.length;
                if (word.address->name == "S") {
                    double value = word.number();
                    // SVC holds no more
                    if (spindle) x.modal.cutting_speeds &= ~(1u << (spindle - 1));
                    // G331 G332 count revolutions
                    const bool taps = active(x, 1) == 11 || active(x, 1) == 12;
                    // the master spindle has changed under G96
                    if (spindle == x.modal.master_spindle && surface_speed_active(x) && !taps)
                        if (!x.core.surface_speed(true) || !refresh_speed_limit(x)) return false;
                    // feet a minute
                    if (x.core.path.spindle.mode == SpindleModeCode::SurfaceSpeed &&
                        !metric_lengths(x))
                        value *= 0.3048;
                    // GWPSON: m/s, feet a second
                    if (spindle && (x.modal.wheel_speeds >> (spindle - 1) & 1u))
                        value *= (metric_lengths(x) ? 1.0 : 0.3048) * 60'000.0 /
                                 (2.0 * std::numbers::pi * x.modal.wheel_radius_mm[spindle]);
                    if (spindle && (x.modal.wheel_speeds >> (spindle - 1) & 1u) &&
                        x.modal.wheel_most_rpm[spindle] > 0)
                        value = std::fmin(value, x.modal.wheel_most_rpm[spindle]);
                    if (!(x.core.path.spindle.mode == SpindleModeCode::SurfaceSpeed
                              ? x.core.spindle_speed(value)
                              : ask_speed(x, value)))
                        return false;
                } else {
                    const auto m = static_cast<std::int64_t>(word.number());
                    if (told && told != m)
                        return fail_word(x, Alarm::CodesContradict, word,
                                         fmt::format("M{}, M{}", told, m));
                    told = m;
                    if (!x.core.spindle_turn(m == 3   ? SpindleTurn::Cw
                                             : m == 4 ? SpindleTurn::Ccw
                                                      : SpindleTurn::Stop))
                        return false;
                    x.modal.closed_spindles &= ~(1u << (x.core.path.spindle.spindle - 1));
                }
                x.blame.column = x.blame.length = 0;
            }
            if (!x.core.commit_spindle()) return false;
            // the PLC's M3 means the spindle that was commanded last
            for (const Word& word : x.block.words)
                if (word.address->name == "M" && speaks(word) && number_of_spindle(word) == spindle)
                    m_to_plc(x, word, static_cast<std::int64_t>(word.number()));
            return true;
        });
        if (!ok) return false;
    }
    return true;
}
double m19_position(const Execution& x, std::uint16_t spindle) {
    const MachineView& view = x.core.view();
    const unsigned s = spindle ? spindle : x.modal.master_spindle;
    return s ? params::get(view.table(), params::sd43240, s) : 0.0;
}
// A spindle that is not in position control yet gets there by the PLC's M19, at any position.
void close_spindle(Execution& x, bool told, bool beside) {
    SpindleState& now = x.core.path.spindle;
    now.turn = SpindleTurn::Stop;
    if (!told) {  // the program has named no angle
        Spindle silent;
        silent.spindle = now.spindle;
        silent.mode = SpindleModeCode::Position;
        silent.value = now.angle_deg;
        silent.mode_changed = silent.silent = true;
        x.core.mark_emitted();
        x.core.sink().spindle(silent, x.core.at);
    }
    Aux orient;
    orient.value = 19;
    orient.text = "M19";
    orient.silent = true;
    orient.beside = beside;
    x.core.mark_emitted();
    x.core.sink().aux(orient, x.core.at);
    x.modal.closed_spindles |= 1u << (now.spindle - 1);
}
// SPOS, SPOSA: a plain value and DC go the short way, IC counts from its position.
bool a_spindle_position(Execution& x, const Word& word) {
    unsigned count = 0;
    for (const Word& other : x.block.words)
        count += other.address->name == "SPOS" || other.address->name == "SPOSA";
    if (count > 3) return fail_word(x, Alarm::FunctionsTooMany, word, "SPOS");
    const bool beside = word.address->name == "SPOSA";  // over the end of the block
    x.core.position_outside_path(beside);
    const bool good =
        with_spindle(x, word.index > 0 ? static_cast<std::uint16_t>(word.index) : 0, [&] {
            if (x.core.path.spindle.spindle == 0)
                return fail_word(x, Alarm::SpindleMissing, word, "SPOS");
            const std::uint16_t spindle = x.core.path.spindle.spindle;
            x.modal.cutting_speeds &= ~(1u << (spindle - 1));
            const double angle = word.number();
            x.core.position_feed(spindle_feed_rpm(x, spindle));
            if (word.mode == Mode::IC) {
                if (std::fabs(angle) >= 100'000.0)
                    return fail_word(x, Alarm::ValueOutOfRange, word, "SPOS");
                if (spindle_closed(x, spindle)) return x.core.spindle_index(angle);
                if (!x.core.spindle_position(x.core.path.spindle.angle_deg + angle,
                                             SpindleApproach::Shortest))
                    return false;
            } else {
                if (angle < 0 || angle >= 360.0)
                    return fail_word(x, Alarm::ValueOutOfRange, word, "SPOS");
                const SpindleApproach how = word.mode == Mode::ACP   ? SpindleApproach::Positive
                                            : word.mode == Mode::ACN ? SpindleApproach::Negative
                                                                     : SpindleApproach::Shortest;
                if (!x.core.spindle_position(angle, how)) return false;
            }
            if (!spindle_closed(x, spindle)) close_spindle(x, true, beside);
            return true;
        });
    x.core.position_outside_path(false);
    x.core.position_feed(0.0);
    return good;
}
// FA of the block counts wherever it is in it; what holds from before is modal.
double spindle_feed_rpm(const Execution& x, std::uint16_t spindle) {
    double degrees = x.modal.spindle_feed[spindle];
    for (const Word& word : x.block.words)
        if (word.address->name == "FA" && word.axis < 0 &&
            (word.index > 0 ? word.index : x.modal.master_spindle) == spindle)
            degrees = word.number();
    return degrees / 360.0;
}
}  // namespace polyturn::channels::sinumerik
