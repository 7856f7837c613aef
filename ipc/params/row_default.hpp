// One row of a table back to its default, every instance.
#pragma once
#include "ipc/params/registry.hpp"
#include "ipc/params/table.hpp"

namespace polyturn::params {
void set_default(Table& table, const Row& row) noexcept;
}
