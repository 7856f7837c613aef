// WHILE, DO, END: loops of custom macro B.
#pragma once
#include <cstdint>
#include <string_view>

#include "channels/fanuc/macro/flow.hpp"

namespace polyturn::channels::fanuc {

struct Execution;

Flow loop_number(Execution& x, const char*& at, const char* end, std::uint8_t& number);
std::uint8_t loop_word(std::string_view line, bool& ends);
bool loops_nest(Execution& x, std::uint8_t number, std::size_t from);
Flow skip_loop(Execution& x, std::uint8_t number, const char* from);

}  // namespace polyturn::channels::fanuc
