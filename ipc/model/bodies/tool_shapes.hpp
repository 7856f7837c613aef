// Outlines of the tools in the turrets: read from the store's table, then plain numbers.
// Protection guards them, the HMI draws them.
#pragma once
#include <array>
#include <cstdint>

#include "ipc/image/segments.hpp"

namespace polyturn {

struct ToolShape {
    std::uint32_t channel = 0, station = 0;  // from 1
    // about the tool carrier's point, X as a radius, in the work area
    double x_low = 0, x_high = 0, z_low = 0, z_high = 0;
};
struct ToolShapes {
    std::array<ToolShape, 1024> shapes{};  // three of each tool in eight turrets of 40 stations
    std::size_t count = 0;
    std::size_t left_out = 0;  // that there was no room for
    bool has(std::uint32_t channel, std::uint32_t station) const noexcept {
        for (std::size_t i = 0; i < count; ++i)
            if (shapes[i].channel == channel && shapes[i].station == station) return true;
        return false;
    }
};

// False: the store is just being replaced. Which magazine is whose turret (PT_TURRET_MAGAZINE) the
// store's own table says: the one of the cyclic thread changes while this reads.
bool read_tool_shapes(const StoreSegment& store, ToolShapes& out);
// The same from copies.
void tool_shapes_of(const ToolTable& tools, const params::Table& table, ToolShapes& out);

}  // namespace polyturn
