// The position on a path record at a length s along it. Pure functions, used by the channel that
// makes the records and by the kernel that drives them: both must mean the same curve.
//
// The slots of a record are its moving machine axes; positions are machine coordinates (mm with X
// as a radius, degrees). s runs from 0 to record.length. For lines and arcs s is true arc length
// over the linear axes (over the rotary ones when no linear axis moves); a curve's parameter u(s)
// is a polynomial that keeps |dp/ds| = 1 to better than 1e-4.
#pragma once
#include <array>
#include <cmath>

#include "polyturn/image_structs.hpp"

namespace polyturn {

using SlotVector = std::array<double, kMaxPathAxes>;

// Position of each slot at s (clamped to [0, length]). No allocation, no throw: called in the
// cyclic thread.
void position_at(const PathRecord& record, double s, SlotVector& position) noexcept;

struct PathDerivatives {
    SlotVector first, second, third;  // d/ds, d2/ds2, d3/ds3 of each slot
};
void derivatives_at(const PathRecord& record, double s, PathDerivatives& out) noexcept;

// Layout of PathRecord::shape. A curve: coefficient k of slot i is at kCoefficients + 6 i + k,
// those of u(s) from kParameter. An arc whose radius changes (kRadiusEnd neither 0 nor kRadius)
// turns by the fraction f(s) of its sweep, its radius goes from kRadius to kRadiusEnd in the same
// proportion, and so do the other slots; kParameter holds f(s). Without coefficients there
// (kParameter + 1 is 0) f = s / length.
namespace arc_shape {
inline constexpr std::size_t kCentreP = 0, kCentreQ = 1, kRadius = 2, kStartAngle = 3, kSweep = 4,
                             kRadiusEnd = 5;
}
namespace curve_shape {
inline constexpr std::size_t kCoefficients = 0, kParameter = 30;
}

}  // namespace polyturn
