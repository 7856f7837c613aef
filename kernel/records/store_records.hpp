// Records that write to the store, in path order: variables, offsets, tool data, parameters.
#pragma once
#include "kernel/channel/channel.hpp"

namespace polyturn::kernel {

void tool_data(Channel& c, const PathRecord& r) noexcept;
void life_group(Channel& c, const PathRecord& r) noexcept;
void variable_or_offset(Channel& c, const PathRecord& r) noexcept;
// A parameter line that the program gives (G10 L50). True: the store has been asked, or answered.
bool parameter_record(Channel& c, const PathRecord& r) noexcept;

}  // namespace polyturn::kernel
