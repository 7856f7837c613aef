// Balance cut of two channels: the exchange between channel and kernel.
#pragma once
#include <cstdint>

namespace polyturn {

// code of a Flag record, as in interrupt_inputs.hpp: register CN_BALANCE
inline constexpr std::int32_t kFlagBalance = 6;
// Codes of the rendezvous of both channels, beyond any M code: a run of cuts begins (also G68), it
// is over (G69).
inline constexpr std::int32_t kBalanceMeeting = 1'000'000'068, kBalanceEnd = 1'000'000'069;

}  // namespace polyturn
