// Statements of custom macro B.
#pragma once
#include "channels/language.hpp"

namespace polyturn::channels::fanuc {

struct Execution;

Step macro_statement(Execution& x, std::size_t from);

}  // namespace polyturn::channels::fanuc
