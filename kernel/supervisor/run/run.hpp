// `polyturn run`: programs on a private controller of their own, in real or virtual time, with
// everything that happens printed as events (cli.md 4).
#pragma once
#include "kernel/supervisor/base/options.hpp"

namespace polyturn::supervisor {
int run_programs(const JobOptions& options);  // exit status
}
