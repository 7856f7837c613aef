// Where in a line that was read before the block stands that an alarm is about: its code that
// moves, else its last G code, else its first word; the word with `letter` where that is named. A
// macro statement begins behind its block number.
#pragma once
#include <cstddef>
#include <cstdint>
#include <string_view>

#include "channels/fanuc/g_codes.hpp"

namespace polyturn::channels::fanuc {

struct LinePlace {
    // in bytes, from 1; 0: the line holds several blocks, or none
    std::uint32_t column = 0, length = 0;
};

// Behind the value that begins here: a number, #101, or an expression in brackets.
std::size_t behind_value(std::string_view line, std::size_t at);

LinePlace place_in_line(std::string_view line, const GTable& table, char letter = 0);

}  // namespace polyturn::channels::fanuc
