// $AA_OFF: ways that synchronized actions lay over the path.
#pragma once
#include <cstddef>
#include <string>
#include <vector>

#include "channels/sinumerik/grammar/tables.hpp"
#include "channels/sinumerik/grammar/value.hpp"

namespace polyturn::channels::sinumerik {

struct Execution;

bool write_overlay(Execution& x, const std::string& name, const std::vector<Value>& indices,
                   const char* from, std::size_t length, const Value& value);
bool drive_overlays(Execution& x);
bool p_overlay_off(Execution& x, Call& c);

}  // namespace polyturn::channels::sinumerik
