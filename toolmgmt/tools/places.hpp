// The places of the machine for tools, as N2905 to N2922 and PT_TURRET_MAGAZINE describe them, and
// what fits where.
//
//   chain, turret   a ring; places count from N2906..N2909. A turret with half stations
//                   (PT_TURRET_HALF): the second half of the numbers lies between the first, the
//                   first of them behind place 1
//   matrix          row by row, from the top left
//   spindle s       10 s where N2922 SPM says so, its change arm 10 s + 1 (SBY); pot 1
//
// Room is counted in half places: neighbours are 2 apart, a half station 1 from its neighbours. Two
// tools get in each other's way when what one needs to its right and the other to its left is more
// than that.
#pragma once

#include <string>

#include "ipc/diagnosis/diagnosis.hpp"
#include "toolmgmt/store_values.hpp"

namespace polyturn::toolmgmt {

void derive_places(const StoreValues& values, ToolPlaceTable& out);
const ToolPlace* find_place(const ToolPlaceTable& places, std::int32_t magazine, std::int32_t pot);
// "magazine 1 pot 3", "spindle S2"
std::string place_name(std::int32_t magazine, std::int32_t pot);

// May this tool stand there, everything else as it is? The tool's own place counts as empty.
Result<void> place_fits(const StoreValues& values, const ToolPlaceTable& places, std::int32_t tool,
                        const ToolPlace& place);
// The free place that fits nearest to `from` (a pot of the magazine; 0: from its first); nullptr:
// none.
const ToolPlace* nearest_free(const StoreValues& values, const ToolPlaceTable& places,
                              std::int32_t tool, std::int32_t magazine, std::int32_t from);
// Way along the magazine in places, signed where it is a ring: the shorter way, forwards when both
// are equal.
double travel_between(const ToolPlaceTable& places, const ToolPlace& from, const ToolPlace& to);

struct TurretOf {
    std::int32_t magazine = 0;  // of a channel; 0: it has none
    std::int32_t stations = 0;
    bool half = false;
};
TurretOf turret_of(const params::Table& table, unsigned channel);
// The spindle that takes tools in a channel without a turret; 0 none.
std::int32_t tool_spindle(const params::Table& table, unsigned channel);

}  // namespace polyturn::toolmgmt
