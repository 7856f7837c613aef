// Travel to a fixed stop: FXS, FXST, FXSW (sinumerik_part2 15.6).
#include <cmath>

#include "channels/sinumerik/interpreter.hpp"
#include "ipc/params/table.hpp"

namespace polyturn::channels::sinumerik {

// FXS[axis]=1: this block travels to a stop; 0: the axis lets go, and what stands in the
// block is driven from where it is then (the block is read again behind that barrier).
bool Interpreter::a_fixed_stop(const Word& word) {
    if (word.axis < 0 || word.axis >= kSpindleAxis)
        return fail_word(Alarm::AxisArgumentMissing, word, "FXS");
    const double value = word.number();
    if (value != 0 && value != 1) return fail_word(Alarm::ValueOutOfRange, word, "FXS", value);
    const AxisSet bit = 1u << word.axis;
    if (value == 1) {
        if (core_.compensating()) return fail_word(Alarm::CompReference, word);
        stops_wanted_ |= bit;
        return true;
    }
    if (!(stops_on_ & bit)) return true;
    stops_on_ &= ~bit;
    core_.limit_torque(static_cast<unsigned>(word.axis), 0.0, 0.0);
    needs_barrier_ = true;
    return false;
}

bool Interpreter::a_stop_torque(const Word& word) {
    if (word.axis < 0 || word.axis >= kSpindleAxis)
        return fail_word(Alarm::AxisArgumentMissing, word, "FXST");
    if (!(word.number() > 0 && word.number() <= 100))
        return fail_word(Alarm::ValueOutOfRange, word, "FXST", word.number());
    const auto i = static_cast<std::size_t>(word.axis);
    modal_.stop_torque[i] = word.number();
    if (stops_on_ >> i & 1u)
        core_.limit_torque(static_cast<unsigned>(i), word.number() * 10.0, modal_.stop_window[i]);
    return true;
}

bool Interpreter::a_stop_window(const Word& word) {
    if (word.axis < 0 || word.axis >= kSpindleAxis)
        return fail_word(Alarm::AxisArgumentMissing, word, "FXSW");
    if (!(word.number() > 0)) return fail_word(Alarm::ValueOutOfRange, word, "FXSW", word.number());
    const auto i = static_cast<std::size_t>(word.axis);
    modal_.stop_window[i] = word.number() * (core_.view().axes[i].rotary ? 1.0 : unit());
    if (stops_on_ >> i & 1u) {
        const double torque =
            modal_.stop_torque[i] > 0
                ? modal_.stop_torque[i] * 10.0
                : static_cast<double>(params::get(core_.view().table(), params::pt_stop_torque,
                                                  core_.view().axes[i].machine_axis + 1u));
        core_.limit_torque(static_cast<unsigned>(i), torque, modal_.stop_window[i]);
    }
    return true;
}

// The torque is limited from the beginning of the block on; the move itself ends at the stop.
bool Interpreter::begin_stops() {
    const AxisSet wanted = stops_wanted_;
    stops_wanted_ = 0;
    if (!wanted) return true;
    for (unsigned i = 0; i < core_.view().axis_count; ++i) {
        if (!(wanted >> i & 1u)) continue;
        const std::uint64_t machine_axis = core_.view().axes[i].machine_axis + 1u;
        const double torque =
            modal_.stop_torque[i] > 0
                ? modal_.stop_torque[i] * 10.0
                : static_cast<double>(params::get(core_.view().table(), params::pt_stop_torque,
                                                  static_cast<unsigned>(machine_axis)));
        core_.limit_torque(i, torque, modal_.stop_window[i]);
    }
    stops_on_ |= wanted;
    for (const Word& word : block_.words)
        if (word.address->name == "POSA" && word.axis >= 0 && (wanted >> word.axis & 1u))
            return fail_word(Alarm::NotBuilt, word, "POSA, FXS");
    core_.meet_stop(wanted);
    return true;
}

}  // namespace polyturn::channels::sinumerik
