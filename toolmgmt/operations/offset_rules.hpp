// One entry into the offset table, or into a cutting edge, with its rules: number (N1400), wear
// limits (N1415, PT_WEAR_STEP), level, tip.
#pragma once

#include "toolmgmt/operations/operation.hpp"

namespace polyturn::toolmgmt {

// Its key, and the whole cell: a common one is the first channel's (offset_owner). `number` must be
// one that the channel has.
Key offset_key(const Work& work, std::int64_t channel, std::int64_t number, int table, int field);
const OffsetCell& offset_cell(const Work& work, std::int64_t channel, std::int64_t number);
// False: a fault was added.
bool enter_offset(Work& work, std::int32_t channel, std::int32_t number, int table, int field,
                  double value);
// The same for a cutting edge of a tool: $TC_DP`dp`. An edge that does not exist yet comes with its
// first value.
bool enter_edge(Work& work, std::int32_t channel, std::int32_t tool, std::int32_t edge, int dp,
                double value);
// The number of $TC_DPx that a field (0 X, 1 Y, 2 Z, 3 R, 4 T) of a table (0 geometry, 1 wear, 2
// base) of the edge has; `plane` 0 G17, 1 G18, 2 G19. -1: no length of the edge lies along that
// axis.
int edge_parameter(const Work& work, std::int32_t channel, std::int32_t tool, std::int32_t edge,
                   int table, int field, unsigned plane = 1);
// What acts beside the value of a row of zeros: the external zero and the work shift, without the
// row itself; as the table shows it.
double zeros_of_positioning(const Work& work, std::int64_t channel, std::size_t row,
                            const AxisConfig& axis);
// What is entered of a length that a display shows: offsets of an axis may be radii in the table
// while its positions are diameters (F5004 #1), and lengths of edges always are.
double share_in_offsets(const AxisConfig& axis);
double share_in_edges(const AxisConfig& axis);

}  // namespace polyturn::toolmgmt
