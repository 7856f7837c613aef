// Rows of ChannelStore::zeros that Core knows (segments.hpp says all of them).
#pragma once
#include <cstdint>

namespace polyturn::channels {

// kZeroNone: no settable zero offset is active, the external one still is.
inline constexpr std::int32_t kZeroNone = -1;
inline constexpr std::int32_t kZeroExternalRow = 0, kZeroG54Row = 1, kZeroShiftRow = 7, kZeroG541Row = 10;

}  // namespace polyturn::channels
