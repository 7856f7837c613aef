// Why a channel is stopped, as the log of stops names it: written by the supervisor, kept by the
// store, shown by the screens.
#pragma once
#include <array>
#include <string_view>

namespace polyturn {

inline constexpr std::array<std::string_view, 11> kStopCauses{
    "alarm",      // of the channel or of the whole machine
    "emergency",  // emergency stop
    "off",        // machine off
    "dead",       // the channel's process is gone
    "hold",       // feed hold
    "wait",       // for another channel
    "program",    // M0, M1, first part
    "single",     // single block
    "operator",   // restart, retrace: somebody works at it by hand
    "reset",      // the program was ended before its time
    "ended",      // the program has come to its end: the next start is awaited
};

}  // namespace polyturn
