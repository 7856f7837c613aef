// What the program knows of each spindle's position loop: at its start nothing, unless nobody else
// can have closed it.
#pragma once
#include <array>
#include <cstdint>

#include "channels/machine_view.hpp"

namespace polyturn::channels::fanuc {

enum class SpindleLoop : std::uint8_t { Unknown, Open, Closed };

struct TurnedSpindle {
    SpindleLoop loop = SpindleLoop::Unknown;
    double angle_deg = 0;
};

using TurnedSpindles = std::array<TurnedSpindle, kMaxSpindles + 1>;

}  // namespace polyturn::channels::fanuc
