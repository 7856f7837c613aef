// Whole turns and degrees in radians.
#pragma once
#include <numbers>

namespace polyturn::channels {

inline constexpr double kTurn = 2.0 * std::numbers::pi;
inline constexpr double kDegree = std::numbers::pi / 180.0;

}  // namespace polyturn::channels
