// $TC_...: tool data as system variables.
#pragma once
#include <cstddef>
#include <string>
#include <string_view>
#include <vector>

#include "channels/sinumerik/grammar/tables.hpp"
#include "channels/sinumerik/grammar/value.hpp"
#include "channels/text/chars.hpp"

namespace polyturn::channels::sinumerik {

struct Execution;

inline constexpr int kMostEdges = 12;  // of a tool (sinumerik_part1 6.6)

// $TC_DP3 -> 3 for the prefix $TC_DP; -1: another name.
inline int parameter_of(std::string_view name, std::string_view prefix) {
    if (!name.starts_with(prefix) || name.size() == prefix.size() ||
        name.size() > prefix.size() + 3)
        return -1;
    int number = 0;
    for (const char c : name.substr(prefix.size())) {
        if (!is_digit(c)) return -1;
        number = number * 10 + (c - '0');
    }
    return number;
}

// $TC_TPG1 to $TC_TPG9: its number; 0 another name.
inline int grinding_parameter(std::string_view name) {
    return name.size() == 8 && name.starts_with("$TC_TPG") && name[7] >= '1' && name[7] <= '9'
               ? name[7] - '0'
               : 0;
}

bool tool_value(Execution& x, const std::string& name, const std::vector<Value>& indices,
                const char* from, std::size_t length, Value& value);
bool edge_cell(Execution& x, const std::string& name, const std::vector<Value>& indices,
               const char* from, std::size_t length, bool make, double*& cell);

}  // namespace polyturn::channels::sinumerik
