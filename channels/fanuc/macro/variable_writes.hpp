// A variable is written, by a statement or from outside.
#pragma once
#include <cstdint>
#include <string_view>

namespace polyturn::channels::fanuc {

struct Execution;

bool write_variable(Execution& x, std::int64_t number, double value, std::string_view comment);
bool preset_variable(Execution& x, std::string_view name, double value);

}  // namespace polyturn::channels::fanuc
