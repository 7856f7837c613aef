// Which tool answers a T call, and where it stands (nct part 2, 30.4 and 30.5; sinumerik part 1,
// 5.2).
//
// Candidates are the tools of the called number, name or group that stand in a magazine the channel
// reaches: its own turret; magazines that N2901 NM1..NM4 name unless they are another channel's
// turret; its tool spindle and change arm. Among those that may be used the choice is
// PT_TOOL_SEARCH:
//   0  N2901 TCU: the least life left, or the least value in the custom column N2904; then the
//      lowest data number
//   1  the one with the state active; otherwise the next higher duplo number after it; then the
//      lowest
//   2  the lowest duplo number
//   3  the first that is active
//   4  the nearest in the magazine
#pragma once

#include "toolmgmt/store_values.hpp"
#include "toolmgmt/tools/places.hpp"

namespace polyturn::toolmgmt {

struct ToolQuestion {
    unsigned channel = 1;
    ToolCallBy by = ToolCallBy::Type;
    double value = 0.0;
    std::string_view name;
};

bool managed(const params::Table& table);  // N2900 TMU
bool usable(const ToolRow& row);
// magazine and tool unit
bool reaches(const params::Table& table, unsigned channel, const ToolRow& row);
// What is left of its life; infinite when it is not watched.
double life_left(const ToolRow& row);
// N2900 TLN = 1 (nct part 2, 30.3): the sum of life less the sum of the counters over all sisters
// of a tool, also those that are locked, broken or past their end; infinite when one of them is not
// watched.
double group_left(const StoreValues& values, const ToolRow& row);
// of one type number, or without one of one name
bool sisters(const ToolRow& a, const ToolRow& b);

// The answer, without its id. alarm is -1 or what prevents it.
ToolAnswer find_tool(const StoreValues& values, const ToolPlaceTable& places,
                     const ToolQuestion& question);

}  // namespace polyturn::toolmgmt
