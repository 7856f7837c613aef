// One entry into the offset table with its rules: number (N1400), wear limits (N1415, PT_WEAR_STEP), level, tip.
#pragma once

#include "toolmgmt/operations/operation.hpp"

namespace polyturn::toolmgmt {

// False: a fault was added.
bool enter_offset(Work& work, std::int32_t channel, std::int32_t number, int table, int field, double value);

}  // namespace polyturn::toolmgmt
