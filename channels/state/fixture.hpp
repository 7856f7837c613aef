// Fixture offset that follows the rotary table (G54.2): from the table's axis, which the work zero
// names, to the workpiece as it is clamped, measured with the table at a reference angle. The table
// takes the vector with it.
//
//   V(a, b) = T1(a) T2(b) T2(b0)' T1(a0)' F        T1 the table axis that carries the other, T2 the
//                                                  one carried; F, a0, b0 the row
//
// V lies in PathState::shift. A move that turns the table ends at the V of its end; in between both
// are driven on straight lines.
#pragma once
#include <array>
#include <cstdint>

#include "ipc/kinematics/five_axis.hpp"

namespace polyturn::channels {

struct FixtureOffset {
    bool on = false;
    // N3212 #7: the linear axes go with the next block that names one of them
    bool rotary_alone = false;
    // directions and indices of the table's axes (five_axis); heads in it do not count
    Kinematics table{};
    std::array<double, 3> measured{};  // F, mm
    std::array<double, 2> at_deg{};    // a0, b0
    std::array<double, 3> now{};       // V, as it is in the shift
};

}  // namespace polyturn::channels
