// A fault is reported with its place, and the program ends.
#pragma once
#include <cstdint>
#include <string>

#include "channels/language.hpp"

namespace polyturn::channels::fagor {

struct Execution;

// `column` 0: of the whole block.
Step fault_at(Execution& x, Alarm alarm, std::uint32_t column, std::uint32_t length,
              std::string detail = {}, double v0 = 0, double v1 = 0);
// By the place that was noted, or else by the letter of the fault.
Step fault(Execution& x, Fault fault);

}  // namespace polyturn::channels::fagor
