// `polyturn dialogue`: what programs ask, page by page, on a terminal; with words behind it they
// are answered, as `polyturn press answer` does.
#pragma once
#include "kernel/supervisor/base/options.hpp"

namespace polyturn::supervisor {
int dialogue_verb(const CommandLine& line);
}  // namespace polyturn::supervisor
