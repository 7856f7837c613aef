// The position of an axis when it has been referenced, in its own unit: N0200 and FG.REFVALUE
// (fagor part 1, 4.1) together, unless the MEFI constant of its place among the axes of its channel
// (80 the first one to 85 the sixth) is not 0. Channels (G28, G74) and kernel (referencing) ask
// here.
#pragma once
#include "ipc/params/table.hpp"

namespace polyturn {
[[nodiscard]] double reference_position(const params::Table& table, unsigned axis) noexcept;
}
