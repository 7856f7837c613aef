// One entry into the offset table with its rules: number (N1400), wear limits (N1415, PT_WEAR_STEP), level, tip.
#pragma once

#include "toolmgmt/operations/operation.hpp"

namespace polyturn::toolmgmt {

// Its key, and the whole cell: a common one is the first channel's (offset_owner). `number` must be one that the channel has.
Key offset_key(const Work& work, std::int64_t channel, std::int64_t number, int table, int field);
const OffsetCell& offset_cell(const Work& work, std::int64_t channel, std::int64_t number);
// False: a fault was added.
bool enter_offset(Work& work, std::int32_t channel, std::int32_t number, int table, int field, double value);

}  // namespace polyturn::toolmgmt
