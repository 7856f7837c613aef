// The unit in which one value counts. Lengths of a machine are millimetres, inches or degrees by
// its own parameters: a channel's by N0104, an axis' by the channel that owns it, or degrees when
// it is rotary (N0106).
#pragma once

#include <string_view>

#include "ipc/params/registry.hpp"
#include "ipc/params/table.hpp"

namespace polyturn::params {

// "mm/min" of the row's "mm/min|inch/min|deg/min"; empty for a plain number.
[[nodiscard]] std::string_view unit_of(const Row& row, const Table& table,
                                       unsigned instance) noexcept;

}  // namespace polyturn::params
