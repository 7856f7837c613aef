// What a block says to spindles: S, M3 to M5, SPOS, M70, and which of them is the master.
#pragma once
#include <cstdint>
#include <functional>

#include "channels/sinumerik/execution.hpp"

namespace polyturn::channels::sinumerik {

bool spindles_to_axes(Execution& x);
void spindle_to_axis(Execution& x);
bool p_spindle_control(Execution& x, Call& c);
bool p_spindle_speed(Execution& x, Call& c);
bool p_setms(Execution& x, Call& c);
bool p_wait_spindle(Execution& x, Call& c);
bool with_spindle(Execution& x, std::uint16_t spindle, const std::function<bool()>& act);
bool spindle_words(Execution& x);
double m19_position(const Execution& x, std::uint16_t spindle);
void close_spindle(Execution& x, bool told, bool beside = false);
bool a_spindle_position(Execution& x, const Word& word);
double spindle_feed_rpm(const Execution& x, std::uint16_t spindle);

inline bool spindle_closed(const Execution& x, std::uint16_t spindle) {
    return x.modal.closed_spindles >> (spindle - 1) & 1u;
}

}  // namespace polyturn::channels::sinumerik
