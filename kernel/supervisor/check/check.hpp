// `polyturn check`: programs are interpreted without a kernel, and their waits are matched.
#pragma once
#include "kernel/supervisor/base/options.hpp"

namespace polyturn::supervisor {
int check_programs(const JobOptions& options);  // exit status
}
