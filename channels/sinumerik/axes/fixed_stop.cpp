// Travel to a fixed stop: FXS, FXST, FXSW (sinumerik_part2 15.6).
#include "channels/sinumerik/axes/fixed_stop.hpp"

#include "channels/sinumerik/execution.hpp"
#include "channels/sinumerik/faults.hpp"
#include "channels/sinumerik/geometry/units.hpp"
#include "ipc/params/table.hpp"

namespace polyturn::channels::sinumerik {

// FXS[axis]=1: this block travels to a stop; 0: the axis lets go, and what stands in the
// block is driven from where it is then (the block is read again behind that barrier).
bool a_fixed_stop(Execution& x, const Word& word) {
    if (word.axis < 0 || word.axis >= kSpindleAxis)
        return fail_word(x, Alarm::AxisArgumentMissing, word, "FXS");
    const double value = word.number();
    if (value != 0 && value != 1) return fail_word(x, Alarm::ValueOutOfRange, word, "FXS", value);
    const AxisSet bit = 1u << word.axis;
    if (value == 1) {
        if (x.core.compensating()) return fail_word(x, Alarm::CompReference, word);
        x.stops.wanted |= bit;
        return true;
    }
    if (!(x.stops.on & bit)) return true;
    x.stops.on &= ~bit;
    x.core.limit_torque(static_cast<unsigned>(word.axis), 0.0, 0.0);
    x.pass.needs_barrier = true;
    return false;
}

bool a_stop_torque(Execution& x, const Word& word) {
    if (word.axis < 0 || word.axis >= kSpindleAxis)
        return fail_word(x, Alarm::AxisArgumentMissing, word, "FXST");
    if (!(word.number() > 0 && word.number() <= 100))
        return fail_word(x, Alarm::ValueOutOfRange, word, "FXST", word.number());
    const auto i = static_cast<std::size_t>(word.axis);
    x.modal.stop_torque[i] = word.number();
    if (x.stops.on >> i & 1u)
        x.core.limit_torque(static_cast<unsigned>(i), word.number() * 10.0, x.modal.stop_window[i]);
    return true;
}

bool a_stop_window(Execution& x, const Word& word) {
    if (word.axis < 0 || word.axis >= kSpindleAxis)
        return fail_word(x, Alarm::AxisArgumentMissing, word, "FXSW");
    if (!(word.number() > 0))
        return fail_word(x, Alarm::ValueOutOfRange, word, "FXSW", word.number());
    const auto i = static_cast<std::size_t>(word.axis);
    x.modal.stop_window[i] = word.number() * (x.core.view().axes[i].rotary ? 1.0 : unit(x));
    if (x.stops.on >> i & 1u) {
        const double torque =
            x.modal.stop_torque[i] > 0
                ? x.modal.stop_torque[i] * 10.0
                : static_cast<double>(params::get(x.core.view().table(), params::pt_stop_torque,
                                                  x.core.view().axes[i].machine_axis + 1u));
        x.core.limit_torque(static_cast<unsigned>(i), torque, x.modal.stop_window[i]);
    }
    return true;
}

// The torque is limited from the beginning of the block on; the move itself ends at the stop.
bool begin_stops(Execution& x) {
    const AxisSet wanted = x.stops.wanted;
    x.stops.wanted = 0;
    if (!wanted) return true;
    for (unsigned i = 0; i < x.core.view().axis_count; ++i) {
        if (!(wanted >> i & 1u)) continue;
        const std::uint64_t machine_axis = x.core.view().axes[i].machine_axis + 1u;
        const double torque =
            x.modal.stop_torque[i] > 0
                ? x.modal.stop_torque[i] * 10.0
                : static_cast<double>(params::get(x.core.view().table(), params::pt_stop_torque,
                                                  static_cast<unsigned>(machine_axis)));
        x.core.limit_torque(i, torque, x.modal.stop_window[i]);
    }
    x.stops.on |= wanted;
    for (const Word& word : x.block.words)
        if (word.address->name == "POSA" && word.axis >= 0 && (wanted >> word.axis & 1u))
            return fail_word(x, Alarm::NotBuilt, word, "POSA, FXS");
    x.core.meet_stop(wanted);
    return true;
}

}  // namespace polyturn::channels::sinumerik
