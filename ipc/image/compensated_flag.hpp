// A bit of PathRecord::flags beside those of RecordFlag: the move is driven with nose-radius
// compensation. Channel and kernel say it to each other for the smallest look-ahead (N1301 MBM).
#pragma once
#include <cstdint>

namespace polyturn {
inline constexpr std::uint32_t kCompensated = 1u << 22;
}  // namespace polyturn
