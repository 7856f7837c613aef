// System variables of the geometry: $P_PFRAME, working areas, poles.
#pragma once
#include <cstddef>
#include <string>
#include <vector>

#include "channels/sinumerik/grammar/tables.hpp"
#include "channels/sinumerik/grammar/value.hpp"

namespace polyturn::channels::sinumerik {

struct Execution;
struct FrameValue;

double& frame_part(FrameValue& frame, std::size_t place, const std::string& part, bool& known);
bool geometry_value(Execution& x, const std::string& name, const std::vector<Value>& indices,
                    Value& value, bool& known);
bool write_geometry(Execution& x, const std::string& name, const std::vector<Value>& indices,
                    const Value& value, bool& known);

}  // namespace polyturn::channels::sinumerik
