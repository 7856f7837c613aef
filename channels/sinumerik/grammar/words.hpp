// The words of a block: read with their values, before anything acts.
#pragma once
#include <string_view>

#include "channels/sinumerik/execution.hpp"

namespace polyturn::channels::sinumerik {

bool names_cycle(std::string_view upper_name);
bool parse_words(Execution& x);
// the last one with this name; nullptr none
const Word* word(const Execution& x, std::string_view name);

inline bool has(const Execution& x, std::string_view name) { return word(x, name) != nullptr; }

}  // namespace polyturn::channels::sinumerik
