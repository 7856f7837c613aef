// DEF, REDEF, DEFINE, PROC, EXTERN: names that a program brings with it.
#pragma once
#include <cstddef>

#include "channels/sinumerik/grammar/value.hpp"

namespace polyturn::channels::sinumerik {

struct Execution;

bool parse_type(Execution& x, Type& type, std::size_t& length);
bool st_def(Execution& x);
bool st_redef(Execution& x);
bool st_define(Execution& x);
void expand_macros(Execution& x);
bool st_proc(Execution& x);
bool st_extern(Execution& x);

}  // namespace polyturn::channels::sinumerik
