// Outlines of the tools that stand in the turrets, as protection guards them: read from the store's table by a thread that may
// take its time, then handed to the cyclic thread as plain numbers.
#pragma once
#include <array>
#include <cstdint>

#include "ipc/image/segments.hpp"

namespace polyturn::kernel {

struct ToolShape {
    std::uint32_t channel = 0, station = 0;   // from 1
    double x_low = 0, x_high = 0, z_low = 0, z_high = 0;   // about the tool carrier's point, X as a radius, in the room
};
struct ToolShapes {
    std::array<ToolShape, 128> shapes{};
    std::size_t count = 0;
    bool has(std::uint32_t channel, std::uint32_t station) const noexcept {
        for (std::size_t i = 0; i < count; ++i)
            if (shapes[i].channel == channel && shapes[i].station == station) return true;
        return false;
    }
};

// False: the store is just being replaced.
bool read_tool_shapes(const StoreSegment& store, const params::Table& table, ToolShapes& out);

}  // namespace polyturn::kernel
