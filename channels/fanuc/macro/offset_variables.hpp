// Which variable is which cell of the offset tables (fanuc_lathe 6.3.2).
#pragma once
#include <cstdint>

#include "channels/state/core.hpp"

namespace polyturn::channels::fanuc {

// A range of them: first variable, how many, table, field.
struct OffsetRange {
    std::int64_t first;
    std::int32_t count;
    OffsetTable table;
    OffsetField field;
};

// The range that the variable is in, and its offset's number; nullptr: it is none.
const OffsetRange* find_range(std::int64_t number, std::int32_t& offset);

}  // namespace polyturn::channels::fanuc
