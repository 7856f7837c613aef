// Offsets and work zeros that a program writes.
#pragma once
#include <cstdint>

#include "channels/state/core.hpp"

namespace polyturn::channels::fanuc {

struct Execution;

double& cell_of(OffsetCell& cell, OffsetTable table, OffsetField field);

void write_offset(Execution& x, OffsetTable table, std::int32_t number, OffsetField field,
                  double value);
void write_zero(Execution& x, std::int32_t row, unsigned place, double value);
bool offset_value_good(Execution& x, OffsetTable table, double shown);

}  // namespace polyturn::channels::fanuc
