// What would have to change for the store to hold what a backup holds. Not the positions of axes:
// they are the machine's.
#pragma once

#include <vector>

#include "toolmgmt/store_values.hpp"

namespace polyturn::toolmgmt {

std::vector<Change> changes_between(const StoreValues& now, StoreValues& wanted);
// "parameters", "offsets", "zeros", "variables", "counters", "tools", "places", "users",
// "dimensions", "pallets".
const char* section_of(Kind kind);

}  // namespace polyturn::toolmgmt
