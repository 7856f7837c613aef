// Interrupt inputs of a channel beside those of InterruptBit, and flags that a program sets in path order.
#pragma once
#include <cstdint>

namespace polyturn {

// In the mask of an Interrupts record: bit kInterruptInput + n - 1 watches INT<n> (Fagor INT1 to INT4). The number of the
// input that came stands in the event's record above bit 0.
inline constexpr unsigned kInterruptInputs = 4;
inline constexpr unsigned kInterruptInput = 8;
inline constexpr std::uint32_t kInterruptInputMask = ((1u << kInterruptInputs) - 1u) << kInterruptInput;

// code of a Flag record: the channel's signal that takes its value.
inline constexpr std::int32_t kFlagTapping = 1;

}  // namespace polyturn
