// Which axis each length of a cutting edge acts along (sinumerik_part1 6.5), and how the parameters
// of an edge are called: $TC_DPx.
#pragma once
#include <array>

#include "ipc/params/registry.hpp"
#include "ipc/params/table.hpp"
#include "polyturn/parameter_handles.hpp"

namespace polyturn {

inline constexpr std::int32_t kMostEdgesOfTool = 12;  // D1 to D12 (6.6)

// Numbers of $TC_DPx. Lengths are those of the tool itself: along X true, never a diameter.
inline constexpr int kDpType = 1, kDpTip = 2, kDpLength = 3, kDpRadius = 6, kDpWear = 12,
                     kDpWearRadius = 15, kDpBase = 21, kDpBaseRadius = 24;
constexpr bool is_edge_wear(int dp) { return dp >= kDpWear && dp < kDpBase; }

// L1 L2 L3 of a tool type in a plane (0 G17, 1 G18, 2 G19) as geometry axes: 0 X, 1 Y, 2 Z, -1
// none.
constexpr std::array<int, 3> axes_of_edge(int type, unsigned plane) {
    // Rows: G17 G18 G19.
    constexpr int kMill[3][3] = {{2, 1, 0}, {1, 0, 2}, {0, 2, 1}};
    constexpr int kDrill[3][3] = {{2, -1, -1}, {1, -1, -1}, {0, -1, -1}};
    constexpr int kTurn[3][3] = {{1, 0, 2}, {0, 2, 1}, {2, 1, 0}};
    constexpr int kSlot[3][3] = {{0, 1, 2}, {1, 0, 2}, {2, 1, 0}};
    // SD42950 = 1 and 2 mean milling and turning tools
    const int family = type == 1 ? 1 : type == 2 ? 5 : type / 100;
    const auto& row = (family == 4 || family == 5 ? kTurn
                       : family == 2              ? kDrill
                       : family == 7              ? kSlot
                                                  : kMill)[plane < 3 ? plane : 1];
    return {row[0], row[1], row[2]};
}

// The same for a channel: SD42950 says another type, SD42940 another plane.
inline std::array<int, 3> axes_of_edge(const params::Table& table, unsigned channel, int type,
                                       unsigned plane) {
    const auto fixed_type = static_cast<int>(params::get(table, params::sd42950, channel)),
               fixed_plane = static_cast<int>(params::get(table, params::sd42940, channel));
    return axes_of_edge(
        fixed_type ? fixed_type : type,
        fixed_plane >= 17 && fixed_plane <= 19 ? static_cast<unsigned>(fixed_plane - 17) : plane);
}

// Which length acts along a geometry axis; -1: none does.
constexpr int length_along(const std::array<int, 3>& axes, int geometry) {
    for (int i = 0; i < 3; ++i)
        if (axes[static_cast<std::size_t>(i)] == geometry) return i;
    return -1;
}

}  // namespace polyturn
