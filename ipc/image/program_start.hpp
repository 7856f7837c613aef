// Programs of other channels that a program chooses and starts (sinumerik INIT, START): codes of
// Flag records, as in interrupt_inputs.hpp. A path is longer than a record's text, so it comes in
// pieces.
#pragma once
#include <cstdint>

namespace polyturn {

// mask: the channel (from 1); text: a piece of the file's path, value: where it begins there;
// plane[0] 1: it was the last piece, the program is selected
inline constexpr std::int32_t kFlagProgram = 7;
// mask: set of channels (bit 0 is channel 1) whose selected programs begin
inline constexpr std::int32_t kFlagStart = 8;

}  // namespace polyturn
