// Calls of programs and the ways back from them: M98, M97 P, macros, M99.
#pragma once
#include <cstdint>

#include "channels/fanuc/macro/variables.hpp"
#include "channels/program_files.hpp"

namespace polyturn::channels::fanuc {

struct Execution;

void look_whether_hidden(Execution& x);
bool call_levels_left(Execution& x, bool macro, bool modal, char letter);
bool enter_program(Execution& x, FileId file, std::int64_t number, std::int64_t repeats,
                   const LocalSet* arguments, bool by_code, bool modal);
bool call_program(Execution& x, std::int64_t number, std::int64_t repeats,
                  const LocalSet* arguments, bool by_code, bool modal, char letter);
bool call_part(Execution& x, std::int64_t number);
bool return_from_program(Execution& x, bool has_target, std::int64_t target);
bool go_on_with(Execution& x, std::int64_t number);

}  // namespace polyturn::channels::fanuc
