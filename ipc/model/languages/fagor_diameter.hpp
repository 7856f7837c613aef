// Whether a channel that speaks Fagor shows an axis as a diameter (fagor_8037t_part1.md 3.5):
// FG.DIAM says so, else the display format FG.DFORMAT, whose values from 4 on are diameters; where
// neither says anything, what the machine says otherwise. Channels and setups ask here.
#pragma once
#include "ipc/params/table.hpp"

namespace polyturn {

// `axis` from 1.
[[nodiscard]] inline bool fagor_shows_diameter(const params::Table& table, unsigned axis,
                                               bool otherwise) noexcept {
    if (const auto diameter = params::get(table, params::fg_diam, axis); diameter >= 0)
        return diameter != 0;
    const auto format = params::get(table, params::fg_dformat, axis);
    return format >= 0 ? format >= 4 : otherwise;
}

}  // namespace polyturn
