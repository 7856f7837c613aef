// Rows of ChannelStore::zeros that Core knows (segments.hpp says all of them).
#pragma once
#include <array>
#include <cstdint>

namespace polyturn::channels {

// kZeroNone: no settable zero offset is active, the external one still is.
inline constexpr std::int32_t kZeroNone = -1;
inline constexpr std::int32_t kZeroExternalRow = 0, kZeroG54Row = 1, kZeroShiftRow = 7,
                              kZeroG541Row = 10;

// Fixture offsets G54.2 P1 to P8: vectors in X, Y, Z, and the angles of the table at which they
// were measured.
inline constexpr std::array<std::int32_t, 8> kFixtureRows{313, 314, 315, 316, 317, 318, 319, 9};

}  // namespace polyturn::channels
