// How a part of a macro statement ends.
#pragma once
#include <cstdint>
#include <string>

#include "channels/fanuc/macro/expression.hpp"
#include "channels/state/core.hpp"

namespace polyturn::channels::fanuc {

struct Execution;

enum class Flow : std::uint8_t { Done, NeedsBarrier, Fault };

Flow flow_fault(Execution& x, Alarm alarm, const char* at, std::string detail = {},
                double value = 0.0);
Flow flow_of(Execution& x, Expression::Status status);
Flow evaluate_expression(Execution& x, const char*& at, const char* end, double& value);
Flow bracketed_condition(Execution& x, const char*& at, const char* end, bool& holds);

}  // namespace polyturn::channels::fanuc
