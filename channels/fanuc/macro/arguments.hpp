// Words of a call: program, count, arguments.
#pragma once
#include <cstdint>

#include "channels/fanuc/macro/variables.hpp"

namespace polyturn::channels::fanuc {

struct Execution;

bool gather_arguments(Execution& x, LocalSet& arguments, std::size_t from_word);
bool program_word(Execution& x, char letter, std::int64_t& program);
bool call_count(Execution& x, std::int64_t& repeats);
bool macro_words(Execution& x, std::int64_t& program, std::int64_t& repeats, LocalSet& arguments);
bool call_stands_first(Execution& x, std::size_t call);

}  // namespace polyturn::channels::fanuc
